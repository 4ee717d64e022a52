#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/touch.hpp>

namespace leadscrew::surfaces {

/// The chain rule, written out: Su, Sv to the second order, S to the third.
Touch<Jet2> touch_along(const Machining& machining, const SurfaceJet& jet, const LinePlace& place) {
  const double u1 = place.u[1], u2 = place.u[2], u3 = place.u[3], v1 = place.v[1], v2 = place.v[2], v3 = place.v[3];
  VectorOf<Jet2> contact, by_u, by_v, along;
  for (std::size_t k = 0; k < 3; ++k) {
    const double su = jet.u[k], sv = jet.v[k], suu = jet.uu[k], suv = jet.uv[k], svv = jet.vv[k], suuu = jet.uuu[k],
                 suuv = jet.uuv[k], suvv = jet.uvv[k], svvv = jet.vvv[k];
    const double first = su * u1 + sv * v1;
    const double second = suu * u1 * u1 + 2 * suv * u1 * v1 + svv * v1 * v1 + su * u2 + sv * v2;
    const double third = suuu * u1 * u1 * u1 + 3 * suuv * u1 * u1 * v1 + 3 * suvv * u1 * v1 * v1 + svvv * v1 * v1 * v1 +
                         3 * (suu * u1 * u2 + suv * (u2 * v1 + u1 * v2) + svv * v1 * v2) + su * u3 + sv * v3;
    contact[k].derivative = {jet.s[k], first, second};
    along[k].derivative = {first, second, third};
    by_u[k].derivative = {su, suu * u1 + suv * v1,
                          suuu * u1 * u1 + 2 * suuv * u1 * v1 + suvv * v1 * v1 + suu * u2 + suv * v2};
    by_v[k].derivative = {sv, suv * u1 + svv * v1,
                          suuv * u1 * u1 + 2 * suvv * u1 * v1 + svvv * v1 * v1 + suv * u2 + svv * v2};
  }
  return touch_of(machining, contact, by_u, by_v, along);
}

Touch<Jet1> touch_of_first_order(const Machining& machining, const SurfaceJet& jet, const LinePlace& place) {
  const double u1 = place.u[1], u2 = place.u[2], v1 = place.v[1], v2 = place.v[2];
  VectorOf<Jet1> contact, by_u, by_v, along;
  for (std::size_t k = 0; k < 3; ++k) {
    const double u_rate = jet.uu[k] * u1 + jet.uv[k] * v1, v_rate = jet.uv[k] * u1 + jet.vv[k] * v1;
    const double first = jet.u[k] * u1 + jet.v[k] * v1;
    contact[k].derivative = {jet.s[k], first};
    along[k].derivative = {first, u_rate * u1 + v_rate * v1 + jet.u[k] * u2 + jet.v[k] * v2};
    by_u[k].derivative = {jet.u[k], u_rate};
    by_v[k].derivative = {jet.v[k], v_rate};
  }
  return touch_of(machining, contact, by_u, by_v, along);
}

Touch<double> touch_at(const Machining& machining, const SurfaceJet& jet, const LinePlace& place) {
  Vector along;
  for (std::size_t k = 0; k < 3; ++k) along[k] = jet.u[k] * place.u[1] + jet.v[k] * place.v[1];
  return touch_of(machining, jet.s, jet.u, jet.v, along);
}

Bending bending_at(const Machining& machining, const SurfaceJet& jet, const Frame& frame, const LinePlace& place) {
  const TangentPair tangents = tangents_of(jet, frame, place.u[1], place.v[1]);
  const Vector axis = axis_of(machining.orientation, frame.n, tangents.f);
  Bending bending;
  bending.surface = curvature_of(jet, frame, tangents);
  bending.clearance = local_clearance(curvature_of(machining.cutter, frame.n, axis, tangents), bending.surface);
  const auto [most, least] = bending.surface.principal();
  bending.greatest = std::max(std::abs(most), std::abs(least));
  bending.axis = {numeric::dot(axis, tangents.f), numeric::dot(axis, tangents.b), numeric::dot(axis, frame.n)};
  bending.b = tangents.b;
  return bending;
}

}  // namespace leadscrew::surfaces
