#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/spindle_pace.hpp>
#include <leadscrew/kinematics/transformation.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <limits>
#include <string>

namespace leadscrew::gcode {

double feed_length_of_line(const base::AxisVector& from, const base::AxisVector& to) {
  for (const base::Axis first : {base::Axis::X, base::Axis::U, base::Axis::A}) {
    const std::size_t i = base::index(first);
    const double length = numeric::hypot(to[i] - from[i], to[i + 1] - from[i + 1], to[i + 2] - from[i + 2]);
    if (length > 0) return length;
  }
  return 0;
}

/// Places of the axes; under tool centre point control a line in machine coordinates is one of the tip.
base::AxisVector SpindlePace::axes_at(const base::AxisVector& place) const {
  const kinematics::Transformation* of_tip = frame_.tip_control();
  return of_tip == nullptr ? place : of_tip->axes_of(place);
}

// Of the axes that it moves, by d_i along the path's length of |d|, the least that one allows:
//
//     v · |d_i| / |d| ≤ v_i
//
// Tool centre point control turns d and leaves its length, as long as no rotary axis moves.
machine::Derivatives SpindlePace::limits_along(const Line& line) const {
  constexpr double none = std::numeric_limits<double>::infinity();
  const double length = feed_length_of_line(line.from, line.to);
  const base::AxisVector from = axes_at(line.from), to = axes_at(line.to);
  machine::Derivatives least{none, none, none};
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    const double part = std::fabs(to[i] - from[i]) / length;
    if (!(part > 0) || !machine_.axes[i]) continue;
    const machine::AxisLimits& limits = *machine_.axes[i];
    least = {std::min(least.velocity, limits.velocity / part), std::min(least.acceleration, limits.acceleration / part),
             std::min(least.jerk, limits.jerk / part)};
  }
  return least;
}

// The cycle follows a simulated spindle along straight lines of the axes.
bool SpindlePace::goes_straight(const Block& block, const Line& line) {
  if (!machine_.threads_follow() || frame_.tip_control() == nullptr) return true;
  for (const base::Axis axis : {base::Axis::A, base::Axis::B, base::Axis::C}) {
    const std::size_t i = base::index(axis);
    if (line.from[i] == line.to[i]) continue;
    return error("thread-turns-tool", block.column_of(base::letter(axis)),
                 std::string("axis ") + base::letter(axis) + " turns the tool along a thread",
                 "turn it in a block before, or end tool centre point control (G49)");
  }
  return true;
}

// A speed in whole revolutions per minute, and the feed that keeps the lead at it.
std::string SpindlePace::at_most(const Line& line, double speed) const {
  const double whole = std::floor(speed);
  std::string most = "at most S" + text(whole);
  if (!line.is_by_feed) return most;
  return most + " with F" + text(line.lead * whole / frame_.length_unit) + ", which is the same lead";
}

// An axis that cannot go as fast as the spindle asks would spoil the thread. So does a simulated spindle where it is fastest.
bool SpindlePace::is_reached(const Block& block, const Line& line) {
  if (!goes_straight(block, line)) return false;
  double fastest = limits_along(line).velocity;
  // What the spindle has turned before motion is in step is made good by going faster than it.
  constexpr double left_to_catch_up = 0.05;
  if (machine_.threads_follow()) fastest *= (1 - left_to_catch_up) / (1 + machine_.spindle->wander);
  constexpr double rounding = 1e-9;
  const double asked = line.lead * line.speed / seconds_per_minute;
  if (asked <= fastest * (1 + rounding)) return true;
  return error("thread-too-fast", motion_column(block),
               "the thread asks for " + text(asked * seconds_per_minute) + " mm/min at S" + text(line.speed),
               "the axes go along with " + at_most(line, fastest * seconds_per_minute / line.lead));
}

// By n² / 2a revolutions.
bool SpindlePace::can_brake(const Block& block, const Line& line) {
  if (!machine_.threads_follow()) return true;
  const double length = feed_length_of_line(line.from, line.to);
  const double acceleration =
      machine::tap_acceleration(*machine_.spindle, limits_along(line), line.lead, machine_.tolerance, machine_.period);
  const double turns = line.speed / seconds_per_minute, way = line.lead * turns * turns / (2 * acceleration);
  if (way <= length) return true;
  const double slower = std::sqrt(2 * acceleration * length / line.lead) * seconds_per_minute;
  return error("tap-too-short", motion_column(block),
               "the spindle takes " + text(std::ceil(way * 10) / 10) + " mm to stand from S" + text(line.speed) +
                   ", and the tap is " + text(std::round(length * 1000) / 1000) + " mm deep",
               at_most(line, slower) + "; or a spindle that brakes faster ([spindle] acceleration_rpm_s)");
}

}  // namespace leadscrew::gcode
