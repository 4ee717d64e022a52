#pragma once
// Moves on time: whoever pushes them may be slow, and motion runs dry without being cut up.
//
//   push() ─▶ queue ─▶ planner's thread ─▶ cyclic thread ─▶ sink        any thread pushes
//
// Motion begins, and comes to rest for want of moves, as the Feeder says (Drought).

#include <leadscrew/base/result.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/pipeline/motion_source.hpp>
#include <leadscrew/realtime/live_moves.hpp>
#include <leadscrew/realtime/runner.hpp>
#include <utility>

namespace leadscrew::realtime {

/// A Runner of moves.
class MoveRunner {
 public:
  /// From rest at options.position; at the machine's period, whatever the options have. The machine is sound
  /// (machine::validate); the sink is as a Runner's.
  MoveRunner(machine::Machine machine, RunnerOptions options, WordSink sink);
  MoveRunner(const MoveRunner&) = delete;
  MoveRunner& operator=(const MoveRunner&) = delete;

  /// As host::MoveQueue::smooth(). Any thread may call it, and those below.
  base::Result<void> smooth(double tolerance) { return moves_.smooth(tolerance); }
  /// As host::MoveQueue::push().
  base::Result<void> push(gcode::Move move) { return moves_.push(std::move(move)); }
  /// No more moves will come: the runner ends where the last ends.
  void finish() { moves_.finish(); }

  /// To start, to override, to stop, and what has happened.
  Runner& runner() { return runner_; }
  /// Why motion ended before its path, once the runner has ended (pipeline::MotionSource::failure).
  const std::optional<base::Diagnostic>& failure() const { return source_.failure(); }

 private:
  const machine::Machine machine_;
  LiveMoves moves_;
  pipeline::MotionSource source_;  ///< the planner's thread's
  Runner runner_;
};

}  // namespace leadscrew::realtime
