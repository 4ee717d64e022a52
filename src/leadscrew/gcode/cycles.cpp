#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/cycles.hpp>

namespace leadscrew::gcode {

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
  const double unit = frame_.length_unit * (is_tilted_ ? 1 : frame_.scale(plan.drill));
  const double zero = is_tilted_ ? 0 : frame_.offset()[drill];
  plan.r_level = *series_->r * unit + (absolute ? zero : series_->initial_level);
  plan.bottom = *series_->bottom * unit + (absolute ? zero : plan.r_level);
  plan.clear_level = modal_.retract == Retract::r_level ? plan.r_level : std::max(plan.r_level, series_->initial_level);
  // LinuxCNC's cycles feed out to the clear level, but for G85, which feeds to R, as all do elsewhere (LinuxCNC manual,
  // G74, G84, G85, G89).
  const bool as_linuxcnc = options_.dialect == Dialect::leadscrew || options_.dialect == Dialect::linuxcnc;
  plan.out_level = as_linuxcnc && plan.code != Code::G85 ? plan.clear_level : plan.r_level;
  if (plan.bottom <= plan.r_level) return true;
  return error("cycle-levels", block.has(drill_letter) ? block.column_of(drill_letter) : motion_column(block),
               "the bottom at " + text(plan.bottom) + " mm is above R at " + text(plan.r_level) + " mm",
               "the bottom of the hole must not be above R");
}

bool CannedCycles::can_drill(const Block& block) {
  for (const base::Axis axis : base::all_axes) {
    const bool is_its_own =
        axis == first_axis(modal_.plane) || axis == second_axis(modal_.plane) || axis == normal_axis(modal_.plane);
    if (!is_its_own && block.has(base::letter(axis))) {
      return error("unused-word", block.column_of(base::letter(axis)),
                   std::string("a canned cycle does not move axis ") + base::letter(axis), "move it in a block before");
    }
  }
  if (modal_.feed_mode == FeedMode::inverse_time) {
    return error("bad-feed-mode", motion_column(block), "a canned cycle in G93", "give G94");
  }
  return can_reach(block);
}

// Holes go along the tool.
bool CannedCycles::can_reach(const Block& block) {
  is_tilted_ = frame_.is_tilted();
  const base::Axis axis = normal_axis(modal_.plane);
  if (is_secondary(modal_.plane) && (is_tilted_ || frame_.tip_control())) {
    return error("tool-not-along", motion_column(block), std::string("a canned cycle along ") + base::letter(axis),
                 "give G17, G18 or G19 before: the tool is along none of U, V and W");
  }
  if ((is_tilted_ || frame_.tip_control()) && !frame_.is_tool_along(axis)) {
    return error("tool-not-along", motion_column(block),
                 std::string("a canned cycle along ") + base::letter(axis) + (is_tilted_ ? " of a tilted plane" : "") +
                     ", and the tool is not",
                 frame_.tip_control() ? "rotary axes turned so that it is, or lines for the holes" : "G53.1 before it");
  }
  if (is_tilted_ || frame_.is_separate(axis)) return true;
  return error("unsupported-rotation", motion_column(block), "a canned cycle whose holes are turned off the axis",
               "turns take cycles in their own plane only");
}

// A place, in the coordinates of the cycle.
base::AxisVector CannedCycles::seen(const base::AxisVector& place) const {
  return is_tilted_ ? frame_.to_program(place) : place;
}

// The way back. A cycle moves no other axes.
base::AxisVector CannedCycles::placed(const base::AxisVector& target) const {
  if (!is_tilted_) return target;
  base::AxisVector place = frame_.to_machine(target);
  for (std::size_t i = base::index(base::Axis::A); i < base::axis_count; ++i) place[i] = frame_.position[i];
  return place;
}

// How often; 0, where Fanuc and Haas have it, only says what holds for the holes that follow.
void CannedCycles::plan_repeats(const Block& block, DrillCycle::Plan& plan) {
  const int least = is_of_fanuc_family(options_.dialect) ? 0 : 1;
  const std::optional<int> repeats = as_integer(block.value_or('L', 1));
  if (!repeats || *repeats < least || *repeats > most_steps) {
    error("bad-value", block.column_of('L'), "a canned cycle has L" + text(block['L']),
          "an integer from " + std::to_string(least) + " to 100000");
    return;
  }
  plan.repeats = *repeats;
}

