#pragma once
// The tool path: smooth pieces joined end to end, each a curve by arc length, tolerance already spent; between them the
// dwells and events of the program, each pinned to its place.

#include <algorithm>
#include <leadscrew/base/event.hpp>
#include <leadscrew/base/line.hpp>
#include <leadscrew/geometry/curve.hpp>
#include <memory>
#include <variant>
#include <vector>

namespace leadscrew::toolpath {

/// From a place on, what is travelled was asked for by another line of the program.
struct LineMark {
  double s = 0;  ///< path length on the piece
  base::Line line{};
};

struct Piece {
  geometry::Curve curve;
  double feed = 0;  ///< greatest speed along the curve, units of its length per second; infinite for a rapid
  base::Line line{};
  bool stop = false;  ///< rest at the end, whatever follows (G61.1)
  /// Where it was made of more than one move: ascending by s; none otherwise.
  std::shared_ptr<const std::vector<LineMark>> lines{};

  base::Line line_at(double s) const {
    if (!lines) return line;
    const auto behind = std::upper_bound(lines->begin(), lines->end(), s,
                                         [](double place, const LineMark& mark) { return place < mark.s; });
    return behind == lines->begin() ? line : std::prev(behind)->line;
  }
  base::Line last_line() const { return lines && !lines->empty() ? lines->back().line : line; }
};

/// Stand still.
struct Dwell {
  geometry::Point position{};
  double seconds = 0;  ///< ≥ 0
  base::Line line{};
};

using Element = std::variant<Piece, Dwell, base::Event>;

}  // namespace leadscrew::toolpath
