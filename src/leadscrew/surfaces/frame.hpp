#pragma once
// The surface about one of its places: normal, fundamental forms, curvatures. Curvature is positive where the surface is
// concave to the tool: where it bends towards the side that n points to.

#include <array>
#include <leadscrew/surfaces/surface.hpp>
#include <optional>

namespace leadscrew::surfaces {

/// First and second fundamental form.
struct Frame {
  Vector n{};                  ///< ±Su × Sv/|Su × Sv|, toward the tool
  double E = 0, F = 0, G = 0;  ///< Su·Su, Su·Sv, Sv·Sv
  double L = 0, M = 0, N = 0;  ///< Suu·n, Suv·n, Svv·n
};

/// side: 1 where the tool is on that of Su × Sv, −1 on the other. None where the normal vanishes.
std::optional<Frame> frame_of(const SurfaceJet& jet, int side);

/// A symmetric tensor of the tangent plane, 1/mm, by components of an orthonormal pair of directions f, b.
struct Tensor {
  double ff = 0, fb = 0, bb = 0;

  friend Tensor operator-(const Tensor& a, const Tensor& b) { return {a.ff - b.ff, a.fb - b.fb, a.bb - b.bb}; }
  /// Both eigenvalues, the greater first.
  std::array<double, 2> principal() const;
};

/// Directions in the tangent plane: f along the derivative of the surface in one direction of parameters, b = n × f. The pass
/// goes along f where it goes along that parameter; across is b.
struct TangentPair {
  Vector f{}, b{};
};
TangentPair tangents_of(const SurfaceJet& jet, const Frame& frame, Direction along);
/// Of any direction du, dv in parameters, not both 0.
TangentPair tangents_of(const SurfaceJet& jet, const Frame& frame, double du, double dv);

/// The surface's curvature by f and b; 1/mm. For unit tangents t: t·K t is the normal curvature along t.
Tensor curvature_of(const SurfaceJet& jet, const Frame& frame, const TangentPair& tangents);

/// How much length across a pass one unit of the parameter across makes: √(G − F²/E) for passes along u.
double width_of(const Frame& frame, Direction along);

}  // namespace leadscrew::surfaces
