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
    : acceleration_(spindle.acceleration / seconds_per_minute),
      ramp_(acceleration_),
      wander_(spindle.wander),
      waves_{} {
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
  const double change = to_ - from_, most = ramp_ * since;
  return from_ + std::clamp(change, -most, most);
}

/// Since the ramp began.
double SpindleMotion::turned(double since) const {
  const double ramp = std::min(std::abs(to_ - from_) / ramp_, since);
  return (from_ + ramp_speed(ramp)) / 2 * ramp + to_ * (since - ramp);
}

void SpindleMotion::turn(double speed, double t, double acceleration) {
  const double now = own_time(t), passed = revolutions(t);
  from_ = ramp_speed(now - begin_);
  to_ = speed / seconds_per_minute;
  revolutions_ = passed;
  begin_ = now;
  ramp_ = std::min(acceleration, acceleration_);
}

/// By its own time u since the ramp began, from n₀ with acceleration a, then at n₁, it stands n²/2b behind where it begins to
/// brake by b. That this is at x it must begin at n, or where it has n₁:
///
///     (n² − n₀²)/2a + n²/2b = x,   n ≤ n₁
void SpindleMotion::stand_at(double place, double t, double next, double acceleration) {
  const double way = to_ < 0 ? -1 : 1, n0 = way * from_, n1 = way * to_, x = way * (place - revolutions_);
  if (to_ == 0) return;
  const double a = ramp_, b = std::min(acceleration, acceleration_);
  const double rise = (n0 < n1 ? 1 : -1) * (n1 * n1 - n0 * n0) / (2 * a);
  const double n = std::sqrt(std::max(x + n0 * n0 / (2 * a), 0.0) / (1 / (2 * a) + 1 / (2 * b)));
  const double steady = std::abs(n1 - n0) / a + (x - rise - n1 * n1 / (2 * b)) / n1;
  const double now = own_time(t) - begin_, u = std::max(n0 < n && n < n1 ? (n - n0) / a : steady, now);
  if (!(u < own_time(next) - begin_)) return;
  const double reached = ramp_speed(u);
  revolutions_ += turned(u);
  from_ = reached;
  to_ = 0;
  begin_ += u;
  ramp_ = b;
}

bool SpindleMotion::is_at_speed(double t) const {
  return ramp_ * (own_time(t) - begin_) >= std::abs(to_ - from_);
}

double SpindleMotion::revolutions(double t) const {
  return revolutions_ + turned(std::max(own_time(t) - begin_, 0.0));
}

double SpindleMotion::speed(double t) const {
  return ramp_speed(std::max(own_time(t) - begin_, 0.0)) * (1 + wander(t));
}

}  // namespace leadscrew::interpolator
