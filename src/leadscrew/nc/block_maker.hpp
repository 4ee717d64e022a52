#pragma once
// Moves of a part program to blocks on the lattice of single steps.
//
//   line    one block, rapids too
//   arc     a block a turn; the axes beside its plane are rounded where the turns end. Where the lattice shows no arc
//           (lattice_arc.hpp) it is a line.
//   curve   chords, as far from it as the machine's chord error allows
//   dwell   so many clocks, rounded
//
// Every end is rounded to the lattice from machine zero, whatever the path there, so that a program's steps sum to its
// end. An arc needs one basic length unit in both axes of its plane. Moves of the tool's tip (tool centre point control)
// are refused.

#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/geometry/nurbs.hpp>
#include <leadscrew/nc/feed_words.hpp>
#include <optional>
#include <vector>

namespace leadscrew::nc {

/// Nearest steps from machine zero; of an axis that the machine lacks 0.
LatticeVector on_lattice(const base::AxisVector& position, const machine::Machine& machine);

class BlockMaker {
 public:
  /// Where the program begins, machine coordinates; the machine must outlive this.
  BlockMaker(const machine::Machine& machine, const PulseOptions& options, const base::AxisVector& start);

  /// Begins anew there, machine coordinates.
  void stand_at(const base::AxisVector& position) { at_ = on_lattice(position, machine_); }

  /// A line, arc, curve or dwell, once the one before has no block left.
  void load(const gcode::Move& move);

  /// Its next block with at least one step, or its dwell; nothing when there is none left. A diagnostic is of the whole
  /// move: none of its blocks follow, though the lattice place moves on to its end. Codes beside those of with_words():
  /// pulse-arc-units, pulse-register, pulse-tip-control.
  std::optional<base::Result<PlannedBlock>> next();

  /// Of the arc counted last.
  const ArcTape& tape() const { return tape_; }
  /// After the block last made.
  const LatticeVector& at() const { return at_; }

 private:
  struct Chords {
    std::vector<geometry::Nurbs> pieces;
    std::size_t piece = 0;
    double at = 0;         // length along the piece
    bool goes_on = false;  // from a chord of this piece
  };

  std::optional<base::Result<PlannedBlock>> of_tip();
  std::optional<base::Result<PlannedBlock>> dwell();
  std::optional<base::Result<PlannedBlock>> wait(double seconds) const;
  std::optional<base::Result<PlannedBlock>> line_or_wait(const LatticeVector& end, const Part& part);
  std::optional<base::Result<PlannedBlock>> next_turn();
  std::optional<base::Result<PlannedBlock>> next_chord();
  std::optional<base::Result<PlannedBlock>> line_to(const LatticeVector& end, const Part& part);
  std::optional<base::Result<PlannedBlock>> turn_to(const LatticeVector& end, double angle);
  std::optional<base::Result<PlannedBlock>> plan(Block block, const Part& part);
  std::optional<base::Diagnostic> arc_problem() const;
  std::optional<base::Diagnostic> register_problem(const Block& block) const;
  std::optional<base::Result<PlannedBlock>> give_up(base::Diagnostic problem);

  const machine::Machine& machine_;
  PulseOptions options_;
  LatticeVector at_;
  gcode::Move move_;
  bool left_ = false;  // is there something of the move left?
  bool told_of_tip_ = false;
  int turn_ = 0;          // of an arc, begun so far
  double sweep_ = 0;      // of the whole arc, radians > 0
  bool closing_ = false;  // a whole turn stood for an arc that is nearly one
  Chords chords_;
  ArcTape tape_;
};

}  // namespace leadscrew::nc
