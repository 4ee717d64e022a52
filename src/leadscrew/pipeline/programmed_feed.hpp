#pragma once
// The feed that a program asks for, line by line, beside the words that travel it.

#include <functional>
#include <leadscrew/gcode/move.hpp>

namespace leadscrew::pipeline {

/// Of a move, mm/s (degrees/s where only rotary axes move); 0 of rapids and of what is no motion.
double programmed_feed(const gcode::Move& move);

class ProgrammedFeed {
 public:
  /// moves: of the program, from its beginning; false at its end.
  explicit ProgrammedFeed(std::function<bool(gcode::Move&)> moves) : moves_(std::move(moves)) {}

  /// Of the moves of this line, the greatest, mm/s (degrees/s where only rotary axes move); 0 where all are rapid.
  /// Lines come as words do: none before the last.
  double at(base::Line line);

 private:
  std::function<bool(gcode::Move&)> moves_;
  gcode::Move move_;
  bool has_move_ = false, begun_ = false;
  base::Line line_{};
  double feed_ = 0;
};

}  // namespace leadscrew::pipeline
