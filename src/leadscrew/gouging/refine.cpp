#include <algorithm>
#include <cmath>
#include <leadscrew/gouging/distance.hpp>
#include <leadscrew/gouging/refine.hpp>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/numeric/vectors.hpp>

namespace leadscrew::gouging {

namespace {

using numeric::difference;
using numeric::dot;
using surfaces::Direction;
using surfaces::Range;
using surfaces::Surface;
using surfaces::SurfaceJet;

constexpr int most_newton_steps = 30;
constexpr int most_shrinkings = 60;
constexpr int most_trials_of_a_size = 40;
constexpr double place_resolution = 1e-8;  // mm

/// What is refined: one part against one surface.
struct Problem {
  const Surface& surface;
  const Part& part;
  const Pose& pose;
  Range u, v;
};

struct Polar {
  double z = 0, rho = 0;
  Vector across{};  // a unit vector from the axis, or 0
};

Polar polar_of(const Pose& pose, const Vector& place) {
  const Vector from_tip = difference(place, pose.tip);
  const double z = dot(from_tip, pose.axis);
  Vector across = numeric::sum(from_tip, -z, pose.axis);
  const double rho = numeric::norm(across);
  for (double& x : across) x = rho > 0 ? x / rho : 0;
  return {z, rho, across};
}

double distance_at(const Problem& problem, double u, double v) {
  const Polar polar = polar_of(problem.pose, problem.surface.at(u, v));
  const double distance = signed_distance(problem.part, polar.rho, polar.z).value, above = polar.z - problem.part.top;
  return above > 0 ? std::max(distance, above) : distance;
}

/// Gradient and second derivatives by u and v.
struct Quadratic {
  std::array<double, 2> gradient{};
  double uu = 0, uv = 0, vv = 0;
};

Quadratic quadratic_at(const Problem& problem, double u, double v) {
  const SurfaceJet jet = problem.surface.jet(u, v);
  const Polar polar = polar_of(problem.pose, jet.s);
  const SignedDistance at = signed_distance(problem.part, polar.rho, polar.z);
  Vector gradient{}, meridian{};
  for (std::size_t k = 0; k < 3; ++k) {
    gradient[k] = at.by_rho * polar.across[k] + at.by_z * problem.pose.axis[k];
    meridian[k] = at.by_rho * problem.pose.axis[k] - at.by_z * polar.across[k];
  }
  const Vector around = kinematics::cross_product(problem.pose.axis, polar.across);
  const double about_axis = polar.rho > 0 ? at.by_rho / polar.rho : 0;
  const bool is_corner = at.by_rho != 0 && at.by_z != 0;
  const double of_corner = is_corner ? 1 / (at.value + problem.part.corner) : 0;
  const auto second = [&](const Vector& a, const Vector& b, const Vector& ab) {
    return dot(gradient, ab) + about_axis * dot(around, a) * dot(around, b) +
           of_corner * dot(meridian, a) * dot(meridian, b);
  };
  return {{dot(gradient, jet.u), dot(gradient, jet.v)},
          second(jet.u, jet.u, jet.uu),
          second(jet.u, jet.v, jet.uv),
          second(jet.v, jet.v, jet.vv)};
}

/// The step to where the gradient vanishes, made shorter until the second derivatives are those of a least value; parameters
/// at an end of their range that lead out of it stay.
std::array<double, 2> newton_step(const Problem& problem, const Quadratic& q, double u, double v, double damping) {
  const bool is_u_fixed = (u <= problem.u.from && q.gradient[0] > 0) || (u >= problem.u.to && q.gradient[0] < 0);
  const bool is_v_fixed = (v <= problem.v.from && q.gradient[1] > 0) || (v >= problem.v.to && q.gradient[1] < 0);
  const double scale_u = std::abs(q.uu) + 1e-300, scale_v = std::abs(q.vv) + 1e-300;
  const double uu = q.uu + damping * scale_u, vv = q.vv + damping * scale_v;
  if (is_u_fixed && is_v_fixed) return {0, 0};
  if (is_u_fixed) return {0, vv > 0 ? -q.gradient[1] / vv : 0};
  if (is_v_fixed) return {uu > 0 ? -q.gradient[0] / uu : 0, 0};
  const double determinant = uu * vv - q.uv * q.uv;
  if (!(determinant > 0) || !(uu > 0)) return {0, 0};
  return {(-vv * q.gradient[0] + q.uv * q.gradient[1]) / determinant,
          (-uu * q.gradient[1] + q.uv * q.gradient[0]) / determinant};
}

struct Trial {
  double u = 0, v = 0, value = 0;
};

bool try_place(const Problem& problem, double u, double v, Trial& best) {
  u = std::clamp(u, problem.u.from, problem.u.to);
  v = std::clamp(v, problem.v.from, problem.v.to);
  const double value = distance_at(problem, u, v);
  if (!(value < best.value)) return false;
  best = {u, v, value};
  return true;
}

/// True where it has come to rest.
bool follow_newton(const Problem& problem, const std::array<double, 2>& size, Trial& best) {
  double damping = 0;
  for (int step = 0; step < most_newton_steps; ++step) {
    const Quadratic q = quadratic_at(problem, best.u, best.v);
    const auto [du, dv] = newton_step(problem, q, best.u, best.v, damping);
    const bool is_at_rest = std::abs(du) <= 1e-7 * size[0] && std::abs(dv) <= 1e-7 * size[1];
    const bool is_better = (du != 0 || dv != 0) && try_place(problem, best.u + du, best.v + dv, best);
    if (is_at_rest && damping == 0 && (du != 0 || dv != 0)) return true;
    if (is_better) {
      damping = damping > 0.1 ? damping / 4 : 0;
    } else {
      damping = damping > 0 ? damping * 4 : 0.5;
      if (damping > 1e6) return false;
    }
  }
  return false;
}

/// Inside the core g has a bend where it is as far from the side as from below: along that, f is smooth. The direction in u and
/// v, of the length of a step of this size along u.
std::array<double, 2> along_bend(const Problem& problem, const Trial& at, const std::array<double, 2>& size) {
  const SurfaceJet jet = problem.surface.jet(at.u, at.v);
  const Vector off = numeric::sum(polar_of(problem.pose, jet.s).across, 1, problem.pose.axis);
  const double du = -dot(off, jet.v), dv = dot(off, jet.u);
  const double length = numeric::norm(numeric::sum(Vector{du * jet.u[0], du * jet.u[1], du * jet.u[2]}, dv, jet.v));
  const double factor = length > 0 ? size[0] * numeric::norm(jet.u) / length : 0;
  return {factor * du, factor * dv};
}

bool try_around(const Problem& problem, const std::array<double, 2>& size, Trial& best) {
  constexpr std::array<std::array<double, 2>, 8> directions = {
      {{1, 0}, {0.7, 0.7}, {0, 1}, {-0.7, 0.7}, {-1, 0}, {-0.7, -0.7}, {0, -1}, {0.7, -0.7}}};
  const Trial center = best;
  bool is_better = false;
  for (const auto& direction : directions) {
    is_better |= try_place(problem, center.u + direction[0] * size[0], center.v + direction[1] * size[1], best);
  }
  const auto [du, dv] = along_bend(problem, center, size);
  is_better |= try_place(problem, center.u + du, center.v + dv, best);
  is_better |= try_place(problem, center.u - du, center.v - dv, best);
  return is_better;
}

/// All directions, each at its size, halved when none leads lower.
void search_around(const Problem& problem, std::array<double, 2> size, Trial& best) {
  const SurfaceJet jet = problem.surface.jet(best.u, best.v);
  const double length_u = numeric::norm(jet.u), length_v = numeric::norm(jet.v);
  for (int shrinking = 0; shrinking < most_shrinkings; ++shrinking) {
    for (int trial = 0; trial < most_trials_of_a_size; ++trial) {
      if (!try_around(problem, size, best)) break;
    }
    if (size[0] * length_u <= place_resolution && size[1] * length_v <= place_resolution) return;
    size = {size[0] / 2, size[1] / 2};
  }
}

}  // namespace

RefinedPlace nearest_on(const Surface& surface, const Part& part, const Pose& pose, double u, double v,
                        const std::array<double, 2>& size) {
  const Problem problem{surface, part, pose, surface.range(Direction::u), surface.range(Direction::v)};
  Trial best{u, v, distance_at(problem, u, v)};
  if (!follow_newton(problem, size, best)) search_around(problem, size, best);
  return {best.value, best.u, best.v, surface.at(best.u, best.v)};
}

}  // namespace leadscrew::gouging
