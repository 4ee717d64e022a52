#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/bisection.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/toolpath/sampling.hpp>
#include <leadscrew/toolpath/swing.hpp>
#include <leadscrew/toolpath/tolerance_space.hpp>
#include <leadscrew/toolpath/tuning.hpp>
#include <limits>

namespace leadscrew::toolpath {

using geometry::Point;

namespace {

using namespace tuning::sampling;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array tip_axes = {base::Axis::X, base::Axis::Y, base::Axis::Z};  // chord error is theirs

double cube_root_of_square(double x) {
  return numeric::cbrt(x * x);
}

}  // namespace

Sampling::Sampling(const machine::Machine& machine)
    : per_acceleration_(machine.period.seconds() * machine.period.seconds() / 8), chord_error_(machine.chord_error) {
  acceleration_.fill(infinity);
  jerk_.fill(infinity);
  for (const base::Axis axis : tip_axes) {
    if (!machine.has(axis)) continue;
    acceleration_[base::index(axis)] = machine.limits(axis).acceleration;
    jerk_[base::index(axis)] = machine.limits(axis).jerk;
  }
}

bool Sampling::needs_share() const {
  double square = 0;
  for (const base::Axis axis : tip_axes) {
    const double acceleration = acceleration_[base::index(axis)];
    if (acceleration < infinity) square += acceleration * acceleration;
  }
  return per_acceleration_ * std::sqrt(square) > chord_error_;
}

machine::Derivatives Sampling::limits_along(const Leg& leg) const {
  Point directions{};
  const base::AxisSet moving = geometry::moving(leg.curve);
  for (const base::Axis axis : tip_axes) directions[base::index(axis)] = moving.contains(axis) ? 1 : 0;
  return limits_along(directions);
}

machine::Derivatives Sampling::limits_along(const Point& direction) const {
  machine::Derivatives limits{infinity, infinity, infinity};
  for (const base::Axis axis : tip_axes) {
    const std::size_t i = base::index(axis);
    const double share = std::abs(direction[i]);
    if (!(share > 0)) continue;
    limits.acceleration = std::min(limits.acceleration, acceleration_[i] / share);
    limits.jerk = std::min(limits.jerk, jerk_[i] / share);
  }
  return limits;
}

/// The largest ε for which ε + ε_s(ε) ≤ P.
double Sampling::largest_deviation(double tolerance, const Bend& bend) const {
  const auto chords = [&](double deviation) {
    const double by_feed = deviation > 0 ? bend.by_feed / deviation : infinity;
    return per_acceleration_ * std::min({bend.acceleration, bend.by_jerk * numeric::cbrt(deviation), by_feed});
  };
  if (chords(tolerance) <= chord_error_) return tolerance;
  // ε_s is the least of three: the largest ε of all is the largest of those for each.
  const double square = tolerance * tolerance / 4 - per_acceleration_ * bend.by_feed;
  const double by_feed = square > 0 ? tolerance / 2 + std::sqrt(square) : 0;
  const auto by_jerk = numeric::bisect(0, tolerance, 50, [&](double deviation) {
    return deviation + per_acceleration_ * bend.by_jerk * numeric::cbrt(deviation) <= tolerance;
  });
  return std::max({tolerance - per_acceleration_ * bend.acceleration, by_feed, by_jerk.from});
}

double Sampling::kept_beside_spline(const Leg& leg) const {
  if (!(per_acceleration_ > 0)) return 0;
  const machine::Derivatives limits = limits_along(leg);
  if (limits.acceleration == infinity) return 0;
  const double tolerance = leg.allowance.tolerance, speed = greatest_speed(leg), turn = tuning::corner_turn;
  const double deviation = largest_deviation(
      tolerance,
      {limits.acceleration, numeric::cbrt(6) * cube_root_of_square(limits.jerk), turn * turn / 6 * speed * speed});
  return tolerance - std::max(deviation, least_share_of_spline * tolerance);
}

bool Sampling::suits_spline(const Leg& leg, double turn) const {
  if (!(per_acceleration_ > 0)) return true;
  const double jerk = limits_along(leg).jerk;
  if (jerk == infinity) return true;
  const double across = std::max(leg.kept, chord_error_) / per_acceleration_;
  return (leg.allowance.tolerance - leg.kept) * turn * turn * jerk * jerk <= 6 * across * across * across;
}

Division Sampling::at_corner(const Piece& before, const Piece& behind, double tolerance,
                             const ToleranceSpace& space) const {
  const double length = geometry::length(before.curve);
  const geometry::PointJet leaving = geometry::jets(before.curve, length), entering = geometry::jets(behind.curve, 0);
  const Point in = space.derivative(leaving, &numeric::Jet<>::first),
              out = space.derivative(entering, &numeric::Jet<>::first);
  const double speed =
      std::max(before.greatest_speed(length, leaving) * norm(in), behind.greatest_speed(0, entering) * norm(out));
  return beside_blend(tolerance, in, out, speed, is_line(before.curve) && is_line(behind.curve));
}

Division Sampling::at_joint(const Leg& before, const Leg& behind, double tolerance) const {
  const geometry::PointJet leaving = geometry::jets(before.curve, geometry::length(before.curve)),
                           entering = geometry::jets(behind.curve, 0);
  return beside_blend(tolerance, before.space.derivative(leaving, &numeric::Jet<>::first),
                      behind.space.derivative(entering, &numeric::Jet<>::first),
                      std::max(toolpath::greatest_speed(before), toolpath::greatest_speed(behind)),
                      is_line(before.curve) && is_line(behind.curve));
}

Division Sampling::beside_blend(double tolerance, const Point& leaving, const Point& entering, double speed,
                                bool are_lines) const {
  if (!(per_acceleration_ > 0)) return {};
  const double turn = turn_between(leaving, entering), in = norm(leaving), out = norm(entering);
  if (!(turn < 2)) return {};
  Point across, along;
  for (std::size_t i = 0; i < across.size(); ++i) {
    across[i] = entering[i] / out - leaving[i] / in;
    along[i] = entering[i] / out + leaving[i] / in;
  }
  const machine::Derivatives limits = limits_along(across), limits_of_sum = limits_along(along);
  if (limits_of_sum.acceleration == infinity) return {};
  const double slowed = turn * turn / (4 - turn * turn) * speed * speed;
  if (are_lines && turn > 0) {
    const double w = Swing(turn).w(), rest = 0.5 - w;
    const double p = 2 * rest * rest * rest - 0.125, first = 6 * rest * rest - 0.75, second = 12 * rest - 3;
    const double deviation =
        largest_deviation(tolerance, {turn * limits.acceleration,
                                      second / numeric::cbrt(p) * cube_root_of_square(turn * turn * limits.jerk / 6),
                                      second * p / (first * first) * slowed});
    if (deviation >= least_share_of_swing * tolerance) return {tolerance - deviation, Rounding::wide};
  }
  Bend bend{turn * limits.acceleration, 24 * cube_root_of_square(turn * limits_of_sum.jerk / 48), 2.0 / 3 * slowed};
  if (!are_lines) {
    // They bend themselves, as a spline does, also where they have one tangent: then the sum is twice that.
    const double by_jerk = numeric::cbrt(6) * cube_root_of_square(2 * limits_of_sum.jerk);
    bend = {2 * limits_of_sum.acceleration, std::max(bend.by_jerk, by_jerk), infinity};
  }
  const double deviation = largest_deviation(tolerance, bend);
  const double rounded = std::max(deviation, std::min(least_share_of_cut * tolerance, 2 * deviation));
  if (rounded < least_tolerance) return {tolerance, Rounding::none};
  return {tolerance - rounded, Rounding::cut};
}

}  // namespace leadscrew::toolpath
