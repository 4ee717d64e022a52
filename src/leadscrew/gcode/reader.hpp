#pragma once
// From the text of a part program to moves: RS274/NGC as NIST IR 6556 defines it and LinuxCNC extends it.
//
//     bytes ─ProgramText─▶ lines ─BlockReader─▶ blocks ─Interpreter─▶ moves
//               ▲ go to     └─Flow └ ExpressionReader, Parameters     └ Frame, arcs, curves, DrillCycle
//               └────────────┘
//
// Read are all words, comments, block delete, %, numbered and named parameters, expressions (expression.hpp); the G
// codes in the table of codes.cpp; F, S and T; loops, conditions and subprograms (flow.hpp). Everything else is a
// diagnostic: unsupported-code, unsupported-o-word, unknown-code. A program begins in mm, XY, absolute, with centres of arcs relative, G64, G94, G98,
// G54 and no motion in force.
//
// Arcs: where the distances of the programmed centre to both ends differ, by at most 2√2·0.01 mm (2√2·0.001 inch under
// G20) or 0.1 % of the greater and 100 times that, the centre moves to the nearest point of the perpendicular bisector
// of the ends. An arc beyond half a turn whose ends nearly meet, so that this would move the centre by more than 0.001
// mm and twice the difference, keeps its centre and is followed by a line of the length of the difference (arc.hpp).
//
// Curves become one move each, a NurbsCurve in machine coordinates with clamped ends. F in any of a curve's blocks
// holds for all of it. It is inside travel or not as a curve, to 1e-6 mm, wherever its control points are.
//
//     G5 X_ Y_ I_ J_ P_ Q_     cubic: control points at I J from the start and at P Q from the end, in G17. Directly
//                              behind another G5, I and J may be missing: it goes on in the direction of that.
//     G5.1 X_ Y_ I_ J_         quadratic: control point at I J from the start, in G17.
//     G5.2 X_ Y_ P_ L_         NURBS of order L (3 … 6; 3 if not given) with uniform knots: a control point with its
//     X_ Y_ P_                 weight P (1 if not given) a block. The first point is where the tool stands; P of the
//     G5.3                     G5.2 block is its weight. G5.3 has no axis words, and no motion is in force behind it.
//                              In G91 all points are seen from the start of the curve.
//     G6.2 P_ K_ X_ Y_ R_ F_   NURBS of order P (2 … 6): a knot, a control point and its weight R (1 if not given) a
//     K_ X_ Y_ R_              block, then as many knots as the order. Axes not given keep their value; in G91 each
//     K_                       point is seen from the one before. The curve must begin where the tool stands, as
//                              exactly as the radii of an arc must agree; its first point need not be given.
//
// G5 … G5.3 are LinuxCNC's, with all nine axes: in G5 and G5.1 the other ones go in proportion to the parameter, in
// G5.2 they are coordinates of the control points. In LinuxCNC's dialect G5 and G5.1 hold for their block alone, and move
// X and Y. G6.2 is Fanuc's G06.2. Before its end a curve of many blocks takes
// nothing but points, knots, F, parameters and remarks: anything else is an unfinished-curve.
//
// A diagnostic's `source` is the line of its place, with as many bytes as the text has, so that the caret stands at its
// column; lines of more than 200 bytes are cut there, and a column beyond 180 of such a line has no `source`. An axis
// that leaves its travel is reported once until it is back, and no block moves meanwhile; an axis that the machine
// lacks is reported once. After 100 errors reading stops, and after 10 000 that only come again in a loop.

#include <cstdint>
#include <functional>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/borrowed.hpp>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/base/result.hpp>
#include <leadscrew/base/sink.hpp>
#include <leadscrew/gcode/dialect.hpp>
#include <leadscrew/gcode/machined_move.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/gcode/parameter_file.hpp>
#include <leadscrew/gcode/probed.hpp>
#include <leadscrew/gcode/remark.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/tool_table.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace leadscrew::surfaces {
class Passes;        // passes.hpp
class PassSource;    // passes.hpp
struct SurfaceForm;  // surface.hpp
}  // namespace leadscrew::surfaces

