#include <algorithm>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/toolpath/corridor.hpp>

namespace leadscrew::toolpath {

template <std::size_t D>
Vector<D> CorridorLeg<D>::at(double s) const {
  if (s <= 0) return from;
  if (s >= length) return to;
  if (!is_arc) return along(from, s, direction);
  const auto [n, c, cosine_less_one] = numeric::sines(turn * s / length);
  const double x = from[first] - center[first], y = from[second] - center[second];
  Vector<D> place = from;
  place[first] = center[first] + c * x - n * y;
  place[second] = center[second] + n * x + c * y;
  return place;
}

template <std::size_t D>
Vector<D> CorridorLeg<D>::tangent(double s) const {
  if (!is_arc) return direction;
  const Vector<D> out = between(center, at(s));
  const double sign = turn > 0 ? 1 / radius : -1 / radius;
  Vector<D> t{};
  t[first] = -sign * out[second];
  t[second] = sign * out[first];
  return t;
}

template <std::size_t D>
typename CorridorLeg<D>::Nearest CorridorLeg<D>::nearest(const Vector<D>& x) const {
  if (!is_arc) {
    const Vector<D> off = between(from, x);
    const double place = inner(direction, off);
    if (place <= 0) return {off, direction, place < 0};
    if (place >= length) return {between(to, x), direction, place > length};
    return {along(off, -place, direction), direction, false};
  }
  const double sign = turn > 0 ? 1 : -1;
  const double rx = x[first] - center[first], ry = x[second] - center[second];
  const double fx = from[first] - center[first], fy = from[second] - center[second];
  const double ex = to[first] - center[first], ey = to[second] - center[second];
  const bool is_inside = sign * (fx * ry - fy * rx) >= 0 && sign * (rx * ey - ry * ex) >= 0;
  const double distance = std::sqrt(rx * rx + ry * ry);
  Nearest found;
  if (is_inside && distance > 0) {
    found.offset = between(from, x);  // across the plane
    found.offset[first] = rx * (1 - radius / distance);
    found.offset[second] = ry * (1 - radius / distance);
    found.tangent[first] = -sign * ry / distance;
    found.tangent[second] = sign * rx / distance;
    return found;
  }
  const Vector<D> a = between(from, x), b = between(to, x);
  found.is_beyond = true;
  found.offset = inner(a, a) < inner(b, b) ? a : b;
  found.tangent = tangent(inner(a, a) < inner(b, b) ? 0 : length);
  return found;
}

template <std::size_t D>
double CorridorLeg<D>::advance(const Vector<D>& x) const {
  if (!is_arc) return std::clamp(inner(direction, between(from, x)), 0.0, length);
  // By the angle from halfway, where it is not ambiguous.
  const Vector<D> middle = between(center, at(length / 2));
  const double rx = x[first] - center[first], ry = x[second] - center[second];
  const double angle =
      numeric::atan2(middle[first] * ry - middle[second] * rx, middle[first] * rx + middle[second] * ry);
  return std::clamp(0.5 + angle / turn, 0.0, 1.0) * length;
}

template <std::size_t D>
CorridorLeg<D> line_leg(const Vector<D>& from, const Vector<D>& to, double margin, double feed) {
  CorridorLeg<D> leg;
  leg.from = from, leg.to = to, leg.margin = margin, leg.feed = feed;
  leg.length = size(between(from, to));
  for (std::size_t i = 0; i < D; ++i) leg.direction[i] = (to[i] - from[i]) / leg.length;
  return leg;
}

template <std::size_t D>
CorridorLeg<D> arc_leg(const Vector<D>& from, const Vector<D>& to, std::size_t first, std::size_t second,
                       const Vector<D>& center, double turn, double margin, double feed) {
  CorridorLeg<D> leg;
  leg.from = from, leg.to = to, leg.margin = margin, leg.feed = feed;
  leg.is_arc = true;
  leg.first = first, leg.second = second, leg.center = center, leg.turn = turn;
  leg.radius = numeric::hypot(from[first] - center[first], from[second] - center[second]);
  leg.length = leg.radius * std::abs(turn);
  return leg;
}

template <std::size_t D>
Vector<D> TimeSpline<D>::at(double time) const {
  const double begin = std::clamp(std::floor(time), 0.0, static_cast<double>(intervals()) - 1);
  const double u = time - begin, v = 1 - u;
  const std::array<double, 4> weights = {v * v * v / 6, ((3 * u - 6) * u * u + 4) / 6,
                                         (((3 - 3 * u) * u + 3) * u + 1) / 6, u * u * u / 6};
  Vector<D> sum{};
  for (std::size_t i = 0; i < 4; ++i) sum = along(sum, weights[i], points[static_cast<std::size_t>(begin) + i]);
  return sum;
}

template struct CorridorLeg<2>;
template struct CorridorLeg<3>;
template struct TimeSpline<2>;
template struct TimeSpline<3>;
template CorridorLeg<2> line_leg<2>(const Vector<2>&, const Vector<2>&, double, double);
template CorridorLeg<3> line_leg<3>(const Vector<3>&, const Vector<3>&, double, double);
template CorridorLeg<2> arc_leg<2>(const Vector<2>&, const Vector<2>&, std::size_t, std::size_t, const Vector<2>&,
                                   double, double, double);
template CorridorLeg<3> arc_leg<3>(const Vector<3>&, const Vector<3>&, std::size_t, std::size_t, const Vector<3>&,
                                   double, double, double);

}  // namespace leadscrew::toolpath
