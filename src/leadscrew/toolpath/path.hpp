#pragma once
// The tool path: smooth pieces joined end to end, each a curve by arc length, tolerance already spent; between them the
// dwells and events of the program, each pinned to its place.

#include <leadscrew/base/event.hpp>
#include <leadscrew/base/line.hpp>
#include <leadscrew/geometry/curve.hpp>
#include <variant>

namespace leadscrew::toolpath {

struct Piece {
  geometry::Curve curve;
  double feed = 0;  ///< greatest speed along the curve, units of its length per second; infinite for a rapid
  base::Line line{};
  bool stop = false;  ///< rest at the end, whatever follows (G61.1)
};

/// Stand still.
struct Dwell {
  geometry::Point position{};
  double seconds = 0;  ///< ≥ 0
  base::Line line{};
};

using Element = std::variant<Piece, Dwell, base::Event>;

}  // namespace leadscrew::toolpath
