#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <leadscrew/gcode/interpreter.hpp>
#include <leadscrew/gcode/number.hpp>

namespace leadscrew::gcode {

namespace {

constexpr double seconds_per_minute = 60;
constexpr double most_steps = 100'000;  // holes of one block, and pecks of one hole

const char* unit_of(base::Axis axis) {
  return base::is_rotary(axis) ? " degrees" : " mm";
}

PlanePoint in_plane(const base::AxisVector& position, Plane plane) {
  return {position[base::index(first_axis(plane))], position[base::index(second_axis(plane))]};
}

// Along the helix, in X, Y and Z.
double arc_length(PlanePoint start, const Interpreter::ArcPlan& plan, const Move& arc) {
  const int direction = plan.turns > 0 ? 1 : -1;
  const PlanePoint center = plan.circle.center;
  const double angle = sweep(start, plan.circle.end, center, direction) +
                       (std::abs(plan.turns) - 1) * sweep(start, start, center, direction);
  const std::size_t normal = base::index(normal_axis(arc.plane));
  return std::hypot(plan.radius * angle, arc.end[normal] - arc.start[normal]);
}

// I, J and K go with X, Y and Z.
constexpr char offset_letter(base::Axis axis) {
  return static_cast<char>('I' + base::index(axis));
}

}  // namespace

std::uint32_t Interpreter::motion_column(const Block& block) const {
  return block.has(Group::motion) ? block.column_of(Group::motion) : block.first_column;
}

void Interpreter::report_travel(base::Axis axis, double value, std::uint32_t column) {
  const machine::AxisLimits& limits = machine_.limits(axis);
  const char* const unit = unit_of(axis);
  error("travel", column,
        std::string("axis ") + base::letter(axis) + " would be at " + text(value) + unit + ", outside its travel",
        "from " + text(limits.travel_min) + " to " + text(limits.travel_max) + unit + " in machine coordinates");
}

void Interpreter::note_outside() {
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    if (travel_low_[i] <= frame_.position[i] && frame_.position[i] <= travel_high_[i]) {
      outside_.erase(axis);
    } else {
      outside_.insert(axis);
    }
  }
}

bool Interpreter::fails_outside(const Block& block) {
  if (outside_.empty()) return false;
  reporter_.fail();
  for (const base::Axis axis : base::all_axes) {
    if (!outside_.contains(axis) || reported_outside_.contains(axis) || reporter_.muted()) continue;
    reported_outside_.insert(axis);
    report_travel(axis, frame_.position[base::index(axis)], motion_column(block));
  }
  return true;
}

// An axis is reported when it leaves its travel, not for every block that it spends outside.
bool Interpreter::axis_inside(base::Axis axis, double value, std::uint32_t column) {
  const std::size_t i = base::index(axis);
  if (travel_low_[i] <= value && value <= travel_high_[i]) {
    outside_.erase(axis);
    reported_outside_.erase(axis);
    return true;
  }
  reporter_.fail();
  outside_.insert(axis);
  if (reported_outside_.contains(axis)) return false;
  if (!reporter_.muted()) reported_outside_.insert(axis);
  report_travel(axis, value, column);
  return false;
}

bool Interpreter::inside_travel(const Block& block, const base::AxisVector& target) {
  bool inside = true;
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    const char letter = base::letter(axis);
    if (target[i] == frame_.position[i] && !block.has(letter)) continue;
    inside &= axis_inside(axis, target[i], block.has(letter) ? block.column_of(letter) : motion_column(block));
  }
  // An axis that stays outside keeps the others from moving.
  if (inside) fails_outside(block);
  return inside;
}

bool Interpreter::bulge_inside(const Block& block, base::Axis axis, double low, double high) {
  const std::size_t i = base::index(axis);
  const bool below = low < travel_low_[i];
  if (!below && high <= travel_high_[i]) return true;
  reporter_.fail();
  if (!outside_.contains(axis)) report_travel(axis, below ? low : high, motion_column(block));
  return false;
}

