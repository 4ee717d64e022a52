#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/host/move_queue.hpp>
#include <leadscrew/host/moves.hpp>
#include <utility>

namespace leadscrew::host {

base::Result<void> MoveQueue::smooth(double tolerance) {
  if (!(tolerance >= 0 && std::isfinite(tolerance)))
    return base::failure(base::problem("tolerance", "a tolerance of " + base::text(tolerance, 9) + " mm", "0 or more"));
  tolerance_ = tolerance;
  return {};
}

base::Result<void> MoveQueue::push(gcode::Move move) {
  if (finished_)
    return base::failure(base::problem("motion-ended", "no move is taken any more", "reset it at its end"));
  if (auto sound = put_behind(last_.end, machine_, move); !sound) return sound;
  move.path_mode = tolerance_ > 0 ? gcode::PathMode::blend : gcode::PathMode::exact_path;
  move.tolerance = move.naive_cam_tolerance = tolerance_;
  append(std::move(move));
  return {};
}

base::Result<void> MoveQueue::push(std::vector<gcode::Move> moves) {
  const std::size_t count = moves_.size();
  const Last last = last_;
  for (gcode::Move& move : moves) {
    if (auto sound = push(std::move(move)); !sound) {
      while (moves_.size() > count) moves_.pop_back();
      last_ = last;
      return sound;
    }
  }
  return {};
}

void MoveQueue::append(gcode::Move move) {
  last_ = {move.end, move.line, move.is_of_tip, move.tool};
  moves_.push_back(std::move(move));
}

/// A dwell of no time, for which motion rests; its place is told as those of the moves before are.
void MoveQueue::end_for_now() {
  gcode::Move rest = dwell(0);
  rest.start = rest.end = last_.end;
  rest.line = last_.line;
  rest.is_of_tip = last_.is_of_tip;
  rest.tool = last_.tool;
  if (!finished_) moves_.push_back(std::move(rest));
}

void MoveQueue::abandon() {
  finished_ = true;
  moves_.clear();
}

void MoveQueue::restart(const base::AxisVector& start) {
  moves_.clear();
  finished_ = has_given_ = false;
  last_ = {start};
}

pipeline::Supply MoveQueue::give(gcode::Move& move) {
  if (moves_.empty()) return finished_ ? pipeline::Supply::end : pipeline::Supply::later;
  move = std::move(moves_.front());
  moves_.pop_front();
  has_given_ = true;
  return pipeline::Supply::move;
}

}  // namespace leadscrew::host
