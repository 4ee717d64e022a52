#pragma once
// What motion in step with the spindle asks of the axes, and a tap of a spindle that takes its time to brake.

#include <leadscrew/gcode/part.hpp>

namespace leadscrew::gcode {

/// Of a line, as feed counts it: along X Y Z; along U V W where those stand still; along A B C where all linear axes do. mm,
/// or degrees.
double feed_length_of_line(const base::AxisVector& from, const base::AxisVector& to);

class SpindlePace : Part {
 public:
  explicit SpindlePace(const Context& context) : Part(context) {}

  /// A line in step with the spindle, in machine coordinates: lead, mm (degrees where only rotary axes move) of it in a
  /// revolution, > 0; speed, revolutions per minute, > 0.
  struct Line {
    const base::AxisVector& from;
    const base::AxisVector& to;
    double lead = 0;
    double speed = 0;
    bool is_by_feed = false;  ///< the lead is F / S
  };

  /// Do the axes go as fast as the spindle asks? Else `thread-too-fast`; `thread-turns-tool` where a simulated spindle is
  /// to be followed and rotary axes move under tool centre point control.
  bool is_reached(const Block& block, const Line& line);
  /// Does a simulated spindle, which turns at that speed as the line begins, stand where it ends? Else `tap-too-short`.
  bool can_brake(const Block& block, const Line& line);

 private:
  std::string at_most(const Line& line, double speed) const;
  bool goes_straight(const Block& block, const Line& line);
  base::AxisVector axes_at(const base::AxisVector& place) const;
  machine::Derivatives limits_along(const Line& line) const;
};

}  // namespace leadscrew::gcode
