#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/numeric/gauss.hpp>
#include <leadscrew/planner/emission.hpp>
#include <leadscrew/planner/proof.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <limits>

namespace leadscrew::planner {

namespace {

using base::MotionState;
using constraints::Constraints;
using numeric::DoubleDouble;

using namespace tuning::proof;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// s(τ) along the section, by a quintic with the speeds and accelerations of both ends (Hermite).
Segment quintic(const PathState& from, const PathState& to, double duration) {
  const double t = duration, distance = to.s - from.s;
  const double r0 = distance - t * (from.speed + t * from.acceleration / 2);
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

class Emitter {
 public:
  Emitter(const SpeedProfile& profile, double begin) : profile_(profile), begin_(begin) {}

  /// From rest or from where the window begins, to rest or to its last knot.
  Emission emit(double end) {
    const std::size_t n = profile_.intervals();
    PathState here = state_at(profile_, 0, 0);
    if (profile_.starts_at_rest()) ramp_up(begin_, here);
    for (std::size_t k = 0; k < n; ++k) push(along_interval(profile_, k, 0, 1, here), k, 0);
    if (profile_.ends_at_rest()) ramp_down(here, end);
    return std::move(emission_);
  }

 private:
  void push(Segment segment, std::size_t interval, double place) {
    segment.begin = now_;
    now_ = now_ + segment.duration;
    emission_.segments.push_back(segment);
    emission_.intervals.push_back(interval);
    emission_.places.push_back(place);
  }

  /// s = J t³/6 up to the first knot: t = 3 s₁/v₁.
  void ramp_up(double from, const PathState& to) {
    const double distance = to.s - from, t = 3 * distance / to.speed;
    Segment segment;
    segment.duration = t;
    segment.s0 = from;
    segment.c3 = distance / (t * t * t);
    push(segment, 0, 0);
  }
  void ramp_down(const PathState& from, double end) {
    const double distance = end - from.s, t = 3 * distance / from.speed, c3 = distance / (t * t * t);
    Segment segment;
    segment.duration = t;
    segment.s0 = from.s;
    segment.v0 = 3 * c3 * t * t;
    segment.c2 = -3 * c3 * t;
    segment.c3 = c3;
    push(segment, profile_.intervals() - 1, 1);
  }

  const SpeedProfile& profile_;
  double begin_;
  Emission emission_;
  DoubleDouble now_;
};

}  // namespace

double travel_time(const SpeedProfile& profile, std::size_t k, double from, double to) {
  const double middle = (from + to) / 2, half = (to - from) / 2;
  double sum = 0;
  for (std::size_t q = 0; q < numeric::gauss_8_of_durations.size(); ++q) {
    const auto [abscissa, weight] = numeric::gauss_8_of_durations[q];
    for (const double side : {-1.0, 1.0}) {
      sum += weight / std::sqrt(profile.square(k, middle + half * side * abscissa));
    }
  }
  return sum * half * profile.width(k);
}

PathState state_at(const SpeedProfile& profile, std::size_t k, double u) {
  const std::vector<double>& s = profile.knots().s;
  return {u >= 1 ? s[k + 1] : s[k] + u * profile.width(k), std::sqrt(profile.square(k, u)),
          profile.square_slope(k, u) / 2, 0};
}

Segment along_interval(const SpeedProfile& profile, std::size_t k, double begin, double end, PathState& from) {
  const PathState here = from;
  from = state_at(profile, k, end);
  if (!profile.is_level(k)) return quintic(here, from, travel_time(profile, k, begin, end));
  from.speed = here.speed;
  from.acceleration = 0;
  Segment segment;
  segment.duration = (from.s - here.s) / here.speed;
  segment.s0 = here.s;
  segment.v0 = here.speed;
  segment.state = MotionState::constant;
  return segment;
}

Emission emit(const SpeedProfile& profile, double begin, double end) {
  return Emitter(profile, begin).emit(end);
}

Segment stop_within(const PathState& from, double t) {
  const double v = from.speed, a = from.acceleration;
  Segment segment;
  segment.duration = t;
  segment.s0 = from.s;
  segment.v0 = v;
  segment.c2 = a / 2;
  segment.c3 = (-3 * v - 2 * t * a) / (3 * t * t);
  segment.c4 = (2 * v + t * a) / (4 * t * t * t);
  return segment;
}

/// Jerk is greatest where it begins. The peak of acceleration is least, 4v/(3t), where a = −v/t; 3v/(2t) where a = 0.
double shortest_stop(const PathState& from, const machine::Derivatives& limits) {
  const double v = from.speed, a = from.acceleration, jerk = 0.99 * limits.jerk;
  return std::max((a + std::sqrt(a * a + 6 * v * jerk)) / jerk, 1.33 * v / limits.acceleration);
}

std::optional<Segment> come_to_rest(const PathState& from, double distance_left, double longest, const Section& section,
                                    const Constraints& constraints) {
  const machine::Derivatives limits = tangent_limits(section.jets(from.s, Side::right), constraints);
  const double v = from.speed, a = from.acceleration;
  if (!(v > 0)) return std::nullopt;
  double t = shortest_stop(from, limits);
  for (int attempt = 0; attempt < 40; ++attempt, t *= 1.06) {
    const double distance = t * (v / 2 + t * a / 12);
    if (t > longest || distance > distance_left || 3 * v + a * t < 0) return std::nullopt;
    const Segment segment = stop_within(from, t);
    if (greatest_ratios(segment, section, constraints, infinity, stop_looks).worst() <= 1) return segment;
  }
  return std::nullopt;
}

std::vector<Segment> cut_at(const Segment& segment, std::span<const double> places) {
  std::vector<Segment> parts;
  Segment rest = segment;
  const double end = evaluate(segment, segment.duration.value()).s;
  for (const double place : places) {
    if (place <= rest.s0.value()) continue;
    if (place >= end) break;
    const double t = time_at(rest, place);
    if (!(t > 0 && t < rest.duration.value())) continue;
    const Segment behind = later(rest, t);
    rest.duration = DoubleDouble(t);
    parts.push_back(rest);
    rest = behind;
    rest.s0 = place;
  }
  parts.push_back(rest);
  return parts;
}

namespace {

/// A piece's two offsets are so far apart as it is long, but for what was rounded when the section was far longer. That would
/// be a step of all axes where the next piece begins: words at the shortest periods show it. So much longer it is travelled.
void stretch(Segment& segment, const Section& section, std::size_t piece) {
  const DoubleDouble apart = numeric::two_sum(section.offset(piece + 1), -section.offset(piece));
  const double length = section.piece(piece).axes().length();
  const double longer = (DoubleDouble(length) - apart).value() / length;
  if (longer == 0) return;
  segment.s0 = segment.s0 + segment.s0.hi * longer;
  segment.v0 = segment.v0 + segment.v0.hi * longer;
  for (double* c : {&segment.c2, &segment.c3, &segment.c4, &segment.c5}) *c += *c * longer;
}

}  // namespace

std::vector<Segment> along_pieces(const std::vector<Segment>& segments, const Section& section, double section_end,
                                  std::size_t first_piece) {
  std::vector<Segment> cut;
  cut.reserve(segments.size() + 8);
  std::size_t piece = first_piece;
  const auto place = [&](Segment segment, std::size_t on) {
    segment.piece = static_cast<std::uint32_t>(on - first_piece);
    segment.s0 = segment.s0 - DoubleDouble(section.offset(on));
    if (section.piece(on).transformation) stretch(segment, section, on);
    cut.push_back(segment);
  };
  for (std::size_t k = 0; k < segments.size(); ++k) {
    Segment segment = segments[k];
    const double end = k + 1 < segments.size() ? segments[k + 1].s0.value() : section_end;
    while (piece + 1 < section.size() && section.offset(piece + 1) <= segment.s0.value()) ++piece;
    while (piece + 1 < section.size() && section.offset(piece + 1) < end) {
      const double border = section.offset(piece + 1), t = time_at(segment, border);
      if (!(t < segment.duration.value())) break;  // it ends where the piece does
      if (t > 0) {
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

}  // namespace leadscrew::planner
