#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/nurbs.hpp>
#include <leadscrew/gcode/travel.hpp>
#include <limits>

namespace leadscrew::gcode {

namespace {

const char* unit_of(base::Axis axis) {
  return base::is_rotary(axis) ? " degrees" : " mm";
}

// A programmed inch is rounded when it becomes millimetres: that is no excursion.
constexpr double travel_rounding = 1e-9;  // mm or degrees

}  // namespace

Travel::Travel(const Context& context) : Part(context) {
  for (const base::Axis axis : base::all_axes) set_limits(axis);
}

void Travel::set_limits(base::Axis axis) {
  const std::size_t i = base::index(axis);
  const bool has = machine_.has(axis) && !released_.contains(axis);
  low_[i] = has ? machine_.limits(axis).travel_min - travel_rounding : -std::numeric_limits<double>::infinity();
  high_[i] = has ? machine_.limits(axis).travel_max + travel_rounding : std::numeric_limits<double>::infinity();
}

void Travel::release(base::Axis one, base::Axis other) {
  for (const base::Axis axis : {one, other}) {
    released_.insert(axis);
    set_limits(axis);
    outside_.erase(axis);
  }
}

bool Travel::released_inside(base::Axis axis, double low, double high, std::uint32_t column) {
  if (!machine_.has(axis)) return true;
  const machine::AxisLimits& limits = machine_.limits(axis);
  const bool below = low < limits.travel_min - travel_rounding;
  if (!below && high <= limits.travel_max + travel_rounding) {
    reported_outside_.erase(axis);
    return true;
  }
  if (reported_outside_.contains(axis)) return reporter_.fail();
  reported_outside_.insert(axis);
  report_travel(axis, below ? low : high, column);
  return false;
}

void Travel::restore() {
  const base::AxisSet released = std::exchange(released_, {});
  for (const base::Axis axis : base::all_axes) {
    if (released.contains(axis)) set_limits(axis);
  }
  if (!released.empty()) note_outside();
}

bool Travel::lacks(base::Axis axis) {
  reporter_.fail();
  // One machine, one problem: not one in every block.
  if (reported_lacking_.contains(axis)) return false;
  if (!reporter_.muted()) reported_lacking_.insert(axis);
  return true;
}

void Travel::report_travel(base::Axis axis, double value, std::uint32_t column) {
  const machine::AxisLimits& limits = machine_.limits(axis);
  const char* const unit = unit_of(axis);
  error("travel", column,
        std::string("axis ") + base::letter(axis) + " would be at " + text(value) + unit + ", outside its travel",
        "from " + text(limits.travel_min) + " to " + text(limits.travel_max) + unit + " in machine coordinates");
}

void Travel::note_outside() {
  const base::AxisVector position = frame_.axes_of(frame_.position);
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    if (low_[i] <= position[i] && position[i] <= high_[i]) {
      outside_.erase(axis);
    } else {
      outside_.insert(axis);
    }
  }
}

bool Travel::fails_outside(const Block& block) {
  if (outside_.empty()) return false;
  reporter_.fail();
  for (const base::Axis axis : base::all_axes) {
    if (!outside_.contains(axis) || reported_outside_.contains(axis) || reporter_.muted()) continue;
    reported_outside_.insert(axis);
    report_travel(axis, frame_.axes_of(frame_.position)[base::index(axis)], motion_column(block));
  }
  return true;
}

// An axis is reported when it leaves its travel, not for every block that it spends outside.
bool Travel::axis_inside(base::Axis axis, double value, std::uint32_t column) {
  const std::size_t i = base::index(axis);
  if (low_[i] <= value && value <= high_[i]) {
    outside_.erase(axis);
    reported_outside_.erase(axis);
    return true;
  }
  reporter_.fail();
  outside_.insert(axis);
  if (reported_outside_.contains(axis)) return false;
  if (!reporter_.muted()) reported_outside_.insert(axis);
  report_travel(axis, value, column);
  return false;
}

bool Travel::inside_travel(const Block& block, const base::AxisVector& target) {
  if (!end_inside(block, target)) return false;
  return !frame_.tip_control() || !outside_.empty() || tip_way_inside(block, {frame_.position, target});
}

[[gnu::cold]] bool Travel::tip_end_inside(const Block& block, const base::AxisVector& target) {
  return places_inside(block, frame_.axes_of(frame_.position), frame_.axes_of(target));
}

bool Travel::tip_inside(const Block& block, const base::AxisVector& start, const base::AxisVector& target) {
  if (!places_inside(block, frame_.axes_of(start), frame_.axes_of(target))) return false;
  return !outside_.empty() || tip_way_inside(block, {start, target});
}

[[gnu::cold]] bool Travel::tip_way_inside(const Block& block, const TipPath& path) {
  return reach_inside(block, axes_reach(*frame_.tip_control(), path, low_, high_));
}

[[gnu::cold]] bool Travel::reach_inside(const Block& block, const AxesReach& reach) {
  bool inside = true;
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z}) {
    const std::size_t i = base::index(axis);
    const bool below = reach.low[i] < low_[i];
    if (!below && reach.high[i] <= high_[i]) continue;
    inside = reporter_.fail();
    if (!outside_.contains(axis)) report_travel(axis, below ? reach.low[i] : reach.high[i], motion_column(block));
  }
  return inside;
}

bool Travel::places_inside(const Block& block, const base::AxisVector& from, const base::AxisVector& target) {
  bool inside = outside_.empty() && reported_outside_.empty();
  for (std::size_t i = 0; i < target.size(); ++i) inside &= low_[i] <= target[i] && target[i] <= high_[i];
  if (inside) return true;
  inside = true;
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    const char letter = base::letter(axis);
    if (target[i] == from[i] && !block.has(letter)) continue;
    inside &= axis_inside(axis, target[i], block.has(letter) ? block.column_of(letter) : motion_column(block));
  }
  // An axis that stays outside keeps the others from moving.
  if (inside) fails_outside(block);
  return inside;
}

bool Travel::bulge_inside(const Block& block, base::Axis axis, double low, double high) {
  const std::size_t i = base::index(axis);
  const bool below = low < low_[i];
  if (!below && high <= high_[i]) return true;
  reporter_.fail();
  if (!outside_.contains(axis)) report_travel(axis, below ? low : high, motion_column(block));
  return false;
}

void Travel::curve_inside(const Block& block, const NurbsCurve& curve) {
  if (frame_.tip_control()) reach_inside(block, axes_reach(*frame_.tip_control(), curve, low_, high_));
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    if (frame_.tip_control() && i < 3) continue;  // of the tip
    bulge_inside(block, axis, reach_beyond(curve, axis, -1, low_[i]), reach_beyond(curve, axis, 1, high_[i]));
  }
}

}  // namespace leadscrew::gcode
