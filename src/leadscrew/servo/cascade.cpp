#include <algorithm>
#include <cmath>
#include <leadscrew/servo/cascade.hpp>
#include <leadscrew/servo/refusal.hpp>

namespace leadscrew::servo {

base::Result<Cascade> Cascade::create(const CascadeOptions& options, double period) {
  Refusal refusal("servo-controller");
  refusal.unless_positive("the period", period);
  refusal.unless_positive("the gain of the position loop", options.position_gain);
  refusal.unless_positive("the gain of the velocity loop", options.velocity_gain);
  refusal.unless_not_negative("the integral gain", options.integral_gain);
  refusal.unless_within("the share of velocity fed forward", options.velocity_forward, 0, 1);
  refusal.unless_not_negative("the feed-forward of acceleration", options.acceleration_forward);
  refusal.unless_limit("the limit of the command", options.limit);
  if (refusal.found()) return base::failure(*refusal.found());
  Cascade made;
  made.options_ = options;
  made.period_ = period;
  return made;
}

double Cascade::command(const Setpoint& setpoint, double reading) {
  const double velocity = (reading - last_reading_.value_or(reading)) / period_;
  last_reading_ = reading;
  const double wanted =
      options_.position_gain * (setpoint.position - reading) + options_.velocity_forward * setpoint.velocity;
  const double missing = wanted - velocity;
  const auto of_sum = [&](double sum) {
    return options_.velocity_gain * missing + options_.integral_gain * period_ * sum +
           options_.acceleration_forward * setpoint.acceleration;
  };
  const double unlimited = of_sum(sum_ + missing);
  const bool winds_up = std::fabs(unlimited) > options_.limit && (unlimited > 0) == (missing > 0);
  if (!winds_up) sum_ += missing;
  return std::clamp(of_sum(sum_), -options_.limit, options_.limit);
}

}  // namespace leadscrew::servo
