#include <leadscrew/machine/fields.hpp>
#include <leadscrew/machine/laser.hpp>
#include <string>

namespace leadscrew::machine {

void check_laser(const Laser& laser, std::vector<base::Diagnostic>& problems) {
  if (0 <= laser.output && laser.output < base::most_outputs) return;
  problems.push_back(base::problem("machine-laser", "the laser's output is " + std::to_string(laser.output),
                                   "an analog output, 0 to " + std::to_string(base::most_outputs - 1),
                                   {.field = field::laser_output}));
}

void LaserPower::observe(const base::Event& event) {
  using Kind = base::Event::Kind;
  const bool by_spindle = laser_.power == Laser::Power::spindle_speed;
  if (by_spindle && base::stops_spindle(event.kind)) is_on_ = false;
  switch (event.kind) {
    case Kind::spindle_clockwise:
    case Kind::spindle_counterclockwise:
      if (!by_spindle) return;
      is_on_ = true;
      asked_ = event.value;
      return;
    case Kind::spindle_speed:
      if (by_spindle) asked_ = event.value;
      return;
    case Kind::analog_output_with_motion:
    case Kind::analog_output:
      if (!by_spindle && event.output == laser_.output) asked_ = event.value;
      return;
    case Kind::programmed_feed:
      programmed_feed_ = event.value;
      return;
    default:
      return;
  }
}

}  // namespace leadscrew::machine
