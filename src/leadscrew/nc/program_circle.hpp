#pragma once
// The circular DDA as programs need it: ends that rounding puts beside the circle are reached without waiting.
//
// A counter that is not zero when the axis that is fast at the end has arrived waits for an integrator with a small
// integrand: up to R clocks for one pulse. Here what is left then is stepped out, a pulse a command.

#include <leadscrew/pulse/circular_dda.hpp>

namespace leadscrew::nc {

class ProgramCircle {
 public:
  static constexpr std::size_t axes = 2;

  constexpr ProgramCircle(const pulse::Arc& arc, pulse::CircularDdaOptions options)
      : dda_(arc, options), end_(arc.end) {
    look();
  }

  constexpr bool done() const { return dda_.done() || (steps_out_ && at_ == end_); }

  constexpr pulse::Pulse<2> step() {
    if (steps_out_) return toward_end();
    const pulse::Pulse<2> pulse = dda_.step();
    if (dda_.left_x() == 0 || dda_.left_y() == 0) look();
    return pulse;
  }

  /// As those of the DDA; they do not go on where it steps out.
  constexpr pulse::QuadrantRegisters stretch() const {
    return steps_out_ ? pulse::QuadrantRegisters{} : dda_.stretch();
  }
  constexpr void give_back(const pulse::QuadrantRegisters& stretch) {
    if (steps_out_) return;
    dda_.give_back(stretch);
    look();
  }

  constexpr pulse::Point at() const { return steps_out_ ? at_ : dda_.at(); }
  /// Steps left, of the quadrant.
  constexpr std::int64_t left_x() const { return steps_out_ ? pulse::absolute(end_.x - at_.x) : dda_.left_x(); }
  constexpr std::int64_t left_y() const { return steps_out_ ? pulse::absolute(end_.y - at_.y) : dda_.left_y(); }

 private:
  /// The axis with the greater integrand has arrived: that happens on a border of quadrants, where the other integrand
  /// is 0 and the DDA steps out by itself, or at the end.
  constexpr void look() {
    if (dda_.left_x() > 0 && dda_.left_y() > 0) return;
    at_ = dda_.at();
    const std::int64_t x = pulse::absolute(at_.x), y = pulse::absolute(at_.y);
    if (dda_.left_x() == 0 && dda_.left_y() > 0 && 0 < x && x < y) steps_out_ = true;
    if (dda_.left_y() == 0 && dda_.left_x() > 0 && 0 < y && y < x) steps_out_ = true;
  }

  constexpr pulse::Pulse<2> toward_end() {
    const pulse::Pulse<2> pulse{{pulse::sign(end_.x - at_.x), pulse::sign(end_.y - at_.y)}};
    at_.x += pulse.step[0];
    at_.y += pulse.step[1];
    return pulse;
  }

  pulse::CircularDda dda_;
  pulse::Point at_, end_;  // at_: where it steps out from, and on
  bool steps_out_ = false;
};

}  // namespace leadscrew::nc
