#include <algorithm>
#include <cmath>
#include <leadscrew/kinematics/chain.hpp>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/numeric/elementary.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace leadscrew::kinematics {

namespace {

/// Angles between directions that differ from a pole's by no more than this are rounding of the directions, radians.
constexpr double pole_rounding = 1e-14;

constexpr Vector tool_direction = {0, 0, 1};

Turn turn_of(const machine::RotaryAxis& axis) {
  Turn turn{axis.axis, unit_vector(axis.direction), axis.point, static_cast<double>(axis.sign), 3};
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(turn.direction[i]) != 1) continue;
    turn.principal = i;
    turn.sign *= turn.direction[i];
    turn.direction = {};
    turn.direction[i] = 1;
  }
  return turn;
}

/// The part of b across a, of length 1.
Vector part_across(const Vector& b, const Vector& a) {
  return unit_vector(numeric::sum(b, -numeric::dot(a, b), a));
}

Cones cones_of(const Vector& first, const Vector& second) {
  Cones cones;
  cones.across = part_across(second, first);
  cones.normal = cross_product(first, cones.across);
  const double between = angle_between(first, second), opening = angle_between(second, tool_direction);
  const double difference = between - opening, sum = between + opening;
  const double half_turn = 0.5 * numeric::two_pi.hi;
  if (std::abs(difference) > pole_rounding) {
    cones.difference_sine = numeric::sin(difference / 2);
    cones.difference_cosine = numeric::cos(difference / 2);
  }
  if (std::abs(sum - half_turn) > pole_rounding) {
    cones.sum_sine = numeric::sin(sum / 2);
    cones.sum_cosine = numeric::cos(sum / 2);
  }
  const Vector reference = part_across(first, second);
  cones.tool_azimuth = numeric::atan2(numeric::dot(tool_direction, cross_product(second, reference)),
                                      numeric::dot(tool_direction, reference)) *
                       numeric::degrees_of_radian.hi;
  return cones;
}

/// Does a stand nearer to the workpiece than b? Axes that carry it do, and the last of them first.
bool is_nearer_to_workpiece(const machine::RotaryAxis& a, const machine::RotaryAxis& b) {
  if (a.carries != b.carries) return a.carries == machine::Carries::workpiece;
  return (a.order > b.order) == (a.carries == machine::Carries::workpiece);
}

}  // namespace

base::Result<Chain> Chain::of(const machine::RotaryChain& chain) {
  std::vector<base::Diagnostic> problems;
  machine::check_chain(chain, problems);
  if (!problems.empty()) return base::failure(std::move(problems.front()));
  Chain result;
  std::array<machine::RotaryAxis, 2> axes = chain.axes;
  if (is_nearer_to_workpiece(axes[1], axes[0])) std::swap(axes[0], axes[1]);
  for (std::size_t i = 0; i < axes.size(); ++i) {
    result.turns_[i] = turn_of(axes[i]);
    if (axes[i].carries == machine::Carries::workpiece) ++result.table_count_;
  }
  result.tool_zero_ = chain.tool_zero;
  result.cones_ = cones_of(result.turns_[0].direction, result.turns_[1].direction);
  return result;
}

Chain chain_of(const machine::Machine& machine) {
  return *Chain::of(*machine.rotary_chain);
}

std::vector<Vector> poles_of(const Chain& chain) {
  const Vector& along = chain.turns()[0].direction;
  std::vector<Vector> poles;
  if (chain.cones().difference_sine == 0) poles.push_back(along);
  if (chain.cones().sum_cosine == 0) poles.push_back({-along[0], -along[1], -along[2]});
  return poles;
}

double angle_to_pole(const Chain& chain, const Vector& direction) {
  double least = std::numeric_limits<double>::infinity();
  for (const Vector& pole : poles_of(chain)) {
    const double half =
        numeric::atan2(numeric::distance(direction, pole), numeric::norm(numeric::sum(direction, 1, pole)));
    least = std::min(least, half * 360 / std::numbers::pi);
  }
  return least;
}

double most_turned(const Chain& chain) {
  return std::sqrt(1 + std::abs(numeric::dot(chain.turns()[0].direction, chain.turns()[1].direction)));
}

}  // namespace leadscrew::kinematics
