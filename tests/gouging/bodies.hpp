#pragma once
// Tools as distance fields, by formulas that share nothing with those that are tested: the distance from the outline of a part
// and whether a place is within it.

#include <algorithm>
#include <cmath>
#include <leadscrew/gouging/tool.hpp>
#include <numbers>
#include <random>

namespace leadscrew::gouging::test {

/// From a part that goes up without end, at the distance rho from its axis and the height z.
inline double field(const Part& part, double rho, double z) {
  const double R = part.radius, r = part.corner, flat = R - r, low = part.bottom;
  const double to_bottom = std::hypot(std::max(rho - flat, 0.0), z - low);
  const double to_side = std::hypot(rho - R, std::max(low + r - z, 0.0));
  const double angle = std::clamp(std::atan2(z - (low + r), rho - flat), -std::numbers::pi / 2, 0.0);
  const double to_corner = std::hypot(rho - flat - r * std::cos(angle), z - (low + r) - r * std::sin(angle));
  const double distance = std::min({to_bottom, to_side, r > 0 ? to_corner : to_bottom});
  const bool is_within = rho < R && z > low && !(rho > flat && z < low + r && std::hypot(rho - flat, z - low - r) > r);
  return is_within ? -distance : distance;
}

/// At a place of the workpiece. From the axis it is the length of the cross product: of the difference of two squares half of the digits
/// would be lost beside it.
inline double field(const Part& part, const Pose& pose, const Vector& place) {
  const Vector &o = pose.axis, d = {place[0] - pose.tip[0], place[1] - pose.tip[1], place[2] - pose.tip[2]};
  const double rho = std::hypot(o[1] * d[2] - o[2] * d[1], o[2] * d[0] - o[0] * d[2], o[0] * d[1] - o[1] * d[0]);
  return field(part, rho, o[0] * d[0] + o[1] * d[1] + o[2] * d[2]);
}

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}

  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  Vector place(double size) { return {between(-size, size), between(-size, size), between(-size, size)}; }
  Vector direction() {
    for (;;) {
      const Vector v = place(1);
      const double length = std::hypot(v[0], v[1], v[2]);
      if (length > 0.1 && length < 1) return {v[0] / length, v[1] / length, v[2] / length};
    }
  }
  /// Ball, flat and bull nose in turn.
  Part cutter(int kind) {
    const double R = between(0.5, 10);
    return {Part::Kind::cutter, R, kind % 3 == 0 ? R : kind % 3 == 1 ? 0 : R * between(0.02, 0.98), between(0, 5)};
  }

 private:
  std::mt19937 engine_;
};

/// The least of a convex function of two shares of a triangle, by golden sections of golden sections.
template <typename F>
double least_on_triangle(const F& f, int steps = 44) {
  const double golden = (std::sqrt(5.0) - 1) / 2;
  const auto least = [&](const auto& g, double high) {
    double a = 0, b = high, x = b - golden * (b - a), y = a + golden * (b - a), at_x = g(x), at_y = g(y);
    double best = std::min({g(a), g(b), at_x, at_y});
    for (int k = 0; k < steps; ++k) {
      if (at_x <= at_y) {
        b = y, y = x, at_y = at_x, x = b - golden * (b - a), at_x = g(x);
      } else {
        a = x, x = y, at_x = at_y, y = a + golden * (b - a), at_y = g(y);
      }
      best = std::min({best, at_x, at_y});
    }
    return best;
  };
  return least([&](double s) { return least([&](double t) { return f(s, t); }, 1 - s); }, 1);
}

}  // namespace leadscrew::gouging::test
