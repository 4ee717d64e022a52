#include <algorithm>
#include <cmath>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/kinematics/rotary_run.hpp>
#include <leadscrew/kinematics/solutions.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <limits>

namespace leadscrew::kinematics {

namespace {

constexpr double whole_turn = 360;
constexpr double angle_rounding = 1e-9;    ///< degrees; so far beyond its end travel is not left
constexpr double same_angle = 1e-6;        ///< degrees; of ways that meet
constexpr double half_turn_margin = 1e-6;  ///< degrees; so near half a turn both ways round are open

double square(double x) {
  return x * x;
}

/// Whole turns that keep [low, high] inside travel: from the first to the second, none where that is less.
std::array<double, 2> turns_inside(double low, double high, double travel_min, double travel_max) {
  return {std::ceil((travel_min - angle_rounding - low) / whole_turn),
          std::floor((travel_max + angle_rounding - high) / whole_turn)};
}

/// Where an angle goes from here: the shorter way, or both where they are as long.
struct NextAngles {
  std::array<double, 2> angles{};
  std::size_t count = 1;
};
NextAngles next_angles(double now, double wanted) {
  const double way = std::remainder(wanted - now, whole_turn);
  NextAngles next{{now + way, now + way - std::copysign(whole_turn, way)}};
  if (std::abs(way) > whole_turn / 2 - half_turn_margin) next.count = 2;
  return next;
}

}  // namespace

RotaryLimits limits_of(const machine::Machine& machine, const Chain& chain) {
  RotaryLimits limits;
  for (std::size_t i = 0; i < 2; ++i) {
    const machine::AxisLimits& axis = machine.limits(chain.turns()[i].axis);
    limits.travel_min[i] = axis.travel_min;
    limits.travel_max[i] = axis.travel_max;
    limits.velocity[i] = axis.velocity;
  }
  return limits;
}

void RotaryRun::begin_at(const Angles<double>& angles) {
  const Vector direction = direction_of(chain_, angles);
  const auto found = solutions(chain_, Vector3<double>(direction));
  Way way;
  way.now = way.low = way.high = angles;
  way.side = found.is_pole ? Side::pole : Side::first;
  if (found.count == 2) {
    const auto apart = [&](std::size_t k) {
      return std::abs(std::remainder(found.angles[k][0] - angles[0], whole_turn)) +
             std::abs(std::remainder(found.angles[k][1] - angles[1], whole_turn));
    };
    if (apart(1) < apart(0)) way.side = Side::second;
  }
  starts_.push_back(angles);
  ways_.push_back(way);
  before_ = angles;
  is_begun_ = true;
  record(ways_);
  last_ = direction;
  count_ = 1;
}

bool RotaryRun::add(const Vector& direction) {
  const Vector unit = unit_vector(direction);
  return add(unit, solutions(chain_, unit));
}

bool RotaryRun::add(const Vector& unit, const Solutions<double>& found) {
  if (failure_) return false;
  cheapest_lost_ = std::numeric_limits<double>::infinity();
  std::vector<Way> ways;
  if (found.count == 0) {
    fail(RunFailure::Kind::out_of_reach, found.miss);
  } else if (count_ == 0) {
    begin(found, ways);
  } else {
    const Vector middle = numeric::sum(last_, 1, unit);
    for (const Way& way : ways_) extend(way, found, middle, ways);
  }
  if (!failure_ && ways.empty()) fail(RunFailure::Kind::travel);
  if (!failure_ && nodes_.size() + ways.size() > most_nodes) fail(RunFailure::Kind::too_long);
  if (failure_) return false;
  prune(ways);
  record(ways);
  ways_.swap(ways);
  last_ = unit;
  ++count_;
  return true;
}

void RotaryRun::begin(const Solutions<double>& found, std::vector<Way>& ways) {
  for (std::size_t k = 0; k < found.count; ++k) {
    Way way;
    way.now = found.angles[k];
    if (found.is_pole) way.now[0] = before_[0];
    way.low = way.high = way.now;
    way.side = found.is_pole ? Side::pole : k == 0 ? Side::first : Side::second;
    way.start = starts_.size();
    starts_.push_back(way.now);
    keep(way, ways);
  }
}

/// To all solutions of the next direction.
void RotaryRun::extend(const Way& way, const Solutions<double>& found, const Vector& middle, std::vector<Way>& ways) {
  for (std::size_t k = 0; k < found.count; ++k) {
    const Side side = found.is_pole ? Side::pole : k == 0 ? Side::first : Side::second;
    const NextAngles first = found.is_pole ? NextAngles{{way.now[0], 0}} : next_angles(way.now[0], found.angles[k][0]);
    const NextAngles second = next_angles(way.now[1], found.angles[k][1]);
    for (std::size_t i = 0; i < first.count; ++i) {
      for (std::size_t j = 0; j < second.count; ++j) step(way, {first.angles[i], second.angles[j]}, side, middle, ways);
    }
  }
}

void RotaryRun::step(const Way& way, const Angles<double>& to, Side side, const Vector& middle,
                     std::vector<Way>& ways) {
  const bool changes_side = side != way.side && side != Side::pole && way.side != Side::pole;
  if (changes_side && !is_straight(way.now, to, middle)) return;
  Way next = way;
  next.side = side;
  next.now = to;
  for (std::size_t i = 0; i < 2; ++i) {
    next.cost += square((to[i] - way.now[i]) / limits_.velocity[i]);
    next.low[i] = std::min(way.low[i], to[i]);
    next.high[i] = std::max(way.high[i], to[i]);
  }
  keep(next, ways);
}

/// Whole turns that its beginning may be at, from the first to the second.
std::array<double, 2> RotaryRun::turns_of(const Way& way, std::size_t axis) const {
  const auto turns = turns_inside(way.low[axis], way.high[axis], limits_.travel_min[axis], limits_.travel_max[axis]);
  if (!is_begun_) return turns;
  return {std::max(turns[0], 0.0), std::min(turns[1], 0.0)};
}

/// If there are whole turns that keep all of it inside travel.
void RotaryRun::keep(const Way& way, std::vector<Way>& ways) {
  for (std::size_t i = 0; i < 2; ++i) {
    const auto [from, to] = turns_of(way, i);
    if (from <= to) continue;
    if (way.cost < cheapest_lost_) {
      cheapest_lost_ = way.cost;
      lost_axis_ = chain_.turns()[i].axis;
    }
    return;
  }
  ways.push_back(way);
}

/// Leaves out what costs more than another way from the same beginning to the same place, which may begin at the same whole
/// turns: what follows is the same for both.
void RotaryRun::prune(std::vector<Way>& ways) {
  // Stable, and without memory of its own; ways are few.
  for (auto way = ways.begin(); way != ways.end(); ++way) {
    std::rotate(std::ranges::upper_bound(ways.begin(), way, way->cost, {}, &Way::cost), way, way + 1);
  }
  std::size_t kept = 0;
  for (const Way& way : ways) {
    const auto is_better = [&](const Way& other) {
      if (other.start != way.start || other.side != way.side) return false;
      for (std::size_t i = 0; i < 2; ++i) {
        if (std::abs(other.now[i] - way.now[i]) > same_angle) return false;
        const auto may = turns_of(way, i), may_other = turns_of(other, i);
        if (may_other[0] > may[0] || may_other[1] < may[1]) return false;
      }
      return true;
    };
    if (std::any_of(ways.begin(), ways.begin() + static_cast<std::ptrdiff_t>(kept), is_better)) continue;
    ways[kept++] = way;
  }
  if (kept > most_ways) is_exact_ = false;
  ways.resize(std::min(kept, most_ways));
}

void RotaryRun::record(std::vector<Way>& ways) {
  first_nodes_.push_back(static_cast<std::uint32_t>(nodes_.size()));
  for (Way& way : ways) {
    nodes_.push_back({way.now, way.node});
    way.node = static_cast<std::uint32_t>(nodes_.size() - 1);
  }
}

/// Does linear motion of both axes pass so near the middle of the great circle?
bool RotaryRun::is_straight(const Angles<double>& from, const Angles<double>& to, const Vector& middle) const {
  const Vector3<double> held = direction_of(chain_, Angles<double>{(from[0] + to[0]) / 2, (from[1] + to[1]) / 2});
  return detail::in_degrees(angle_between(held, middle)) <= tolerance_;
}

RotaryRun::Choice RotaryRun::best() const {
  Choice best;
  best.cost = std::numeric_limits<double>::infinity();
  for (const Way& way : ways_) {
    Choice choice{&way, {}, way.cost};
    for (std::size_t i = 0; i < 2; ++i) {
      const auto [from, to] = turns_of(way, i);
      const double start = starts_[way.start][i];
      choice.turns[i] = whole_turn * std::clamp(std::nearbyint((before_[i] - start) / whole_turn), from, to);
      choice.cost += square((start + choice.turns[i] - before_[i]) / limits_.velocity[i]);
    }
    if (choice.cost < best.cost) best = choice;
  }
  return best;
}

double RotaryRun::cost() const {
  return ways_.empty() ? 0 : best().cost;
}

std::vector<Angles<double>> RotaryRun::angles() const {
  std::vector<Angles<double>> all(count_);
  if (ways_.empty()) return all;
  const Choice choice = best();
  std::uint32_t node = choice.way->node;
  for (std::size_t k = count_; k-- > 0; node = nodes_[node].parent) {
    for (std::size_t i = 0; i < 2; ++i) {
      all[k][i] = std::clamp(nodes_[node].angles[i] + choice.turns[i], limits_.travel_min[i], limits_.travel_max[i]);
    }
  }
  return all;
}

/// That of a way at a vertex.
std::uint32_t RotaryRun::node_of(const Way& way, std::size_t vertex) const {
  std::uint32_t node = way.node;
  for (std::size_t k = count_ - 1; k > vertex; --k) node = nodes_[node].parent;
  return node;
}

std::vector<Angles<double>> RotaryRun::decide(std::size_t count) {
  std::vector<Angles<double>> all = angles();
  if (ways_.empty() || count == 0) return {};
  all.resize(count);
  const Choice choice = best();
  const std::uint32_t decided = node_of(*choice.way, count - 1);
  const Angles<double> turns = choice.turns;
  const std::size_t start = choice.way->start;
  std::erase_if(ways_, [&](const Way& way) { return way.start != start || node_of(way, count - 1) != decided; });
  for (Way& way : ways_) {
    for (std::size_t i = 0; i < 2; ++i) {
      for (double* angle : {&way.now[i], &way.low[i], &way.high[i]}) *angle += turns[i];
    }
  }
  for (Node& node : nodes_) {
    for (std::size_t i = 0; i < 2; ++i) node.angles[i] += turns[i];
  }
  for (std::size_t i = 0; i < 2; ++i) starts_[start][i] += turns[i];
  is_begun_ = true;
  forget(count);
  return all;
}

/// The nodes of the first vertices.
void RotaryRun::forget(std::size_t count) {
  const std::uint32_t offset = first_nodes_[count];
  nodes_.erase(nodes_.begin(), nodes_.begin() + offset);
  first_nodes_.erase(first_nodes_.begin(), first_nodes_.begin() + static_cast<std::ptrdiff_t>(count));
  for (Node& node : nodes_) node.parent = node.parent >= offset ? node.parent - offset : 0;
  for (std::uint32_t& first : first_nodes_) first -= offset;
  for (Way& way : ways_) way.node -= offset;
  count_ -= count;
}

void RotaryRun::fail(RunFailure::Kind kind, double miss) {
  failure_ = RunFailure{kind, count_, miss, lost_axis_};
}

}  // namespace leadscrew::kinematics
