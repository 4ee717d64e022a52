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

void Outbox::set_tool(Move& move) const {
  for (std::size_t i = 0; i < move.tool.size(); ++i) move.tool[i] = frame_.tool()[i];
  if (!frame_.tip_control()) return;
  move.is_of_tip = true;
  move.tool = frame_.tip_control()->tool;
  move.orientation_tolerance = modal_.effective_mode == PathMode::blend ? modal_.orientation_tolerance : 0;
}

Move& Outbox::emit(Move::Kind kind) {
  if (size_ == moves_.size()) moves_.emplace_back();
  Move& move = moves_[size_++];
  prepare(move, kind, modal_.line);
  return move;
}

void Outbox::emit_event(base::Event::Kind kind, double value, std::int32_t output, double q) {
  prepare_event(emit(Move::Kind::event), kind, value, output, q);
}

void Outbox::prepare_event(Move& move, base::Event::Kind kind, double value, std::int32_t output, double q) const {
  prepare(move, Move::Kind::event, modal_.line);
  move.event = {kind, value, modal_.line, output, waits_for(kind), q};
}

// Whether motion rests for an event that is no pause and no end.
bool Outbox::waits_for(base::Event::Kind kind) const {
  using Kind = base::Event::Kind;
  switch (kind) {
    case Kind::spindle_clockwise:
    case Kind::spindle_counterclockwise:
    case Kind::spindle_stop:
      return machine_.spindle_waits;
    case Kind::tool_change:
    case Kind::turret_indexing:
    case Kind::spindle_orientation:
    case Kind::digital_input:
    case Kind::analog_input:
    case Kind::user_function:
    case Kind::spindle_in_step:
    case Kind::rigid_tap:
      return true;
    default:
      return false;
  }
}

}  // namespace leadscrew::gcode
