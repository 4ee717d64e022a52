#pragma once
// Which coordinates a program's moves are told in: those of the machine's axes, or, under tool centre point control, those
// of the tool's tip in the workpiece and the rotary axes.

#include <array>
#include <leadscrew/gcode/move.hpp>
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
  /// The next move of this space; false where it ends.
  bool next(gcode::Move& move) {
    if (!has_ahead_) read();
    if (!has_ahead_ || space_of(ahead_) != space_) return false;
    std::swap(move, ahead_);
    has_ahead_ = false;
    return true;
  }
  /// Once next() has said false, or before it is called: goes to the next space, if there is one.
  bool begin_next() {
    if (!has_ahead_) read();
    if (has_ahead_) space_ = space_of(ahead_);
    return has_ahead_;
  }
  /// After begin_next(): where its first move begins, in its coordinates.
  const base::AxisVector& start() const { return ahead_.start; }
  /// Once next() has said false: is there another space?
  bool has_next() const { return has_ahead_; }

 private:
  static Space space_of(const gcode::Move& move) { return move.is_of_tip ? Space{true, move.tool} : Space{}; }
  void read() { has_ahead_ = moves_(ahead_); }

  MoveSource moves_;
  Space space_;
  gcode::Move ahead_;
  bool has_ahead_ = false;
};

}  // namespace leadscrew::referee
