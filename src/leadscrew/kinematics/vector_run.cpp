#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/kinematics/solutions.hpp>
#include <leadscrew/kinematics/vector_run.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <utility>

namespace leadscrew::kinematics {

namespace {

constexpr double greatest_step = 1;  ///< degrees, of either axis in one part
/// Of E, that straight angles may leave the great circle by: a quarter would keep E as well, but paths of coarse vectors
/// past a pole take up to a sixth longer then.
constexpr double chord_share = 1.0 / 64;
/// Degrees, at most E: by so much they may leave it on the exact path, where a spline through their ends stays a tenth nearer.
constexpr double chord_of_spline = 1e-4;
constexpr double side_share = 0.25;  ///< of what is left of E, where sides change or the first axis turns beside a pole
/// Of that, what the middle of a change of sides may be off: elsewhere it is off by a little more.
constexpr double middle_share = 0.9;
constexpr double pole_share = 0.875;  ///< of E, that leading through a pole may take
constexpr double grown = 2.5;         ///< part to part on the exact path
constexpr double full_circle = 360;
constexpr double radians_of_degree = numeric::two_pi.hi / 360;
constexpr std::size_t most_ahead = std::size_t{1} << 16;  ///< lines that wait for a pole to be left

/// The pole, for a direction that is one within the last digit of vectors.
Vector at_pole_if_near(const Chain& chain, const Vector& direction) {
  const Vector& pole = chain.turns()[0].direction;
  const double along = numeric::dot(pole, direction);
  const Vector nearer = along < 0 ? Vector{-pole[0], -pole[1], -pole[2]} : pole;
  return is_within(nearer, direction, reach_rounding) ? nearer : direction;
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
  return {from, {std::remainder(to[0] - from[0], full_circle), std::remainder(to[1] - from[1], full_circle)}};
}

/// What is travelled along one programmed line.
struct TravelledLine {
  const Chain& chain;
  const DirectionSegment& segment;
  const std::vector<const PolePass*>& passes;
  double tolerance_sine;  ///< of the chords

  Vector at(double share) const {
    Vector direction = segment.circle.at(share);
    const double s = segment.from + share * (segment.to - segment.from);
    for (const PolePass* pass : passes) {
      if (pass->begin() < s && s < pass->end()) direction = pass->applied(s, direction);
    }
    return at_pole_if_near(chain, direction);
  }

  Held held_at(double share) const {
    Held held{share, at(share), {}};
    held.found = solutions(chain, held.direction);
    return held;
  }

  /// Does linear motion of both axes, on each side, keep the tool near enough?
  bool is_short_enough(const Held& a, const Held& b) const {
    if (a.found.count == 0 || b.found.count == 0) return true;  // told where the angles are chosen
    std::array<StraightTurn, 2> turns;
    for (std::size_t side = 0; side < 2; ++side) {
      turns[side] = straight_turn(a, b, side);
      const Angles<double>& turned = turns[side].turned;
      if (std::max(std::abs(turned[0]), std::abs(turned[1])) > greatest_step) return false;
    }
    const int looks = passes.empty() ? 1 : 3;
    for (int k = 1; k <= looks; ++k) {
      const double share = static_cast<double>(k) / (looks + 1);
      const Vector wanted = at(a.share + share * (b.share - a.share));
      for (const StraightTurn& turn : turns) {
        const Vector held = direction_of(
            chain, Angles<double>{turn.from[0] + share * turn.turned[0], turn.from[1] + share * turn.turned[1]});
        if (!is_within(held, wanted, tolerance_sine)) return false;
      }
    }
    return true;
  }

  /// Where it must have vertices, from the last to the first.
  std::vector<Held> corners() const {
    std::vector<double> shares{1};
    const auto add = [&](double share) {
      if (share > 0 && share < 1) shares.push_back(share);
    };
    for (const PolePass* pass : passes) {
      for (const double s : {pass->begin(), pass->first, pass->last, pass->end()}) add(segment.share_at(s));
    }
    const Vector& pole = chain.turns()[0].direction;
    // Where an end is taken for the pole already, the nearest place may be next to nothing from there.
    if (passes.empty() && segment.circle.may_come_near(pole, reach_rounding)) {
      const double nearest = segment.circle.nearest_to_axis(pole);
      const auto is_pole = [&](double share) { return held_at(share).found.is_pole; };
      if (nearest > 0 && nearest < 1 && is_pole(nearest) && !is_pole(0) && !is_pole(1)) add(nearest);
    }
    std::ranges::sort(shares, std::greater<>());
    std::vector<Held> all;
    for (const double share : shares) {
      if (all.empty() || share < all.back().share) all.push_back(held_at(share));
    }
    return all;
  }

