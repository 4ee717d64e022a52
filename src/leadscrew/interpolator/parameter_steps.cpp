#include <algorithm>
#include <cmath>
#include <leadscrew/interpolator/parameter_steps.hpp>
#include <leadscrew/numeric/vectors.hpp>

namespace leadscrew::interpolator {

namespace {

using numeric::dot;

using Triple = std::array<double, 3>;

/// C and two derivatives by u, over the three coordinates by which length is told.
struct Measured {
  Triple value{}, first{}, second{};
};

/// The first of the three coordinates by which length is told: those of X Y Z, else U V W, else A B C that move. A
/// smooth piece is cut where such a group begins or ceases to, so that any derivative anywhere tells.
std::size_t measured_group(const geometry::PointJet& jet) {
  constexpr std::array<std::size_t, 3> groups = {base::index(base::Axis::X), base::index(base::Axis::U),
                                                 base::index(base::Axis::A)};
  for (const std::size_t group : groups) {
    for (std::size_t i = group; i < group + 3; ++i) {
      if (jet[i].first != 0 || jet[i].second != 0 || jet[i].third != 0) return group;
    }
  }
  return groups.back();
}

Measured measured(const geometry::PointJet& jet, std::size_t group) {
  Measured at;
  for (std::size_t i = 0; i < 3; ++i) {
    at.value[i] = jet[group + i].value;
    at.first[i] = jet[group + i].first;
    at.second[i] = jet[group + i].second;
  }
  return at;
}

double uniform_step(const geometry::Nurbs& curve, double distance) {
  return (curve.last_parameter() - curve.first_parameter()) * distance / curve.length();
}

/// Δu of first order; uniform where C′ = 0.
double first_order(const geometry::Nurbs& curve, const Measured& at, double distance) {
  const double step = distance / numeric::norm(at.first);
  return std::isfinite(step) ? step : uniform_step(curve, distance);
}

/// Δu of second order; of first where it does not lead forward.
double second_order(const Measured& at, double distance, double first) {
  const double squared = dot(at.first, at.first);
  const double step = first - dot(at.first, at.second) * distance * distance / (2 * squared * squared);
  return step > 0 && std::isfinite(step) ? step : first;
}

double chord_length(const Measured& a, const Measured& b) {
  return numeric::distance(b.value, a.value);
}

/// The step, halved while it would jump: while C(u + Δu) or, on a curve that comes back, C(u + Δu/2) is farther away
/// than ten times the distance. Near a cusp, where |C′| is next to 0, a Taylor step could else end anywhere.
double without_jump(const geometry::Nurbs& curve, const Measured& at, std::size_t group, double u, double distance,
                    double step) {
  constexpr int most_halvings = 60;
  const auto jumps_to = [&](double there) {
    return chord_length(at, measured(curve.jets_at(std::min(there, curve.last_parameter())), group)) > 10 * distance;
  };
  for (int halving = 0; halving < most_halvings; ++halving) {
    if (!jumps_to(u + step) && !jumps_to(u + step / 2)) break;
    step = std::min(step, curve.last_parameter() - u) / 2;
  }
  return step;
}

/// Two steps of Newton's method for |C(u + Δu) − C(u)| = distance.
double chord_corrected(const geometry::Nurbs& curve, const Measured& at, std::size_t group, double u, double distance,
                       double step) {
  for (int pass = 0; pass < 2; ++pass) {
    const double there = std::min(u + step, curve.last_parameter());
    const Measured next = measured(curve.jets_at(there), group);
    const Triple chord = numeric::difference(next.value, at.value);
    const double length = numeric::norm(chord);
    const double corrected = there - u + (distance - length) * length / dot(chord, next.first);
    if (!(corrected > 0 && std::isfinite(corrected))) return step;
    step = corrected;
  }
  return step;
}

double marching_step(const geometry::Nurbs& curve, StepRule rule, double u, double distance) {
  if (rule == StepRule::uniform) return uniform_step(curve, distance);
  const geometry::PointJet jet = curve.jets_at(u);
  const std::size_t group = measured_group(jet);
  const Measured at = measured(jet, group);
  const double first = first_order(curve, at, distance);
  if (rule == StepRule::taylor1) return without_jump(curve, at, group, u, distance, first);
  const double second = without_jump(curve, at, group, u, distance, second_order(at, distance, first));
  if (rule == StepRule::taylor2) return second;
  return chord_corrected(curve, at, group, u, distance, second);
}

}  // namespace

double next_parameter(const geometry::Nurbs& curve, StepRule rule, double u, double s, double distance) {
  if (rule == StepRule::arc_length) return curve.parameter(std::min(s + distance, curve.length()));
  if (!(distance > 0)) return u;
  return std::min(u + marching_step(curve, rule, u, distance), curve.last_parameter());
}

}  // namespace leadscrew::interpolator
