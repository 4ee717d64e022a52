#include <leadscrew/servo/pid.hpp>
#include <leadscrew/servo/refusal.hpp>

namespace leadscrew::servo {

base::Result<Pid> Pid::create(const PidOptions& options, double period) {
  Refusal refusal("servo-controller");
  refusal.unless_positive("the period", period);
  refusal.unless_not_negative("the proportional gain", options.gains.proportional);
  refusal.unless_not_negative("the integral gain", options.gains.integral);
  refusal.unless_not_negative("the derivative gain", options.gains.derivative);
  refusal.unless_not_negative("the feed-forward of velocity", options.velocity_forward);
  refusal.unless_not_negative("the feed-forward of acceleration", options.acceleration_forward);
  refusal.unless_limit("the limit of the command", options.limit);
  if (refusal.found()) return base::failure(*refusal.found());
  Pid made;
  made.gains_ = options.gains;
  made.gains_.integral *= period;
  if (options.form == PidForm::standard) made.gains_.derivative /= period;
  made.velocity_forward_ = options.velocity_forward;
  made.acceleration_forward_ = options.acceleration_forward;
  made.limit_ = options.limit;
  made.anti_windup_ = options.anti_windup;
  return made;
}

}  // namespace leadscrew::servo
