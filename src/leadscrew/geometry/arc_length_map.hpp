#pragma once
// Arc length along one polynomial piece of a curve, and its inverse as a table.
//
//   length      Gauss-Legendre, 8 points, halving until the halves agree with the whole
//   inverse     x(σ) = x_begin + c1 σ + … + c5 σ⁵ on 0 ≤ σ ≤ h, with the true x, x′, x″ at both ends:
//
//                 x′ = 1/v    x″ = −v₁/v³    x‴ = (3 v₁²/v − v₂)/v⁴
//                 v = |C′|,   v₁ = dv/dx = C′·C″/v,   v₂ = d²v/dx² = (C″·C″ + C′·C‴ − v₁²)/v
//
//               halving until the composition's own speed g = v·x′(σ) is 1 within a tolerance, and its derivatives by s
//               are small beside what the curve itself has: g′ beside k and g″ beside k², with k the larger of the
//               curvature and the reciprocal of the piece's length. A quintic's error in x is τ³(1 − τ)³ of
//               something, τ = σ/h: its first derivative is largest at τ = (1 ± 1/√5)/2, its second at 1/2, its third
//               at the ends, and there they are looked at. x′ > 0 is certain where the Bernstein coefficients of x′ are
//               positive.
//
// At an end where v = 0 (a cusp, coinciding control points) x′ is infinite. If v ~ xᵏ⁻¹ there, s ~ xᵏ, and halving x
// towards the end divides what is left by 2ᵏ, all pieces between being similar to one another. It ends with a remainder
// that is straight to rounding: 10⁻¹⁵ mm between the curve and its chord. That is travelled along the chord at constant
// speed, where the table is exact again and every derivative finite. The same serves ends where the radius of
// curvature is next to nothing.

#include <array>
#include <leadscrew/geometry/nurbs.hpp>
#include <leadscrew/geometry/rational.hpp>
#include <vector>

namespace leadscrew::geometry {

/// One piece of x(σ).
struct MapPiece {
  double x_begin = 0, x_end = 0;
  double length = 0;          ///< h
  std::array<double, 5> c{};  ///< of σ … σ⁵
  bool is_straight = false;   ///< a remainder, to be travelled along its chord
};

/// x′ and x″ at an end of a piece.
struct MapEnd {
  double first = 0, second = 0;
};

/// Coefficients of σ … σ⁵ with these derivatives at both ends, h apart, over which x grows by `span`.
std::array<double, 5> quintic_map(double span, double h, const MapEnd& begin, const MapEnd& end);

/// Whether |C′| vanishes at an end, or the curvature is as good as infinite there.
struct SingularEnds {
  bool begin = false, end = false;
};

/// The table for the whole of `curve`: appends to `from_start` what counts x from the curve's start, and to `from_end`
/// what counts it from its end and comes after that.
void map_arc_length(const RationalBezier& curve, const Metric& metric, SingularEnds singular,
                    const MapTolerance& tolerance, std::vector<MapPiece>& from_start, std::vector<MapPiece>& from_end);

}  // namespace leadscrew::geometry
