// What canned cycles ask of the spindle and the operator, and taps of the spindle.

#include <leadscrew/gcode/cycles.hpp>

namespace leadscrew::gcode {

// mm in a revolution, of a tapping cycle in step with the spindle.
std::optional<double> CannedCycles::tap_lead() const {
  const bool has_lead = modal_.spindle_speed > 0 && cycle_feed_.mode == Feed::Mode::units_per_second;
  if (!has_lead) return std::nullopt;
  return cycle_feed_.value * seconds_per_minute / modal_.spindle_speed;
}

bool CannedCycles::can_tap(const Block& block, const DrillCycle::Plan& plan) {
  const std::optional<double> lead = tap_lead();
  if (!plan.follows || !lead || !(plan.r_level > plan.bottom)) return true;
  base::AxisVector top = cycle_.hole(0), bottom = top;
  top[base::index(plan.drill)] = plan.r_level;
  bottom[base::index(plan.drill)] = plan.bottom;
  const base::AxisVector from = placed(top), to = placed(bottom);
  const SpindlePace::Line line{from, to, *lead, modal_.spindle_speed};
  return pace_.is_reached(block, line) && pace_.can_brake(block, line);
}

// Of a step that is neither a move nor a dwell. False where it asks for nothing.
bool CannedCycles::prepare_event(Move& move, DrillCycle::Step::Kind kind) const {
  using Event = base::Event::Kind;
  using Kind = DrillCycle::Step::Kind;
  switch (kind) {
    case Kind::pause:
      outbox_.prepare_event(move, Event::pause);
      return true;
    case Kind::spindle_orient:
      outbox_.prepare_event(move, Event::spindle_orientation);
      return true;
    case Kind::overrides_off:
      outbox_.prepare_event(move, Event::overrides_off);
      return true;
    case Kind::overrides_on:
      if (modal_.feed_override && modal_.speed_override) {
        outbox_.prepare_event(move, Event::overrides_on);
        return true;
      }
      if (!modal_.feed_override && !modal_.speed_override) return false;
      outbox_.prepare_event(move, modal_.feed_override ? Event::feed_override : Event::spindle_override, 1);
      return true;
    case Kind::in_step:
    case Kind::out_of_step:
      return prepare_step_event(move, kind == Kind::in_step);
    case Kind::spindle_turn:
      if (modal_.spindle != Code::M5) return false;
      [[fallthrough]];
    default:
      outbox_.prepare_event(move, spindle_event(kind), kind == Kind::spindle_stop ? 0 : modal_.spindle_speed);
      move.event.waits |= cycle_.plan().follows;
      return true;
  }
}

// A tap goes in step with the spindle: it waits for nothing, as the spindle's events in it wait where the machine asks for
// it; but where the cycle follows the spindle, for that.
bool CannedCycles::prepare_step_event(Move& move, bool in_step) const {
  const std::optional<double> lead = tap_lead();
  if (!lead) return false;
  outbox_.prepare_event(move, base::Event::Kind::spindle_in_step, in_step ? *lead : 0, base::in_tapping_cycle);
  move.event.waits = cycle_.plan().follows;
  return true;
}

base::Event::Kind CannedCycles::spindle_event(DrillCycle::Step::Kind kind) const {
  using Event = base::Event::Kind;
  using Kind = DrillCycle::Step::Kind;
  const Code code = cycle_.plan().code;
  const bool standing = modal_.spindle == Code::M5;
  const bool clockwise = standing ? code != Code::G74 : modal_.spindle == Code::M3;
  if (kind == Kind::spindle_stop) return Event::spindle_stop;
  if (kind == Kind::spindle_start && standing) return Event::spindle_stop;
  return clockwise == (kind != Kind::spindle_reverse) ? Event::spindle_clockwise : Event::spindle_counterclockwise;
}

}  // namespace leadscrew::gcode
