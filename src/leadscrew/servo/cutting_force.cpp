#include <algorithm>
#include <cmath>
#include <leadscrew/servo/cutting_force.hpp>
#include <leadscrew/servo/refusal.hpp>
#include <numbers>

namespace leadscrew::servo {

namespace {

constexpr double turn = 2 * std::numbers::pi;

}  // namespace

base::Result<MillingForce> MillingForce::create(const MillingOptions& options) {
  Refusal refusal("servo-milling");
  refusal.unless_within("the number of teeth", options.teeth, 1, 64);
  refusal.unless_positive("the diameter", options.diameter);
  refusal.unless_positive("the spindle's speed", options.spindle_speed);
  refusal.unless_positive("the cutting coefficient", options.cutting_coefficient);
  refusal.unless_not_negative("the edge coefficient", options.edge_coefficient);
  refusal.unless_not_negative("noise", options.noise);
  if (refusal.found()) return base::failure(*refusal.found());
  return MillingForce(options);
}

double MillingForce::engaged_angle(double width) const {
  return std::acos(std::clamp(1 - 2 * width / options_.diameter, -1.0, 1.0));
}

double MillingForce::after(double seconds, double feed, const Engagement& engagement) {
  turns_ += seconds * options_.spindle_speed;
  turns_ -= std::floor(turns_);
  const double feed_per_tooth = feed / (options_.spindle_speed * options_.teeth);
  const double engaged = engaged_angle(engagement.width);
  double force = 0;
  for (int tooth = 0; tooth < options_.teeth; ++tooth) {
    const double place = turns_ + static_cast<double>(tooth) / options_.teeth;
    const double angle = turn * (place - std::floor(place));
    if (angle >= engaged) continue;
    force += options_.cutting_coefficient * feed_per_tooth * std::sin(angle) + options_.edge_coefficient;
  }
  return force * engagement.depth + noise();
}

double MillingForce::mean(double feed, const Engagement& engagement) const {
  const double feed_per_tooth = feed / (options_.spindle_speed * options_.teeth);
  const double engaged = engaged_angle(engagement.width);
  return options_.teeth * engagement.depth / turn *
         (options_.cutting_coefficient * feed_per_tooth * (1 - std::cos(engaged)) +
          options_.edge_coefficient * engaged);
}

/// The difference of two uniform numbers: a triangle of the variance 1/6. Knuth's linear congruence of 64 bits; its low
/// bits are poor and not used.
double MillingForce::noise() {
  const auto uniform = [&] {
    random_ = random_ * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(random_ >> 11) * 0x1p-53;
  };
  const double first = uniform(), second = uniform();
  return options_.noise * std::sqrt(6.0) * (first - second);
}

}  // namespace leadscrew::servo
