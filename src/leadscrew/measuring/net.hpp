#pragma once
// A rational B-spline surface from its net, by the recursion of Cox and de Boor (Piegl and Tiller, "The NURBS Book", eq. 2.5
// and 2.9). Passes are made from polynomials of each span (surfaces/surface.hpp); here is the other way to the same surface, so
// that what judges them shares no formula with what made them.

#include <array>
#include <cstddef>
#include <leadscrew/surfaces/surface.hpp>
#include <vector>

namespace leadscrew::measuring {

using machine::Vector;

/// The basis functions that are not 0 at a parameter, and their derivatives.
struct Basis {
  std::size_t first = 0;  ///< index of the first control point
  std::array<double, surfaces::highest_degree + 1> value{}, derivative{};
};
/// Of clamped knots. A parameter beyond the range is taken as its end.
Basis basis_of(int degree, const std::vector<double>& knots, double parameter);

/// A place of the surface.
struct SurfacePlace {
  Vector s{};                       ///< mm
  Vector n{};                       ///< ±Su × Sv/|Su × Sv|; 0 where it vanishes
  double area = 0;                  ///< |Su × Sv|: mm² by du dv
  double along_u = 0, along_v = 0;  ///< |Su|, |Sv|
};

/// A net and which side of it is machined: 1 that of Su × Sv, −1 the other. The form must outlive it.
class Net {
 public:
  Net(const surfaces::SurfaceForm& form, int side) : form_(&form), side_(side) {}

  Basis basis(surfaces::Direction direction, double parameter) const;
  SurfacePlace at(const Basis& u, const Basis& v) const;
  SurfacePlace at(double u, double v) const {
    return at(basis(surfaces::Direction::u, u), basis(surfaces::Direction::v, v));
  }

 private:
  const surfaces::SurfaceForm* form_;
  int side_;
};

}  // namespace leadscrew::measuring
