#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/drill_cycle.hpp>
#include <leadscrew/gcode/frame.hpp>

namespace leadscrew::gcode {

namespace {

using DrillAction = DrillCycle::Action;

// What each cycle does from R on.
constexpr DrillAction of_g83[] = {DrillAction::peck, DrillAction::down, DrillAction::dwell, DrillAction::clear};
constexpr DrillAction of_g84[] = {DrillAction::no_overrides, DrillAction::in_step,         DrillAction::down,
                                  DrillAction::stop,         DrillAction::reverse,         DrillAction::dwell,
                                  DrillAction::out,          DrillAction::out_of_step,     DrillAction::stop,
                                  DrillAction::start,        DrillAction::overrides_again, DrillAction::clear};
// Beside a spindle that stands at both ends: it does not turn back while the tool dwells.
constexpr DrillAction of_g84_followed[] = {DrillAction::no_overrides, DrillAction::turn,  DrillAction::in_step,
                                           DrillAction::down,         DrillAction::stop,  DrillAction::dwell,
                                           DrillAction::reverse,      DrillAction::out,   DrillAction::out_of_step,
                                           DrillAction::stop,         DrillAction::start, DrillAction::overrides_again,
                                           DrillAction::clear};
constexpr DrillAction of_g76_bore[] = {DrillAction::down,  DrillAction::dwell, DrillAction::stop, DrillAction::orient,
                                       DrillAction::aside, DrillAction::clear, DrillAction::back, DrillAction::start};
constexpr DrillAction of_g85[] = {DrillAction::down, DrillAction::out, DrillAction::clear};
constexpr DrillAction of_g86[] = {DrillAction::down, DrillAction::dwell, DrillAction::stop, DrillAction::clear,
                                  DrillAction::start};
constexpr DrillAction of_g87[] = {DrillAction::aside, DrillAction::stop,   DrillAction::orient,    DrillAction::plunge,
                                  DrillAction::back,  DrillAction::start,  DrillAction::bore_back, DrillAction::down,
                                  DrillAction::stop,  DrillAction::orient, DrillAction::aside,     DrillAction::clear,
                                  DrillAction::back,  DrillAction::start};
constexpr DrillAction of_g88[] = {DrillAction::down,  DrillAction::dwell, DrillAction::stop,
                                  DrillAction::pause, DrillAction::clear, DrillAction::start};
constexpr DrillAction of_g89[] = {DrillAction::down, DrillAction::dwell, DrillAction::out, DrillAction::clear};
constexpr DrillAction of_drilling[] = {DrillAction::down, DrillAction::dwell, DrillAction::clear};

std::span<const DrillAction> actions_of(const DrillCycle::Plan& plan) {
  switch (plan.code) {
    case Code::G73:
    case Code::G83:
      return of_g83;
    case Code::G74:
    case Code::G84:
      return plan.follows ? std::span<const DrillAction>(of_g84_followed) : of_g84;
    case Code::G76_bore:
      return of_g76_bore;
    case Code::G85:
      return of_g85;
    case Code::G86:
      return of_g86;
    case Code::G87:
      return of_g87;
    case Code::G88:
      return of_g88;
    case Code::G89:
      return of_g89;
    default:
      return of_drilling;
  }
}

bool is_tapping(Code code) {
  return code == Code::G74 || code == Code::G84;
}

std::span<const DrillAction> from_in_step(std::span<const DrillAction> actions) {
  return actions.subspan(static_cast<std::size_t>(std::ranges::find(actions, DrillAction::in_step) - actions.begin()));
}

}  // namespace

DrillCycle::DrillCycle(const Plan& plan) : plan_(plan), phase_(Phase::lift), position_(plan.start) {}

base::AxisVector DrillCycle::hole(int number) const {
  const Pattern& pattern = plan_.pattern;
  base::AxisVector target = plan_.first_hole;
  if (pattern.radius != 0) {
    const double angle = pattern.start_angle + number * pattern.step_angle;
    target[base::index(pattern.first)] += pattern.radius * cosine_of_degrees(angle);
    target[base::index(pattern.second)] += pattern.radius * sine_of_degrees(angle);
    return target;
  }
  for (std::size_t i = 0; i < base::axis_count; ++i) target[i] += number * pattern.increment[i];
  return target;
}

base::AxisVector DrillCycle::end() const {
  base::AxisVector target = hole(plan_.repeats - 1);
  target[base::index(plan_.drill)] = plan_.clear_level;
  return target;
}

DrillCycle::Step DrillCycle::at_level(Step::Kind kind, double level) {
  position_[base::index(plan_.drill)] = level;
  return {kind, position_};
}

DrillCycle::Step DrillCycle::move_aside(double sign) {
  for (std::size_t i = 0; i < base::axis_count; ++i) position_[i] += sign * plan_.aside[i];
  return {Step::Kind::rapid, position_};
}

DrillCycle::Step DrillCycle::next() {
  using Kind = Step::Kind;
  const double level = position_[base::index(plan_.drill)];
  switch (phase_) {
    case Phase::lift:
      phase_ = Phase::approach;
      return at_level(Kind::rapid, std::max(level, plan_.r_level));
    case Phase::approach:
      phase_ = Phase::to_r_level;
      position_ = hole(hole_);
      return at_level(Kind::rapid, level);
    case Phase::to_r_level:
      phase_ = Phase::in_hole;
      actions_ = actions_of(plan_);
      peck_level_ = plan_.r_level;
      pecks_ = 0;
      return at_level(Kind::rapid, plan_.r_level);
    case Phase::in_hole:
      return in_hole();
    case Phase::peck_out:
      phase_ = Phase::peck_in;
      if (plan_.code == Code::G73) return next();
      return at_level(Kind::rapid, plan_.r_level);
    case Phase::peck_in:
      phase_ = Phase::in_hole;
      return at_level(Kind::rapid, std::min(plan_.r_level, peck_level_ + peck_clearance));
    case Phase::done:
      break;
  }
  return {Kind::rapid, position_};
}

// The next peck, or, where the rest of the hole is one, what comes behind the pecks.
DrillCycle::Step DrillCycle::peck() {
  const double size = std::max(plan_.peck - pecks_ * plan_.peck_step, plan_.least_peck);
  const double deeper = plan_.peck_step > 0 ? peck_level_ - size
                                            : plan_.r_level - (pecks_ + 1) * plan_.peck;  // exact where all are equal
  if (!(deeper > plan_.bottom + least_rest)) {
    actions_ = actions_.subspan(1);
    return in_hole();
  }
  ++pecks_;
  peck_level_ = deeper;
  phase_ = Phase::peck_out;
  return at_level(Step::Kind::feed, deeper);
}

// Of a tap: that of the next peck, or the bottom.
double DrillCycle::tap_level() {
  const double deeper = plan_.r_level - ++pecks_ * plan_.peck;
  peck_level_ = plan_.peck > 0 && deeper > plan_.bottom + least_rest ? deeper : plan_.bottom;
  return peck_level_;
}

DrillCycle::Step DrillCycle::in_hole() {
  using Kind = Step::Kind;
  while (!actions_.empty() && actions_.front() == Action::dwell && !plan_.dwells) actions_ = actions_.subspan(1);
  if (!actions_.empty()) {
    const Action action = actions_.front();
    if (action == Action::peck) return peck();
    actions_ = actions_.subspan(1);
    switch (action) {
      case Action::peck:
      case Action::down:
        return at_level(Kind::feed, is_tapping(plan_.code) ? tap_level() : plan_.bottom);
      case Action::plunge:
        return at_level(Kind::rapid, plan_.bottom);
      case Action::out: {
        Step out = at_level(Kind::feed, taps_deeper() ? plan_.r_level : plan_.out_level);
        out.is_fast = true;
        return out;
      }
      case Action::bore_back:
        return at_level(Kind::feed, plan_.level);
      case Action::clear:
        return at_level(Kind::rapid, plan_.clear_level);
      case Action::dwell:
        return {Kind::dwell, position_};
      case Action::aside:
        return move_aside(1);
      case Action::back:
        return move_aside(-1);
      case Action::orient:
        return {Kind::spindle_orient, position_};
      case Action::stop:
        return {Kind::spindle_stop, position_};
      case Action::reverse:
        return {Kind::spindle_reverse, position_};
      case Action::start:
        if (taps_deeper()) actions_ = from_in_step(actions_of(plan_));
        return {Kind::spindle_start, position_};
      case Action::turn:
        return {Kind::spindle_turn, position_};
      case Action::no_overrides:
        return {Kind::overrides_off, position_};
      case Action::overrides_again:
        return {Kind::overrides_on, position_};
      case Action::in_step:
        return {Kind::in_step, position_};
      case Action::out_of_step:
        return {Kind::out_of_step, position_};
      case Action::pause:
        return {Kind::pause, position_};
    }
  }
  ++hole_;
  phase_ = hole_ < plan_.repeats ? Phase::approach : Phase::done;
  return {Kind::rapid, position_};
}

}  // namespace leadscrew::gcode
