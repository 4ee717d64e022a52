#include <algorithm>
#include <leadscrew/gcode/cycles.hpp>

namespace leadscrew::gcode {

namespace {

constexpr double most_steps = 100'000;  // holes of one block, and pecks of one hole

}  // namespace

// Levels along the axis of the hole; R and the bottom hold for the cycles that follow, as numbers, which are read in
// the units of the block that uses them. In G91 the bottom is seen from R,
// and R from the level at which the series began (LinuxCNC manual, G Codes, "Canned Cycles"): holes of a row are equally
// deep.
bool CannedCycles::plan_levels(const Block& block, DrillCycle::Plan& plan) {
  const std::size_t drill = base::index(plan.drill);
  const char drill_letter = base::letter(plan.drill);
  const bool absolute = modal_.distance == Distance::absolute;
  if (block.has('R')) series_->r = block['R'];
  if (block.has(drill_letter)) series_->bottom = block[drill_letter];
  if (!series_->r || !series_->bottom) {
    const char missing = series_->bottom ? 'R' : drill_letter;
    return error("missing-word", motion_column(block), name(plan.code) + " lacks " + missing,
                 "give R and " + std::string(1, drill_letter) + " in the first block of a cycle");
  }
  plan.r_level = *series_->r * frame_.length_unit + (absolute ? frame_.sum()[drill] : series_->initial_level);
  plan.bottom = *series_->bottom * frame_.length_unit + (absolute ? frame_.sum()[drill] : plan.r_level);
  plan.clear_level = modal_.retract == Retract::r_level ? plan.r_level : std::max(plan.r_level, series_->initial_level);
  if (plan.bottom <= plan.r_level) return true;
  return error("cycle-levels", block.has(drill_letter) ? block.column_of(drill_letter) : motion_column(block),
               "the bottom at " + text(plan.bottom) + " mm is above R at " + text(plan.r_level) + " mm",
               "the bottom of the hole must not be above R");
}

bool CannedCycles::can_drill(const Block& block) {
  for (const base::Axis axis : base::all_axes) {
    const bool linear = axis == base::Axis::X || axis == base::Axis::Y || axis == base::Axis::Z;
    if (!linear && block.has(base::letter(axis))) {
      return error("unused-word", block.column_of(base::letter(axis)),
                   std::string("a canned cycle does not move axis ") + base::letter(axis), "move it in a block before");
    }
  }
  if (modal_.feed_mode == FeedMode::inverse_time) {
    return error("bad-feed-mode", motion_column(block), "a canned cycle in G93", "give G94");
  }
  if (frame_.is_rotated() && modal_.plane != Plane::XY) {
    return error("unsupported-rotation", motion_column(block),
                 "a canned cycle of G18 or G19 in a rotated coordinate system",
                 "rotated systems take cycles of G17 only");
  }
  return true;
}

void CannedCycles::plan_repeats(const Block& block, DrillCycle::Plan& plan) {
  const std::optional<int> repeats = as_integer(block.value_or('L', 1));
  if (!repeats || *repeats < 1 || *repeats > most_steps) {
    error("bad-value", block.column_of('L'), "a canned cycle has L" + text(block['L']), "an integer from 1 to 100000");
    return;
  }
  plan.repeats = *repeats;
}

void CannedCycles::plan_dwell(const Block& block, DrillCycle::Plan& plan) {
  if (block.has('P')) series_->dwell = block['P'];
  if (!series_->dwell) error("missing-word", motion_column(block), "G82 lacks P", "give the dwell, seconds");
  plan.dwell_seconds = series_->dwell.value_or(0);
  if (plan.dwell_seconds < 0) {
    error("bad-value", block.has('P') ? block.column_of('P') : motion_column(block),
          "the dwell is " + text(plan.dwell_seconds) + " s", "P must be 0 or more");
    series_->dwell = 0;
  }
}

void CannedCycles::plan_pecks(const Block& block, DrillCycle::Plan& plan) {
  if (block.has('Q')) series_->peck = block['Q'];
  if (!series_->peck) error("missing-word", motion_column(block), "G83 lacks Q", "give the depth of a peck");
  plan.peck = series_->peck.value_or(1) * frame_.length_unit;
  if (!(plan.peck > 0) || !((plan.r_level - plan.bottom) / plan.peck <= most_steps)) {
    error("bad-value", block.has('Q') ? block.column_of('Q') : motion_column(block),
          "the peck is " + text(plan.peck) + " mm", "above 0, and at most 100000 pecks to the bottom");
    series_->peck.reset();
  }
}

void CannedCycles::drill(const Block& block) {
  if (!can_drill(block)) return;
  DrillCycle::Plan plan;
  plan.code = modal_.to_do;
  plan.drill = normal_axis(modal_.plane);
  plan.start = frame_.position;
  plan.first_hole = motion_.target_of(block);
  const std::size_t drill = base::index(plan.drill);
  if (modal_.distance == Distance::incremental) {
    for (std::size_t i = 0; i < base::axis_count; ++i) plan.increment[i] = plan.first_hole[i] - plan.start[i];
  }

  if (!series_) series_ = Series{.initial_level = plan.start[drill]};
  if (series_->code != plan.code) series_ = Series{.code = plan.code, .initial_level = series_->initial_level};
  const bool levels = plan_levels(block, plan);
  plan_repeats(block, plan);
  if (plan.code == Code::G82) plan_dwell(block, plan);
  if (plan.code == Code::G83) plan_pecks(block, plan);
  base::AxisVector down = plan.first_hole;
  down[drill] = plan.bottom;
  Feed feed;
  motion_.feed_of(block, motion_.is_linear(down), block.has('F'), feed);
  feed.value = modal_.linear_feed;
  if (!levels) {
    frame_.position = plan.first_hole;
    return;
  }
  cycle_feed_ = feed;
  cycle_ = DrillCycle(plan);
  travel_.fails_outside(block);
  // Between the first and the last hole, and between the levels, all is straight: the corners tell.
  base::AxisVector up = cycle_.end();
  up[drill] = std::max(plan.clear_level, plan.start[drill]);
  if (travel_.inside_travel(block, down)) travel_.inside_travel(block, up);
}

bool CannedCycles::next(Move& move) {
  while (cycle_.active()) {
    const DrillCycle::Step step = cycle_.next();
    if (step.kind == DrillCycle::Step::Kind::dwell) {
      outbox_.prepare(move, Move::Kind::dwell, modal_.line);
      move.dwell_seconds = cycle_.plan().dwell_seconds;
      return true;
    }
    if (step.target == frame_.position) continue;
    outbox_.prepare(move, Move::Kind::line, modal_.line);
    move.end = step.target;
    if (step.kind == DrillCycle::Step::Kind::feed) move.feed = cycle_feed_;
    frame_.position = step.target;
    return true;
  }
  return false;
}

void CannedCycles::abandon() {
  if (cycle_.active()) frame_.position = cycle_.end();
  cycle_ = {};
}

}  // namespace leadscrew::gcode
