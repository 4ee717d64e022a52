#pragma once
// From text, or from moves that a host gives, to motion: reader, tool path and planner joined, a chunk a call, in
// constant memory.
//
// Whoever moves a machine has read the whole program before and found no error in it. It is read again to move, and
// that second reading must find the same: motion ends, at rest on the path, as soon as it reports an error, the source
// fails, or `unchanged` says that the program is another by now.

#include <functional>
#include <leadscrew/base/borrowed.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <leadscrew/pipeline/move_input.hpp>
#include <leadscrew/planner/planner.hpp>
#include <leadscrew/toolpath/builder.hpp>
#include <optional>
#include <utility>

namespace leadscrew::pipeline {

/// A program that has an error must not be moved: read it whole first. The machine and the tool table must outlive
/// this.
class MotionSource {
 public:
  /// diagnostics: gets every diagnostic of this reading; may be empty.
  MotionSource(gcode::ByteSource source, base::Borrowed<machine::Machine> machine,
               base::Borrowed<machine::ToolTable> tools, const gcode::ReaderOptions& options,
               gcode::DiagnosticSink diagnostics);
  /// Of moves, from `start`, mm or degrees. The machine must outlive this.
  MotionSource(MoveInput moves, base::Borrowed<machine::Machine> machine, const geometry::Point& start);
  MotionSource(const MotionSource&) = delete;  // the reader tells this one what it finds
  MotionSource& operator=(const MotionSource&) = delete;

  /// Called with what passes on its way to the planner.
  std::function<void(const gcode::Move&)> on_move;
  std::function<void(const toolpath::Element&)> on_element;  ///< the same
  /// Is the program still the one that was checked? Asked after each piece of text that is read, before anything is
  /// made of it, and before each chunk. An error it returns ends the motion. Absent: it cannot change.
  std::function<base::Result<void>()> unchanged;

  /// Reads and plans as far as the next chunk needs; none at the program's end, while motion is held, while it
  /// wants_moves(), and from then on when the motion has failed or was aborted. What was handed out stays good: a cycle that gets no chunk runs the stop tail of the
  /// last, and rests on the path of the program that was checked.
  std::optional<planner::Chunk> next();

  /// Asked every few milliseconds while a window of motion is planned. Once it says true motion ends as if it had
  /// failed, with the diagnostic `interrupted`.
  void stop_when(std::function<bool()> asked) { planner_.stop_when(std::move(asked)); }

  /// Why motion ends before the program does: the first error of this reading, be it the reader's (which its sink gets
  /// as well), the source's or that of `unchanged`; `travel`, where the path leaves that of an axis; or that it was
  /// interrupted.
  const std::optional<base::Diagnostic>& failure() const { return failure_; }
  /// The warning `planning-simplified`, where parts of the path are slower than they need be: planning them for the
  /// machine's own limits would have taken too much work (planner::Planner::simplified_sections).
  std::optional<base::Diagnostic> warning() const;

  /// Before the first chunk: events say where a move begins whose feed is not that of the one before
  /// (base::Event::Kind::programmed_feed).
  void tell_feed() { builder_.tell_feed(); }
  /// The same of the tool that a move is made with (base::Event::Kind::tool_offset, tip_control).
  void tell_tool() { builder_.tell_tool(); }

  /// Before the first chunk: the cycle follows the machine's spindle, if it has one (planner::Planner::follow_spindle).
  void follow_spindle() {
    if (machine_.threads_follow()) builder_.tell_revolutions();
    planner_.follow_spindle();
  }

  /// What the move that on_move gets has to do with a surface.
  const gcode::MachinedMove& machined() const { return reader_ ? reader_->machined() : no_surface; }

  /// Blocks of the program read so far.
  std::int64_t blocks() const { return reader_ ? reader_->blocks() : 0; }
  /// Was there no chunk because a probing move is under way that a real probe ends (gcode::ProbingMoves::real)? All of it
  /// has been handed out.
  bool waits_for_probe() const { return probing_ && !is_cut_short(); }
  /// The probing move that is being handed out; none otherwise.
  const std::optional<gcode::Move>& probing() const { return probing_; }
  /// Of that move no more chunks come.
  void end_probing() { probing_ends_ = true; }
  /// Motion rests by the tail of the last chunk, and this is what the probe has found: reads on from there. What is left of
  /// the probing move is forgotten.
  void probed(const gcode::Probed& result);
  /// Where motion rests by the tail of the last chunk, mm or degrees.
  const geometry::Point& rest() const { return planner_.rest(); }

  /// Was there no chunk for want of moves that are not known yet?
  bool wants_moves() const { return wants_moves_; }
  /// Was there no chunk because the program asks for an input (ReaderOptions::asks_inputs)? All before it has been handed
  /// out.
  bool wants_input() const { return input_ && !is_cut_short() && !planner_.is_held(); }
  /// The M66 that asks.
  const std::optional<base::Event>& input() const { return input_; }
  /// What it has found (Reader::input_is); none: as if the input were off. Reads on.
  void input_is(std::optional<double> value) {
    if (value) reader_->input_is(*value);
    input_.reset();
  }
  /// No chunk comes any more.
  void abort() { aborted_ = true; }
  /// Has the motion failed, or been aborted?
  bool is_cut_short() const { return failure_ || aborted_; }
  /// To change what is planned, between two chunks.
  planner::Planner& planner() { return planner_; }
  /// Has the whole program been read?
  bool has_read_all() const { return !reading_; }

 private:
  gcode::ByteSource watched(gcode::ByteSource source);
  gcode::DiagnosticSink watched(gcode::DiagnosticSink diagnostics);
  Supply read(gcode::Move& move);
  bool read_move();
  void begin_probing(const gcode::Move& move);
  bool settle();
  bool push(toolpath::Element element);
  std::optional<planner::Chunk> pop();

  static inline const gcode::MachinedMove no_surface{};

  const machine::Machine& machine_;
  geometry::Point start_;
  double tolerance_ = 0;  ///< the greatest so far, mm
  std::optional<base::Diagnostic> failure_;
  std::optional<gcode::Reader> reader_;
  MoveInput moves_;
  toolpath::Builder builder_;
  planner::Planner planner_;
  bool reading_ = true;
  bool wants_moves_ = false;
  bool asks_inputs_ = false;
  std::optional<base::Event> input_;  ///< that is asked for
  bool probes_ = false;               ///< a real probe ends probing moves
  std::optional<gcode::Move> probing_;
  bool probing_ends_ = false;
  bool aborted_ = false;
};

}  // namespace leadscrew::pipeline
