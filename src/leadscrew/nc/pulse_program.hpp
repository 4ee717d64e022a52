#pragma once
// A part program as steps of reference pulses, as many a call as are wanted, in bounded memory.
//
//   text ─gcode::Reader─▶ moves ─BlockMaker─▶ blocks ─look-ahead─▶ RampedFeed ──command──▶ BlockInterpolator ─▶ steps
//
// Steps happen at ticks of the clock, the first at tick 1 or later; at each of them an axis makes at most one step. Of
// any method, the steps of a program sum to its end on the lattice, exactly, and no axis exceeds its velocity by more
// than a step or two over any time. With Shape::accelerate and no override, moreover, for any axis, any time t and any
// W, |p(t + W) − 2 p(t) + p(t − W)| ≤ a W² + 6 steps, for a the axis' acceleration in steps/s²: it moves as something
// that keeps the limit does, but for what a lattice of steps cannot show.

#include <functional>
#include <leadscrew/base/event.hpp>
#include <leadscrew/nc/block_look_ahead.hpp>
#include <leadscrew/nc/block_maker.hpp>
#include <leadscrew/nc/ramped_feed.hpp>

namespace leadscrew::nc {

/// Asked before every block: is the work still wanted?
using GoesOn = std::function<bool()>;

/// What is wrong with a block for whoever is to make its pulses, or nothing.
using BlockCheck = std::function<std::optional<base::Diagnostic>(const Block&)>;

/// Reads and plans a whole program without a pulse: each problem goes to the sink, in the order of the text, those of
/// the reader too. A block in which the reader finds an error is not planned, and after 100 errors in all it stops. How
/// many there are, up to where it no longer goes on; a program that has one must not be moved. `more` looks at each block
/// too, if it is given.
std::int64_t check_pulses(gcode::ByteSource source, const machine::Machine& machine, const machine::ToolTable& tools,
                          const gcode::ReaderOptions& reading, const PulseOptions& options,
                          const gcode::DiagnosticSink& sink, const GoesOn& goes_on, const BlockCheck& more = {});

class PulseProgram {
 public:
  /// The machine and the tool table must outlive it.
  PulseProgram(gcode::ByteSource source, const machine::Machine& machine, const machine::ToolTable& tools,
               const gcode::ReaderOptions& reading, const PulseOptions& options, gcode::DiagnosticSink sink);

  /// The next steps in order, all those of the last tick too: of one clock at least, of one block, and as many as find
  /// buffer, which is for base::axis_count or more. None at the program's end, and at its first problem.
  std::span<const steps::StepEvent> next(std::span<steps::StepEvent> buffer);

  /// Of the part program: where the last steps come from.
  base::Line line() const { return planned_.block.line; }

  /// Thousandths of the programmed feed, 1 … 2000, from the next command on; clamped at each block's greatest word.
  void override_feed(int thousandths);

  /// Of the clock, so far; once next() has had no step the whole duration, dwells at the end included.
  std::int64_t ticks() const { return tick_; }
  std::int64_t commands() const { return commands_; }  ///< of feed, so far
  std::int64_t errors() const;                         ///< of reading and planning, so far
  const std::optional<base::Diagnostic>& source_failure() const { return reader_.source_failure(); }

 private:
  bool begin_block();
  void fill();
  void aim();
  void begin_feed(const BlockLookAhead::Next& next, double speed);
  double speed() const;

  PulseOptions options_;
  gcode::Reader reader_;
  BlockMaker maker_;
  BlockLookAhead ahead_;
  RampedFeed feed_;
  gcode::Move move_;
  bool reading_ = true;
  PlannedBlock planned_;
  BlockInterpolator interpolator_;
  std::int64_t commands_left_ = 0;
  std::int64_t override_ = 1000;
  std::int64_t tick_ = 0, commands_ = 0;
};

}  // namespace leadscrew::nc