void CannedCycles::plan_dwell(const Block& block, DrillCycle::Plan& plan) {
  if (block.has('P')) series_->dwell = block['P'];
  // LinuxCNC needs P of all of these; other controllers go on at once without.
  const bool strict = options_.dialect == Dialect::linuxcnc &&
                      (plan.code == Code::G86 || plan.code == Code::G88 || plan.code == Code::G89);
  if (!series_->dwell && (plan.code == Code::G82 || strict)) {
    error("missing-word", motion_column(block), name(plan.code) + " lacks P", "give the dwell, seconds");
  }
  plan.dwells = series_->dwell.has_value();
  plan.dwell_seconds = series_->dwell.value_or(0);
  if (plan.dwell_seconds < 0) {
    error("bad-value", block.has('P') ? block.column_of('P') : motion_column(block),
          "the dwell is " + text(plan.dwell_seconds) + " s", "P must be 0 or more");
    series_->dwell = 0;
  }
}

// Pecks of Q, or, as Haas has it, the first of I, each less by J, and none below K.
void CannedCycles::plan_pecks(const Block& block, DrillCycle::Plan& plan) {
  if (block.has('Q')) series_->peck = block['Q'];
  if (block.has('I')) series_->first_peck = block['I'];
  if (block.has('J')) series_->peck_step = block['J'];
  if (block.has('K')) series_->least_peck = block['K'];
  const double unit = frame_.length_unit;
  const double whole = plan.r_level - plan.bottom;
  if (series_->first_peck) {
    plan.peck = *series_->first_peck * unit;
    plan.peck_step = series_->peck_step.value_or(0) * unit;
    plan.least_peck = plan.peck_step > 0 ? series_->least_peck.value_or(*series_->first_peck) * unit : 0;
  } else if (!series_->peck && options_.dialect == Dialect::haas) {
    plan.peck = std::max(whole, 1.0);  // all at once
  } else {
    if (!series_->peck) {
      error("missing-word", motion_column(block), name(plan.code) + " lacks Q", "give the depth of a peck");
    }
    plan.peck = series_->peck.value_or(1) * unit;
  }
  const double least = plan.peck_step > 0 ? plan.least_peck : plan.peck;
  if (!(plan.peck > 0 && plan.peck_step >= 0 && least > 0) || !(whole / least <= most_steps)) {
    const char letter = block.has('Q') ? 'Q' : 'I';
    error("bad-value", block.has(letter) ? block.column_of(letter) : motion_column(block),
          "the peck is " + text(least) + " mm", "above 0, and at most 100000 pecks to the bottom");
    series_->peck.reset();
    series_->first_peck.reset();
  }
}

// Off the wall of the hole: by I and J, or, in Fanuc's cycles, by Q along the first axis.
void CannedCycles::plan_aside(const Block& block, DrillCycle::Plan& plan) {
  const base::Axis first = first_axis(modal_.plane), second = second_axis(modal_.plane);
  if (block.has('Q')) series_->aside_first = block['Q'];
  const auto letter_aside = [](base::Axis axis) { return static_cast<char>('I' + base::index(axis) % 3); };
  const char letters[] = {letter_aside(first), letter_aside(second)};
  if (block.has(letters[0])) series_->aside_first = block[letters[0]];
  if (block.has(letters[1])) series_->aside_second = block[letters[1]];
  plan.aside[base::index(first)] = series_->aside_first.value_or(0) * frame_.length_unit;
  plan.aside[base::index(second)] = series_->aside_second.value_or(0) * frame_.length_unit;
  if (!is_tilted_) plan.aside = frame_.direction_to_machine(plan.aside);
  if (plan.code != Code::G87) return warn_of_wall(block);
  const char level = letter_aside(plan.drill);
  if (block.has(level)) series_->level = block[level];
  if (!series_->level || !(series_->aside_first || series_->aside_second)) {
    error("missing-word", motion_column(block), "G87 lacks how far aside the tool goes in, or how far up it bores",
          std::string("give ") + letters[0] + ", " + letters[1] + " and " + level);
  }
  const double zero = is_tilted_ ? 0 : frame_.offset()[base::index(plan.drill)];
  plan.level = series_->level.value_or(0) * frame_.length_unit * (is_tilted_ ? 1 : frame_.scale(plan.drill)) +
               (modal_.distance == Distance::absolute ? zero : plan.bottom);
}