base::AxisVector Interpreter::target_of(const Block& block, const base::AxisVector& from) const {
  base::AxisVector target = from;
  const std::uint32_t axes = block.words & axis_letter_bits & machine_letters_;
  const bool in_machine = block.code(Group::nonmodal) == 530;
  const bool rotated = frame_.is_rotated() && !in_machine && (axes & (letter_bit('X') | letter_bit('Y')));
  base::AxisVector program{};
  if (rotated) program = frame_.to_program(from);
  for (std::uint32_t rest = axes; rest != 0; rest &= rest - 1) {
    const auto letter = static_cast<unsigned>(std::countr_zero(rest));
    const base::Axis axis = axis_of_letter(letter);
    const std::size_t i = base::index(axis);
    const double along = block.value[letter] * frame_.unit(axis);
    if (in_machine) {
      target[i] = along;
    } else if (distance_ == Distance::absolute) {
      target[i] = along + frame_.sum()[i];
      program[i] = along;
    } else {
      target[i] += along;
      program[i] += along;
    }
  }
  if (rotated) {
    const base::AxisVector turned = frame_.to_machine(program);
    for (const base::Axis axis : {base::Axis::X, base::Axis::Y}) {
      if (machine_.has(axis)) target[base::index(axis)] = turned[base::index(axis)];
    }
  }
  return target;
}

void Interpreter::move(const Block& block) {
  // A motion that could not be told keeps the one in force.
  if (block.has(Group::motion)) {
    if (block.code(Group::motion) != motion_) tangent_.reset();
    motion_ = block.code(Group::motion);
  }
  if (motion_ == 800 || (to_do_ >= 0 && !is_drill_cycle(to_do_))) series_.reset();
  if (to_do_ < 0) return;
  if (is_drill_cycle(to_do_)) {
    drill(block);
  } else if (is_arc(to_do_)) {
    arc(block);
  } else if (is_curve(to_do_)) {
    curve(block);
  } else {
    const base::AxisVector target = target_of(block);
    Feed feed;
    if (to_do_ == 10 && (block.words & axis_letter_bits)) feed_of(block, is_linear(target), block.has('F'), feed);
    line_to(block, target, feed);
  }
}

bool Interpreter::is_linear(const base::AxisVector& target) const {
  for (const base::Axis axis : base::all_axes) {
    if (!base::is_rotary(axis) && target[base::index(axis)] != frame_.position[base::index(axis)]) return true;
  }
  return false;
}

bool Interpreter::feed_of(const Block& block, bool linear, bool given, Feed& feed) {
  if (feed_mode_ == FeedMode::inverse_time) {
    // F in any units is a reciprocal of minutes, as it is in degrees a minute.
    feed = {Feed::Mode::per_second, given ? angular_feed_ : 1 / seconds_per_minute};
    if (given) return true;
    return error("missing-feed", motion_column(block), "a block of G93 lacks F", "give the reciprocal of its minutes");
  }
  if (!feed_known_) {
    error("missing-feed", motion_column(block), "no feed has been set", "give F before or in this block");
    assume_feed();
  }
  feed = {Feed::Mode::units_per_second, linear ? linear_feed_ : angular_feed_};
  return true;
}

void Interpreter::line_to(const Block& block, const base::AxisVector& target, const Feed& feed) {
  inside_travel(block, target);
  if (target == frame_.position) return;
  Move& line = emit(Move::Kind::line);
  line.end = target;
  line.feed = feed;
  frame_.position = target;
}

bool Interpreter::arc_center(const Block& block, PlanePoint start, PlanePoint& center) {
  const base::Axis first = first_axis(plane_);
  const base::Axis second = second_axis(plane_);
  const char first_letter = offset_letter(first);
  const char second_letter = offset_letter(second);
  if (!block.has(first_letter) && !block.has(second_letter)) {
    return error("missing-word", motion_column(block), "the arc has neither a centre nor a radius",
                 std::string("give ") + first_letter + " and " + second_letter + ", or R");
  }
  double a = block.value_or(first_letter, 0) * frame_.length_unit;
  double b = block.value_or(second_letter, 0) * frame_.length_unit;
  if (arc_distance_ == Distance::incremental) {
    // Rotation is about Z and only arcs of the XY plane get here with one: first is X, second is Y.
    if (frame_.is_rotated()) frame_.rotate(a, b);
    center = {start.first + a, start.second + b};
    return true;
  }
  if (!block.has(first_letter) || !block.has(second_letter)) {
    return error("missing-word", motion_column(block), "the arc has half a centre",
                 std::string("G90.1 needs both ") + first_letter + " and " + second_letter);
  }
  base::AxisVector program{};
  program[base::index(first)] = a;
  program[base::index(second)] = b;
  center = in_plane(frame_.to_machine(program), plane_);
  return true;
}

