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

double RotaryLift::Steps::greatest() const {
  double most = 0;
  for (const Step& step : of_way) most = std::max({most, std::abs(step.change[0]), std::abs(step.change[1])});
  return most;
}

/// By how much each angle changes. `any_side`: whichever is nearer, as behind a pole.
std::optional<RotaryLift::Steps> RotaryLift::steps_to(const kinematics::Vector& direction, bool any_side) {
  const auto found = kinematics::solutions(chain_, direction);
  if (found.count == 0) {
    miss_ = found.miss;
    return std::nullopt;
  }
  Steps steps;
  steps.is_pole = found.is_pole;
  for (std::size_t k = 0; k < 2; ++k) {
    const Way& way = ways_[k];
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t side : {way.side, 1 - way.side}) {
      const Angles& to = found.angles[found.count == 2 ? side : 0];
      const Angles change{found.is_pole ? 0 : std::remainder(to[0] - way.now[0], turn_of_axis),
                          std::remainder(to[1] - way.now[1], turn_of_axis)};
      const double size = std::abs(change[0]) + std::abs(change[1]);
      if (size < least) steps.of_way[k] = {change, side};
      least = std::min(least, size);
      if (!any_side) break;
    }
  }
  return steps;
}

void RotaryLift::go(const Steps& steps) {
  for (std::size_t k = 0; k < 2; ++k) {
    Way& way = ways_[k];
    way.side = steps.of_way[k].side;
    for (std::size_t i = 0; i < 2; ++i) {
      const double change = steps.of_way[k].change[i];
      way.now[i] += change;
      way.low[i] = std::min(way.low[i], way.now[i]);
      way.high[i] = std::max(way.high[i], way.now[i]);
      way.cost += squared(change / limits_.velocity[i]);
    }
  }
  is_in_pole_ = steps.is_pole;
}

bool RotaryLift::add_place(const surfaces::PassNode& node, const kinematics::Vector& direction) {
  place_ = {node.u, node.v};
  for (std::size_t k = 0; k < 2; ++k) {
    ways_[k].now = before_;
    ways_[k].side = k;
  }
  const auto steps = steps_to(direction, false);
  if (!steps) return false;
  go(*steps);
  for (Way& way : ways_) {
    way.start = way.low = way.high = way.now;
    way.cost = 0;
  }
  is_begun_ = true;
  return true;
}

/// Halved where an angle changes by so much that it would not be known which way round; at last straight through a pole.
bool RotaryLift::add_between(const surfaces::PassNode& from, const surfaces::PassNode& to) {
  place_ = {to.u, to.v};
  std::array<double, most_halvings_of_lift + 1> ahead{};
  std::size_t count = 1;
  ahead[0] = 1;
  double at = 0;
  while (count > 0) {
    const double share = ahead[count - 1];
    const bool is_last = count == ahead.size();
    const auto steps = steps_to(axis_between(from, to, share), is_in_pole_ || is_last);
    if (!steps) return false;
    if (steps->greatest() > greatest_step && !is_last) {
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
  constexpr double behind_pole = 1.0 / 64;  // where it begins in one
  const surfaces::PassNode &first = pass.nodes[0], &second = pass.nodes[1];
  if (!is_begun_) {
    const bool is_pole = kinematics::solutions(chain_, axis_between(first, second, 0)).is_pole;
    if (!add_place(first, axis_between(first, second, is_pole ? behind_pole : 0))) return false;
  }
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
