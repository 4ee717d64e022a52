#pragma once
// An arc of a part program on the lattice of single steps. Its ends are rounded where they are, so that nothing adds up
// from block to block; its centre goes to the lattice point near the true one that both ends are equally far from, to
// half a step if there is one.

#include <leadscrew/pulse/arc.hpp>
#include <optional>

namespace leadscrew::nc {

struct TrueArc {
  double center_x = 0, center_y = 0;  ///< steps of the axes, from machine zero
  double radius = 0;                  ///< steps
  double sweep = 0;                   ///< radians, 0 < sweep ≤ 2π, in its direction
  pulse::Direction direction = pulse::Direction::counterclockwise;
};

/// About its centre. Nothing where the lattice shows no arc from one place to the other: its radius is below a step,
/// or its ends are so near that rounding has them coincide or change places.
std::optional<pulse::Arc> on_lattice(const TrueArc& arc, pulse::Point start, pulse::Point end);

/// Angle of an arc of the lattice, radians, in 0 … 2π, 2π where the ends coincide.
double sweep(const pulse::Arc& arc);

}  // namespace leadscrew::nc
