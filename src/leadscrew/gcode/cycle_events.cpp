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
  base::AxisVector top = cycle_.hole(0), bottom = top, shallowest = top;
  top[base::index(plan.drill)] = plan.r_level;
  bottom[base::index(plan.drill)] = plan.bottom;
  shallowest[base::index(plan.drill)] = plan.peck > 0 ? std::max(plan.r_level - plan.peck, plan.bottom) : plan.bottom;
  const base::AxisVector from = placed(top), to = placed(bottom), first = placed(shallowest);
  const bool is_by_feed = modal_.feed_mode != FeedMode::per_revolution;
  const double speed = modal_.spindle_speed;
  return pace_.is_reached(block, {from, to, *lead, speed * plan.out_factor, is_by_feed}) &&
         pace_.can_brake(block, {from, first, *lead, speed, is_by_feed});
}

// Pecks of Q, each followed by the way out to R (Haas).
void CannedCycles::plan_tap(const Block& block, DrillCycle::Plan& plan) {
  if (block.has('Q')) series_->peck = block['Q'];
  plan.peck = series_->peck.value_or(0) * frame_.length_unit;
  if (series_->peck && !(plan.peck > 0 && (plan.r_level - plan.bottom) / plan.peck <= most_steps)) {
    error("bad-value", block.has('Q') ? block.column_of('Q') : motion_column(block),
          "the peck is " + text(plan.peck) + " mm", "above 0, and at most 100000 pecks to the bottom");
    series_->peck.reset();
    plan.peck = 0;
  }
  plan_way_out(block, plan);
}

// Haas: the tap leaves J times as fast as it enters. Fanuc ("Override during rigid tapping"): J is the speed of the spindle on
// the way out; one that is not from S to twice S its controllers take for S, and here it is an error.
void CannedCycles::plan_way_out(const Block& block, DrillCycle::Plan& plan) {
  if (block.has('J')) series_->way_out = block['J'];
  if (!series_->way_out) return;
  const double given = *series_->way_out, speed = modal_.spindle_speed;
  const bool is_speed = options_.dialect == Dialect::fanuc;
  const double least = is_speed ? speed : 1, most = is_speed ? 2 * speed : 9;
  if (least > 0 && given >= least && given <= most) {
    plan.out_factor = given / least;
    return;
  }
  const std::uint32_t column = block.has('J') ? block.column_of('J') : motion_column(block);
  series_->way_out.reset();
  if (is_speed) {
    error("bad-value", column,
          "the spindle is to turn at J" + text(given) + " on the way out, at S" + text(speed) + " in",
          "J is its speed, from S to twice S: S600 and J1200 for twice as fast");
  } else {
    error("bad-value", column, "the tap is to leave " + text(given) + " times as fast as it enters", "J from 1 to 9");
  }
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
      outbox_.prepare_event(move, spindle_event(kind), spindle_speed(kind));
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

// Of the spindle's event, revolutions per minute.
double CannedCycles::spindle_speed(DrillCycle::Step::Kind kind) const {
  using Kind = DrillCycle::Step::Kind;
  if (kind == Kind::spindle_stop) return 0;
  return modal_.spindle_speed * (kind == Kind::spindle_reverse ? cycle_.plan().out_factor : 1);
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
