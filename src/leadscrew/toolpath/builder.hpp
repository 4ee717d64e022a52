#pragma once
// From moves to the tool path, streaming: moves are pushed, and elements come out once nothing ahead can change them.
//
// Every move is kept as programmed, one curve a block; a NURBS curve becomes its smooth pieces
// (geometry::smooth_pieces).

#include <deque>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <optional>

namespace leadscrew::toolpath {

/// Length by which feed is counted: of X Y Z together; of U V W where those stand still; of A B C (degrees) where all
/// linear axes stand still. For an arc in the plane's axes, radius · |sweep| takes the place of their straight
/// distance; a NURBS curve's is the sum of its smooth pieces'.
double feed_length(const gcode::Move& move);

class Builder {
 public:
  void push(const gcode::Move& move);
  /// No more moves will come.
  void finish() {}
  /// The next element that is settled, if there is one.
  std::optional<Element> pop();

 private:
  void settle(const geometry::Curve& curve, const gcode::Move& move, double feed_length);

  std::deque<Element> settled_;
};

}  // namespace leadscrew::toolpath
