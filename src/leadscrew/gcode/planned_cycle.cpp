#include <leadscrew/gcode/planned_cycle.hpp>

namespace leadscrew::gcode {

void PlannedCycle::begin(const Block& block) {
  block_ = &block;
  moves_.clear();
  next_ = 0;
  failed_ = is_kept_ = false;
  start_ = frame_.to_program(frame_.position);
  end_ = frame_.position;
  for (std::size_t i = 0; i < position_.size(); ++i) position_[i] = start_[i];
  if (modal_.tool_is_aside) add(end_, 0, {}, Feed{});
}

void PlannedCycle::begin_kept(const Block& block) {
  begin(block);
  is_kept_ = true;
}

void PlannedCycle::fail(std::string_view code, std::string message, std::string hint) {
  failed_ = true;
  if (is_kept_) {
    reporter_.error_where_kept(code, std::move(message), std::move(hint));
  } else {
    error(code, motion_column(*block_), std::move(message), std::move(hint));
  }
}

bool PlannedCycle::has_room() {
  if (failed_) return false;
  if (moves_.size() < most_moves) return true;
  fail("too-many-passes", "the cycle takes more than " + std::to_string(most_moves) + " moves", "greater steps");
  return false;
}

// Of the axes that lie between two places.
bool PlannedCycle::is_inside(const base::AxisVector& low, const base::AxisVector& high) {
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    const bool is_below = low[i] < travel_.low()[i];
    if (!is_below && high[i] <= travel_.high()[i]) continue;
    fail("travel",
         std::string("axis ") + base::letter(axis) + " would be at " + text(is_below ? low[i] : high[i]) +
             " mm, outside its travel",
         "from " + text(travel_.low()[i]) + " to " + text(travel_.high()[i]) + " mm in machine coordinates");
    return false;
  }
  return true;
}

// Axes that the cycle does not move, and that go by themselves, stay exactly where they are.
base::AxisVector PlannedCycle::placed(const std::array<double, 3>& place) const {
  base::AxisVector program = start_;
  for (std::size_t i = 0; i < place.size(); ++i) program[i] = place[i];
  base::AxisVector machine = frame_.to_machine(program);
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    if (frame_.is_separate(axis) && program[i] == start_[i]) machine[i] = frame_.position[i];
  }
  return machine;
}

void PlannedCycle::add(const base::AxisVector& end, int turn, PlanePoint center, const Feed& feed) {
  moves_.push_back({turn, {end[0], end[1], end[2]}, center, feed});
  end_ = end;
}

void PlannedCycle::line(const std::array<double, 3>& to, const Feed& feed) {
  if (!has_room()) return;
  position_ = to;
  const base::AxisVector end = placed(to);
  if (end != end_ && is_inside(end, end)) add(end, 0, {}, feed);
}

void PlannedCycle::arc(PlanePoint to, PlanePoint center, int turn, const Feed& feed) {
  if (!has_room()) return;
  const double scale = frame_.circle_scale(base::Axis::X, base::Axis::Y);
  if (scale == 0) {
    fail("unsupported-rotation", "arcs of the cycle are no circles of the machine",
         "the cycle takes turns in its own plane, and equal scales");
    return;
  }
  if (scale < 0) turn = -turn;
  position_ = {to.first, to.second, position_[2]};
  const PlanePoint start = in_plane(end_, Plane::XY);
  base::AxisVector end = placed(position_);
  const base::AxisVector middle = placed({center.first, center.second, position_[2]});
  const ArcCircle circle = circle_by_center(start, in_plane(end, Plane::XY), in_plane(middle, Plane::XY), turn, 1,
                                            arc_tolerance(frame_.length_unit != 1));
  if (circle.problem != ArcCircle::Problem::none) {
    if (is_inside(end, end)) add(end, 0, {}, feed);  // too short to be one
    return;
  }
  end[0] = circle.end.first;
  end[1] = circle.end.second;
  const PlaneBox box = arc_extent(start, circle.end, circle.center, turn);
  base::AxisVector low = end, high = end;
  low[0] = box.low.first;
  low[1] = box.low.second;
  high[0] = box.high.first;
  high[1] = box.high.second;
  if (is_inside(low, high)) add(end, turn, circle.center, feed);
}

bool PlannedCycle::take(Move& move) {
  const Planned& planned = moves_[next_++];
  outbox_.prepare(move, planned.turn != 0 ? Move::Kind::arc : Move::Kind::line, modal_.line);
  move.plane = Plane::XY;
  for (std::size_t i = 0; i < planned.end.size(); ++i) move.end[i] = planned.end[i];
  move.center_first = planned.center.first;
  move.center_second = planned.center.second;
  move.turns = planned.turn;
  move.feed = planned.feed;
  frame_.position = move.end;
  return true;
}

void PlannedCycle::abandon() {
  if (next_ < moves_.size()) frame_.position = end_;
  moves_.clear();
  next_ = 0;
}

}  // namespace leadscrew::gcode
