#pragma once
// The contour of a lathe part: lines and arcs in the plane of Z and X, as the lathe cycles G70 to G72 offset and cut it.
//
// A cycle sees its contour as if Z decreased along it and X increased from its first point to its last: mirrored, and
// for cuts along X turned, into an attitude of its own. All lengths are in the program's units, X is a radius.

#include <cstdint>
#include <leadscrew/gcode/arc.hpp>
#include <vector>

namespace leadscrew::gcode {

/// Lengths below which points of a contour coincide (LinuxCNC's lathe cycles: 1e-6 of a unit).
inline constexpr double contour_tolerance = 1e-6;

/// A line or an arc of at most half a turn. PlanePoint: first is Z, second X.
struct ContourPiece {
  PlanePoint start;
  PlanePoint end;
  PlanePoint center;        ///< of an arc
  int turn = 0;             ///< 0 a line, 1 counterclockwise from Z to X (G3), −1 clockwise (G2)
  std::uint32_t block = 0;  ///< which block it is of, counted by who collects the contour

  bool is_arc() const { return turn != 0; }
};

/// What a block of the contour puts at its end: a fillet of this radius, or the chamfer with the same ends.
struct ContourCorner {
  double size = 0;  ///< 0: none
  bool is_chamfer = false;
};

/// From the program's plane to the attitude in which a contour is cut, and back.
class Attitude {
 public:
  /// Of a cut along X instead of Z: turned by 90°, Z becomes −X and X becomes Z.
  void turn() { turned_ = !turned_; }
  /// So that Z decreases and X increases from the first point to the last, which have been put into this attitude.
  void face(PlanePoint first, PlanePoint last);

  PlanePoint in(PlanePoint point) const;
  PlanePoint out(PlanePoint point) const;
  /// Of a piece, and of a turn: those that are mirrored turn the other way.
  ContourPiece in(const ContourPiece& piece) const;
  int turn_out(int turn) const { return mirrors_z_ != mirrors_x_ ? -turn : turn; }

 private:
  bool turned_ = false;
  bool mirrors_z_ = false;
  bool mirrors_x_ = false;
};

using Contour = std::vector<ContourPiece>;

/// From point to point.
double span_of(PlanePoint a, PlanePoint b);

/// Whether the piece, in its attitude, never goes back along Z.
bool goes_one_way(const ContourPiece& piece);

/// Puts fillets and chamfers at the ends of pieces; `corners` are those of the pieces. The corner at the end of the last
/// piece has no second side and is left out. False where one does not fit.
bool round_corners(Contour& contour, const std::vector<ContourCorner>& corners);

/// Moves the pieces aside by a distance, to the right as the contour goes where it is positive, closing the gaps with arcs
/// and cutting off what crosses. A piece that is swallowed goes. False where what is left does not go one way, or is too
/// fine to be followed.
bool offset(Contour& contour, double aside);

}  // namespace leadscrew::gcode
