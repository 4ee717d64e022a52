#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/drill_cycle.hpp>
#include <leadscrew/gcode/frame.hpp>

namespace leadscrew::gcode {

namespace {

// What a cycle does from R on, a character an action:
//
//     p  down in pecks       d  down at feed      b  to the bottom at rapid    r  out at feed    k  to K at feed
//     c  to the clear level  w  dwell             a  aside, off the wall       h  back over the hole
//     o  orient the spindle  s  stop it           v  reverse it                t  turn it as before  m  wait for the operator
const char* actions_of(Code code) {
  switch (code) {
    case Code::G73:
    case Code::G83:
      return "pdwc";
    case Code::G74:
    case Code::G84:
      return "dsvwrstc";
    case Code::G76_bore:
      return "dwoacht";
    case Code::G85:
      return "drc";
    case Code::G86:
      return "dwsct";
    case Code::G87:
      return "aobhtkdoacht";
    case Code::G88:
      return "dwsmct";
    case Code::G89:
      return "dwrc";
    default:
      return "dwc";
  }
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
      action_ = actions_of(plan_.code);
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
    ++action_;
    return in_hole();
  }
  ++pecks_;
  peck_level_ = deeper;
  phase_ = Phase::peck_out;
  return at_level(Step::Kind::feed, deeper);
}

DrillCycle::Step DrillCycle::in_hole() {
  using Kind = Step::Kind;
  if (*action_ == 'p') return peck();
  while (*action_ == 'w' && !plan_.dwells) ++action_;
  switch (*action_ == 0 ? '\0' : *action_++) {
    case 'd':
      return at_level(Kind::feed, plan_.bottom);
    case 'b':
      return at_level(Kind::rapid, plan_.bottom);
    case 'r':
      return at_level(Kind::feed, plan_.out_level);
    case 'k':
      return at_level(Kind::feed, plan_.level);
    case 'c':
      return at_level(Kind::rapid, plan_.clear_level);
    case 'w':
      return {Kind::dwell, position_};
    case 'a':
      return move_aside(1);
    case 'h':
      return move_aside(-1);
    case 'o':
      return {Kind::spindle_orient, position_};
    case 's':
      return {Kind::spindle_stop, position_};
    case 'v':
      return {Kind::spindle_reverse, position_};
    case 't':
      return {Kind::spindle_start, position_};
    case 'm':
      return {Kind::pause, position_};
    default:
      break;
  }
  ++hole_;
  phase_ = hole_ < plan_.repeats ? Phase::approach : Phase::done;
  return {Kind::rapid, position_};
}

}  // namespace leadscrew::gcode
