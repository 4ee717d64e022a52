#include <leadscrew/gcode/outbox.hpp>
#include <leadscrew/kinematics/transformation.hpp>

namespace leadscrew::gcode {

bool Outbox::take(Move& move) {
  if (next_ == size_) return false;
  // The memory of a curve comes back for the next.
  NurbsCurve memory = std::move(move.curve);
  move = std::move(moves_[next_]);
  moves_[next_++].curve = std::move(memory);
  return true;
}

void Outbox::set_tip(Move& move) const {
  move.is_of_tip = true;
  move.tool = frame_.tip_control()->tool;
  move.orientation_tolerance = modal_.effective_mode == PathMode::blend ? modal_.orientation_tolerance : 0;
}

Move& Outbox::emit(Move::Kind kind) {
  Move& move = moves_[size_++];
  prepare(move, kind, modal_.line);
  return move;
}

void Outbox::emit_event(base::Event::Kind kind, double value, std::int32_t output) {
  prepare_event(emit(Move::Kind::event), kind, value, output);
}

void Outbox::prepare_event(Move& move, base::Event::Kind kind, double value, std::int32_t output) const {
  using Kind = base::Event::Kind;
  const bool turns_spindle =
      kind == Kind::spindle_clockwise || kind == Kind::spindle_counterclockwise || kind == Kind::spindle_stop;
  const bool in_step = kind == Kind::spindle_in_step || kind == Kind::rigid_tap;
  const bool waits = kind == Kind::tool_change || in_step || (turns_spindle && machine_.spindle_waits);
  prepare(move, Move::Kind::event, modal_.line);
  move.event = {kind, value, modal_.line, output, waits};
}

}  // namespace leadscrew::gcode
