#pragma once
// Motion for a host, a controller or a program of its own: it owns all that it is made of.
//
//   auto motion = host::Motion::of_program(machine, text);            host::Motion motion(machine);
//   if (!motion) …                                                    motion.push(host::line({10, 0, 0}, 50));
//                                                                     motion.finish();
//                    while (std::size_t count = motion.next(words)) send(words first count);
//
//   auto planned = motion.plan();      all of it at once: planned->duration(), planned->at(0.25).velocity
//
// One thread at a time. Words are those of `leadscrew run`, bit for bit.

#include <cstddef>
#include <functional>
#include <leadscrew/base/event.hpp>
#include <leadscrew/base/result.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/host/move_queue.hpp>
#include <leadscrew/host/moves.hpp>
#include <leadscrew/host/program_texts.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/pipeline/trajectory.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace leadscrew::host {

/// How a motion is made.
struct MotionOptions {
  base::AxisVector start{};  ///< mm or degrees, where motion begins
  /// No more than about this is settled ahead, s > 0: a change of feed, a hold and an abort act within it and what
  /// the limits need. Words are the same for any.
  double slice = 0.05;
  pipeline::EventSink on_event{};  ///< of a program; with the word in whose period it happens
  // Of programs alone.
  std::string file{};               ///< for places in diagnostics
  machine::ToolTable tools{};       ///< that it may ask for
  SubprogramText subprogram{};      ///< asked once for each that the program calls and does not hold
  std::int64_t fuel = 100'000'000;  ///< lines that are read in loops and subprograms, at most; ≥ 0
  /// The host says what inputs are (M66), by input_is(). Otherwise they are off.
  bool has_inputs = false;
  /// Probing moves (G38.2 … G38.5, G31) end where probe_found() says so. Otherwise as the machine's simulated probe does.
  bool has_probe = false;
  /// Surfaces (G6.5) are machined though the tool gouges where it touches, and contours of cutter compensation where ways
  /// beside both meet. Otherwise these are errors, `surface-gouge` and `cutter-gouge`.
  bool allows_gouging = false;
  std::optional<gcode::PathMode> path_mode{};  ///< in place of G61, G61.1 and G64
  std::optional<double> tolerance{};           ///< mm, ≥ 0, in place of P of G64
  /// By which words step along curves; plan() is by arc length.
  interpolator::StepRule step_rule = interpolator::StepRule::arc_length;
  /// Asked every few KiB while a program is read, and every few milliseconds while planning takes long: with the share,
  /// 0 … 1, of the program that has been read, 0 of moves. Once it says false, what was asked for fails with
  /// `interrupted`; motion comes to rest.
  std::function<bool(double share)> goes_on{};
};

using pipeline::Trajectory, pipeline::TrajectoryState;

/// Somebody turns the feed override, or holds feed, while motion is under way.
struct FeedChange {
  double time = 0;    ///< s of the motion, as it is with the changes before
  double factor = 1;  ///< 0 … 2; 0 holds, until the next change
};

/// What plan() tells beside the motion. Events of the tool are then among those of the trajectory (MotionSource::tell_tool).
struct PlanNotes {
  /// Gets each move, in order, before it is planned, and what it has to do with a surface; may be empty.
  std::function<void(const gcode::Move&, const gcode::MachinedMove&)> on_move{};
  pipeline::Summary summary{};  ///< of all words; complete when plan() has succeeded
};

/// Along a program, which is checked whole before it moves, or along moves as they come.
class Motion {
 public:
  /// Along moves that push() gives, from options.start, smoothed within the machine's tolerance. The machine is sound
  /// (machine::validate), and the start is inside its travel.
  explicit Motion(machine::Machine machine, MotionOptions options = {});
  /// Of the text of a part program, which is read whole first; diagnostics get what is found, once. Errors: the first of
  /// these that is one.
  static base::Result<std::unique_ptr<Motion>> of_program(machine::Machine machine, std::string text,
                                                          MotionOptions options = {},
                                                          const gcode::DiagnosticSink& diagnostics = {});
  Motion(const Motion&) = delete;
  Motion& operator=(const Motion&) = delete;

