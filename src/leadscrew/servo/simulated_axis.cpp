#include <algorithm>
#include <cmath>
#include <leadscrew/servo/refusal.hpp>
#include <leadscrew/servo/simulated_axis.hpp>

namespace leadscrew::servo {

base::Result<SimulatedAxis> SimulatedAxis::create(const AxisOptions& options) {
  Refusal refusal("servo-axis");
  refusal.unless_positive("the drive's acceleration for one unit of command", options.drive.acceleration);
  refusal.unless_not_negative("the drive's damping", options.drive.damping);
  refusal.unless_limit("the limit of the command", options.command_limit);
  refusal.unless_not_negative("friction", options.friction);
  refusal.unless_not_negative("breakaway", options.breakaway);
  refusal.unless_not_negative("backlash", options.backlash);
  refusal.unless_not_negative("the encoder's resolution", options.encoder_resolution);
  if (refusal.found()) return base::failure(*refusal.found());
  return SimulatedAxis(options);
}

void SimulatedAxis::advance(double command, double seconds) {
  const double held = std::clamp(command, -options_.command_limit, options_.command_limit);
  const double pull = options_.drive.acceleration * held;
  // Once up to a stop, and once for what follows it.
  for (int part = 0; part < 2 && seconds > 0; ++part) seconds -= travel(pull, seconds);
}

/// Moves until the screw stops, at most for so many seconds; returns how long that took.
double SimulatedAxis::travel(double pull, double at_most) {
  const bool stands = screw_.velocity == 0;
  if (stands && std::fabs(pull) <= std::max(options_.friction, options_.breakaway)) return at_most;
  const double against = std::copysign(options_.friction, stands ? pull : screw_.velocity);
  const Pull net{pull - against, options_.drive.damping};
  const double rest = time_to_rest(screw_.velocity, net);
  const bool stops = rest <= at_most;
  screw_ = after(screw_, net, stops ? rest : at_most);
  if (stops) screw_.velocity = 0;
  // It moved in one direction, so its position now is the farthest it came.
  const double play = options_.backlash / 2;
  slide_ = std::clamp(slide_, screw_.position - play, screw_.position + play);
  return stops ? rest : at_most;
}

double SimulatedAxis::current(double command) const {
  const Drive& drive = options_.drive;
  const double held = std::clamp(command, -options_.command_limit, options_.command_limit);
  return drive.acceleration * held - (drive.regulates_velocity ? drive.damping * screw_.velocity : 0);
}

double SimulatedAxis::reading() const {
  const double position = options_.encoder_place == EncoderPlace::screw ? screw_.position : slide_;
  const double resolution = options_.encoder_resolution;
  return resolution > 0 ? std::floor(position / resolution + 0.5) * resolution : position;
}

}  // namespace leadscrew::servo
