#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/numeric/bisection.hpp>
#include <leadscrew/planner/limit_ratios.hpp>
#include <leadscrew/planner/proof.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <limits>

namespace leadscrew::planner {

namespace {

using constraints::Constraints;
using constraints::LimitRatios;
using numeric::Pair;
using numeric::PairBits;

using namespace tuning::proof;

constexpr double turning_back = 1.5;  // ratio that stands for a motion that goes back
constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

/// The vertex of the parabola through three values at even steps, if it lies between the outer ones and is a maximum; else
/// the middle one.
double vertex(double before, double here, double after) {
  const double bend = 2 * here - before - after, slope = (after - before) / 2;
  return std::abs(slope) < bend ? here + slope * slope / (2 * bend) : here;
}

/// The greatest of values ≥ 0 at even steps, raised to the vertex of the parabola through every three of them where that may
/// lie above 1: it is no higher than 4/3 of the middle one. NaN counts as infinity: it exceeds every limit.
class Peak {
 public:
  void look(Pair values) {
    greatest_ = (values > greatest_ ? values : greatest_) + (values - values);  // NaN stays
    if (numeric::any(numeric::between(last_, values) > 0.74)) {
      const double peak = std::max(vertex(last_[0], last_[1], values[0]), vertex(last_[1], values[0], values[1]));
      greatest_[0] = peak > greatest_[0] ? peak : greatest_[0];
      const double third_difference = values[1] - last_[0] - 3 * (values[0] - last_[1]);
      possible_ = std::max(possible_, peak + of_third_difference * std::abs(third_difference));
    }
    last_ = values;
  }
  double greatest() const {
    const double greatest = std::max(greatest_[0], greatest_[1]);
    return std::isnan(greatest_[0] + greatest_[1]) ? infinity : greatest;
  }
  /// By how much a cubic through four values may lie above the parabolas counts, too.
  double possible() const { return possible_; }

 private:
  static constexpr double of_third_difference = 0.0642;  // the greatest |u(u² − 1)/6|, |u| ≤ 1

  Pair last_ = {nan, nan};  ///< before the first there is none: no parabola
  Pair greatest_{};
  double possible_ = 0;
};

/// Of every limit by itself: where one takes over from another, the greater of both has a kink, whose peak no parabola
/// finds.
class Peaks {
 public:
  /// moving: axes; rows of others are 0 at every place.
  explicit Peaks(base::AxisSet moving) : moving_(moving) {}

  /// Two looks, one behind the other. `on_speed`: what speeds count for.
  void look(const Constraints& constraints, const constraints::PlaceOf<Pair>& place,
            const constraints::PathRatesOf<Pair>& rates, Pair on_speed) {
    constraints.each_proven_row(place, [&](auto kind, std::size_t index, const auto& row) {
      using Kind = constraints::KindAt<kind>;
      if constexpr (Kind::is_of_axes) {
        if (!moving_.contains(base::all_axes[index])) return;
      }
      const std::size_t i = LimitRatios::offset<kind> + index;
      const Pair ratio = row.ratio(rates);
      if constexpr (Kind::is_smooth) {
        peaks_[i].look(constraints::is_speed<typename Kind::Row> ? ratio * on_speed : ratio);
      } else {
        jumping_[i] = std::max({jumping_[i], ratio[0], ratio[1]});
      }
    });
  }
  LimitRatios greatest() const {
    LimitRatios greatest = jumping_;
    for (std::size_t i = 0; i < LimitRatios::size; ++i) greatest[i] = std::max(greatest[i], peaks_[i].greatest());
    return greatest;
  }
  /// May one exceed its limit, though none does by what was seen?
  bool is_unsure() const {
    const auto possible = [](const Peak& peak) { return peak.possible() > 1; };
    return std::ranges::any_of(peaks_, possible) && greatest().greatest() <= 1;
  }

 private:
  base::AxisSet moving_;
  std::array<Peak, LimitRatios::size> peaks_;
  LimitRatios jumping_;  ///< of what does not run smoothly
};

/// Where polynomials are many, most are those of a curve's table of arc length, which run smoothly from one to the next.
int looks_at_polynomials(std::size_t count) {
  const std::size_t close = std::min(count, few_polynomials), seen = std::min(count, most_polynomials);
  return looks_per_polynomial * static_cast<int>(close) + looks_per_more * static_cast<int>(seen - close);
}

/// The least speed where acceleration, a cubic, passes from below 0 at one time to above 0 at another.
double least_speed(const Segment& segment, double from, double to) {
  const auto slows_down = [&](double t) { return evaluate(segment, t).acceleration < 0; };
  return evaluate(segment, numeric::bisect(from, to, 20, slows_down).from).speed;
}

/// Along one segment.
class SegmentProof {
 public:
  SegmentProof(const Segment& segment, const Section& section, const Constraints& constraints, double feed_factor)
      : segment_(segment),
        section_(section),
        constraints_(constraints),
        feed_factor_(feed_factor),
        begin_(segment.s0.value()),
        end_(evaluate(segment, segment.duration.value()).s),
        first_(section.piece_at(begin_, Side::right)),
        last_(section.piece_at(end_, Side::left)) {
    for (std::size_t p = first_; p <= last_; ++p) moving_.insert(section.piece(p).axes().moving());
  }

  Ratios ratios(int looks) {
    const std::size_t borders = section_.borders(begin_, end_);
    looks = std::max(looks, looks_at_polynomials(borders + 1));
    for (int closer = 0; look_along(looks) && closer < most_closer; ++closer) looks *= 2;
    look_at_joints();
    if (borders > 0) look_at_tables();
    const machine::Derivatives greatest = ratios_.by_derivative();
    const double rows = std::max(greatest.acceleration, greatest.jerk) * between_looks;
    constexpr double rounding = 1e-9;
    const bool turns_back = std::min(slowest_[0], slowest_[1]) < -rounding * std::max(fastest_[0], fastest_[1]);
    return {greatest.velocity, turns_back ? std::max(turning_back, rows) : rows, turns_back};
  }

