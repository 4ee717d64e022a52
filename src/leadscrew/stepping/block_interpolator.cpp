#include <algorithm>
#include <cmath>
#include <leadscrew/stepping/block_interpolator.hpp>
#include <numbers>

namespace leadscrew::stepping {

namespace {

constexpr double quarter_turn = std::numbers::pi / 2;

/// √Σ Δ², rounded up.
std::int64_t length_rounded_up(const LatticeVector& way, std::int64_t more) {
  std::int64_t square = more * more;
  double estimate = static_cast<double>(more) * static_cast<double>(more);
  for (const std::int64_t of_axis : way) {
    estimate += static_cast<double>(of_axis) * static_cast<double>(of_axis);
    if (estimate < 0x1p62) square += of_axis * of_axis;
  }
  return estimate < 0x1p62 ? pulse::capacity_for(square) : static_cast<std::int64_t>(std::ceil(std::sqrt(estimate)));
}

bool is_dda(PulseMethod method) {
  return method == PulseMethod::koren || method == PulseMethod::dda;
}

std::int64_t line_commands(const LatticeVector& way, PulseMethod method) {
  if (is_dda(method)) return length_rounded_up(way, 0);
  std::int64_t sum = 0, longest = 0;
  for (const std::int64_t of_axis : way) {
    sum += pulse::absolute(of_axis);
    longest = std::max(longest, pulse::absolute(of_axis));
  }
  return method == PulseMethod::point_comparison ? sum : longest;
}

/// Commands from 0 to an angle ≥ 0 on a circle of radius 1: ∫ dθ of a DDA, ∫ |sin θ| + |cos θ| dθ where axes step one
/// by one, ∫ max(|sin θ|, |cos θ|) dθ where the faster one always steps.
double commands_to(double angle, PulseMethod method) {
  if (is_dda(method)) return angle;
  const double quarters = std::floor(angle / quarter_turn), rest = angle - quarters * quarter_turn;
  if (method == PulseMethod::point_comparison) return quarters * 2 + std::sin(rest) + 1 - std::cos(rest);
  const double eighth = quarter_turn / 2;
  const double within = rest <= eighth ? std::sin(rest) : 2 * std::sin(eighth) - std::cos(rest);
  return quarters * 2 * std::sin(eighth) + within;
}

/// Turned so that its way is counterclockwise, in 0 … 2π.
double angle_of(pulse::Point at, pulse::Direction direction) {
  const double angle =
      std::atan2(static_cast<double>(direction) * static_cast<double>(at.y), static_cast<double>(at.x));
  return angle < 0 ? angle + 4 * quarter_turn : angle;
}

std::int64_t circle_commands(const pulse::Arc& arc, PulseMethod method) {
  const double from = angle_of(arc.start, arc.direction);
  double to = angle_of(arc.end, arc.direction);
  if (to <= from) to += 4 * quarter_turn;
  const double radius = std::sqrt(static_cast<double>(arc.squared_radius()));
  return std::max<std::int64_t>(1, std::llround(radius * (commands_to(to, method) - commands_to(from, method))));
}

}  // namespace

void count_commands(Block& block, PulseMethod method) {
  switch (block.kind) {
    case Block::Kind::line:
      block.commands = line_commands(block.way, method);
      break;
    case Block::Kind::point_to_point:
      block.commands = line_commands(block.way, PulseMethod::bresenham);
      break;
    case Block::Kind::arc:
      block.circle_commands = circle_commands(block.arc, method);
      block.commands =
          block.way == LatticeVector{} ? block.circle_commands : length_rounded_up(block.way, block.circle_commands);
      break;
    case Block::Kind::dwell:
      break;
  }
}

BlockInterpolator::BlockInterpolator(const Block& block, PulseMethod method, const InterpolationOptions& options) {
  if (block.kind == Block::Kind::dwell) return;
  load_straight(block, method, options);
  if (block.kind == Block::Kind::arc) load_circle(block, method, options);
}

void BlockInterpolator::load_straight(const Block& block, PulseMethod method, const InterpolationOptions& options) {
  has_circle_ = block.kind == Block::Kind::arc;
  LatticeVector way{};
  if (has_circle_) way[lanes_++] = block.circle_commands;
  for (std::size_t axis = 0; axis < base::axis_count; ++axis) {
    if (block.way[axis] == 0) continue;
    axis_of_[lanes_] = axis;
    way[lanes_++] = block.way[axis];
  }
  if (has_circle_ && lanes_ == 1) lanes_ = 0;  // nothing but the circle: every command is its clock
  if (lanes_ == 0) return;
  if (block.kind == Block::Kind::point_to_point) {
    straight_.emplace<PointToPoint<base::axis_count>>(way);
    return;
  }
  if (method == PulseMethod::point_comparison && block.kind == Block::Kind::line) {
    straight_.emplace<LinePointComparison<base::axis_count>>(way);
    return;
  }
  // With the longest way as its capacity a DDA is Bresenham's line: preloaded with ⌊(q − 1)/2⌋ it steps the shorter
  // axes where they are more than half a step behind.
  const std::int64_t capacity = block.commands;
  const bool is_bresenham = block.kind == Block::Kind::line && !is_dda(method);
  const std::int64_t preload =
      is_bresenham ? (capacity - 1) / 2 : pulse::preloaded(options.preload, capacity, /*is_lagging=*/true);
  if (lanes_ <= 3) {
    straight_.emplace<pulse::LinearDda<3>>(std::array{way[0], way[1], way[2]}, capacity, preload);
  } else {
    straight_.emplace<pulse::LinearDda<base::axis_count>>(way, capacity, preload);
  }
}

void BlockInterpolator::load_circle(const Block& block, PulseMethod method, const InterpolationOptions& options) {
  first_ = block.first_axis;
  second_ = block.second_axis;
  switch (method) {
    case PulseMethod::koren:
      circle_.emplace<ProgramCircle>(block.arc,
                                     pulse::CircularDdaOptions{pulse::Order::x_first, options.preload, options.places});
      break;
    case PulseMethod::dda:
      circle_.emplace<ProgramCircle>(
          block.arc, pulse::CircularDdaOptions{pulse::Order::parallel, options.preload, options.places});
      break;
    case PulseMethod::point_comparison:
      circle_.emplace<pulse::CircularSearch<pulse::Search::point_comparison>>(block.arc);
      break;
    case PulseMethod::min_error:
    case PulseMethod::bresenham:
      circle_.emplace<pulse::CircularSearch<pulse::Search::least_error>>(block.arc);
      break;
    case PulseMethod::improved_min_error:
      circle_.emplace<pulse::CircularSearch<pulse::Search::improved_least_error>>(block.arc);
      break;
  }
}

std::int64_t BlockInterpolator::left(std::size_t axis) const {
  std::int64_t steps = 0;
  if (has_circle_ && (axis == first_ || axis == second_)) {
    if (const auto* circle = std::get_if<ProgramCircle>(&circle_)) {
      steps = axis == first_ ? circle->left_x() : circle->left_y();
    }
    return steps;
  }
  for (std::size_t lane = has_circle_; lane < lanes_; ++lane) {
    if (axis_of_[lane] != axis) continue;
    with(straight_, [&](const auto& straight) { return (steps = straight.left(lane)) > 0; });
  }
  return steps;
}

}  // namespace leadscrew::stepping
