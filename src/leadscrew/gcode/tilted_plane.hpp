#pragma once
// A tilted working plane (G68.2): where it lies in the workpiece, and the ways of saying so.
//
//     workpiece = origin + R p        p: coordinates of the program, in the plane; the columns of R are its X, Y and Z
//
// Fanuc 30i operator's manual, "Tilted working plane indexing"; Haas mill operator's manual, "G268". Angles turn
// counterclockwise as seen from the positive end of the axis that they turn about.

#include <array>
#include <cstddef>
#include <leadscrew/kinematics/chain.hpp>
#include <optional>

namespace leadscrew::gcode {

struct TiltedPlane {
  using Vector = std::array<double, 3>;
  using Matrix = std::array<Vector, 3>;  ///< by rows

  Vector origin{};                                    ///< mm, of the workpiece
  Matrix turn = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  ///< R, a rotation

  /// Of this plane's coordinates to those of the workpiece where they are another plane's, which lies in the workpiece so.
  TiltedPlane in(const TiltedPlane& outer) const;

  /// About the workpiece's Z, then the plane's X, then its Z (Euler), degrees.
  static Matrix by_euler(const Vector& degrees);
  /// About the workpiece's own axes, one after the other: `order` has 1, 2 and 3 for X, Y and Z; degrees[0] is about X.
  static Matrix by_fixed_axes(const std::array<int, 3>& order, const Vector& degrees);
  /// X leads from the first point to the second, the third is on the side of Y. None where they lie on one line.
  static std::optional<Matrix> by_points(const Vector& first, const Vector& second, const Vector& third);
  /// Z is as told, X as told but for what it has along Z. None where either is 0, or they are more than 5 degrees from square.
  static std::optional<Matrix> by_vectors(const Vector& x, const Vector& z);
};

/// A plane in force, on a machine that turns the tool or the workpiece to it.
struct PlaneInForce {
  TiltedPlane plane;
  kinematics::Chain chain;
};

}  // namespace leadscrew::gcode
