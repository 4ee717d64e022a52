#pragma once
// The referee: judges a train of words against the program and the machine it was made for. It shares no code with the
// rooms that make motion; it reads the program's moves and has formulas of its own for lines, arcs and NURBS curves.
//
// Limits: first, second and third differences of each axis, as if the machine stood still before the first word and
// after the last (derivatives.hpp).
//
// Deviation: the distance between words and programmed path in both directions, matched in order: of each word to the
// path, and of the path between two matches to the chord between the two words, less a·T²/8, by which a motion within
// acceleration a may leave its chord (matcher.hpp). Length is Euclid's over all axes, a rotary axis at a radius of
// 50 mm.
//
// Under tool centre point control all that is of the tool's tip in the workpiece and of the rotary axes, by kinematics of
// the referee's own (pose.hpp); tip and direction of the tool are told apart as well.
//
// Ends: the first word at the program's start, the last at its end.
//
// Rest: where the program asks for it between two moves (stop_check.hpp).
//
// Feed: the travel from word to word against the programmed feed (feed_check.hpp), and against the planned one where that
// is constant (feed_ripple.hpp).
//
//     words    ●──●──●──●         ●──●     the word at ▲ is too far from the path: "deviation"
//                        ╲  ●  ╱
//                           ▲
//     path     ──────────┐     ┌─────      both lower corners are too far from every chord: "skipped path"
//                        └─────┘
//
// A trace is a set of samples: what happened between two words and left no sign in them cannot be judged. At 1 ms and
// 1 m/s² that is an eighth of a micrometre (sampling_allowance.hpp).

#include <array>
#include <cstdint>
#include <functional>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/line.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/machine/machine.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::referee {

/// Largest value over limit, from differences of words less their rounding bound 8·ulp(max |q|)/Tᵏ.
struct AxisVerdict {
  base::Axis axis{};              ///< whose
  double velocity_ratio = 0;      ///< of the first differences
  double acceleration_ratio = 0;  ///< of the second
  double jerk_ratio = 0;          ///< of the third
};

/// A limit or a tolerance that was not kept.
struct Violation {
  double t = 0;       ///< seconds
  base::Line line{};  ///< source line of the block the word was matched to
  std::string what;   ///< such as "X jerk", "deviation", "orientation", "feed"
  double value = 0;   ///< mm, degrees and seconds
  double limit = 0;   ///< the same
};

/// The block that a word was matched to.
struct MatchedBlock {
  base::Line line{};             ///< of the program
  double feed = 0;               ///< programmed, mm/s or degrees/s; infinite for a rapid
  std::array<double, 3> tool{};  ///< offset of the tool in it, mm; 0 of machines without a chain of rotary axes
  double distance =
      0;  ///< mm, of the word from there; of the tool's tip from its place under tool centre point control
  double tolerance = 0;  ///< mm, of the block
};

/// What all words were.
struct Verdict {
  double time_s = 0;  ///< words · period
  double deviation_mm =
      0;  ///< largest distance between words and programmed geometry, matched monotonically, of either from the other
  double tolerance_mm = 0;  ///< the largest tolerance that applied
  /// Under tool centre point control, largest of each word from the place of the path that it is matched to; none without.
  std::optional<double> tip_deviation_mm;
  std::optional<double> orientation_deviation_deg;  ///< of the tool's direction, likewise
  double orientation_tolerance_deg = 0;  ///< the largest that applied, of the tool's direction; 0 where none did
  double start_error_mm = 0;             ///< distance of the first word from the program's start
  double end_error_mm = 0;               ///< distance of the last word from the program's end
  double feed_programmed_max = 0;        ///< mm/s
  double feed_max_ratio = 0;             ///< speed over programmed feed, largest
  std::optional<double> feed_ripple;     ///< FeedRipple::greatest()
  std::vector<AxisVerdict> axes;         ///< for each axis the machine has
  std::int64_t violation_count = 0;      ///< all there are
  std::vector<Violation> violations;     ///< the first 1000: beyond 0.1 % of a limit, or beyond the tolerance and 1 nm

  /// Was anything not kept?
  bool objects() const { return violation_count > 0; }
};

/// Gives the program's moves one after the other, with dwells and events; false at its end.
using MoveSource = std::function<bool(gcode::Move&)>;

/// Judges words as they come; memory does not grow with the program or the trace. The machine must outlive the referee.
class Referee {
 public:
  /// `cancelled`: asked often during long work; once it returns true, observe() and conclude() return at once and the
  /// verdict is of no use. May be empty.
  Referee(MoveSource moves, const machine::Machine& machine, base::Period period, std::function<bool()> cancelled = {});
  ~Referee();
  Referee(Referee&&) noexcept;             ///< what is moved from may only be assigned to
  Referee& operator=(Referee&&) noexcept;  ///< the same

  /// The next word: axis positions one period after the word before. `planned_feed`: base::Word::feed, where the trace
  /// tells it.
  void observe(const base::AxisVector& position, std::optional<double> planned_feed = {});

  /// Of the word observed last; while several blocks are as near, of one of them.
  MatchedBlock matched() const;

  /// After the last word: what remains of the program has not been visited.
  Verdict conclude();

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace leadscrew::referee
