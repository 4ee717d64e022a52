#include <algorithm>
#include <cmath>
#include <leadscrew/planner/limit_ratios.hpp>
#include <leadscrew/planner/optimal_motion.hpp>
#include <leadscrew/planner/speed_profile.hpp>

namespace leadscrew::planner {

namespace {

using base::MotionState;
using numeric::DoubleDouble;

constexpr double gap = 1e-3;  // of the time, to the optimum
constexpr int repairs = 3;
constexpr double repair_margin = 2e-4;
constexpr double granted_slowing = 1.0002;  // below, slowing time costs less than planning again

constexpr std::array<double, 4> gauss_half_places = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                                     0.9602898564975363};
constexpr std::array<double, 4> gauss_half_weights = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                                      0.1012285362903763};

struct Knot {
  double s = 0, speed = 0, acceleration = 0;
};

/// s(τ) along the section, by a quintic with the speeds and accelerations of both ends (Hermite).
Segment quintic(const Knot& from, const Knot& to, double duration) {
  const double t = duration, way = to.s - from.s;
  const double r0 = way - t * (from.speed + t * from.acceleration / 2);
  const double r1 = t * (to.speed - from.speed - t * from.acceleration);
  const double r2 = t * t * (to.acceleration - from.acceleration);
  Segment segment;
  segment.duration = t;
  segment.s0 = from.s;
  segment.v0 = from.speed;
  segment.c2 = from.acceleration / 2;
  segment.c3 = (10 * r0 - 4 * r1 + r2 / 2) / (t * t * t);
  segment.c4 = (-15 * r0 + 7 * r1 - r2) / (t * t * t * t);
  segment.c5 = (6 * r0 - 3 * r1 + r2 / 2) / (t * t * t * t * t);
  return segment;
}

/// ∫ x^(−1/2) ds over an interval, by eight-point Gauss.
double travel_time(const SpeedProfile& profile, std::size_t k) {
  double sum = 0;
  for (std::size_t q = 0; q < 4; ++q) {
    for (const double side : {-1.0, 1.0}) {
      sum += gauss_half_weights[q] / std::sqrt(profile.square(k, 0.5 + 0.5 * side * gauss_half_places[q]));
    }
  }
  return sum / 2 * profile.width(k);
}

class Emission {
 public:
  explicit Emission(const SpeedProfile& profile) : profile_(profile) {}

  std::vector<Segment> emit(double length) {
    const std::size_t n = profile_.intervals();
    Knot here = knot(0, 0);
    ramp_up(here);
    for (std::size_t k = 0; k < n; ++k) here = interval(k, here);
    ramp_down(here, length);
    return std::move(segments_);
  }
  const std::vector<std::size_t>& intervals() const { return intervals_; }

 private:
  Knot knot(std::size_t k, double u) const {
    const double x = profile_.square(k, u);
    const std::vector<double>& s = profile_.knots().s;
    return {u >= 1 ? s[k + 1] : s[k] + u * profile_.width(k), std::sqrt(x), profile_.square_slope(k, u) / 2};
  }

  void push(Segment segment, std::size_t interval) {
    segment.begin = now_;
    now_ = now_ + segment.duration;
    segments_.push_back(segment);
    intervals_.push_back(interval);
  }

  /// s = J t³/6 up to the first knot: t = 3 s₁/v₁.
  void ramp_up(const Knot& to) {
    const double t = 3 * to.s / to.speed;
    Segment segment;
    segment.duration = t;
    segment.c3 = to.s / (t * t * t);
    push(segment, 0);
  }
  void ramp_down(const Knot& from, double length) {
    const double way = length - from.s, t = 3 * way / from.speed, c3 = way / (t * t * t);
    Segment segment;
    segment.duration = t;
    segment.s0 = from.s;
    segment.v0 = 3 * c3 * t * t;
    segment.c2 = -3 * c3 * t;
    segment.c3 = c3;
    push(segment, profile_.intervals() - 1);
  }

  Knot interval(std::size_t k, const Knot& from) {
    if (profile_.is_level(k)) {
      Segment segment;
      segment.duration = profile_.width(k) / from.speed;
      segment.s0 = from.s;
      segment.v0 = from.speed;
      segment.state = MotionState::constant;
      const Knot to{profile_.knots().s[k + 1], from.speed, 0};
      push(segment, k);
      return to;
    }
    const Knot to = knot(k, 1);
    push(quintic(from, to, travel_time(profile_, k)), k);
    return to;
  }

  const SpeedProfile& profile_;
  std::vector<Segment> segments_;
  std::vector<std::size_t> intervals_;
  DoubleDouble now_;
};

