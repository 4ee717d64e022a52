#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/pecking_cycles.hpp>

namespace leadscrew::gcode {

namespace {

constexpr std::size_t pecking_x = base::index(base::Axis::X), pecking_z = base::index(base::Axis::Z);

}  // namespace

bool PeckingCycles::check(const Block& block) {
  const std::uint32_t column = block.column_of(Group::nonmodal);
  const std::string code = name(block.code(Group::nonmodal));
  if (!frame_.is_offset_only()) {
    return error("unsupported-rotation", column, code + " in turned, scaled or mirrored coordinates",
                 "the turning cycles take offsets only");
  }
  if (modal_.feed_mode == FeedMode::inverse_time)
    return error("bad-feed-mode", column, code + " in G93", "give G98 or G99");
  for (const base::Axis axis : base::all_axes) {
    const char letter = base::letter(axis);
    if (axis == base::Axis::X || axis == base::Axis::Z || !block.has(letter)) continue;
    return error("unused-word", block.column_of(letter), code + " does not move axis " + letter,
                 "move it in a block before");
  }
  return true;
}

// P or Q, which a way needs.
bool PeckingCycles::step_of(const Block& block, char letter, double way, double& step) {
  step = block.value_or(letter, 0) * frame_.length_unit;
  if (way == 0 || step > 0) return true;
  const std::string code = name(block.code(Group::nonmodal));
  if (!block.has(letter)) {
    return error("missing-word", block.column_of(Group::nonmodal), code + " lacks " + letter,
                 letter == 'P' ? "P is the step along X, of the radius" : "Q is the step along Z");
  }
  return error("bad-value", block.column_of(letter), code + " has " + letter + text(block[letter]),
               std::string(1, letter) + " must be above 0");
}

bool PeckingCycles::plan(const Block& block, Plan& plan) {
  const bool is_face = block.is(Code::G74_face);
  const char along_letter = is_face ? 'Z' : 'X';
  if (!block.has(along_letter)) {
    return error("missing-word", block.column_of(Group::nonmodal),
                 name(block.code(Group::nonmodal)) + " lacks " + along_letter, "it is the bottom");
  }
  plan.along = is_face ? pecking_z : pecking_x;
  plan.across = is_face ? pecking_x : pecking_z;
  const base::AxisVector target = motion_.target_of(block);
  plan.depth = target[plan.along] - frame_.position[plan.along];
  plan.width = target[plan.across] - frame_.position[plan.across];
  if (!step_of(block, is_face ? 'Q' : 'P', plan.depth, plan.peck)) return false;
  if (!step_of(block, is_face ? 'P' : 'Q', plan.width, plan.step)) return false;
  plan.relief = block.value_or('R', 0) * frame_.length_unit;
  if (plan.width > 0) plan.relief = -plan.relief;
  return motion_.feed_of(block, true, block.has('F'), plan.feed);
}

void PeckingCycles::peck(const Block& block) {
  constexpr std::uint32_t settings = letter_bit('R') | letter_bit('N');
  if (!(block.words & ~settings)) {
    if (block.value_or('R', 0) < 0) {
      error("bad-value", block.column_of('R'), "the tool goes back by " + text(block['R']), "R must be 0 or more");
    } else {
      retract_ = block.value_or('R', retract_);
    }
    return;
  }
  Plan cycle;
  if (!check(block) || !plan(block, cycle)) return;
  planned_.begin(block);
  const double along = planned_.position()[cycle.along], across = planned_.position()[cycle.across];
  const double size = std::fabs(cycle.width);
  for (double way = 0; !planned_.failed();) {
    peck_at(across + std::copysign(way, cycle.width), cycle);
    if (way >= size) break;
    way = std::min(way + cycle.step, size);
    go(cycle, along, across + std::copysign(way, cycle.width), Feed{});
  }
  go(cycle, along, across, Feed{});
}

// To the bottom and back.
void PeckingCycles::peck_at(double across, const Plan& plan) {
  const double from = planned_.position()[plan.along], depth = std::fabs(plan.depth);
  const auto at = [&](double way) { return from + std::copysign(way, plan.depth); };
  for (double way = 0; way < depth && !planned_.failed();) {
    way = std::min(way + plan.peck, depth);
    go(plan, at(way), across, plan.feed);
    if (way < depth) go(plan, at(std::max(way - retract_ * frame_.length_unit, 0.0)), across, Feed{});
  }
  if (plan.relief != 0) go(plan, at(depth), across + plan.relief, Feed{});
  go(plan, from, across + plan.relief, Feed{});
}

void PeckingCycles::go(const Plan& plan, double along, double across, const Feed& feed) {
  std::array<double, 3> to = planned_.position();
  to[plan.along] = along;
  to[plan.across] = across;
  planned_.line(to, feed);
}

}  // namespace leadscrew::gcode
