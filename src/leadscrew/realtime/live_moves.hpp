#pragma once
// Moves from one thread to another, which plans them while they come: their queue, and what the feeder asks about it.

#include <cstddef>
#include <cstdint>
#include <leadscrew/base/result.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/host/move_queue.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/pipeline/move_input.hpp>
#include <leadscrew/realtime/feeder.hpp>
#include <leadscrew/realtime/schedule.hpp>
#include <mutex>
#include <utility>

namespace leadscrew::realtime {

/// Any thread may call anything.
class LiveMoves {
 public:
  /// As a host::MoveQueue.
  LiveMoves(base::Borrowed<machine::Machine> machine, const base::AxisVector& start) : moves_(machine, start) {}

  /// As host::MoveQueue::smooth().
  base::Result<void> smooth(double tolerance) {
    const std::lock_guard lock(mutex_);
    return moves_.smooth(tolerance);
  }
  /// As host::MoveQueue::push().
  base::Result<void> push(gcode::Move move) {
    const std::lock_guard lock(mutex_);
    auto pushed = moves_.push(std::move(move));
    if (pushed) note_arrival();
    return pushed;
  }
  /// As host::MoveQueue::append().
  void append(gcode::Move move) {
    const std::lock_guard lock(mutex_);
    moves_.append(std::move(move));
    note_arrival();
  }
  /// No more moves will come.
  void finish() {
    const std::lock_guard lock(mutex_);
    moves_.finish();
  }

  /// The next of them, to be planned.
  pipeline::Supply give(gcode::Move& move) {
    const std::lock_guard lock(mutex_);
    return moves_.give(move);
  }
  /// How many wait for that.
  std::size_t waiting() {
    const std::lock_guard lock(mutex_);
    return moves_.waiting().size();
  }
  /// Of Planning::drought, when more is wanted than there is.
  Drought drought() {
    const std::lock_guard lock(mutex_);
    return {is_open_, 1e-9 * static_cast<double>(now() - last_came_)};
  }
  /// Planning::end_for_now.
  void end_for_now() {
    const std::lock_guard lock(mutex_);
    moves_.end_for_now();
    is_open_ = false;
  }

 private:
  void note_arrival() {
    last_came_ = now();
    is_open_ = true;
  }

  std::mutex mutex_;
  host::MoveQueue moves_;
  std::int64_t last_came_ = 0;  ///< ns
  bool is_open_ = false;        ///< has any come behind the last rest?
};

}  // namespace leadscrew::realtime
