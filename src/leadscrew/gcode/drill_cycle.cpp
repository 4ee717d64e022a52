#include <algorithm>
#include <leadscrew/gcode/drill_cycle.hpp>

namespace leadscrew::gcode {

DrillCycle::DrillCycle(const Plan& plan) : plan_(plan), phase_(Phase::lift), position_(plan.start) {}

base::AxisVector DrillCycle::hole(int number) const {
  base::AxisVector target = plan_.first_hole;
  for (std::size_t i = 0; i < base::axis_count; ++i) target[i] += number * plan_.increment[i];
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
      peck_ = 1;
      phase_ = plan_.code == Code::G83 && peck_depth(peck_) > plan_.bottom + least_peck ? Phase::cut : Phase::bottom;
      return at_level(Kind::rapid, plan_.r_level);
    case Phase::cut:
      phase_ = Phase::peck_out;
      return at_level(Kind::feed, peck_depth(peck_));
    case Phase::peck_out:
      phase_ = Phase::peck_in;
      return at_level(Kind::rapid, plan_.r_level);
    case Phase::peck_in: {
      const double back = std::min(plan_.r_level, peck_depth(peck_) + peck_clearance);
      ++peck_;
      phase_ = peck_depth(peck_) > plan_.bottom + least_peck ? Phase::cut : Phase::bottom;
      return at_level(Kind::rapid, back);
    }
    case Phase::bottom:
      phase_ = plan_.code == Code::G82 ? Phase::dwell : Phase::retract;
      return at_level(Kind::feed, plan_.bottom);
    case Phase::dwell:
      phase_ = Phase::retract;
      return {Kind::dwell, position_};
    case Phase::retract:
      phase_ = Phase::clear;
      if (plan_.code != Code::G85) return next();
      return at_level(Kind::feed, plan_.r_level);
    case Phase::clear:
      ++hole_;
      phase_ = hole_ < plan_.repeats ? Phase::approach : Phase::done;
      return at_level(Kind::rapid, plan_.clear_level);
    case Phase::done:
      break;
  }
  return {Kind::rapid, position_};
}

}  // namespace leadscrew::gcode
