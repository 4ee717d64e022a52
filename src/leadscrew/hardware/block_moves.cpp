#include <algorithm>
#include <leadscrew/hardware/block_moves.hpp>

namespace leadscrew::hardware {

namespace {

constexpr std::int64_t most_steps = (std::int64_t{1} << model_width) - 1;
constexpr std::int64_t greatest_radius = (std::int64_t{1} << (model_width - 1)) - 2;

BlockMove refused(BlockMove::Problem problem, std::size_t axis) {
  return {problem, axis, {}};
}

BlockMove line_of(const nc::Block& block, const Lanes& lanes) {
  BlockMove made;
  for (std::size_t axis = 0; axis < block.delta.size(); ++axis) {
    const std::int64_t steps = block.delta[axis];
    if (steps == 0) continue;
    const auto lane = lanes.of(axis);
    if (!lane) return refused(BlockMove::Problem::axis, axis);
    if (pulse::absolute(steps) > most_steps) return refused(BlockMove::Problem::too_long, axis);
    made.move.delta[*lane] = static_cast<std::int32_t>(steps);
  }
  return made;
}

BlockMove arc_of(const nc::Block& block, const Lanes& lanes) {
  for (std::size_t axis = 0; axis < block.delta.size(); ++axis) {
    if (block.delta[axis] != 0) return refused(BlockMove::Problem::helix, axis);
  }
  for (const std::size_t axis : {block.first_axis, block.second_axis}) {
    if (!lanes.of(axis)) return refused(BlockMove::Problem::axis, axis);
  }
  for (const pulse::Point at : {block.arc.start, block.arc.end}) {
    if (std::max(pulse::absolute(at.x), pulse::absolute(at.y)) > greatest_radius)
      return refused(BlockMove::Problem::too_long, block.first_axis);
  }
  if (block.arc.squared_radius() > greatest_radius * greatest_radius)
    return refused(BlockMove::Problem::too_long, block.first_axis);
  BlockMove made;
  made.move.kind = driver::Move::Kind::arc;
  made.move.arc = block.arc;
  made.move.first_axis = *lanes.of(block.first_axis);
  made.move.second_axis = *lanes.of(block.second_axis);
  return made;
}

}  // namespace

Lanes::Lanes(const machine::Machine& machine) {
  std::uint8_t next = 0;
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis) || next == axes_.size()) continue;
    lane_[base::index(axis)] = next;
    axes_[next++] = axis;
  }
}

std::optional<std::uint8_t> Lanes::of(std::size_t axis) const {
  return lane_[axis];
}

BlockMove move_of(const nc::Block& block, const Lanes& lanes) {
  BlockMove made;
  if (block.kind == nc::Block::Kind::dwell) {
    made.move.kind = driver::Move::Kind::dwell;
    made.move.ticks = static_cast<std::uint64_t>(block.dwell_clocks);
    return made;
  }
  made = block.kind == nc::Block::Kind::arc ? arc_of(block, lanes) : line_of(block, lanes);
  made.move.feed = static_cast<std::uint64_t>(
      std::clamp<std::int64_t>(block.feed_word, 1, std::max<std::int64_t>(block.greatest_word, 1)));
  return made;
}

}  // namespace leadscrew::hardware
