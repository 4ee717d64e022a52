#include <leadscrew/pipeline/motion_source.hpp>

namespace leadscrew::pipeline {

std::optional<planner::Chunk> MotionSource::next() {
  std::optional<planner::Chunk> chunk = planner_.pop();
  while (!chunk && reading_) {
    gcode::Move move;
    reading_ = reader_.next(move);
    if (reading_) {
      if (on_move) on_move(move);
      builder_.push(move);
    } else {
      builder_.finish();
    }
    while (const std::optional<toolpath::Element> element = builder_.pop()) {
      planner_.push(*element);
      if (on_element) on_element(*element);
    }
    if (!reading_) planner_.finish();
    chunk = planner_.pop();
  }
  return chunk;
}

}  // namespace leadscrew::pipeline
