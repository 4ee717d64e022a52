#pragma once
// What is measured: a range of a surface, and how finely.

#include <cstddef>
#include <leadscrew/surfaces/surface.hpp>
#include <vector>

namespace leadscrew::measuring {

struct Target {
  surfaces::SurfaceForm form;  ///< mm, in the coordinates of the tools; has no fault
  surfaces::Range u, v;        ///< within its own; from < to
  int side = 1;                ///< 1: tools are on the side of Su × Sv, −1: on the other
  /// Of the passes; both ways where they have none, as in spirals.
  enum class Across { u, v, both } across = Across::v;
  double step = 0;                    ///< between passes, mm; > 0
  double expected = 0;                ///< height of ridges, mm, roughly: looked for first; 0: nothing is known
  double reach = 1;                   ///< what is left above so many mm has not been reached; > 0
  double places_per_step = 20;        ///< across the passes, if there are no more than most_places
  std::size_t most_places = 1 << 20;  ///< of the grid; ≥ 64
};

/// Parameters at which a target is looked at, from end to end of its ranges.
struct GridLines {
  std::vector<double> u, v;
};
GridLines grid_of(const Target& target);
/// The longest of some lines of its range along a direction of parameters, mm.
double length_along(const Target& target, surfaces::Direction direction);

}  // namespace leadscrew::measuring
