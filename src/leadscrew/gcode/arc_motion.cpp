// G2 and G3: arcs, helices and full circles.

#include <cmath>
#include <cstdlib>
#include <leadscrew/gcode/motion.hpp>

namespace leadscrew::gcode {

namespace {

constexpr double most_turns = 100'000;

// I, J and K go with X, Y and Z.
constexpr char offset_letter(base::Axis axis) {
  return static_cast<char>('I' + base::index(axis));
}

}  // namespace

// Along the helix, in X, Y and Z.
double Motion::arc_length(PlanePoint start, const ArcPlan& plan, const Move& arc) {
  const int direction = plan.turns > 0 ? 1 : -1;
  const PlanePoint center = plan.circle.center;
  const double angle = sweep(start, plan.circle.end, center, direction) +
                       (std::abs(plan.turns) - 1) * sweep(start, start, center, direction);
  const std::size_t normal = base::index(normal_axis(arc.plane));
  return std::hypot(plan.circle.radius * angle, arc.end[normal] - arc.start[normal]);
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
  double a = block.value_or(first_letter, 0) * frame_.length_unit;
  double b = block.value_or(second_letter, 0) * frame_.length_unit;
  if (modal_.arc_distance == Distance::incremental) {
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
  center = in_plane(frame_.to_machine(program), modal_.plane);
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
  if (frame_.is_rotated() && modal_.plane != Plane::XY) {
    return error("unsupported-rotation", motion_column(block), "an arc of G18 or G19 in a rotated coordinate system",
                 "rotated systems take arcs of G17 only");
  }
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

// Only a circle that reaches beyond a limit is worth finding out how far along it the arc goes.
void Motion::arc_inside(const Block& block, PlanePoint start, const ArcPlan& plan) {
  const base::Axis first = first_axis(modal_.plane);
  const base::Axis second = second_axis(modal_.plane);
  const auto reaches = [&](base::Axis axis, double center) {
    return center - plan.circle.radius < travel_.low()[base::index(axis)] ||
           center + plan.circle.radius > travel_.high()[base::index(axis)];
  };
  const ArcCircle& circle = plan.circle;
  if (!reaches(first, circle.center.first) && !reaches(second, circle.center.second)) return;
  const PlaneBox box = arc_extent(start, circle.end, circle.center, plan.turns);
  travel_.bulge_inside(block, first, box.low.first, box.high.first) &&
      travel_.bulge_inside(block, second, box.low.second, box.high.second);
}

void Motion::arc(const Block& block) {
  const base::AxisVector target = target_of(block);
  const PlanePoint start = in_plane(frame_.position, modal_.plane);
  ArcPlan plan;
  const bool known = plan_arc(block, start, in_plane(target, modal_.plane), plan);
  Feed feed;
  feed_of(block, true, block.has('F'), feed);  // also where it closes, and its end is where it begins
  // Only a line comes back from outside at once.
  const bool from_outside = travel_.fails_outside(block);
  travel_.inside_travel(block, target);
  if (!known) {
    frame_.position = target;
    return;
  }
  if (!from_outside) arc_inside(block, start, plan);

  Move& arc = outbox_.emit(Move::Kind::arc);
  arc.end = target;
  arc.end[base::index(first_axis(modal_.plane))] = plan.circle.end.first;
  arc.end[base::index(second_axis(modal_.plane))] = plan.circle.end.second;
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
