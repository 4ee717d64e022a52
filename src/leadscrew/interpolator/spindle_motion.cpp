#include <algorithm>
#include <cmath>
#include <leadscrew/interpolator/spindle_motion.hpp>
#include <leadscrew/numeric/sine.hpp>
#include <numbers>

namespace leadscrew::interpolator {

namespace {

constexpr double seconds_per_minute = 60;

/// 0 … 1. Steele, Lea, Flood, "Fast splittable pseudorandom number generators" (2014): the mix of SplitMix64.
double drawn(std::uint64_t& state) {
  std::uint64_t z = state += 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

numeric::Sines sines_at(double frequency, double t, double phase) {
  return numeric::sines(numeric::DoubleDouble(frequency * t + phase));
}

}  // namespace

SpindleMotion::SpindleMotion(const machine::Spindle& spindle)
    : acceleration_(spindle.acceleration / seconds_per_minute), wander_(spindle.wander), waves_{} {
  std::uint64_t state = spindle.seed;
  double sum = 0;
  for (std::size_t k = 0; k < waves_.size(); ++k) {
    const double share = 0.1 + drawn(state);
    waves_[k] = {share, 2 * std::numbers::pi * static_cast<double>(k + 1) / spindle.wander_period,
                 2 * std::numbers::pi * drawn(state)};
    sum += share;
  }
  for (Wave& wave : waves_) wave.share /= sum;
}

double SpindleMotion::own_time(double t) const {
  double sum = 0;
  for (const Wave& wave : waves_) {
    const double turned =
        sines_at(wave.frequency, 0, wave.phase).cosine - sines_at(wave.frequency, t, wave.phase).cosine;
    sum += wave.share / wave.frequency * turned;
  }
  return t + wander_ * sum;
}

double SpindleMotion::wander(double t) const {
  double sum = 0;
  for (const Wave& wave : waves_) sum += wave.share * sines_at(wave.frequency, t, wave.phase).sine;
  return wander_ * sum;
}

double SpindleMotion::ramp_speed(double since) const {
  const double change = to_ - from_, most = acceleration_ * since;
  return from_ + std::clamp(change, -most, most);
}

void SpindleMotion::turn(double speed, double t) {
  const double now = own_time(t), passed = revolutions(t);
  from_ = ramp_speed(now - begin_);
  to_ = speed / seconds_per_minute;
  revolutions_ = passed;
  begin_ = now;
}

double SpindleMotion::revolutions(double t) const {
  const double since = own_time(t) - begin_, ramp = std::min(std::abs(to_ - from_) / acceleration_, since);
  return revolutions_ + (from_ + ramp_speed(ramp)) / 2 * ramp + to_ * (since - ramp);
}

double SpindleMotion::speed(double t) const {
  return ramp_speed(own_time(t) - begin_) * (1 + wander(t));
}

}  // namespace leadscrew::interpolator
