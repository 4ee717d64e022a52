#include <algorithm>
#include <cmath>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/kinematics/solutions.hpp>
#include <leadscrew/kinematics/vector_run.hpp>
#include <utility>

namespace leadscrew::kinematics {

namespace {

constexpr double greatest_step = 1;  ///< degrees, of either axis in one part
constexpr double whole_circle = 360;

/// A pole that the run touches within the last digit of its vectors.
Vector at_pole_if_near(const Chain& chain, const Vector& direction) {
  const Vector& pole = chain.turns()[0].direction;
  const double along = numeric::dot(pole, direction);
  const Vector nearer = along < 0 ? Vector{-pole[0], -pole[1], -pole[2]} : pole;
  return angle_between(nearer, direction) <= reach_rounding ? nearer : direction;
}

/// One direction with its angles.
struct Held {
  double share = 0;
  Vector direction{};
  Solutions<double> found;
};

/// Of one pair of angles to another, the shorter way round.
struct StraightTurn {
  Angles<double> from{}, turned{};
};

/// The angles between two directions on one side. At a pole the first angle is that of the other end.
StraightTurn straight_turn(const Held& a, const Held& b, std::size_t side) {
  Angles<double> from = a.found.angles[a.found.is_pole ? 0 : side], to = b.found.angles[b.found.is_pole ? 0 : side];
  if (a.found.is_pole) from[0] = to[0];
  if (b.found.is_pole) to[0] = from[0];
  return {from, {std::remainder(to[0] - from[0], whole_circle), std::remainder(to[1] - from[1], whole_circle)}};
}

/// Does linear motion of both axes, on each side, keep the tool near enough to the great circle?
bool is_short_enough(const Chain& chain, const Held& a, const Held& b, const Vector& middle, double tolerance) {
  if (a.found.count == 0 || b.found.count == 0) return true;  // told where the angles are chosen
  for (std::size_t side = 0; side < 2; ++side) {
    const StraightTurn turn = straight_turn(a, b, side);
    if (std::max(std::abs(turn.turned[0]), std::abs(turn.turned[1])) > greatest_step) return false;
    const Vector held =
        direction_of(chain, Angles<double>{turn.from[0] + turn.turned[0] / 2, turn.from[1] + turn.turned[1] / 2});
    if (detail::in_degrees(angle_between(held, middle)) > tolerance) return false;
  }
  return true;
}

}  // namespace

VectorRun::VectorRun(const Chain& chain, const RotaryLimits& limits, const VectorRunSettings& settings)
    : chain_(chain), limits_(limits), settings_(settings) {}

void VectorRun::begin_at(const Vector& tip, const Angles<double>& angles) {
  choice_.emplace(chain_, limits_, angles, settings_.orientation_tolerance / 4);
  choice_->begin_at(angles);
  last_ = {tip, at_pole_if_near(chain_, direction_of(chain_, angles)), 0};
  vertices_.push_back(last_);
}

bool VectorRun::begin_free(const Vector& tip, const Vector& direction, const Angles<double>& before) {
  choice_.emplace(chain_, limits_, before, settings_.orientation_tolerance / 4);
  last_ = {tip, at_pole_if_near(chain_, unit_vector(direction)), 0};
  return append(last_);
}

bool VectorRun::add(const Vector& tip, const Vector& direction) {
  if (failure_) return false;
  const Vertex next{tip, at_pole_if_near(chain_, unit_vector(direction)), segments_};
  if (!subdivide(last_, next)) return false;
  last_ = next;
  ++segments_;
  if (vertices_.size() > most_vertices) decide(vertices_.size() / 2);
  return true;
}

/// Parts of one line, halved until each is nearly a great circle; a pole that it passes within rounding is a vertex.
bool VectorRun::subdivide(const Vertex& from, const Vertex& to) {
  const GreatCircle circle(from.direction, to.direction);
  if (circle.angle() > 3.14159265358979323846 - GreatCircle::least_opening) {
    return fail(VectorRunFailure::Kind::opposite, to.segment);
  }
  const auto held_at = [&](double share) {
    Held held{share, at_pole_if_near(chain_, circle.at(share)), {}};
    held.found = solutions(chain_, Vector3<double>(held.direction));
    return held;
  };
  const auto vertex_of = [&](const Held& held) {
    Vertex vertex{to.tip, held.direction, to.segment};
    if (held.share < 1) vertex.tip = numeric::sum(from.tip, held.share, numeric::difference(to.tip, from.tip));
    return vertex;
  };
  const double tolerance = settings_.orientation_tolerance / 4;
  std::vector<Held> ahead{held_at(1)};
  const double nearest = circle.nearest_to_axis(chain_.turns()[0].direction);
  if (nearest > 0 && nearest < 1) {
    if (Held held = held_at(nearest); held.found.is_pole) ahead.push_back(std::move(held));
  }
  Held at = held_at(0);
  for (std::size_t parts = 0; !ahead.empty();) {
    const double middle = (at.share + ahead.back().share) / 2;
    const bool is_divisible = middle > at.share && middle < ahead.back().share;
    if (is_divisible && !is_short_enough(chain_, at, ahead.back(), circle.at(middle), tolerance)) {
      if (parts + ahead.size() >= most_parts) return fail(VectorRunFailure::Kind::pole_too_sharp, to.segment);
      ahead.push_back(held_at(middle));
      continue;
    }
    at = std::exchange(ahead.back(), {});
    ahead.pop_back();
    ++parts;
    if (!append(vertex_of(at))) return false;
  }
  return true;
}

bool VectorRun::append(const Vertex& vertex) {
  if (!choice_->add(vertex.direction)) return fail(*choice_->failure(), vertex.segment);
  vertices_.push_back(vertex);
  return true;
}

/// The first vertices that are not.
void VectorRun::decide(std::size_t count) {
  const std::vector<Angles<double>> angles = count < choice_->size() ? choice_->decide(count) : choice_->angles();
  for (std::size_t k = 0; k < count; ++k) {
    const Vertex& vertex = vertices_[k];
    if (!std::exchange(is_start_known_, true)) {
      start_angles_ = angles[k];
      continue;
    }
    decided_.push_back({vertex.tip, angles[k], vertex.segment, 0.75 * settings_.orientation_tolerance, false});
  }
  vertices_.erase(vertices_.begin(), vertices_.begin() + static_cast<std::ptrdiff_t>(count));
}

std::vector<RunVertex> VectorRun::take() {
  return std::exchange(decided_, {});
}

bool VectorRun::finish() {
  if (choice_) decide(vertices_.size());
  return !failure_;
}

bool VectorRun::fail(VectorRunFailure::Kind kind, std::size_t segment) {
  failure_ = VectorRunFailure{kind, segment, 0, base::Axis::A};
  return false;
}

bool VectorRun::fail(const RunFailure& failure, std::size_t segment) {
  using Kind = VectorRunFailure::Kind;
  const Kind kind = failure.kind == RunFailure::Kind::out_of_reach ? Kind::out_of_reach
                    : failure.kind == RunFailure::Kind::travel     ? Kind::travel
                                                                   : Kind::pole_too_sharp;
  failure_ = VectorRunFailure{kind, segment, failure.miss, failure.axis};
  return false;
}

}  // namespace leadscrew::kinematics
