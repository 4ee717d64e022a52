#pragma once
// The rooms joined into one: the text of a part program, or moves, go in, words come out, one a call, in constant
// memory.
//
//        gcode::Reader    toolpath::Builder    planner::Planner    interpolator::Interpolator
//   text ─────────────▶ moves ─────────────▶ path ──────────────▶ motion ─────────────▶ words

#include <cstdint>
#include <functional>
#include <leadscrew/base/borrowed.hpp>
#include <leadscrew/base/event.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/interpolator/interpolator.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <leadscrew/pipeline/motion_source.hpp>
#include <leadscrew/pipeline/move_input.hpp>
#include <leadscrew/planner/time_bound.hpp>
#include <optional>
#include <span>

namespace leadscrew::pipeline {

/// What the motion was, up to the last word made.
struct Summary {
  std::int64_t blocks = 0;          ///< read
  std::int64_t moves = 0;           ///< travelled: lines and arcs
  std::int64_t words = 0;           ///< servo periods
  double time_s = 0;                ///< words · period
  double dwell_s = 0;               ///< asked for by G4 and the like
  double bound_s = 0;               ///< the least time without a jerk limit (planner::TimeBound); known at the end
  double length_mm = 0;             ///< of the tool path, as Word::path_length
  double feed_programmed_max = 0;   ///< mm/s; 0 if the program has only rapids
  double tolerance_mm = 0;          ///< the largest that applied
  constraints::LimitRatios plan{};  ///< analytically, from the motion; of threads at the speed of S
  /// Of lines in step with a simulated spindle (Machine::threads_follow); none where there is none.
  interpolator::ThreadFigures threads{};
};

/// Counts a move that will be travelled: moves, dwell_s, feed_programmed_max, tolerance_mm.
void account(const gcode::Move& move, Summary& summary);

/// Called for each event once, in order: with the word in whose period motion passes its place, before that is returned.
using EventSink = std::function<void(const base::PassedEvent&)>;

/// Why there is a word, or none.
enum class Progress : std::uint8_t {
  moving,       ///< there is one
  wants_moves,  ///< what is known of the path has been planned as far as it can be; more moves may come
  held,         ///< at rest, until the feed override is above 0
  ended,        ///< the last word, at rest, has been made
  wants_input,  ///< at rest, until input_is() says what the input is that the program asks for
};

/// A program that has an error must not be moved: read it whole first (gcode::Reader), then run it. The machine and the
/// tool table must outlive the program.
///
///     while (program.prepare()) send(program.cycle());
class Program {
 public:
  /// Of a text, from its beginning. `diagnostics` gets those of this reading; it may be empty.
  Program(gcode::ByteSource source, base::Borrowed<machine::Machine> machine, base::Borrowed<machine::ToolTable> tools,
          const gcode::ReaderOptions& options, gcode::DiagnosticSink diagnostics);
  /// Of moves, from `start`, mm or degrees. The machine must outlive this.
  Program(MoveInput moves, base::Borrowed<machine::Machine> machine, const geometry::Point& start);

  Program(const Program&) = delete;  // the interpolator looks into the chunk that is kept here
  Program& operator=(const Program&) = delete;

  /// Before the first word: how NURBS curves are stepped along.
  void step_by(interpolator::StepRule rule) { interpolator_.step_by(rule); }

  /// As of planner::Planner: chunks from now on are about so long, s > 0, and programmed feed is multiplied by a
  /// factor, 0 … 2, from the next chunk on; 0 holds.
  void slice(double seconds) { source_.planner().slice(seconds); }
  /// The same.
  void override_feed(double factor) { source_.planner().override_feed(factor); }

  /// Adaptive feed, as of planner::Planner.
  void adapt_feed(double factor) { source_.planner().adapt_feed(factor); }
  /// The M66 that the program waits at, while it wants_input.
  const std::optional<base::Event>& input() const { return source_.input(); }
  /// What it has found: the input's value, or -1 where the time for it is over. The program is read on from there.
  void input_is(double value) { source_.input_is(value); }