  /// The ends of parts that are short enough, in order; none where there would be more than VectorRun::most_parts.
  std::optional<std::vector<Held>> parts(Held at, bool is_spline) const {
    std::vector<Held> ahead = corners(), ends{at};
    while (!ahead.empty()) {
      if (is_divisible(at.share, ahead.back().share) && !is_short_enough(at, ahead.back())) {
        if (ends.size() + ahead.size() > VectorRun::most_parts) return std::nullopt;
        ahead.push_back(held_at((at.share + ahead.back().share) / 2));
        continue;
      }
      at = ahead.back();
      ends.push_back(at);
      ahead.pop_back();
    }
    if (is_spline && !grade(ends)) return std::nullopt;
    ends.erase(ends.begin());
    return ends;
  }

  static bool is_divisible(double from, double to) {
    const double middle = (from + to) / 2;
    return middle > from && middle < to;
  }

  /// Halves parts that are more than twice as long as one near by: beside a pole angles go as 1/s, and a cubic spline through
  /// places ever farther apart swings about that. False where there would be too many.
  bool grade(std::vector<Held>& ends) const {
    constexpr std::size_t near = 4;  // parts of one length before those of twice that
    for (bool is_graded = false; !is_graded;) {
      is_graded = true;
      std::vector<Held> graded{ends.front()};
      for (std::size_t k = 1; k < ends.size(); ++k) {
        const double length = ends[k].share - ends[k - 1].share;
        double least = length;
        for (std::size_t j = k > near ? k - near : 1; j < std::min(k + near + 1, ends.size()); ++j)
          least = std::min(least, ends[j].share - ends[j - 1].share);
        if (length > grown * least && is_divisible(ends[k - 1].share, ends[k].share)) {
          graded.push_back(held_at((ends[k - 1].share + ends[k].share) / 2));
          is_graded = false;
        }
        graded.push_back(ends[k]);
      }
      ends = std::move(graded);
      if (ends.size() > VectorRun::most_parts + 1) return false;
    }
    return true;
  }
};

}  // namespace

VectorRun::VectorRun(const Chain& chain, const RotaryLimits& limits, const VectorRunSettings& settings)
    : chain_(chain),
      limits_(limits),
      settings_(settings),
      passes_(chain, settings.blends
                         ? radians_of_degree * std::min(settings.pole_cone, pole_share * settings.orientation_tolerance)
                         : 0) {}

void VectorRun::begin_at(const Vector& tip, const Angles<double>& angles) {
  choice_.emplace(chain_, limits_, angles, middle_share * side_share * settings_.orientation_tolerance);
  choice_->begin_at(angles);
  const Vector unit = unit_vector(direction_of(chain_, angles)), direction = at_pole_if_near(chain_, unit);
  last_found_ = solutions(chain_, direction);
  ahead_.push_back({tip, unit, 0, 0});
  vertices_.push_back({tip, direction, 0, 0, 0, last_found_.is_pole});
}

bool VectorRun::begin_free(const Vector& tip, const Vector& direction, const Angles<double>& before) {
  choice_.emplace(chain_, limits_, before, middle_share * side_share * settings_.orientation_tolerance);
  is_free_ = true;
  const Vector unit = unit_vector(direction), held = at_pole_if_near(chain_, unit);
  ahead_.push_back({tip, unit, 0, 0});
  last_found_ = solutions(chain_, held);
  return append({tip, held, 0, 0, 0, false});
}

bool VectorRun::add(const Vector& tip, const Vector& direction) {
  if (failure_) return false;
  const Programmed& from = ahead_.back();
  const Vector unit = unit_vector(direction);
  const GreatCircle circle(from.direction, unit);
  const double turned = circle.angle();
  if (turned > numeric::two_pi.hi / 2 - GreatCircle::least_opening) {
    return follow(true) && fail(VectorRunFailure::Kind::opposite, segments_);
  }
  const double length = numeric::hypot(numeric::distance(from.tip, tip), PolePasses::radius * turned);
  passes_.observe({circle, from.s, from.s + length});
  ahead_.push_back({tip, unit, segments_++, from.s + length});
  return follow(false);
}

/// Makes vertices as far as poles are known, or of all lines.
bool VectorRun::follow(bool all) {
  if (all || ahead_.size() > most_ahead) passes_.close();
  const double until = all || ahead_.size() > most_ahead ? ahead_.back().s : passes_.known_until();
  while (ahead_.size() > 1 && ahead_[1].s <= until) {
    if (!subdivide(ahead_[0], ahead_[1])) return false;
    ahead_.pop_front();
    passes_.forget_before(ahead_.front().s);
    if (vertices_.size() <= most_vertices) continue;
    std::size_t half = vertices_.size() / 2;
    // Where the pole is left, the vertex behind is decided as well: how far the first axis turns.
    if (vertices_[half - 1].is_pole && !vertices_[half].is_pole) ++half;
    decide(half);
  }
  return true;
}

/// Parts of one line, halved until each is nearly a great circle.
bool VectorRun::subdivide(const Programmed& from, const Programmed& to) {
  const DirectionSegment segment{GreatCircle(from.direction, to.direction), from.s, to.s};
  const std::vector<const PolePass*> passes = passes_.between(from.s, to.s);
  double left = settings_.orientation_tolerance;
  for (const PolePass* pass : passes) {
    left = std::min(left, settings_.orientation_tolerance - detail::in_degrees(pass->greatest));
  }
  const double of_spline = settings_.blends ? 0 : std::min(left, chord_of_spline);
  const double off = std::max(chord_share * left, of_spline);
  const TravelledLine line{chain_, segment, passes, numeric::sin(radians_of_degree * off)};
  const std::optional<std::vector<Held>> parts = line.parts({0, line.at(0), last_found_}, !settings_.blends);
  if (!parts) return fail(VectorRunFailure::Kind::pole_too_sharp, to.segment);
  for (const Held& end : *parts) {
    last_found_ = end.found;
    Vertex vertex{to.tip, end.direction, to.segment, (1 - side_share) * left, to.s, end.found.is_pole};
    if (end.share < 1) {
      vertex.tip = numeric::sum(from.tip, end.share, numeric::difference(to.tip, from.tip));
      vertex.s = from.s + end.share * (to.s - from.s);
    }
    if (!append(vertex)) return false;
  }
  return true;
}

bool VectorRun::append(const Vertex& vertex) {
  if (!choice_->add(vertex.direction, last_found_)) return fail(*choice_->failure(), vertex.segment);
  vertices_.push_back(vertex);
  vertices_.back().is_pole = last_found_.is_pole;
  return true;
}

/// The first vertices that are not.
void VectorRun::decide(std::size_t count) {
  std::vector<Angles<double>> angles = choice_->angles();
  if (count < choice_->size()) choice_->decide(count);
  angles.resize(count);
  for (std::size_t k = 0; k < count;) {
    const std::size_t end = end_of_poles(k, count);
    if (end == k) {
      put(vertices_[k], angles[k], false);
      ++k;
    } else {
      put_poles(k, end, angles);
      k = end;
    }
  }
  vertices_.erase(vertices_.begin(), vertices_.begin() + static_cast<std::ptrdiff_t>(count));
}

/// The vertices at a pole from here on end before this one.
std::size_t VectorRun::end_of_poles(std::size_t first, std::size_t count) const {
  std::size_t end = first;
  while (end < count && vertices_[end].is_pole) ++end;
  return end;
}

/// By how much the tool leaves a great circle from the pole while the first axis turns, degrees.
double VectorRun::turning_error(const Vector& direction, double turn) const {
  return numeric::sin(radians_of_degree * angle_from_pole(chain_, direction) / 2) * std::abs(turn) / 2;
}

/// At a pole the first axis is free. It turns evenly from the vertex before to the one behind, where that leaves the great
/// circles by little; else while the tool stays at the pole; or at rest.
void VectorRun::put_poles(std::size_t first, std::size_t end, const std::vector<Angles<double>>& angles) {
  const bool is_left = end < angles.size(), is_begin = !is_start_known_;
  const double behind = is_left ? angles[end][0] : angles[first][0];
  const double before = is_begin && is_free_ ? behind : angles[first][0], turn = behind - before;
  double from = vertices_[first].s, to = vertices_[end - 1].s;
  if (is_left) {
    const double begin = is_begin ? from : last_s_, all = vertices_[end].s - begin;
    const double comes = is_begin ? 0 : turning_error(last_direction_, turn * (from - begin) / all),
                 leaves = turning_error(vertices_[end].direction, turn * (vertices_[end].s - to) / all);
    if (std::max(comes, leaves) <= middle_share * side_share / (1 - side_share) * vertices_[end].tolerance) {
      from = begin;
      to = vertices_[end].s;
    }
  }
  for (std::size_t k = first; k < end; ++k) {
    const double share = to > from ? (vertices_[k].s - from) / (to - from) : 0;
    put(vertices_[k], {before + share * turn, angles[k][1]}, false);
  }
  if (!(to > from) && turn != 0) put(vertices_[end - 1], {behind, angles[end - 1][1]}, true);
}

void VectorRun::put(const Vertex& vertex, const Angles<double>& angles, bool is_pole_turn) {
  last_s_ = vertex.s;
  last_direction_ = vertex.direction;
  if (!is_pole_turn && !std::exchange(is_start_known_, true)) {
    start_angles_ = angles;
    return;
  }
  const double tolerance = vertex.tolerance > 0 ? vertex.tolerance : (1 - side_share) * settings_.orientation_tolerance;
  decided_.push_back({vertex.tip, angles, vertex.segment, tolerance, is_pole_turn});
}

std::vector<RunVertex> VectorRun::take() {
  return std::exchange(decided_, {});
}

bool VectorRun::finish() {
  if (!choice_) return true;
  if (!failure_) follow(true);
  decide(vertices_.size());
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