// G76 of boring.
void CannedCycles::warn_of_wall(const Block& block) {
  const bool leaves_wall = series_->aside_first.value_or(0) != 0 || series_->aside_second.value_or(0) != 0;
  if (leaves_wall || std::exchange(series_->told_of_wall, true)) return;
  const bool has_any = block.has('Q') || block.has('I') || block.has('J') || block.has('K');
  reporter_.warning("missing-word", motion_column(block),
                    std::string("the tool leaves along the wall: G76 ") + (has_any ? "says 0" : "lacks Q"),
                    "give Q, how far aside it leaves");
}

// A tapping cycle, and one that stops the spindle, goes on with what turned before.
bool CannedCycles::can_turn(const Block& block) {
  const Code code = modal_.to_do, spindle = modal_.spindle;
  const bool taps = code == Code::G74 || code == Code::G84;
  if (!taps && code != Code::G86 && code != Code::G87 && code != Code::G88) return true;
  if (spindle == Code::M5 && options_.dialect == Dialect::linuxcnc) {
    return error("spindle-stands", motion_column(block), "the spindle stands in " + name(code), "give M3 or M4 before");
  }
  if (!taps || spindle == Code::M5 || spindle == (code == Code::G84 ? Code::M3 : Code::M4)) return true;
  return error(
      "spindle-turns-back", motion_column(block),
      std::string("the spindle turns ") + (code == Code::G84 ? "counterclockwise" : "clockwise") + " in " + name(code),
      code == Code::G84 ? "give M3 before" : "give M4 before");
}

// What a block says of the series that it belongs to.
void CannedCycles::plan_series(const Block& block, DrillCycle::Plan& plan) {
  plan_dwell(block, plan);
  if (plan.code == Code::G73 || plan.code == Code::G83) plan_pecks(block, plan);
  if (plan.code == Code::G74 || plan.code == Code::G84) plan_tap(block, plan);
  if (plan.code == Code::G76_bore || plan.code == Code::G87) plan_aside(block, plan);
}

void CannedCycles::drill(const Block& block) {
  if (!can_drill(block)) return;
  DrillCycle::Plan plan;
  plan.code = modal_.to_do;
  plan.drill = normal_axis(modal_.plane);
  plan.start = seen(frame_.position);
  plan.first_hole = seen(motion_.target_of(block));
  const std::size_t drill = base::index(plan.drill);
  if (modal_.distance == Distance::incremental) {
    for (std::size_t i = 0; i < base::axis_count; ++i) {
      plan.pattern.increment[i] = plan.first_hole[i] - plan.start[i];
    }
  }

  if (!series_) series_ = Series{.initial_level = plan.start[drill]};
  if (series_->code != plan.code) series_ = Series{.code = plan.code, .initial_level = series_->initial_level};
  const bool levels = plan_levels(block, plan);
  plan_repeats(block, plan);
  plan_series(block, plan);
  const bool turns = can_turn(block);
  set_cycle_feed(block);
  if (!levels || !turns) {
    frame_.position = placed(plan.first_hole);
    return;
  }
  if (plan.repeats > 0) begin(block, plan);
}

// Holes are cut along linear axes.
void CannedCycles::set_cycle_feed(const Block& block) {
  motion_.feed_of(block, true, block.has('F'), cycle_feed_);
}

void CannedCycles::begin(const Block& block, const DrillCycle::Plan& whole) {
  DrillCycle::Plan plan = whole;
  plan.follows = machine_.threads_follow() && (plan.code == Code::G74 || plan.code == Code::G84) && tap_lead();
  const std::size_t drill = base::index(plan.drill);
  cycle_ = DrillCycle(plan);
  if (!can_tap(block, plan)) return;
  if (modal_.tool_is_aside) come_back(plan);
  at_ = plan.start;
  travel_.fails_outside(block);
  const double top = std::max(plan.clear_level, plan.start[drill]);
  // Between the first and the last hole of a row, and between the levels, all is straight: the corners tell.
  const int step = plan.pattern.radius != 0 ? 1 : std::max(1, plan.repeats - 1);
  for (int i = 0; i < plan.repeats; i += step) {
    base::AxisVector down = cycle_.hole(i), up = down;
    down[drill] = std::min(plan.bottom, plan.code == Code::G87 ? plan.level : plan.bottom);
    up[drill] = top;
    base::AxisVector aside = up;
    for (std::size_t k = 0; k < base::axis_count; ++k) aside[k] += plan.aside[k];
    if (!travel_.inside_travel(block, placed(down)) || !travel_.inside_travel(block, placed(up))) return;
    if (aside != up && !travel_.inside_travel(block, placed(aside))) return;
  }
}