/// The largest ratio of any limit, eight looks a segment. What has a peak between two looks, higher than both by a few
/// millionths, counts as if it were larger by `between_looks`.
double greatest_ratio(const Segment& segment, const Section& section, const machine::Machine& machine) {
  constexpr int looks = 8;
  constexpr double between_looks = 5e-5;
  double greatest = 0;
  const double duration = segment.duration.value();
  for (int k = 0; k <= looks; ++k) {
    const PathState at = evaluate(segment, duration * k / looks);
    const Side side = k == 0 ? Side::right : Side::left;
    const geometry::PointJet jet = section.jets(at.s, side);
    const AxisRatios ratios = greatest_ratios(jet, at, machine);
    const double feed = at.speed / section.piece(section.piece_at(at.s, side)).feed;
    const double turning = turns(jet) ? 1 + between_looks : 1;
    greatest = std::max(
        {greatest, feed, ratios.velocity * turning, std::max(ratios.acceleration, ratios.jerk) * (1 + between_looks)});
  }
  return greatest;
}

/// s(t) → s(λt): velocity, acceleration and jerk by λ, λ², λ³.
void slow_down(std::vector<Segment>& segments, double factor) {
  DoubleDouble now;
  for (Segment& segment : segments) {
    segment.begin = now;
    segment.duration = segment.duration / DoubleDouble(factor);
    now = now + segment.duration;
    double power = factor;
    segment.v0 = segment.v0 * power;
    for (double* const c : {&segment.c2, &segment.c3, &segment.c4, &segment.c5}) *c *= power *= factor;
  }
}

/// The time at which the segment passes a place inside it, by bisection and Newton.
double time_at(const Segment& segment, double s) {
  double from = 0, to = segment.duration.value();
  for (int step = 0; step < 200 && to - from > 1e-16 * to; ++step) {
    const double middle = (from + to) / 2;
    (evaluate(segment, middle).s < s ? from : to) = middle;
  }
  return to;
}

/// The same polynomial from a later time on.
Segment later(const Segment& segment, double t) {
  Segment rest = segment;
  const PathState at = evaluate(segment, t);
  const double c3 = segment.c3, c4 = segment.c4, c5 = segment.c5;
  rest.begin = segment.begin + DoubleDouble(t);
  rest.duration = segment.duration - DoubleDouble(t);
  rest.v0 = at.speed;
  rest.c2 = at.acceleration / 2;
  rest.c3 = c3 + t * (4 * c4 + t * 10 * c5);
  rest.c4 = c4 + 5 * t * c5;
  return rest;
}

/// Cuts segments where pieces meet and counts way from each piece's beginning.
std::vector<Segment> along_pieces(const std::vector<Segment>& segments, const Section& section) {
  std::vector<Segment> cut;
  cut.reserve(segments.size() + section.size());
  std::size_t piece = 0;
  const auto place = [&](Segment segment, std::size_t on) {
    segment.piece = static_cast<std::uint32_t>(on);
    segment.s0 = segment.s0 - DoubleDouble(section.offset(on));
    cut.push_back(segment);
  };
  for (std::size_t k = 0; k < segments.size(); ++k) {
    Segment segment = segments[k];
    const double end = k + 1 < segments.size() ? segments[k + 1].s0.value() : section.length();
    while (piece + 1 < section.size() && section.offset(piece + 1) <= segment.s0.value()) ++piece;
    while (piece + 1 < section.size() && section.offset(piece + 1) < end) {
      const double border = section.offset(piece + 1), t = time_at(segment, border);
      if (t > 0 && t < segment.duration.value()) {
        Segment rest = later(segment, t);
        segment.duration = DoubleDouble(t);
        rest.s0 = border;
        place(segment, piece);
        segment = rest;
      }
      ++piece;
    }
    place(segment, piece);
  }
  return cut;
}

}  // namespace

std::vector<Segment> plan_section(const Section& section, const machine::Machine& machine) {
  SpeedProfile profile(section, machine, place_knots(section, machine));
  std::vector<Segment> segments;
  double worst = 0;
  for (int round = 0; round <= repairs; ++round) {
    profile.optimize(gap);
    profile.level_cruises();
    Emission emission(profile);
    segments = emission.emit(section.length());
    worst = 0;
    bool repaired = false;
    std::vector<double> factors(profile.intervals(), 1.0);
    for (std::size_t k = 0; k < segments.size(); ++k) {
      const double ratio = greatest_ratio(segments[k], section, machine);
      worst = std::max(worst, ratio);
      if (ratio <= 1) continue;
      const std::size_t interval = emission.intervals()[k];
      for (std::size_t i = interval > 0 ? interval - 1 : 0; i <= std::min(interval + 1, profile.intervals() - 1); ++i) {
        factors[i] = std::max(factors[i], ratio + repair_margin);
      }
      repaired = true;
    }
    if (!repaired || worst <= granted_slowing || round == repairs) break;
    for (std::size_t i = 0; i < factors.size(); ++i) {
      if (factors[i] > 1) profile.tighten(i, factors[i]);
    }
    profile.creep();
  }
  if (worst > 1) slow_down(segments, 1 / worst);
  return along_pieces(segments, section);
}

}  // namespace leadscrew::planner