  /// Before the first word: who is told of events.
  void on_event(EventSink sink) { events_ = std::move(sink); }
  /// Before the first word: events of programmed feed come too (MotionSource::tell_feed).
  void tell_feed() { source_.tell_feed(); }
  /// Likewise those of the tool (MotionSource::tell_tool).
  void tell_tool() { source_.tell_tool(); }
  /// Called for each move before it is planned.
  void on_move(std::function<void(const gcode::Move&)> sink) { moves_ = std::move(sink); }
  /// What that move has to do with a surface.
  const gcode::MachinedMove& machined() const { return source_.machined(); }
  /// Before the first word: how to ask whether the program is still the one that was checked
  /// (MotionSource::unchanged).
  void watch(std::function<base::Result<void>()> unchanged) { source_.unchanged = std::move(unchanged); }

  /// Reads and plans as far as the next word needs; false when the last word (at rest, at the end) has been made, and
  /// while there is none for another reason (progress()). The first word is that of t = 0, at rest at the start; a
  /// program that moves nothing has that one word. Motion that fails goes through its stop tail to a last word at rest
  /// on the path.
  bool prepare();
  /// What the last prepare() found.
  Progress progress() const { return progress_; }
  /// Motion ends by the stop tail of what has been handed out: no later than that of the chunk in motion; in step with the
  /// spindle as soon as the limits allow.
  void abort();

  /// Before the first word: whether to end now, asked while planning takes long (MotionSource::stop_when).
  void stop_when(std::function<bool()> asked) { source_.stop_when(std::move(asked)); }

  /// The next word; prepare() must have said true.
  base::Word cycle();
  /// The next words, bit for bit as cycle() gives them, as many as `words` holds and nobody has to plan for; at least
  /// one. prepare() must have said true; not empty.
  std::span<const base::Word> cycle(std::span<base::Word> words);

  /// The probing move (G38.2 … G38.5, G31) along which the last word lies, which a real probe ends
  /// (gcode::ProbingMoves::real); none otherwise.
  const gcode::Move* probing() const;
  /// The probe has found what that move looks for, at this position, mm or degrees: motion comes to rest within a slice and
  /// what the limits need, and goes on from there as the program does. Of several calls the first counts. Nothing without
  /// a probing move.
  void probe_found(const base::AxisVector& position);

  /// Will the next prepare() read or plan, or is the motion of the next word there already?
  bool will_plan() const { return !ended_ && interpolator_.wants_chunk(); }

  /// Of all words so far.
  const Summary& summary() const { return summary_; }
  /// Why motion ends before the program does (MotionSource::failure).
  const std::optional<base::Diagnostic>& failure() const { return source_.failure(); }
  /// Of a motion that is slower than it need be (MotionSource::warning).
  std::optional<base::Diagnostic> warning() const { return source_.warning(); }

 private:
  void watch_path();
  Progress find_word();
  bool plan_next();
  void stop();
  void conclude_probing();
  void tell_events(std::size_t count, base::Tick tick);
  void account(const gcode::Move& move);
  void account(const base::Word& word);

  const machine::Machine& machine_;
  constraints::Constraints constraints_;
  MotionSource source_;
  planner::TimeBound bound_;
  interpolator::Interpolator interpolator_;
  planner::Chunk chunk_;
  EventSink events_;
  std::function<void(const gcode::Move&)> moves_;
  std::size_t told_ = 0;                ///< events of the chunk
  std::optional<gcode::Probed> found_;  ///< by the probe, along the move that is under way
  base::Line last_line_{};              ///< of the last word
  base::Tick line_begin_{};             ///< of the first word of that line
  bool bound_is_known_ = false;
  Progress progress_ = Progress::moving;
  bool ended_ = false;  ///< but for the last word
  Summary summary_;
};

}  // namespace leadscrew::pipeline
