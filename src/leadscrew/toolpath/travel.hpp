#pragma once
// The travel of the machine, asked of the path as it will be moved along: behind every fit and blend, and whatever the
// reader has said of the program. A piece that has not been found inside cannot be handed to a cycle.

#include <leadscrew/base/axes.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/toolpath/path.hpp>
#include <optional>

namespace leadscrew::toolpath {

/// Where an axis leaves its travel.
struct TravelExcess {
  base::Axis axis = base::Axis::X;
  double position = 0;  ///< mm or degrees
};

/// Marks the piece as inside the travel of every axis of the machine (Piece::travel), or says which axis leaves it. No
/// part of an axis' motion may be beyond travel by more than `slack` ≥ 0, mm or degrees; where motion began beyond it,
/// at `start`, not farther than that. Axes that the machine lacks stand still. The greatest coordinate is found to
/// rounding where it has one peak at most in 0.2 rad of an arc, in a quarter of each polynomial of a curve, and in a 32nd
/// part of the piece.
std::optional<TravelExcess> check_travel(Piece& piece, const machine::Machine& machine, const geometry::Point& start,
                                         double slack);

/// Widens the box from `least` to `greatest`, mm or degrees, until these axes are inside it all along the piece, to
/// rounding as above.
void widen(const Piece& piece, base::AxisSet axes, geometry::Point& least, geometry::Point& greatest);

}  // namespace leadscrew::toolpath
