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
  if (auto sound = put_behind(end_, machine_, move); !sound) return sound;
  move.path_mode = tolerance_ > 0 ? gcode::PathMode::blend : gcode::PathMode::exact_path;
  move.tolerance = move.naive_cam_tolerance = tolerance_;
  append(std::move(move));
  return {};
}

void MoveQueue::append(gcode::Move move) {
  end_ = move.end;
  line_ = move.line;
  is_of_tip_ = move.is_of_tip;
  tool_ = move.tool;
  moves_.push_back(std::move(move));
}

/// A dwell of no time, for which motion rests; its place is told as those of the moves before are.
void MoveQueue::end_for_now() {
  gcode::Move rest = dwell(0);
  rest.start = rest.end = end_;
  rest.line = line_;
  rest.is_of_tip = is_of_tip_;
  rest.tool = tool_;
  if (!finished_) moves_.push_back(std::move(rest));
}

void MoveQueue::abandon() {
  finished_ = true;
  moves_.clear();
}

void MoveQueue::restart(const base::AxisVector& start) {
  moves_.clear();
  finished_ = has_given_ = false;
  end_ = start;
  line_ = {};
  is_of_tip_ = false;
  tool_ = {};
}

pipeline::Supply MoveQueue::give(gcode::Move& move) {
  if (moves_.empty()) return finished_ ? pipeline::Supply::end : pipeline::Supply::later;
  move = std::move(moves_.front());
  moves_.pop_front();
  has_given_ = true;
  return pipeline::Supply::move;
}

}  // namespace leadscrew::host
