#pragma once
// Lines whose ends are told by the tool's direction (G43.5; Fanuc, "Tool center point control", type 2).
//
//     G1 X Y Z I J K     tip along a straight line of the workpiece, direction along the great circle to I J K
//
// Two pairs of angles of the rotary axes hold a tool in a direction, and each may be whole turns away. Which it is, is chosen
// for a whole connected run of lines (kinematics::VectorRun); so lines are kept back, and the events between them, until the
// run ends: where anything asks where rotary axes are. Then each line becomes moves of the tip and the rotary axes, as a
// program under G43.4 would tell them: under G64 lines of a degree at most, on the exact path, and where G64 allows too little
// for rounding, one smooth curve.
//
// A rapid to another direction begins a run: it turns rotary axes straight, to where the lines behind it go on best.
// Where more than kinematics::VectorRun::most_vertices are kept back, the first half of them is decided.

#include <deque>
#include <leadscrew/gcode/motion.hpp>
#include <leadscrew/kinematics/vector_run.hpp>
#include <optional>
#include <vector>

namespace leadscrew::gcode {

class VectorMoves : Part {
 public:
  VectorMoves(const Context& context, Motion& motion, Travel& travel, Outbox& outbox)
      : Part(context), motion_(motion), travel_(travel), outbox_(outbox) {}

  /// G43.5: the tool keeps its direction until a line changes it. I, J and K beside it, without a motion, hold from the next
  /// line on.
  void begin(const Block& block);
  /// Something else turns the rotary axes.
  void forget_direction() { direction_.reset(); }
  /// G0 and G1 under G43.5. Errors: `tool-vector`, `pose-out-of-reach`, `rotary-travel`, `pole-too-sharp`.
  void line(const Block& block);
  /// What happens behind the lines so far.
  void keep(Move& event);

  /// Are there lines whose angles are not known yet?
  bool is_open() const { return run_.has_value(); }
  /// Has anything been kept back?
  bool any() const { return is_open() || !lines_.empty() || !events_.empty(); }
  /// Whether a block can be executed while they are not known.
  bool goes_on(const Block& block) const;
  /// Decides them all. The program then stands where they have led.
  void settle();
  /// The next move of those that are decided. Error: `travel`, at the line's own block.
  bool take(Move& move);
  /// The place of the line whose move was taken last, if that is this line.
  const KeptPlace* place_of(base::Line line) const { return taken_ && taken_->line == line ? &*taken_ : nullptr; }

 private:
  using Vector = kinematics::Vector;

  /// A line of the program; of the end, the rotary axes are not known.
  struct KeptLine {
    base::AxisVector end{};
    Feed feed;
    bool stops = false;  ///< exactly at its end (G9)
    KeptPlace place;
  };
  struct KeptEvent {
    std::size_t before = 0;  ///< the number of the line that it comes before
    Move move;
  };
  /// A part of a line, with the number of the line.
  struct LinePart {
    std::size_t line = 0;
    kinematics::RunVertex vertex;
    double share = 0;  ///< of the line, at its end; set where the line begins
  };

  std::optional<Vector> direction_of(const Block& block);
  Vector direction();
  kinematics::Angles<double> angles_at(const base::AxisVector& place) const;
  void set_angles(const kinematics::Angles<double>& angles);
  void set_position(const base::AxisVector& place);
  double orientation_tolerance() const;
  bool blends() const;
  void lead(const Vector& direction, const base::AxisVector& target, bool is_free);
  void collect(bool is_finished);
  void report(const kinematics::VectorRunFailure& failure, const KeptPlace& place);
  void fail();
  // vector_parts.cpp
  bool begin_line();
  void end_line();
  void set_shares();
  bool is_inside();
  base::AxisVector place_at(const LinePart& part) const;
  std::size_t parts_of_curve() const;
  bool make_move(Move& move);
  void make_curve(Move& move, std::size_t count) const;
  void tell_of_pole_turn();
  std::size_t next_number() const { return taken_lines_ + lines_.size(); }

  Motion& motion_;
  Travel& travel_;
  Outbox& outbox_;
  std::optional<kinematics::VectorRun> run_;
  std::optional<Vector> direction_;  // of the last line; none: as the axes stand
  // Lines are counted from the program's beginning on.
  std::deque<KeptLine> lines_;
  std::deque<KeptEvent> events_;
  std::deque<LinePart> parts_;
  std::size_t taken_lines_ = 0;    // the number of lines_.front()
  std::size_t decided_lines_ = 0;  // all parts of the lines before this are known
  std::size_t run_begin_ = 0;      // the number of the run's first line
  base::Line run_begin_line_{};
  std::size_t first_segment_ = 0;  // the number of the line that is segment 0 of the run
  bool is_start_open_ = false;     // the run's first line is free, and its part is not known yet
  bool is_in_line_ = false;        // moves of lines_.front() are being taken
  std::size_t parts_left_ = 0;     // of lines_.front(), where they are
  double share_ = 0;               // of lines_.front(): where the moves taken so far have led
  base::AxisVector line_begin_{};  // where lines_.front() begins
  base::AxisVector at_{};          // where the moves taken so far have led
  std::optional<KeptPlace> taken_;
  Move event_;
};

}  // namespace leadscrew::gcode