// Behind G40 the tool may still stand beside the contour, and the first hole lie where the program stands. A rise to R would
// lead back as well.
void CannedCycles::come_back(const DrillCycle::Plan& plan) {
  constexpr double rounding = 1e-9;  // mm, of a tilted plane
  if (plan.start[base::index(plan.drill)] < plan.r_level - rounding) return;
  for (const base::Axis axis : {first_axis(modal_.plane), second_axis(modal_.plane)}) {
    const std::size_t i = base::index(axis);
    if (std::fabs(cycle_.hole(0)[i] - plan.start[i]) > (is_tilted_ ? rounding : 0)) return;
  }
  outbox_.emit(Move::Kind::line).feed.mode = Feed::Mode::rapid;
}

// Where G70, G71 and G72 have their holes: I the radius or the distance, mm, J the first angle and K the step, degrees, L
// how many.
void CannedCycles::plan_pattern(const Block& block, DrillCycle::Plan& plan) {
  const double distance = block['I'] * frame_.length_unit, angle = block.value_or('J', 0);
  plan.pattern.first = first_axis(modal_.plane);
  plan.pattern.second = second_axis(modal_.plane);
  if (block.is(Code::G72_bolts)) {
    plan.pattern.increment[base::index(plan.pattern.first)] = distance * cosine_of_degrees(angle);
    plan.pattern.increment[base::index(plan.pattern.second)] = distance * sine_of_degrees(angle);
    if (!is_tilted_) plan.pattern.increment = frame_.direction_to_machine(plan.pattern.increment);
    return;
  }
  plan.pattern.radius = distance;
  plan.pattern.start_angle = angle;
  plan.pattern.step_angle = block.is(Code::G71_bolts) ? block['K'] : 360.0 / std::max(plan.repeats, 1);
}

void CannedCycles::drill_pattern(const Block& block) {
  const Code code = block.code(Group::nonmodal);
  if (!series_ || !is_canned_cycle(modal_.motion) || modal_.motion != series_->code) {
    error("missing-cycle", block.column_of(Group::nonmodal), name(code) + " stands without a cycle in force",
          "give the cycle with L0 in the block before");
    return;
  }
  if ((row(code).needs.bits & ~block.words) || !can_reach(block)) return;
  DrillCycle::Plan plan;
  plan.code = series_->code;
  plan.drill = normal_axis(modal_.plane);
  plan.start = plan.first_hole = seen(frame_.position);
  // The letters of the pattern are not those of the cycle.
  Block bare = block;
  bare.words &= ~row(code).words.bits;
  if (!plan_levels(bare, plan)) return;
  plan_repeats(block, plan);
  plan_series(bare, plan);
  plan_pattern(block, plan);
  set_cycle_feed(block);
  if (plan.repeats > 0) begin(block, plan);
}

// In a tilted plane the cycle begins where rounding leaves the program's coordinates.
bool CannedCycles::stands_at(const base::AxisVector& target) const {
  if (!is_tilted_) return false;
  constexpr double rounding = 1e-9;  // mm
  const base::AxisVector place = placed(target);
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::fabs(place[i] - frame_.position[i]) > rounding) return false;
  }
  return true;
}

bool CannedCycles::next_of_cycle(Move& move) {
  using Kind = DrillCycle::Step::Kind;
  while (cycle_.active()) {
    const DrillCycle::Step step = cycle_.next();
    if (step.kind == Kind::dwell) {
      outbox_.prepare(move, Move::Kind::dwell, modal_.line);
      move.dwell_seconds = cycle_.plan().dwell_seconds;
      return true;
    }
    if (step.kind != Kind::rapid && step.kind != Kind::feed) {
      if (prepare_event(move, step.kind)) return true;
      continue;
    }
    if (step.target == at_ || stands_at(step.target)) continue;
    outbox_.prepare(move, Move::Kind::line, modal_.line);
    at_ = step.target;
    move.end = placed(step.target);
    if (step.kind == Kind::feed) move.feed = cycle_feed_;
    if (step.is_fast) move.feed.value *= cycle_.plan().out_factor;
    frame_.position = move.end;
    return true;
  }
  return false;
}

void CannedCycles::abandon() {
  if (cycle_.active()) frame_.position = placed(cycle_.end());
  cycle_ = {};
}

}  // namespace leadscrew::gcode
