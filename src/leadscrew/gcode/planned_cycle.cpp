#include <leadscrew/gcode/planned_cycle.hpp>

namespace leadscrew::gcode {

void PlannedCycle::begin(const Block& block) {
  block_ = &block;
  moves_.clear();
  next_ = 0;
  failed_ = false;
  start_ = frame_.to_program(frame_.position);
  end_ = frame_.position;
  for (std::size_t i = 0; i < position_.size(); ++i) position_[i] = start_[i];
}

bool PlannedCycle::has_room() {
  if (failed_) return false;
  if (moves_.size() < most_moves) return true;
  failed_ = true;
  return error("too-many-passes", motion_column(*block_),
               "the cycle takes more than " + std::to_string(most_moves) + " moves", "greater steps");
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
  if (!travel_.inside_travel(*block_, end)) {
    failed_ = true;
    return;
  }
  moves_.push_back({turn, {end[0], end[1], end[2]}, center, feed});
  end_ = end;
}

void PlannedCycle::line(const std::array<double, 3>& to, const Feed& feed) {
  if (!has_room()) return;
  position_ = to;
  const base::AxisVector end = placed(to);
  if (end != end_) add(end, 0, {}, feed);
}

void PlannedCycle::arc(PlanePoint to, PlanePoint center, int turn, const Feed& feed) {
  if (!has_room()) return;
  const double scale = frame_.circle_scale(base::Axis::X, base::Axis::Y);
  if (scale == 0) {
    failed_ = true;
    error("unsupported-rotation", motion_column(*block_), "arcs of the cycle are no circles of the machine",
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
    add(end, 0, {}, feed);  // too short to be one
    return;
  }
  end[0] = circle.end.first;
  end[1] = circle.end.second;
  const PlaneBox box = arc_extent(start, circle.end, circle.center, turn);
  if (!travel_.bulge_inside(*block_, base::Axis::X, box.low.first, box.high.first) ||
      !travel_.bulge_inside(*block_, base::Axis::Y, box.low.second, box.high.second)) {
    failed_ = true;
    return;
  }
  add(end, turn, circle.center, feed);
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
