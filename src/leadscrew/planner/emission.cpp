#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/numeric/bisection.hpp>
#include <leadscrew/numeric/gauss.hpp>
#include <leadscrew/planner/emission.hpp>
#include <leadscrew/planner/limit_ratios.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <limits>

namespace leadscrew::planner {

namespace {

using base::MotionState;
using constraints::Constraints;
using constraints::LimitRatios;
using numeric::DoubleDouble;

using namespace tuning::proof;

constexpr double turning_back = 1.5;  // ratio that stands for a motion that goes back
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

/// The greatest of values ≥ 0 at even steps, raised to the vertex of the parabola through every three of them where that may
/// lie above 1: it is no higher than 4/3 of the middle one. NaN counts as infinity: it exceeds every limit.
class Peak {
 public:
  void look(double value) {
    if (!(value <= greatest_)) greatest_ = std::isnan(value) ? infinity : value;
    if (++looks_ > 2 && last_ > 0.74) {
      const double bend = 2 * last_ - before_last_ - value, slope = (value - before_last_) / 2;
      if (std::abs(slope) < bend) greatest_ = std::max(greatest_, last_ + slope * slope / (2 * bend));
    }
    before_last_ = last_;
    last_ = value;
  }
  double greatest() const { return greatest_; }

 private:
  int looks_ = 0;
  double last_ = 0, before_last_ = 0, greatest_ = 0;
};

/// Of every limit by itself: where one takes over from another, the greater of both has a kink, whose peak no parabola
/// finds.
class Peaks {
 public:
  /// moving: axes; rows of others are 0 at every place.
  explicit Peaks(base::AxisSet moving) : moving_(moving) {}

  void look(const Constraints& constraints, const constraints::Place& place, const PathState& at, double on_speed) {
    constraints.each_row(place, [&](auto kind, std::size_t index, const auto& row) {
      using Kind = constraints::KindAt<kind>;
      if constexpr (Kind::is_of_axes) {
        if (!moving_.contains(base::all_axes[index])) return;
      }
      if constexpr (Kind::is_proven) {
        const std::size_t i = LimitRatios::offset<kind> + index;
        const double ratio = row.ratio(rates(at));
        if constexpr (Kind::is_smooth) {
          peaks_[i].look(constraints::is_speed<typename Kind::Row> ? ratio * on_speed : ratio);
        } else {
          jumping_[i] = std::max(jumping_[i], ratio);
        }
      }
    });
  }
  LimitRatios greatest() const {
    LimitRatios greatest = jumping_;
    for (std::size_t i = 0; i < LimitRatios::size; ++i) greatest[i] = std::max(greatest[i], peaks_[i].greatest());
    return greatest;
  }

 private:
  base::AxisSet moving_;
  std::array<Peak, LimitRatios::size> peaks_;
  LimitRatios jumping_;  ///< of what does not run smoothly
};

/// Where polynomials are many, most are those of a curve's table of arc length, which run smoothly from one to the next.
int looks_at_polynomials(std::size_t count) {
  const std::size_t close = std::min(count, few_polynomials), seen = std::min(count, most_borders);
  return looks_per_polynomial * static_cast<int>(close) + looks_per_more * static_cast<int>(seen - close);
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

/// The least speed where acceleration, a cubic, passes from below 0 at one time to above 0 at another.
double least_speed(const Segment& segment, double from, double to) {
  const auto slows_down = [&](double t) { return evaluate(segment, t).acceleration < 0; };
  return evaluate(segment, numeric::bisect(from, to, 20, slows_down).from).speed;
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

Ratios greatest_ratios(const Segment& segment, const Section& section, const Constraints& constraints,
                       double feed_factor, int looks) {
  // Every polynomial of the curve is looked at.
  const double end = evaluate(segment, segment.duration.value()).s;
  const std::size_t borders = section.borders(segment.s0.value(), end);
  looks = std::max(looks, looks_at_polynomials(borders + 1));
  const auto has_table = [&](std::size_t piece) { return section.piece(piece).axes().has_table(); };
  const std::size_t first = section.piece_at(segment.s0.value(), Side::right);
  const std::size_t last = section.piece_at(end, Side::left);
  const double on_curves = borders > most_borders ? dense_steps : has_table(first) || has_table(last) ? map_steps : 1;
  const auto look_at = [&](std::size_t piece, double s, Side side) {
    return seen_place_without_chords(section.piece(piece), s - section.offset(piece), side);
  };
  base::AxisSet moving;
  for (std::size_t p = first; p <= last; ++p) moving.insert(section.piece(p).axes().moving());
  Peaks peaks(moving);
  double fastest = 0, slowest = infinity;
  PathState before;
  std::size_t piece = first;
  const double duration = segment.duration.value();
  for (int k = 0; k <= looks; ++k) {
    const PathState at = evaluate(segment, duration * k / looks);
    fastest = std::max(fastest, at.speed);
    slowest = std::min(slowest, at.speed);
    if (k > 0 && before.acceleration < 0 && at.acceleration > 0)
      slowest = std::min(slowest, least_speed(segment, duration * (k - 1) / looks, duration * k / looks));
    before = at;
    while (piece < last && section.offset(piece + 1) < at.s) ++piece;
    const SeenPlace seen = look_at(piece, at.s, k == 0 ? Side::right : Side::left);
    peaks.look(constraints, seen.at_feed(feed_factor), at, turns(seen.jet) ? between_looks : 1);
  }
  // Where pieces meet inside the segment, or q‴ jumps, on both sides: one may be too short for any of the looks.
  LimitRatios ratios = peaks.greatest();
  const auto look_on_both_sides = [&](double s, std::size_t before_it, std::size_t behind_it) {
    const PathState at = evaluate(segment, time_at(segment, s));
    constraints.raise(look_at(before_it, s, Side::left).at_feed(feed_factor), rates(at), ratios);
    constraints.raise(look_at(behind_it, s, Side::right).at_feed(feed_factor), rates(at), ratios);
  };
  for (std::size_t p = first; p <= last; ++p) {
    if (p > first) look_on_both_sides(section.offset(p), p - 1, p);
    const double offset = section.offset(p);
    for (const double s : section.piece(p).axes().breaks(segment.s0.value() - offset, end - offset))
      look_on_both_sides(offset + s, p, p);
  }
  const machine::Derivatives greatest = ratios.by_derivative();
  constexpr double rounding = 1e-9;
  const bool turns_back = slowest < -rounding * fastest;
  const double rows = std::max(greatest.acceleration, greatest.jerk * on_curves) * between_looks;
  return {greatest.velocity, turns_back ? std::max(turning_back, rows) : rows, turns_back};
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
