// G81, G82, G83 and G85: canned cycles. What is said in the first block of a series holds for those that follow.

#include <algorithm>
#include <leadscrew/gcode/interpreter.hpp>
#include <leadscrew/gcode/number.hpp>

namespace leadscrew::gcode {

namespace {

constexpr double most_steps = 100'000;  // holes of one block, and pecks of one hole

}  // namespace

// Levels along the axis of the hole; R and the bottom hold for the cycles that follow.
bool Interpreter::plan_levels(const Block& block, DrillCycle::Plan& plan) {
  const std::size_t drill = base::index(plan.drill);
  const char drill_letter = base::letter(plan.drill);
  const bool absolute = distance_ == Distance::absolute;
  if (block.has('R')) series_->r = block['R'] * frame_.length_unit;
  if (block.has(drill_letter)) series_->bottom = block[drill_letter] * frame_.length_unit;
  if (!series_->r || !series_->bottom) {
    const char missing = series_->bottom ? 'R' : drill_letter;
    return error("missing-word", motion_column(block), g_name(plan.code) + " lacks " + missing,
                 "give R and " + std::string(1, drill_letter) + " in the first block of a cycle");
  }
  plan.r_level = *series_->r + (absolute ? frame_.sum()[drill] : plan.start[drill]);
  plan.bottom = *series_->bottom + (absolute ? frame_.sum()[drill] : plan.r_level);
  plan.clear_level = retract_ == Retract::r_level ? plan.r_level : std::max(plan.r_level, series_->initial_level);
  if (plan.bottom < plan.r_level) return true;
  return error("cycle-levels", block.has(drill_letter) ? block.column_of(drill_letter) : motion_column(block),
               "the bottom at " + text(plan.bottom) + " mm is not below R at " + text(plan.r_level) + " mm",
               "R must be above the bottom of the hole");
}

bool Interpreter::can_drill(const Block& block) {
  for (const base::Axis axis : base::all_axes) {
    const bool linear = axis == base::Axis::X || axis == base::Axis::Y || axis == base::Axis::Z;
    if (!linear && block.has(base::letter(axis))) {
      return error("unused-word", block.column_of(base::letter(axis)),
                   std::string("a canned cycle does not move axis ") + base::letter(axis), "move it in a block before");
    }
  }
  if (feed_mode_ == FeedMode::inverse_time) {
    return error("bad-feed-mode", motion_column(block), "a canned cycle in G93", "give G94");
  }
  if (frame_.is_rotated() && plane_ != Plane::XY) {
    return error("unsupported-rotation", motion_column(block),
                 "a canned cycle of G18 or G19 in a rotated coordinate system",
                 "rotated systems take cycles of G17 only");
  }
  return true;
}

void Interpreter::plan_repeats(const Block& block, DrillCycle::Plan& plan) {
  const std::optional<int> repeats = as_integer(block.value_or('L', 1));
  if (!repeats || *repeats < 1 || *repeats > most_steps) {
    error("bad-value", block.column_of('L'), "a canned cycle has L" + text(block['L']), "an integer from 1 to 100000");
    return;
  }
  plan.repeats = *repeats;
}

void Interpreter::plan_dwell(const Block& block, DrillCycle::Plan& plan) {
  if (block.has('P')) series_->dwell = block['P'];
  if (!series_->dwell) error("missing-word", motion_column(block), "G82 lacks P", "give the dwell, seconds");
  plan.dwell_seconds = series_->dwell.value_or(0);
  if (plan.dwell_seconds < 0) {
    error("bad-value", block.has('P') ? block.column_of('P') : motion_column(block),
          "the dwell is " + text(plan.dwell_seconds) + " s", "P must be 0 or more");
    series_->dwell = 0;
  }
}

void Interpreter::plan_pecks(const Block& block, DrillCycle::Plan& plan) {
  if (block.has('Q')) series_->peck = block['Q'] * frame_.length_unit;
  if (!series_->peck) error("missing-word", motion_column(block), "G83 lacks Q", "give the depth of a peck");
  plan.peck = series_->peck.value_or(1);
  if (!(plan.peck > 0) || !((plan.r_level - plan.bottom) / plan.peck <= most_steps)) {
    error("bad-value", block.has('Q') ? block.column_of('Q') : motion_column(block),
          "the peck is " + text(plan.peck) + " mm", "above 0, and at most 100000 pecks to the bottom");
    series_->peck.reset();
  }
}

void Interpreter::drill(const Block& block) {
  if (!can_drill(block)) return;
  DrillCycle::Plan plan;
  plan.code = to_do_;
  plan.drill = normal_axis(plane_);
  plan.start = frame_.position;
  plan.first_hole = target_of(block);
  const std::size_t drill = base::index(plan.drill);
  if (distance_ == Distance::incremental) {
    for (std::size_t i = 0; i < base::axis_count; ++i) plan.increment[i] = plan.first_hole[i] - plan.start[i];
  }

  if (!series_) series_ = CycleSeries{.initial_level = plan.start[drill]};
  if (series_->code != plan.code) series_ = CycleSeries{.code = plan.code, .initial_level = series_->initial_level};
  const bool levels = plan_levels(block, plan);
  plan_repeats(block, plan);
  if (plan.code == 820) plan_dwell(block, plan);
  if (plan.code == 830) plan_pecks(block, plan);
  base::AxisVector down = plan.first_hole;
  down[drill] = plan.bottom;
  Feed feed;
  feed_of(block, is_linear(down), block.has('F'), feed);
  feed.value = linear_feed_;
  if (!levels) {
    frame_.position = plan.first_hole;
    return;
  }
  cycle_feed_ = feed;
  cycle_ = DrillCycle(plan);
  fails_outside(block);
  // Between the first and the last hole, and between the levels, all is straight: the corners tell.
  base::AxisVector up = cycle_.end();
  up[drill] = std::max(plan.clear_level, plan.start[drill]);
  if (inside_travel(block, down)) inside_travel(block, up);
}

}  // namespace leadscrew::gcode