bool Interpreter::report_circle(const Block& block, const ArcCircle& circle) {
  const std::uint32_t column = motion_column(block);
  switch (circle.problem) {
    case ArcCircle::Problem::none:
      return true;
    case ArcCircle::Problem::zero_radius:
      return error("arc-radius", column, "arc radius is 0", "the centre must be away from both ends");
    case ArcCircle::Problem::radii_differ:
      return error("arc-radius", column, "arc radius differs by " + text(circle.difference) + " mm at its ends",
                   "the centre must be as far from the start as from the end");
    case ArcCircle::Problem::radius_too_small:
      return error("arc-radius", column,
                   "arc radius is too small by " + text(circle.difference) + " mm to reach its end",
                   "R must be at least half the distance from start to end");
    case ArcCircle::Problem::ends_coincide:
      return error("arc-radius", column, "an arc by radius ends where it begins",
                   "give the centre of a full circle by I, J or K");
  }
  return false;
}

// How often the arc turns, and about where; false where that cannot be known.
bool Interpreter::plan_arc(const Block& block, PlanePoint start, PlanePoint end, ArcPlan& plan) {
  const ArcTolerance tolerance = arc_tolerance(frame_.length_unit != 1);
  const int direction = to_do_ == 30 ? 1 : -1;
  const std::optional<int> turns = block.has('P') ? as_integer(block['P']) : 1;
  if (!turns || *turns < 1 || *turns > most_steps) {
    return error("bad-value", block.column_of('P'), "an arc has P" + text(block['P']), "an integer from 1 to 100000");
  }
  plan.turns = direction * *turns;
  if (frame_.is_rotated() && plane_ != Plane::XY) {
    return error("unsupported-rotation", motion_column(block), "an arc of G18 or G19 in a rotated coordinate system",
                 "rotated systems take arcs of G17 only");
  }
  const bool centred = block.has(offset_letter(first_axis(plane_))) || block.has(offset_letter(second_axis(plane_)));
  if (block.has('R') && centred) {
    return error("ambiguous-word", block.column_of('R'), "the arc has a radius and a centre", "give one of them");
  }
  if (block.has('R')) {
    plan.circle = circle_by_radius(start, end, block['R'] * frame_.length_unit, direction, tolerance);
  } else {
    PlanePoint center;
    if (!arc_center(block, start, center)) return false;
    plan.circle = circle_by_center(start, end, center, direction, *turns, tolerance);
  }
  plan.radius = std::hypot(start.first - plan.circle.center.first, start.second - plan.circle.center.second);
  return report_circle(block, plan.circle);
}

// Only a circle that reaches beyond a limit is worth finding out how far along it the arc goes.
void Interpreter::arc_inside(const Block& block, PlanePoint start, const ArcPlan& plan) {
  const base::Axis first = first_axis(plane_);
  const base::Axis second = second_axis(plane_);
  const auto reaches = [&](base::Axis axis, double center) {
    return center - plan.radius < travel_low_[base::index(axis)] ||
           center + plan.radius > travel_high_[base::index(axis)];
  };
  const ArcCircle& circle = plan.circle;
  if (!reaches(first, circle.center.first) && !reaches(second, circle.center.second)) return;
  const PlaneBox box = arc_extent(start, circle.end, circle.center, plan.turns);
  bulge_inside(block, first, box.low.first, box.high.first) &&
      bulge_inside(block, second, box.low.second, box.high.second);
}

void Interpreter::arc(const Block& block) {
  const base::AxisVector target = target_of(block);
  const PlanePoint start = in_plane(frame_.position, plane_);
  ArcPlan plan;
  const bool known = plan_arc(block, start, in_plane(target, plane_), plan);
  Feed feed;
  feed_of(block, is_linear(target), block.has('F'), feed);
  // Only a line comes back from outside at once.
  const bool from_outside = fails_outside(block);
  inside_travel(block, target);
  if (!known) {
    frame_.position = target;
    return;
  }
  if (!from_outside) arc_inside(block, start, plan);

  Move& arc = emit(Move::Kind::arc);
  arc.end = target;
  arc.end[base::index(first_axis(plane_))] = plan.circle.end.first;
  arc.end[base::index(second_axis(plane_))] = plan.circle.end.second;
  arc.center_first = plan.circle.center.first;
  arc.center_second = plan.circle.center.second;
  arc.turns = plan.turns;
  arc.feed = feed;
  frame_.position = arc.end;
  if (frame_.position == target) return;
  // The line that leads on from an arc that nearly closes goes at the speed of the arc.
  if (feed.mode == Feed::Mode::per_second) {
    feed = {Feed::Mode::units_per_second, arc_length(start, plan, arc) * feed.value};
  }
  line_to(block, target, feed);
}

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
