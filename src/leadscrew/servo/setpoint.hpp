#pragma once
// What an axis is asked for at the beginning of a period.

namespace leadscrew::servo {

struct Setpoint {
  double position = 0;      ///< mm or degrees
  double velocity = 0;      ///< mm/s, of the period that begins: for feed-forward
  double acceleration = 0;  ///< mm/s²
};

/// Of successive words T apart: differences of the position that is due and of those after it, so that a command which
/// is held for a period is that of this period.
constexpr Setpoint setpoint_of(double position, double next, double after_next, double period) {
  const double velocity = (next - position) / period;
  return {position, velocity, ((after_next - next) / period - velocity) / period};
}

}  // namespace leadscrew::servo
