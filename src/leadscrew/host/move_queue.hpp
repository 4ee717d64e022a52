#pragma once
// Moves that a host gives one by one: each checked and joined to the one before when it is pushed, in their order when
// they are planned.

#include <array>
#include <deque>
#include <leadscrew/base/borrowed.hpp>
#include <leadscrew/base/result.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/pipeline/move_input.hpp>
#include <vector>

namespace leadscrew::host {

/// One thread at a time. The machine must outlive it.
class MoveQueue {
 public:
  /// From `start`, mm or degrees; smoothed within the machine's tolerance.
  MoveQueue(base::Borrowed<machine::Machine> machine, const base::AxisVector& start)
      : machine_(machine), last_{start}, tolerance_(machine->tolerance) {}

  /// How moves from now on are joined: within so many mm of them (0.0002 or more smooth), or as they are, without a
  /// needless stop (0). Errors: `tolerance`, where it is below 0 or not finite.
  base::Result<void> smooth(double tolerance);
  /// The next move, behind the one before (put_behind()). Codes: those of put_behind(), `motion-ended` behind finish(). A
  /// move that is refused changes nothing.
  base::Result<void> push(gcode::Move move);
  /// Several, one behind the other: all of them, or, where one is refused, none.
  base::Result<void> push(std::vector<gcode::Move> moves);
  /// The same of a move that the reader of a program has made (gcode::Reader), as it is; not behind finish().
  void append(gcode::Move move);
  /// Motion comes to rest where the moves so far end; more may follow.
  void end_for_now();
  /// No more moves will come.
  void finish() { finished_ = true; }
  /// Forgets the moves that have not been given, and takes no more.
  void abandon();
  /// Empty and open again, from `start`; joined as before.
  void restart(const base::AxisVector& start);

  /// The next of them, to be planned.
  pipeline::Supply give(gcode::Move& move);

  /// Those that have not been given.
  const std::deque<gcode::Move>& waiting() const { return moves_; }
  /// Have any been given?
  bool has_given() const { return has_given_; }
  /// Where the last one that was pushed ends.
  const base::AxisVector& end() const { return last_.end; }

 private:
  /// Of the last move that was pushed.
  struct Last {
    base::AxisVector end;
    base::Line line{};
    bool is_of_tip = false;
    std::array<double, 3> tool{};
  };

  const machine::Machine& machine_;
  std::deque<gcode::Move> moves_;
  Last last_;
  double tolerance_;
  bool finished_ = false;
  bool has_given_ = false;
};

}  // namespace leadscrew::host
