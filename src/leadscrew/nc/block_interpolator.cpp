#include <algorithm>
#include <cmath>
#include <leadscrew/nc/block_interpolator.hpp>
#include <numbers>

namespace leadscrew::nc {

namespace {

constexpr double quarter_turn = std::numbers::pi / 2;

/// √Σ Δ², rounded up.
std::int64_t length_rounded_up(const LatticeVector& delta, std::int64_t more) {
  std::int64_t square = more * more;
  double estimate = static_cast<double>(more) * static_cast<double>(more);
  for (const std::int64_t of_axis : delta) {
    estimate += static_cast<double>(of_axis) * static_cast<double>(of_axis);
    if (estimate < 0x1p62) square += of_axis * of_axis;
  }
  return estimate < 0x1p62 ? pulse::capacity_for(square) : static_cast<std::int64_t>(std::ceil(std::sqrt(estimate)));
}

std::int64_t longest_of(const LatticeVector& delta) {
  std::int64_t longest = 0;
  for (const std::int64_t of_axis : delta) longest = std::max(longest, pulse::absolute(of_axis));
  return longest;
}

std::int64_t sum_of(const LatticeVector& delta) {
  std::int64_t sum = 0;
  for (const std::int64_t of_axis : delta) sum += pulse::absolute(of_axis);
  return sum;
}

/// Until the last overflow of a DDA with integrands up to `longest`, a register of capacity q and p in it: the least k
/// with p + k·longest ≥ q·longest. Those with smaller integrands are done no later.
std::int64_t dda_commands(std::int64_t longest, std::int64_t capacity, std::int64_t preload) {
  return longest == 0 ? 0 : capacity - preload / longest;
}

/// What the DDA of a block's line, or that of the axes beside its circle, begins with.
std::int64_t preload_of(const Block& block, PulseMethod method, const InterpolationOptions& options) {
  // With the longest component as its capacity a DDA is Bresenham's line: preloaded with ⌊(q − 1)/2⌋ it steps the
  // shorter axes where they are more than half a step behind.
  if (block.kind == Block::Kind::line && rate_of(method) != CommandRate::path_length) return (block.capacity - 1) / 2;
  return pulse::preloaded(options.preload, block.capacity, /*is_lagging=*/true);
}

void count_line(Block& block, PulseMethod method, const InterpolationOptions& options) {
  const CommandRate rate = rate_of(method);
  if (rate == CommandRate::every_step) {
    block.commands = sum_of(block.delta);
    return;
  }
  const std::int64_t longest = longest_of(block.delta);
  block.capacity = rate == CommandRate::path_length ? length_rounded_up(block.delta, 0) : longest;
  block.commands = dda_commands(longest, block.capacity, preload_of(block, method, options));
}

/// Commands from 0 to an angle ≥ 0 on a circle of radius 1: ∫ dθ of a DDA, ∫ |sin θ| + |cos θ| dθ where axes step one
/// by one, ∫ max(|sin θ|, |cos θ|) dθ where the faster one always steps.
double commands_to(double angle, CommandRate rate) {
  if (rate == CommandRate::path_length) return angle;
  const double quarters = std::floor(angle / quarter_turn), rest = angle - quarters * quarter_turn;
  if (rate == CommandRate::every_step) return quarters * 2 + std::sin(rest) + 1 - std::cos(rest);
  const double eighth = quarter_turn / 2;
  const double within = rest <= eighth ? std::sin(rest) : 2 * std::sin(eighth) - std::cos(rest);
  return quarters * 2 * std::sin(eighth) + within;
}

/// The polar angle, in 0 … 2π, mirrored where the arc is clockwise, so that it grows along any arc.
double angle_of(pulse::Point at, pulse::Direction direction) {
  const double angle =
      std::atan2(static_cast<double>(direction) * static_cast<double>(at.y), static_cast<double>(at.x));
  return angle < 0 ? angle + 4 * quarter_turn : angle;
}

/// By which an arc may take less or more than integrated: what the path is off at its ends and between its quadrants.
constexpr std::int64_t uncertain_commands = 10;

/// Of an arc that is long beside those.
std::int64_t integrated_commands(const pulse::Arc& arc, CommandRate rate) {
  const double from = angle_of(arc.start, arc.direction);
  double to = angle_of(arc.end, arc.direction);
  if (to <= from) to += 4 * quarter_turn;
  const double radius = std::sqrt(static_cast<double>(arc.squared_radius()));
  return std::max<std::int64_t>(1, std::llround(radius * (commands_to(to, rate) - commands_to(from, rate))));
}

/// What the visitor says of the circle's interpolator at its start.
template <typename Visitor>
auto with_circle(const pulse::Arc& arc, PulseMethod method, const InterpolationOptions& options,
                 const Visitor& visitor) {
  return with_row(method, [&](auto row) { return visitor(row.circle(arc, options)); });
}

std::int64_t recorded_commands(const pulse::Arc& arc, PulseMethod method, const InterpolationOptions& options,
                               ArcTape& tape) {
  if (tape.holds(arc)) return tape.commands();
  return with_circle(arc, method, options, [&](const auto& circle) { return tape.record(arc, circle); });
}

void count_arc(Block& block, PulseMethod method, const InterpolationOptions& options, ArcTape& tape) {
  block.circle_commands = integrated_commands(block.arc, rate_of(method));
  block.uncertain = 0;
  if (block.circle_commands > ArcTape::most_commands) {
    block.uncertain = uncertain_commands;
  } else {
    block.circle_commands = recorded_commands(block.arc, method, options, tape);
  }
  block.commands = block.circle_commands;
  if (block.delta == LatticeVector{}) return;
  block.capacity = length_rounded_up(block.delta, block.circle_commands);
  block.commands = dda_commands(std::max(longest_of(block.delta), block.circle_commands), block.capacity,
                                preload_of(block, method, options));
}

}  // namespace

void count_commands(Block& block, PulseMethod method, const InterpolationOptions& options, ArcTape& tape) {
  switch (block.kind) {
    case Block::Kind::line:
      count_line(block, method, options);
      break;
    case Block::Kind::point_to_point:
      block.commands = longest_of(block.delta);
      break;
    case Block::Kind::arc:
      count_arc(block, method, options, tape);
      break;
    case Block::Kind::dwell:
      break;
  }
}

BlockInterpolator::BlockInterpolator(const Block& block, PulseMethod method, const InterpolationOptions& options,
                                     const ArcTape& tape) {
  if (block.kind == Block::Kind::arc && tape.holds(block.arc)) {
    load_arc(block, ArcTape::Player(tape), method, options);
  } else {
    *this = BlockInterpolator(block, method, options);
  }
}

BlockInterpolator::BlockInterpolator(const Block& block, PulseMethod method, const InterpolationOptions& options) {
  if (block.kind == Block::Kind::dwell) return;
  if (block.kind == Block::Kind::arc) {
    with_circle(block.arc, method, options, [&](const auto& circle) { load_arc(block, circle, method, options); });
  } else {
    load_line(block, method, options);
  }
}

void BlockInterpolator::load_line(const Block& block, PulseMethod method, const InterpolationOptions& options) {
  LatticeVector delta{};
  std::size_t axes = 0;
  for (const base::Axis axis : base::all_axes) {
    if (block.delta[base::index(axis)] == 0) continue;
    lanes_[axes] = axis;
    delta[axes++] = block.delta[base::index(axis)];
  }
  if (block.kind == Block::Kind::point_to_point) {
    state_ = PointToPoint<base::axis_count>(delta);
  } else if (axes <= 2) {
    load_line<2>(block, delta, method, options);
  } else if (axes == 3) {
    load_line<3>(block, delta, method, options);
  } else if (axes <= 5) {
    load_line<5>(block, delta, method, options);
  } else {
    load_line<base::axis_count>(block, delta, method, options);
  }
}

template <std::size_t axes>
void BlockInterpolator::load_line(const Block& block, const LatticeVector& delta, PulseMethod method,
                                  const InterpolationOptions& options) {
  std::array<std::int64_t, axes> deltas;
  std::copy_n(delta.begin(), axes, deltas.begin());
  const std::int64_t preload = preload_of(block, method, options);
  with_row(method, [&](auto row) { state_ = row.template line<axes>(deltas, block.capacity, preload); });
}

template <typename Circle>
void BlockInterpolator::load_arc(const Block& block, const Circle& circle, PulseMethod method,
                                 const InterpolationOptions& options) {
  // The circle's commands, and the displacements of the axes beside it.
  LatticeVector delta{block.circle_commands};
  std::size_t beside = 0;
  lanes_[0] = base::all_axes[block.first_axis];
  lanes_[1] = base::all_axes[block.second_axis];
  for (const base::Axis axis : base::all_axes) {
    if (block.delta[base::index(axis)] == 0) continue;
    lanes_[2 + beside] = axis;
    delta[++beside] = block.delta[base::index(axis)];
  }
  in_order_ = std::is_sorted(lanes_.begin(), lanes_.begin() + static_cast<std::ptrdiff_t>(2 + beside));
  const std::int64_t capacity = block.capacity, preload = preload_of(block, method, options);
  if (beside == 0) {
    state_ = circle;
  } else if (beside == 1) {
    state_ = Helix<Circle, 1>(circle, {std::array{delta[0], delta[1]}, capacity, preload});
  } else {
    std::array<std::int64_t, 1 + all_beside> deltas;
    std::copy_n(delta.begin(), deltas.size(), deltas.begin());
    state_ = Helix<Circle, all_beside>(circle, {deltas, capacity, preload});
  }
}

AxisPulse BlockInterpolator::step() {
  AxisPulse made;
  std::visit(
      [&](auto& state) {
        const auto pulse = state.step();
        for (std::size_t i = 0; i < pulse.step.size(); ++i) {
          made.step[base::index(lanes_[i])] += pulse.step[i];
        }
      },
      state_);
  return made;
}

namespace {

std::int64_t left(const ProgramCircle& circle, std::size_t lane) {
  return lane == 0 ? circle.left_x() : circle.left_y();
}

template <pulse::Search method>
std::int64_t left(const pulse::CircularSearch<method>&, std::size_t) {
  return 0;
}

std::int64_t left(const ArcTape::Player&, std::size_t) {
  return 0;
}

template <typename Circle, std::size_t beside>
std::int64_t left(const Helix<Circle, beside>& helix, std::size_t lane) {
  return lane < Circle::axes ? left(helix.circle(), lane) : helix.straight().left(lane - 1);
}

template <typename Line>
std::int64_t left(const Line& line, std::size_t lane) {
  return line.left(lane);
}

}  // namespace

std::int64_t BlockInterpolator::left(std::size_t axis) const {
  std::int64_t steps = 0;
  std::visit(
      [&]<typename Interpolator>(const Interpolator& state) {
        for (std::size_t i = 0; i < Interpolator::axes; ++i) {
          if (base::index(lanes_[i]) == axis) steps += nc::left(state, i);
        }
      },
      state_);
  return steps;
}

}  // namespace leadscrew::nc
