#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/rotary_lift.hpp>
#include <leadscrew/kinematics/solutions.hpp>
#include <leadscrew/surfaces/hermite.hpp>
#include <limits>

namespace leadscrew::gcode {

namespace {

constexpr double turn_of_axis = 360;
constexpr double greatest_step = 60;  // degrees; of an axis, from one direction to the next
constexpr double travel_margin = 1e-9;
constexpr std::size_t most_halvings_of_lift = 24;

double squared(double x) {
  return x * x;
}

kinematics::Vector axis_between(const surfaces::PassNode& a, const surfaces::PassNode& b, double share) {
  kinematics::Vector axis;
  for (std::size_t k = 0; k < 3; ++k) axis[k] = surfaces::hermite_value(a.axis[k], b.axis[k], b.t - a.t, share);
  return axis;
}

}  // namespace

/// By how much each angle changes on both sides.
std::optional<RotaryLift::Steps> RotaryLift::steps_to(const kinematics::Vector& direction) {
  const auto found = kinematics::solutions(chain_, direction);
  if (found.count == 0) {
    miss_ = found.miss;
    return std::nullopt;
  }
  Steps steps;
  for (std::size_t side = 0; side < 2; ++side) {
    const Angles& to = found.angles[found.count == 2 ? side : 0];
    for (std::size_t i = 0; i < 2; ++i) {
      const bool is_free = found.is_pole && i == 0;
      steps[side][i] = is_free ? 0 : std::remainder(to[i] - ways_[side].now[i], turn_of_axis);
    }
  }
  return steps;
}

void RotaryLift::go(const Steps& steps) {
  for (std::size_t side = 0; side < 2; ++side) {
    Way& way = ways_[side];
    for (std::size_t i = 0; i < 2; ++i) {
      way.now[i] += steps[side][i];
      way.low[i] = std::min(way.low[i], way.now[i]);
      way.high[i] = std::max(way.high[i], way.now[i]);
      way.cost += squared(steps[side][i] / limits_.velocity[i]);
    }
  }
}

bool RotaryLift::add_place(const surfaces::PassNode& node, const kinematics::Vector& direction) {
  place_ = {node.u, node.v};
  for (Way& way : ways_) way.now = before_;
  const auto steps = steps_to(direction);
  if (!steps) return false;
  for (std::size_t side = 0; side < 2; ++side) {
    Way& way = ways_[side];
    for (std::size_t i = 0; i < 2; ++i) way.now[i] += (*steps)[side][i];
    way.start = way.low = way.high = way.now;
  }
  is_begun_ = true;
  return true;
}

/// Halved where an angle changes by so much that it would not be known which way round.
bool RotaryLift::add_between(const surfaces::PassNode& from, const surfaces::PassNode& to) {
  place_ = {to.u, to.v};
  std::array<double, most_halvings_of_lift + 1> ahead{};
  std::size_t count = 1;
  ahead[0] = 1;
  double at = 0;
  while (count > 0) {
    const double share = ahead[count - 1];
    const auto steps = steps_to(axis_between(from, to, share));
    if (!steps) return false;
    double greatest = 0;
    for (const Angles& each : *steps) greatest = std::max({greatest, std::abs(each[0]), std::abs(each[1])});
    if (greatest > greatest_step && count < ahead.size()) {
      ahead[count++] = at + (share - at) / 2;
      continue;
    }
    go(*steps);
    at = share;
    --count;
  }
  return true;
}

bool RotaryLift::add(const surfaces::Pass& pass) {
  const surfaces::PassNode& first = pass.nodes.front();
  if (!is_begun_ && !add_place(first, {first.axis[0][0], first.axis[1][0], first.axis[2][0]})) return false;
  for (std::size_t k = 1; k < pass.nodes.size(); ++k) {
    if (!add_between(pass.nodes[k - 1], pass.nodes[k])) return false;
  }
  return true;
}

std::optional<RotaryLift::Choice> RotaryLift::best() {
  std::optional<Choice> best;
  double least = std::numeric_limits<double>::infinity(), least_lost = least;
  for (std::size_t side = 0; side < 2; ++side) {
    const Way& way = ways_[side];
    Choice choice{side, way.start};
    double cost = way.cost;
    bool is_inside = true;
    for (std::size_t i = 0; i < 2; ++i) {
      const double first = std::ceil((limits_.travel_min[i] - travel_margin - way.low[i]) / turn_of_axis);
      const double last = std::floor((limits_.travel_max[i] + travel_margin - way.high[i]) / turn_of_axis);
      if (!(first <= last)) {
        if (cost < least_lost) lost_axis_ = chain_.turns()[i].axis;
        least_lost = std::min(least_lost, cost);
        is_inside = false;
        break;
      }
      const double nearest = std::nearbyint((before_[i] - way.start[i]) / turn_of_axis);
      choice.start[i] += turn_of_axis * std::clamp(nearest, first, last);
      cost += squared((choice.start[i] - before_[i]) / limits_.velocity[i]);
    }
    if (!is_inside || !(cost < least)) continue;
    least = cost;
    best = choice;
  }
  return best;
}

}  // namespace leadscrew::gcode