 private:
  /// Two by two, from the segment's beginning to its end. Returns whether looks lie too far apart to be sure.
  bool look_along(int looks) {
    looks += 1 - looks % 2;
    acceleration_ = times_ = Pair{};
    Peaks peaks(moving_);
    const double duration = segment_.duration.value();
    std::size_t piece = first_;
    const auto piece_of = [&](double s) {
      while (piece < last_ && section_.offset(piece + 1) < s) ++piece;
      return piece;
    };
    for (int k = 0; k < looks; k += 2) {
      const Pair times = {duration * k / looks, duration * (k + 1) / looks};
      const PathStateOf<Pair> at = evaluate(segment_, times);
      see_speeds(at, times);
      const std::size_t on = piece_of(at.s[0]), then_on = piece_of(at.s[1]);
      const Side side = k == 0 ? Side::right : Side::left;
      const double offset = section_.offset(on);
      const SeenPlaces seen =
          on == then_on ? seen_places(section_.piece(on), at.s[0] - offset, side, at.s[1] - offset, Side::left)
                        : side_by_side(see(on, at.s[0], side), see(then_on, at.s[1], Side::left));
      peaks.look(constraints_, seen.at_feed(feed_factor_), rates(at),
                 turns(seen.jet) ? numeric::all<Pair>(between_looks) : numeric::all<Pair>(1));
    }
    ratios_ = peaks.greatest();
    return peaks.is_unsure();
  }
  void see_speeds(const PathStateOf<Pair>& at, Pair times) {
    fastest_ = at.speed > fastest_ ? at.speed : fastest_;
    slowest_ = at.speed < slowest_ ? at.speed : slowest_;
    const Pair before = numeric::between(acceleration_, at.acceleration), since = numeric::between(times_, times);
    if (numeric::any((before < 0) & (at.acceleration > 0))) {
      for (const std::size_t k : {0, 1}) {
        if (before[k] < 0 && at.acceleration[k] > 0)
          slowest_[0] = std::min(slowest_[0], least_speed(segment_, since[k], times[k]));
      }
    }
    acceleration_ = at.acceleration;
    times_ = times;
  }
  SeenPlace see(std::size_t piece, double s, Side side) const {
    return seen_place_without_chords(section_.piece(piece), s - section_.offset(piece), side);
  }
  /// Where pieces meet inside the segment, or q‴ jumps, on both sides: one may be too short for any of the looks.
  void look_at_joints() {
    for (std::size_t p = first_; p <= last_; ++p) {
      const double offset = section_.offset(p);
      if (p > first_) look_on_both_sides(time_at(segment_, offset), offset, p - 1, p);
      for (const double s : section_.piece(p).axes().breaks(begin_ - offset, end_ - offset))
        look_on_both_sides(time_at(segment_, offset + s), offset + s, p, p);
    }
  }
  /// Where pieces of a table of arc length meet, if the step of jerk there may exceed a limit, and nothing does yet.
  void look_at_tables() {
    const double allowed = allowed_step();
    if (allowed < 0) return;
    double reached = 0;  // the time at the last of them
    for (std::size_t p = first_; p <= last_; ++p) {
      const double offset = section_.offset(p);
      const toolpath::AxisPath axes = section_.piece(p).axes();
      const double from = std::max(begin_ - offset, 0.0), to = std::min(end_ - offset, axes.length());
      if (from >= to) continue;
      axes.each_table_border(from, to, [&](const geometry::Nurbs::Border& border) {
        if (border.step <= allowed) return;
        const double s = offset + border.s;
        reached = numeric::bisect(reached, segment_.duration.value(), 30, [&](double t) {
                    return evaluate(segment_, t).s < s;
                  }).from;
        look_on_both_sides(reached, s, p, p);
      });
    }
  }
  /// Of q‴, as a multiple of q′: by so much |q̇|·ṡ²/j of each axis is below what is left of its jerk.
  double allowed_step() const {
    const double speed = std::max(fastest_[0], fastest_[1]);
    double least = infinity;
    for (const base::Axis axis : base::all_axes) {
      if (!moving_.contains(axis)) continue;
      const machine::Derivatives seen = ratios_.of_axis(axis), limits = constraints_.of_axis(axis);
      const double by_step = seen.velocity * limits.velocity * speed * speed / limits.jerk;
      least = std::min(least, (1 / between_looks - seen.jerk) / by_step);
    }
    return least;
  }
  void look_on_both_sides(double time, double s, std::size_t before_it, std::size_t behind_it) {
    const PathState at = evaluate(segment_, time);
    constraints_.raise(see(before_it, s, Side::left).at_feed(feed_factor_), rates(at), ratios_);
    constraints_.raise(see(behind_it, s, Side::right).at_feed(feed_factor_), rates(at), ratios_);
  }

  const Segment& segment_;
  const Section& section_;
  const Constraints& constraints_;
  double feed_factor_;
  double begin_, end_;        // of the segment, on the section
  std::size_t first_, last_;  // pieces
  base::AxisSet moving_;
  Pair fastest_{}, slowest_ = numeric::all<Pair>(infinity);
  Pair acceleration_{}, times_{};  // of the last two looks
  LimitRatios ratios_;
};

}  // namespace

Ratios greatest_ratios(const Segment& segment, const Section& section, const Constraints& constraints,
                       double feed_factor, int looks) {
  return SegmentProof(segment, section, constraints, feed_factor).ratios(looks);
}

}  // namespace leadscrew::planner
