#include <algorithm>
#include <cmath>
#include <leadscrew/planner/braking.hpp>
#include <leadscrew/planner/emission.hpp>
#include <leadscrew/planner/limit_ratios.hpp>
#include <leadscrew/planner/proof.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <utility>

namespace leadscrew::planner {

namespace {

using namespace tuning::braking;

/// By the limits along the tangent there, as if the path went straight on; units.
double stopping_distance(const PathState& from, const Section& section, const constraints::Constraints& constraints) {
  const machine::Derivatives limits = tangent_limits(section.jets(from.s, Side::right), constraints);
  const double rise = std::max(from.acceleration, 0.0) / limits.jerk;  // s, while speed still rises
  const double fastest = from.speed + from.acceleration * rise / 2;
  return rise * (from.speed + from.acceleration * rise / 3) + fastest * stop_time(fastest, limits) / 2;
}

/// A part of a window that begins in motion.
struct Part {
  Knots knots;
  Continuation before;
};

/// The intervals that begin within this distance.
std::optional<Part> part_of(const Window& window, std::size_t from, double distance) {
  std::optional<Continuation> before = window.profile.continuation(window.intervals[from], window.places[from]);
  if (!before) return std::nullopt;
  const std::size_t left = window.profile.intervals() - window.intervals[from];
  std::size_t n = 0;
  while (n < left && before->s[n] < before->s[0] + distance) ++n;
  Part part;
  if (n < left && n + tuning::knots::knots_beyond < before->s.size()) {
    before->s.resize(n + 1 + tuning::knots::knots_beyond);
    before->breaks.resize(before->s.size());
    before->tightened.resize(std::min(before->tightened.size(), n));
    before->c.resize(n + 3);
    before->creeping = n + 3;
    before->loose = n;
    before->end_ramp = 0;
    part.knots.free_end = true;
  } else {
    n = left;
  }
  if (n < fewest_intervals) return std::nullopt;
  part.knots.s = before->s;
  part.knots.breaks = before->breaks;
  part.knots.intervals = n;
  part.knots.end_ramp = before->end_ramp;
  part.before = std::move(*before);
  return part;
}

class Braking {
 public:
  Braking(const Section& section, const constraints::Constraints& constraints, double feed_factor)
      : section_(section), constraints_(constraints), feed_factor_(feed_factor) {}

  struct Outcome {
    std::optional<Tail> tail;  ///< none also where what leads to rest exceeds a limit however rows are tightened
    bool lands = false;        ///< was there a stop by one cubic?
  };
  /// Down to a creep, and to rest as soon as there is a stop by one cubic that ends before `farthest`.
  Outcome come_down(Part part, double farthest) const {
    const double begin = part.knots.s[0], end = part.knots.s.back() + part.knots.end_ramp;
    SpeedProfile profile(section_, constraints_, std::move(part.knots), std::move(part.before), feed_factor_);
    double gap = last_gap;
    for (int round = 0; round <= repairs && profile.greatest_ratio() < 1; ++round, gap *= 10) {
      profile.descend_to_creep(round > 0 ? deep_gap : first_gap, gap);
      Emission emission = emit(profile, begin, end);
      std::optional<Landing> landing = land(emission.segments, farthest);
      if (!landing) return {};
      emission.segments.resize(landing->after);
      const std::vector<Excess> excesses = excesses_of(emission);
      if (excesses.empty()) return {joined(std::move(emission.segments), landing->stop), true};
      profile.retreat(tuning::window::far_inside);
      profile.center(deep_gap);
      for (const Excess& excess : excesses) tighten(profile, excess);
    }
    return {std::nullopt, true};
  }

 private:
  /// A stop by one cubic, behind so many segments.
  struct Landing {
    std::size_t after = 0;
    Segment stop;
  };
  /// Where a limit is exceeded between knots.
  struct Excess {
    std::size_t interval = 0;
    Ratios ratios;
  };

  std::optional<Landing> land(const std::vector<Segment>& segments, double farthest) const {
    std::optional<Landing> landing;
    const double begin = segments[0].s0.value();
    for (std::size_t k = 0; k < segments.size() && segments[k].s0.value() < farthest; ++k) {
      const std::optional<Segment> stop = cubic(evaluate(segments[k], 0), farthest);
      if (!stop) continue;
      landing = Landing{k, *stop};
      farthest = end_of(*stop) - worthwhile * (end_of(*stop) - begin);
    }
    return landing;
  }