  /// As MoveQueue::smooth().
  base::Result<void> smooth(double tolerance) { return moves_.smooth(tolerance); }
  /// As MoveQueue::push(). `motion-ended` of a program, too.
  base::Result<void> push(gcode::Move move) { return moves_.push(std::move(move)); }
  /// Motion comes to rest where the moves so far end; more may follow.
  void end_for_now() { moves_.end_for_now(); }
  /// No more moves will come.
  void finish() { moves_.finish(); }

  /// All of it, planned from its beginning to its end as nobody intervenes, by the feed override as it stands: of a program,
  /// or of the moves that have been pushed so far, with rest behind the last. A probe of its own touches
  /// where probing moves lead. Words stay those that they are; this plans beside them. `notes` may be null. `changes`, in the
  /// order of time, act from the first instant that the limits allow: motion that is held brakes, stands, and goes on with the
  /// next of them, or ends there. Errors: `motion-moves` where next() has taken some of the moves already; `override` while
  /// held, and of a change that is none; failure().
  base::Result<Trajectory> plan(PlanNotes* notes = nullptr, std::span<const FeedChange> changes = {}) const;

  /// The next words, as many as there are room and motion for: fewer than asked only where progress() says why.
  std::size_t next(std::span<base::Word> words);
  /// Why next() gave less than it was asked for.
  pipeline::Progress progress() const { return program_->progress(); }
  /// Why motion ended before its path did.
  const std::optional<base::Diagnostic>& failure() const { return program_->failure(); }

  /// Programmed feed (not rapids) is multiplied by this, 0 … 2; 0 holds. As far as the program allows (M48 to M50, M53):
  /// what it does not is remembered, and counts when it does. Errors: `override`.
  base::Result<void> override_feed(double factor);
  /// Adaptive feed, 0 … 1: a second factor of the feed where the program asks for it, by M52; 0 holds. Errors:
  /// `override`.
  base::Result<void> adapt_feed(double factor);
  /// The M66 that motion rests for while progress() is wants_input; none otherwise.
  std::optional<base::Event> input() const;
  /// What that has found: the input's value, 0 or 1 of a digital one, or -1 where the time for it is over. Errors:
  /// `input-idle` where none is asked for, `move-finite`.
  base::Result<void> input_is(double value);
  /// What the probing move looks for along which the last word lies: of motions with a probe of their own
  /// (MotionOptions::has_probe).
  gcode::ProbeSearch probing() const;
  /// The probe has found that, where the axes stand at this position, mm or degrees, or else at that of the last word:
  /// motion comes to rest within a slice and what the limits need, and goes on as the program does. Words that have been
  /// given belong to it: ask for few of them while probing. The first call counts; at the first word along the move, at
  /// rest, it says that this is so before the move begins. Errors: `probe-idle` where nothing is
  /// being probed, `move-finite`.
  base::Result<void> probe_found(const std::optional<base::AxisVector>& position = {});

  /// Motion ends, at rest on its path, within a slice and what the limits need; what was pushed behind is forgotten.
  void abort();
  /// After its last word: stands here, mm or degrees, and waits for moves; words count from 0 again. Errors:
  /// `motion-moves` before that, `move-finite`, `travel`.
  base::Result<void> reset(const base::AxisVector& position);

  /// Of all words so far.
  const pipeline::Summary& summary() const { return program_->summary(); }
  /// Where the moves that were pushed end.
  const base::AxisVector& end() const { return moves_.end(); }

 private:
  Motion(machine::Machine machine, MotionOptions options, std::shared_ptr<ProgramTexts> texts);
  void begin();
  template <class Joined>
  void join(std::optional<Joined>& joined, pipeline::MoveInput moves) const;
  using ChunkSink = std::function<void(const planner::Chunk&)>;
  using FeedChanges = std::span<const FeedChange>;
  base::Result<Trajectory> plan_from(pipeline::MotionSource& source, FeedChanges changes,
                                     const ChunkSink& sink = {}) const;
  base::Result<Trajectory> plan_noted(pipeline::MotionSource& source, FeedChanges changes, PlanNotes& notes) const;

  const machine::Machine machine_;
  MotionOptions options_;
  std::shared_ptr<ProgramTexts> texts_;  ///< of a program; else none
  MoveQueue moves_;
  std::optional<pipeline::Program> program_;
  double feed_override_ = 1;
  base::AxisVector last_position_{};  ///< of the last word; of motions with a probe alone
};

}  // namespace leadscrew::host
