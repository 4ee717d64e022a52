#include <cmath>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/frame.hpp>

namespace leadscrew::surfaces {

using kinematics::cross_product;
using numeric::dot;

std::optional<Frame> frame_of(const SurfaceJet& jet, int side) {
  const Vector cross = cross_product(jet.u, jet.v);
  const double length = numeric::norm(cross);
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  Frame frame;
  for (std::size_t k = 0; k < 3; ++k) frame.n[k] = side < 0 ? -cross[k] / length : cross[k] / length;
  frame.E = dot(jet.u, jet.u);
  frame.F = dot(jet.u, jet.v);
  frame.G = dot(jet.v, jet.v);
  frame.L = dot(jet.uu, frame.n);
  frame.M = dot(jet.uv, frame.n);
  frame.N = dot(jet.vv, frame.n);
  return frame;
}

std::array<double, 2> Tensor::principal() const {
  const double mean = (ff + bb) / 2, radius = numeric::hypot((ff - bb) / 2, fb);
  return {mean + radius, mean - radius};
}

TangentPair tangents_of(const SurfaceJet& jet, const Frame& frame, double du, double dv) {
  Vector along{};
  for (std::size_t k = 0; k < 3; ++k) along[k] = du * jet.u[k] + dv * jet.v[k];
  const Vector f = kinematics::unit_vector(along);
  return {f, cross_product(frame.n, f)};
}

TangentPair tangents_of(const SurfaceJet& jet, const Frame& frame, Direction along) {
  return along == Direction::u ? tangents_of(jet, frame, 1, 0) : tangents_of(jet, frame, 0, 1);
}

/// A tangent t = p Su + q Sv has p, q from t·Su and t·Sv by the first form; then II(t, t).
Tensor curvature_of(const SurfaceJet& jet, const Frame& frame, const TangentPair& tangents) {
  const double determinant = frame.E * frame.G - frame.F * frame.F;
  const auto parameters = [&](const Vector& t) {
    const double by_u = dot(t, jet.u), by_v = dot(t, jet.v);
    return std::array<double, 2>{(frame.G * by_u - frame.F * by_v) / determinant,
                                 (frame.E * by_v - frame.F * by_u) / determinant};
  };
  const auto second = [&](const std::array<double, 2>& a, const std::array<double, 2>& b) {
    return frame.L * a[0] * b[0] + frame.M * (a[0] * b[1] + a[1] * b[0]) + frame.N * a[1] * b[1];
  };
  const auto f = parameters(tangents.f), b = parameters(tangents.b);
  return {second(f, f), second(f, b), second(b, b)};
}

double width_of(const Frame& frame, Direction along) {
  const double area = std::sqrt(frame.E * frame.G - frame.F * frame.F);
  return area / std::sqrt(along == Direction::u ? frame.E : frame.G);
}

}  // namespace leadscrew::surfaces