namespace leadscrew::gcode {

using base::ByteSource;
using base::TextOpener;

class Frame;          // frame.hpp
struct ModalState;    // modal_state.hpp
class SurfaceDrafts;  // surface_drafts.hpp

/// A place for what readings of a program find of its surfaces (ReaderOptions::surface_drafts), in bounded memory; any thread may use
/// it.
std::shared_ptr<SurfaceDrafts> new_surface_drafts();

/// A source over text that outlives it.
ByteSource text_source(std::string_view text);

/// Called once for each problem, in the order of the text.
using DiagnosticSink = std::function<void(const base::Diagnostic&)>;

/// Gets a line or an arc as the program tells it.
using MoveSink = std::function<void(const Move&)>;

/// How a program is read.
struct ReaderOptions {
  std::string file{};                       ///< name for diagnostics
  base::AxisVector start{};                 ///< machine coordinates, mm or degrees, where the program begins
  bool block_delete = true;                 ///< skip blocks that begin with '/'
  Dialect dialect = Dialect::leadscrew;     ///< what codes mean
  std::optional<PathMode> path_mode{};      ///< overrides G61, G61.1 and G64
  std::optional<double> tolerance{};        ///< mm; overrides P of G64; ≥ 0
  std::vector<NumberedValue> parameters{};  ///< of a parameter file: what they are where the program begins
  /// Called when the program has been read to its end without error, with what a parameter file then keeps; may be
  /// empty. It is ahead of motion by as much as the reader is.
  std::function<void(const std::vector<NumberedValue>&)> parameters_at_end{};
  RemarkSink remarks{};  ///< gets messages and log lines of the program; may be empty
  /// Loops and subprograms go back in the text: where it is opened anew. None: the reader keeps what it has read of it
  /// from the first of them on, up to 16 MiB, and there are no subprograms in files.
  TextOpener opener{};
  /// Of a text that is written while its motion goes on: has nothing come for a while? Asked where the next line is not there
  /// yet and lines under G43.5 are kept back, whose rotary axes are decided together: on true those are, as if no line
  /// followed. May wait a moment. None: the text comes as fast as it is read.
  std::function<bool()> is_dry{};
  std::int64_t fuel = 100'000'000;  ///< lines that are read in loops and subprograms, at most; ≥ 0
  bool asks_inputs = false;         ///< whoever reads gives Reader::input_is() of each M66, or at least may
  ProbingMoves probing = ProbingMoves::simulated;  ///< of G38.2 … G38.5 and G31
  bool warns_of_unset = false;  ///< lint-unset-parameter: a numbered parameter is read that never had a value
  /// Surfaces whose passes turn rotary axes: what this reading finds of them is kept there for others of the program, which then do
  /// not find it again; moves are the same with and without. None: nothing is kept.
  std::shared_ptr<SurfaceDrafts> surface_drafts{};
  /// Who makes the passes of surfaces, for instance a thread of its own while they are checked here. None, or where it gives
  /// none: the reader, as it comes to them. Moves are the same.
  std::function<std::unique_ptr<surfaces::PassSource>(surfaces::Passes&)> pass_source{};
  /// Surfaces are machined though the tool gouges where it touches, else `surface-gouge`; gouges of cutter compensation where
  /// ways meet are warnings, else errors, `cutter-gouge`.
  bool allows_gouging = false;
  /// Gets what cutter compensation (G41, G42) leads the tool's middle beside, and the ways in and out, before the moves that it
  /// becomes are handed out; none behind an error. May be empty.
  MoveSink programmed{};
  bool repeats = false;  ///< M99 in the main program: goes on from its beginning; otherwise ends it
};

/// Reads a part program block by block. Memory does not grow with the program. A block with a problem yields a
/// diagnostic and no move, and reading goes on, so that one pass reports every problem of a program; whoever moves a
/// machine first reads the whole program and moves only if it has no error. The machine and the tool table must outlive
/// the reader.
class Reader {
 public:
  /// Of a text, from its beginning. `sink` gets each problem; it may be empty.
  Reader(ByteSource source, base::Borrowed<machine::Machine> machine, base::Borrowed<machine::ToolTable> tools,
         ReaderOptions options, DiagnosticSink sink);
  ~Reader();
  Reader(Reader&&) noexcept;             ///< what is moved from may only be assigned to
  Reader& operator=(Reader&&) noexcept;  ///< the same

  /// The next move; false at the program's end (M2, M30, the closing %, the end of the text, or a source that failed).
  bool next(Move& move);

  /// An error that another room finds in the move handed out last: it goes to the sink with the place of the first word
  /// of its block, of a curve's first block, and is counted among the reader's own.
  void reject(const Move& move, base::Diagnostic problem);

  /// The same of a warning.
  void warn(const Move& move, base::Diagnostic problem);

  /// The same, at the F word of the block where it has one.
  void warn_of_feed(const Move& move, base::Diagnostic problem);

  /// What the input is that the event handed out last asks for (M66, base::is_input), or -1 where the time for it is
  /// over: before the next move is asked for, since what follows may depend on it. Without that inputs are off.
  void input_is(double value);
  /// How the probing move handed out last has ended, where the machine has a probe of its own (ProbingMoves::real):
  /// before the next move is asked for, since what follows may depend on it. Error: `probe-failed`, where G38.2 or G38.4
  /// did not find what it looks for.
  void probed(const Probed& result);

  /// Where the program's coordinates lie, in the block of the move handed out last.
  const Frame& frame() const;
  int system() const;               ///< the coordinate system in force there: 1 … 9, G54 … G59.3
  const ModalState& modal() const;  ///< the modes in force there

  /// Of the move handed out last: the surface that it machines.
  const MachinedMove& machined() const;

  /// The surfaces that G6.4 has defined so far and that have no fault, by their numbers; mm, in the program's coordinates.
  std::vector<std::shared_ptr<const surfaces::SurfaceForm>> surfaces() const;

  std::int64_t blocks() const;  ///< blocks read so far: lines that hold at least one word
  std::int64_t errors() const;  ///< diagnostics of severity error so far
  /// The names of the texts read so far, by the numbers that base::file() gives: the program's own, then subprograms.
  const std::vector<std::string>& files() const;
  /// Set when the source failed; the diagnostic is the source's.
  const std::optional<base::Diagnostic>& source_failure() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace leadscrew::gcode
