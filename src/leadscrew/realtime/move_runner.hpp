#pragma once
// Moves on time: whoever pushes them may be slow, and motion runs dry without being cut up.
//
//   push() ─▶ queue ─▶ planner's thread ─▶ cyclic thread ─▶ sink        any thread pushes
//
// Motion begins, and comes to rest for want of moves, as the Feeder says (Supply).

#include <cstdint>
#include <leadscrew/base/result.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/host/move_queue.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/pipeline/motion_source.hpp>
#include <leadscrew/realtime/runner.hpp>
#include <mutex>

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
  base::Result<void> smooth(double tolerance);
  /// As host::MoveQueue::push().
  base::Result<void> push(gcode::Move move);
  /// No more moves will come: the runner ends where the last ends.
  void finish();

  /// To start, to override, to stop, and what has happened.
  Runner& runner() { return runner_; }
  /// Why motion ended before its path, once the runner has ended (pipeline::MotionSource::failure).
  const std::optional<base::Diagnostic>& failure() const { return source_.failure(); }

 private:
  pipeline::Supply give(gcode::Move& move);
  std::optional<Drought> drought();
  void end_for_now();

  const machine::Machine machine_;
  std::mutex mutex_;
  host::MoveQueue moves_;          ///< the mutex's, like these
  std::int64_t last_came_ = 0;     ///< ns
  bool is_open_ = false;           ///< has anything been pushed behind the last rest?
  pipeline::MotionSource source_;  ///< the planner's thread's
  Runner runner_;
};

}  // namespace leadscrew::realtime
