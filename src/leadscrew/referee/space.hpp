#pragma once
// Which coordinates a program's moves are told in: those of the machine's axes, or, under tool centre point control, those
// of the tool's tip in the workpiece and the rotary axes.
//
// In the latter a place is matched by the tip and the rotary axes together, so that a tip that comes by twice is told apart
// by how the tool stands. A degree counts as P/E mm there, P the tolerance of the tip and E that of the tool's direction:
// what is within P is then within both, and no more of one is asked for than its own; 64 times what a degree usually counts at
// most, and a 64th of it at least. P and E are those of the first move
// that travels and may be rounded; where they change before coordinates do, of a move with others less is allowed: the lesser of P and E times
// what a degree counts.

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <leadscrew/gcode/move.hpp>
#include <leadscrew/referee/metric.hpp>
#include <leadscrew/referee/referee.hpp>
#include <utility>

namespace leadscrew::referee {

struct Space {
  bool is_of_tip = false;
  std::array<double, 3> tool{};  ///< of the tip, mm

  friend bool operator==(const Space&, const Space&) = default;
};

/// The program's moves, one space after the other.
class Spaces {
 public:
  explicit Spaces(MoveSource moves) : moves_(std::move(moves)) {}

  /// The space of the moves that next() gives.
  const Space& space() const { return space_; }
  /// What a degree counts in it, mm.
  double per_degree() const { return per_degree_; }
  /// The next move of this space; false where it ends.
  bool next(gcode::Move& move) {
    if (!read(1) || space_of(ahead_.front()) != space_) return false;
    std::swap(move, ahead_.front());
    ahead_.pop_front();
    return true;
  }
  /// Once next() has said false, or before it is called: goes to the next space, if there is one.
  bool begin_next() {
    if (!read(1)) return false;
    space_ = space_of(ahead_.front());
    per_degree_ = find_per_degree();
    return true;
  }
  /// After begin_next(): where its first move begins, in its coordinates.
  const base::AxisVector& start() const { return ahead_.front().start; }
  /// Once next() has said false: is there another space?
  bool has_next() const { return !ahead_.empty(); }

 private:
  static constexpr std::size_t most_ahead = 64;  // moves among which tolerances are looked for
  static constexpr double most_stretched = 64;

  static Space space_of(const gcode::Move& move) { return move.is_of_tip ? Space{true, move.tool} : Space{}; }
  /// Are there so many moves ahead?
  bool read(std::size_t count) {
    for (gcode::Move move; ahead_.size() < count && moves_(move);) ahead_.push_back(std::move(move));
    return ahead_.size() >= count;
  }
  double find_per_degree() {
    for (std::size_t k = 0; space_.is_of_tip && k < most_ahead && read(k + 1); ++k) {
      const gcode::Move& move = ahead_[k];
      if (space_of(move) != space_) break;
      const bool travels = move.kind != gcode::Move::Kind::dwell && move.kind != gcode::Move::Kind::event;
      const bool is_rounded = move.path_mode == gcode::PathMode::blend && move.tolerance >= gcode::least_rounded;
      if (!travels || !is_rounded || !(move.orientation_tolerance > 0)) continue;
      return std::clamp(move.tolerance / move.orientation_tolerance, millimetres_per_degree / most_stretched,
                        millimetres_per_degree * most_stretched);
    }
    return millimetres_per_degree;
  }

  MoveSource moves_;
  Space space_;
  double per_degree_ = millimetres_per_degree;
  std::deque<gcode::Move> ahead_;
};

}  // namespace leadscrew::referee