  std::vector<Excess> excesses_of(const Emission& emission) const {
    std::vector<Excess> excesses;
    for (std::size_t k = 0; k < emission.segments.size(); ++k) {
      const Ratios ratios = greatest_ratios(emission.segments[k], section_, constraints_, feed_factor_, usual_looks);
      if (!(ratios.worst() <= 1)) excesses.push_back({emission.intervals[k], ratios});
    }
    return excesses;
  }

  /// Rows around it, by half of their margin at most.
  static void tighten(SpeedProfile& profile, const Excess& excess) {
    const std::size_t last = profile.intervals() - 1, k = std::min(excess.interval, last);
    for (std::size_t i = k > 0 ? k - 1 : 0; i <= std::min(k + 1, last); ++i) {
      const Ratios margin = profile.margin(i);
      const auto factor = [](double ratio, double room) {
        return ratio > 1 ? std::max(1.0, std::min(ratio + tuning::window::repair_margin, (1 + room) / 2)) : 1.0;
      };
      profile.tighten(i, {factor(excess.ratios.speed, margin.speed), factor(excess.ratios.rows, margin.rows)});
    }
  }

  static Tail joined(std::vector<Segment> segments, Segment stop) {
    if (!segments.empty()) stop.begin = segments.back().begin + segments.back().duration;
    segments.push_back(stop);
    return {std::move(segments), end_of(stop)};
  }

  static double end_of(const Segment& stop) { return evaluate(stop, stop.duration.value()).s; }

  std::optional<Segment> cubic(const PathState& from, double farthest) const {
    if (!(from.speed > 0)) return std::nullopt;
    double t = shortest_stop(from, tangent_limits(section_.jets(from.s, Side::right), constraints_));
    for (int attempt = 0; attempt < attempts; ++attempt, t *= longer) {
      const Segment stop = stop_within(from, t);
      if (end_of(stop) > farthest || !(3 * from.speed + from.acceleration * t >= 0)) return std::nullopt;
      if (is_seen_to_fail(stop, section_, constraints_, feed_factor_)) continue;
      if (greatest_ratios(stop, section_, constraints_, feed_factor_, stop_looks).worst() <= 1) return stop;
    }
    return std::nullopt;
  }

  const Section& section_;
  const constraints::Constraints& constraints_;
  double feed_factor_;
};

}  // namespace

bool is_seen_to_fail(const Segment& stop, const Section& section, const constraints::Constraints& constraints,
                     double feed_factor) {
  for (int k = 0; k <= first_looks; ++k) {
    const PathState at = evaluate(stop, stop.duration.value() * k / first_looks);
    const Side side = k == 0 ? Side::right : Side::left;
    const geometry::PointJet jet = section.jets(at.s, side);
    const constraints::Place place{jet, feed_factor * section.greatest_speed(at.s, side, jet)};
    if (!(constraints.ratios(place, rates(at)).greatest() <= 1)) return true;
  }
  return false;
}

std::optional<Tail> brake(const Window& window, std::size_t from, double farthest, const Section& section,
                          const constraints::Constraints& constraints, double feed_factor) {
  const Segment& first = window.segments[from];
  const Braking braking(section, constraints, feed_factor);
  double distance = reach * stopping_distance(evaluate(first, 0), section, constraints);
  std::optional<Tail> best;
  for (int part_count = 0; part_count < most_parts; ++part_count, distance *= 2) {
    std::optional<Part> part = part_of(window, from, distance);
    if (!part) break;
    const bool is_all = !part->knots.free_end;
    const double end = part->knots.s[part->knots.intervals];
    Braking::Outcome outcome = braking.come_down(std::move(*part), farthest);
    if (outcome.tail) {
      farthest = outcome.tail->end;
      best = std::move(outcome.tail);
    }
    // Where the stop ends farther than the part does, speed was not down before its end.
    if (is_all || (outcome.lands && farthest <= end)) break;
    if (outcome.lands && !best) break;
  }
  if (!best) return std::nullopt;
  for (Segment& segment : best->segments) segment.begin = first.begin + segment.begin;
  return best;
}

}  // namespace leadscrew::planner
