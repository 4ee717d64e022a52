#include <algorithm>
#include <cmath>
#include <leadscrew/toolpath/axis_path.hpp>

namespace leadscrew::toolpath {

namespace {

constexpr double part_of_turn = 3;  // degrees: within it sines are nearly polynomials

bool is_turning(const kinematics::Transformation& transformation, base::AxisSet moving) {
  const auto& turns = transformation.chain.turns();
  return moving.contains(turns[0].axis) || moving.contains(turns[1].axis);
}

}  // namespace

base::AxisSet AxisPath::moving() const {
  base::AxisSet moving = geometry::moving(curve_);
  if (!transformation_) return moving;
  if (moving.empty()) return moving;
  // A table that is turned takes each of X, Y and Z in the workpiece into all three.
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z}) moving.insert(axis);
  return moving;
}

std::span<const double> AxisPath::breaks(double from, double to) const {
  const std::span all = breaks();
  const double rounding = 1e-12 * length();
  const auto first = std::ranges::upper_bound(all, from + rounding),
             last = std::ranges::lower_bound(all, to - rounding);
  return first < last ? std::span(first, last) : std::span<const double>();
}

std::size_t AxisPath::borders(double from, double to) const {
  const std::size_t borders = geometry::borders(curve_, from, to);
  if (!transformation_ || !is_turning(*transformation_, geometry::moving(curve_))) return borders;
  const geometry::Point begin = geometry::evaluate(curve_, from), end = geometry::evaluate(curve_, to);
  double turned = 0;
  for (const kinematics::Turn& turn : transformation_->chain.turns()) {
    const std::size_t i = base::index(turn.axis);
    turned += std::abs(end[i] - begin[i]);
  }
  return borders + static_cast<std::size_t>(turned / part_of_turn);
}

std::optional<geometry::Curve> standing_curve(const kinematics::Transformation& transformation,
                                              const geometry::Curve& curve) {
  if (is_turning(transformation, geometry::moving(curve))) return std::nullopt;
  const auto degrees = kinematics::angles_of(transformation.chain, geometry::start(curve));
  geometry::RigidMotion motion;
  for (std::size_t j = 0; j < 3; ++j) {
    kinematics::Vector3<double> unit{};
    unit[j] = 1;
    const auto turned = kinematics::in_machine(transformation.chain, degrees, unit);
    for (std::size_t i = 0; i < 3; ++i) motion.rotation[i][j] = turned[i];
  }
  motion.place = [&](const geometry::Point& point) { return transformation.axes_of(point); };
  return geometry::moved(curve, motion);
}

}  // namespace leadscrew::toolpath
