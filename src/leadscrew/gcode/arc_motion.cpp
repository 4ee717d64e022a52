// G2 and G3: arcs, helices and full circles.

#include <cmath>
#include <cstdlib>
#include <leadscrew/gcode/motion.hpp>
#include <leadscrew/gcode/nurbs.hpp>
#include <leadscrew/numeric/functions.hpp>

namespace leadscrew::gcode {

namespace {

constexpr double most_turns = 100'000;

// I, J and K go with X, Y and Z.
constexpr char offset_letter(base::Axis axis) {
  return static_cast<char>('I' + base::index(axis));
}

bool is_rounding(PlanePoint a, PlanePoint b) {
  constexpr double rounding = 1e-9;  // mm
  return numeric::hypot(b.first - a.first, b.second - a.second) < rounding;
}

}  // namespace

// Along the helix, in X, Y and Z.
double Motion::arc_length(PlanePoint start, const ArcPlan& plan, const Move& arc) {
  const int direction = plan.turns > 0 ? 1 : -1;
  const PlanePoint center = plan.circle.center;
  const double angle = sweep(start, plan.circle.end, center, direction) +
                       (std::abs(plan.turns) - 1) * sweep(start, start, center, direction);
  const std::size_t normal = base::index(normal_axis(arc.plane));
  return numeric::hypot(plan.circle.radius * angle, arc.end[normal] - arc.start[normal]);
}

bool Motion::arc_center(const Block& block, PlanePoint start, PlanePoint& center) {
  const base::Axis first = first_axis(modal_.plane);
  const base::Axis second = second_axis(modal_.plane);
  const char first_letter = offset_letter(first);
  const char second_letter = offset_letter(second);
  if (!block.has(first_letter) && !block.has(second_letter)) {
    return error("missing-word", motion_column(block), "the arc has neither a centre nor a radius",
                 std::string("give ") + first_letter + " and " + second_letter + ", or R");
  }
  const double a = block.value_or(first_letter, 0) * frame_.length_unit;
  const double b = block.value_or(second_letter, 0) * frame_.length_unit;
  if (modal_.arc_distance == Distance::incremental) {
    center = {start.first + a, start.second + b};
    return true;
  }
  if (!block.has(first_letter) || !block.has(second_letter)) {
    return error("missing-word", motion_column(block), "the arc has half a centre",
                 std::string("G90.1 needs both ") + first_letter + " and " + second_letter);
  }
  center = {a, b};
  if (frame_.is_offset_only()) {
    center.first += frame_.offset()[base::index(first)];
    center.second += frame_.offset()[base::index(second)];
  }
  return true;
}

bool Motion::report_circle(const Block& block, const ArcCircle& circle) {
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
bool Motion::plan_arc(const Block& block, PlanePoint start, PlanePoint end, ArcPlan& plan) {
  for (const base::Axis axis : {first_axis(modal_.plane), second_axis(modal_.plane)}) {
    if (machine_.has(axis)) continue;
    if (!travel_.lacks(axis)) return false;
    return error("unknown-axis", motion_column(block),
                 std::string("the arc moves ") + base::letter(axis) + ", which the machine does not have",
                 "an arc needs both axes of its plane");
  }
  const ArcTolerance tolerance = arc_tolerance(frame_.length_unit != 1);
  const int direction = modal_.to_do == Code::G3 ? 1 : -1;
  const std::optional<int> turns = block.has('P') ? as_integer(block['P']) : 1;
  if (!turns || *turns < 1 || *turns > most_turns) {
    return error("bad-value", block.column_of('P'), "an arc has P" + text(block['P']), "an integer from 1 to 100000");
  }
  plan.turns = direction * *turns;
  const bool centred =
      block.has(offset_letter(first_axis(modal_.plane))) || block.has(offset_letter(second_axis(modal_.plane)));
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
  return report_circle(block, plan.circle);
}

// The same circle in machine coordinates; false where it is none there, or one of another plane.
bool Motion::place_circle(ArcPlan& plan) const {
  const base::Axis first = first_axis(modal_.plane), second = second_axis(modal_.plane);
  const double scale = frame_.circle_scale(first, second);
  if (scale == 0) return false;
  const auto place = [&](PlanePoint point) {
    base::AxisVector program{};
    program[base::index(first)] = point.first;
    program[base::index(second)] = point.second;
    return in_plane(frame_.to_machine(program), modal_.plane);
  };
  plan.circle.center = place(plan.circle.center);
  plan.circle.end = place(plan.circle.end);
  plan.circle.radius *= std::fabs(scale);
  if (scale < 0) plan.turns = -plan.turns;
  return true;
}

// An arc that is no circle of a plane of the machine: the curve that the program's circle becomes.
void Motion::arc_as_curve(const Block& block, const ArcPlan& plan, const base::AxisVector& target, const Feed& feed) {
  Move& move = outbox_.emit(Move::Kind::nurbs);
  const base::AxisVector from = frame_.to_program(frame_.position);
  base::AxisVector to = frame_.to_program(target);
  to[base::index(first_axis(modal_.plane))] = plan.circle.end.first;
  to[base::index(second_axis(modal_.plane))] = plan.circle.end.second;
  if (!make_arc_curve(move.curve, modal_.plane, from, to, plan.circle.center, plan.turns)) {
    error("too-many-points", motion_column(block), "an arc of so many turns that is no circle of the machine",
          "give fewer turns");
    return;
  }
  for (ControlPoint& point : move.curve.points) {
    point.position = frame_.to_machine(point.position);
    for (std::size_t i = base::index(base::Axis::A); i < base::axis_count; ++i) {
      if (target[i] == frame_.position[i]) point.position[i] = target[i];
    }
  }
  move.curve.points.front().position = frame_.position;
  if (plan.reaches) move.curve.points.back().position = target;
  travel_.curve_inside(block, move.curve);
  move.end = move.curve.points.back().position;
  move.feed = feed;
  frame_.position = move.end;
  if (!plan.reaches) line_to(block, target, feed);
}

// Whether the whole circle reaches beyond a limit.
bool Motion::bulges_outside(const ArcCircle& circle) const {
  const auto reaches = [&](base::Axis axis, double center) {
    return center - circle.radius < travel_.low()[base::index(axis)] ||
           center + circle.radius > travel_.high()[base::index(axis)];
  };
  return reaches(first_axis(modal_.plane), circle.center.first) ||
         reaches(second_axis(modal_.plane), circle.center.second);
}

// Only where the circle reaches beyond a limit is it worth finding out how far along it the arc goes.
void Motion::arc_inside(const Block& block, PlanePoint start, const ArcPlan& plan) {
  const ArcCircle& circle = plan.circle;
  if (!bulges_outside(circle)) return;
  const base::Axis first = first_axis(modal_.plane);
  const base::Axis second = second_axis(modal_.plane);
  const PlaneBox box = arc_extent(start, circle.end, circle.center, plan.turns);
  travel_.bulge_inside(block, first, box.low.first, box.high.first) &&
      travel_.bulge_inside(block, second, box.low.second, box.high.second);
}

// The tip's circle leads the axes elsewhere.
[[gnu::cold]] void Motion::tip_arc_inside(const Block& block, PlanePoint start, const ArcPlan& plan,
                                          const base::AxisVector& target) {
  const int direction = plan.turns > 0 ? 1 : -1;
  const PlanePoint center = plan.circle.center;
  const double turned = sweep(start, plan.circle.end, center, direction) +
                        (std::abs(plan.turns) - 1) * sweep(start, start, center, direction);
  travel_.tip_way_inside(block, {frame_.position, target, true, modal_.plane, center, direction * turned});
}

// The circle is found where it was written: in the program's coordinates where more than offsets lie between.
[[gnu::cold]] bool Motion::plan_turned_arc(const Block& block, const base::AxisVector& target, ArcPlan& plan) {
  return plan_closing_arc(block, in_plane(frame_.to_program(frame_.position), modal_.plane),
                          in_plane(frame_.to_program(target), modal_.plane), plan);
}

// What is no more than rounding makes no end of a whole turn another place than its start.
bool Motion::plan_closing_arc(const Block& block, PlanePoint start, PlanePoint end, ArcPlan& plan) {
  plan.closes = is_rounding(start, end);
  if (plan.closes) end = start;
  const bool known = plan_arc(block, start, end, plan);
  plan.reaches = plan.circle.end.first == end.first && plan.circle.end.second == end.second;
  return known;
}

std::optional<ArcCircle> Motion::plain_circle(const Block& block, Code motion, const base::AxisVector& target) const {
  const base::Axis first = first_axis(modal_.plane), second = second_axis(modal_.plane);
  const char first_letter = offset_letter(first), second_letter = offset_letter(second);
  constexpr std::uint32_t offsets = letter_bit('I') | letter_bit('J') | letter_bit('K');
  const std::uint32_t centred = block.words & (letter_bit(first_letter) | letter_bit(second_letter));
  const bool known = (block.words & offsets) == centred && (centred != 0) != block.has('R');
  if (!known || modal_.arc_distance != Distance::incremental || !machine_.has(first) || !machine_.has(second))
    return {};
  const PlanePoint start = in_plane(frame_.position, modal_.plane), end = in_plane(target, modal_.plane);
  const bool closes = start.first == end.first && start.second == end.second;
  if (!closes && is_rounding(start, end)) return {};
  const ArcTolerance tolerance = arc_tolerance(frame_.length_unit != 1);
  const int direction = motion == Code::G3 ? 1 : -1;
  const PlanePoint center{start.first + block.value_or(first_letter, 0) * frame_.length_unit,
                          start.second + block.value_or(second_letter, 0) * frame_.length_unit};
  const ArcCircle circle = block.has('R')
                               ? circle_by_radius(start, end, block['R'] * frame_.length_unit, direction, tolerance)
                               : circle_by_center(start, end, center, direction, 1, tolerance);
  const bool reaches = circle.end.first == end.first && circle.end.second == end.second;
  if (circle.problem != ArcCircle::Problem::none || !reaches || bulges_outside(circle)) return {};
  for (std::size_t i = 0; i < target.size(); ++i) {
    if (!(travel_.low()[i] <= target[i] && target[i] <= travel_.high()[i])) return {};
  }
  return circle;
}

void Motion::arc(const Block& block) {
  base::AxisVector target = target_of(block);
  if (is_secondary(modal_.plane)) {
    frame_.position = target;
    error("bad-plane", motion_column(block), "an arc in a plane of U, V and W", "give G17, G18 or G19 before");
    return;
  }
  const bool transforms = !frame_.is_offset_only();
  const PlanePoint start = in_plane(frame_.position, modal_.plane);
  ArcPlan plan;
  const bool known = transforms ? plan_turned_arc(block, target, plan)
                                : plan_closing_arc(block, start, in_plane(target, modal_.plane), plan);
  Feed feed;
  feed_of(block, true, block.has('F'), feed);  // also where it closes, and its end is where it begins
  // Only a line comes back from outside at once.
  const bool from_outside = travel_.fails_outside(block);
  travel_.end_inside(block, target);
  if (!known) {
    frame_.position = target;
    return;
  }
  if (transforms && !place_circle(plan)) return arc_as_curve(block, plan, target, feed);
  const std::size_t first = base::index(first_axis(modal_.plane)), second = base::index(second_axis(modal_.plane));
  if (plan.closes && plan.reaches) target[first] = frame_.position[first], target[second] = frame_.position[second];
  if (!from_outside) frame_.tip_control() ? tip_arc_inside(block, start, plan, target) : arc_inside(block, start, plan);

  Move& arc = outbox_.emit(Move::Kind::arc);
  arc.end = target;
  if (!plan.reaches) arc.end[first] = plan.circle.end.first, arc.end[second] = plan.circle.end.second;
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

}  // namespace leadscrew::gcode
