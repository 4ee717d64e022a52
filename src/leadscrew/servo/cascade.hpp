#pragma once
// The cascade of servo drives: a proportional position loop around a velocity loop with proportional and integral
// parts.
//
//   w = Kv·(reference − reading) + v        velocity that is wanted, with the setpoint's own fed forward
//   ε = w − (reading − reading₋₁)/T         and what is missing of it
//   u = P·ε + I·T·Σε + Fa·a                 with the setpoint's own acceleration fed forward
//
// The velocity is read from the same encoder, a difference of readings: half a period old, and as coarse as one count a
// period. Before the first period the reading is taken to have stood. Saturation and windup as in Pid.

#include <leadscrew/base/result.hpp>
#include <leadscrew/servo/setpoint.hpp>
#include <limits>
#include <optional>

namespace leadscrew::servo {

struct CascadeOptions {
  double position_gain = 0;         ///< Kv, 1/s; > 0
  double velocity_gain = 0;         ///< P, units of command/(mm/s); > 0
  double integral_gain = 0;         ///< I, units/mm; ≥ 0
  double velocity_forward = 1;      ///< share of the setpoint's velocity that is fed forward, 0 … 1
  double acceleration_forward = 0;  ///< Fa, units/(mm/s²): 1 over what the drive makes of a unit; ≥ 0
  double limit = std::numeric_limits<double>::infinity();  ///< of |u|; > 0
};

class Cascade {
 public:
  /// period: T, seconds. Code: `servo-controller`.
  static base::Result<Cascade> create(const CascadeOptions& options, double period);

  /// The command for the period that begins. Once a period.
  double command(const Setpoint& setpoint, double reading);

 private:
  Cascade() = default;

  CascadeOptions options_;
  double period_ = 0;
  double sum_ = 0;  // Σε, mm/s
  std::optional<double> last_reading_;
};

}  // namespace leadscrew::servo
