#include <leadscrew/gcode/pose_moves.hpp>
#include <leadscrew/kinematics/transformation.hpp>

namespace leadscrew::gcode {

/// Nearly all curves lie so far inside that it takes no close look.
bool PoseMoves::is_inside(const Block& block, const NurbsCurve& curve) {
  const kinematics::Transformation* const control = frame_.tip_control();
  bool is_sure = !control || path_.is_inside(*control, travel_.low(), travel_.high());
  for (std::size_t i = control ? 3 : 0; is_sure && i < base::axis_count; ++i) {
    for (const ControlPoint& point : curve.points) {
      is_sure = is_sure && travel_.low()[i] <= point.position[i] && point.position[i] <= travel_.high()[i];
    }
  }
  if (is_sure) return true;
  if (!travel_.end_inside(block, curve.points.back().position)) return false;
  travel_.curve_inside(block, curve);
  return !reporter_.failed();
}

bool PoseMoves::take(const Block& block, base::Line line, const Feed& feed, bool at_contact, Move& move) {
  outbox_.prepare(move, Move::Kind::nurbs, line);
  if (move.path_mode == PathMode::blend) move.path_mode = PathMode::exact_path;
  move.tolerance = move.naive_cam_tolerance = move.orientation_tolerance = 0;
  move.feed = feed;
  path_.take(move.curve, frame_.position, at_contact);
  move.end = move.curve.points.back().position;
  if (!is_inside(block, move.curve)) return false;
  frame_.position = move.end;
  return true;
}

}  // namespace leadscrew::gcode
