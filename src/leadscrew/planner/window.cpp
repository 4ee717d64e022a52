#include <algorithm>
#include <cmath>
#include <leadscrew/planner/emission.hpp>
#include <leadscrew/planner/proof.hpp>
#include <leadscrew/planner/tuning.hpp>
#include <leadscrew/planner/window.hpp>
#include <limits>
#include <numeric>

namespace leadscrew::planner {

namespace {

using numeric::DoubleDouble;

using namespace tuning::window;

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Where tightened rows have not helped, as where a window begins and little can change, a profile that is farther
/// inside may: it costs less than what the last round falls back to.
constexpr double gap_of_round(int round, int rounds) {
  return round + 2 < rounds ? gap : round + 1 < rounds ? 10 * gap : 100 * gap;
}

/// The knot that the next window begins at: the last one before which this window's end has no influence. Where the end
/// is no farther than `stops_felt` stopping distances, speed is lower than it would be if the end were farther; so it
/// may be for `stops_before` stopping times before that place. Behind a corner, where speed is next to 0, the influence
/// ends sooner than the stopping distance from there tells.
std::size_t commit_until(const SpeedProfile& profile, const Section& section,
                         const constraints::Constraints& constraints, bool is_of_least_time) {
  const std::size_t n = profile.intervals();
  const double end = profile.knots().s[n];
  const std::size_t least_left = is_of_least_time ? tuning::least_time::least_ahead : least_ahead;
  std::size_t k = n;
  double since = 0, time_needed = infinity;
  while (k > 0) {
    --k;
    since += travel_time(profile, k);
    const double s = profile.knots().s[k], speed = std::sqrt(profile.square(k, 0));
    const double stop = stop_time(speed, tangent_limits(section.jets(s, Side::right), constraints));
    if (end - s <= stops_felt * speed * stop / 2) {
      since = 0;
      time_needed = stops_before * stop;
    }
    if (n - k >= least_left && since >= time_needed) break;
  }
  return std::max({k, static_cast<std::size_t>(committed * static_cast<double>(n)), std::size_t{1}});
}

/// Only from rest: x(s) becomes λ²x(s), and so does what follows.
void slow_down(Window& window, double factor) {
  window.profile.slow_down(factor);
  DoubleDouble now;
  for (Segment& segment : window.segments) {
    segment.begin = now;
    segment.duration = segment.duration / DoubleDouble(factor);
    now = now + segment.duration;
    double power = factor;
    segment.v0 = segment.v0 * power;
    for (double* const c : {&segment.c2, &segment.c3, &segment.c4, &segment.c5}) *c *= power *= factor;
  }
  if (!window.after) return;
  const double square = factor * factor;
  window.after->share *= square;
  for (double& c : window.after->c) c *= square;
}

class WindowPlanner {
 public:
  WindowPlanner(const Section& section, const constraints::Constraints& constraints, const PlannedRange& range,
                const std::optional<Continuation>& continuation, Aim aim, std::size_t most_intervals, Effort& effort,
                const Window* before)
      : section_(section),
        constraints_(constraints),
        range_(range),
        continuation_(continuation),
        aim_(aim),
        most_intervals_(most_intervals),
        effort_(effort),
        before_(before ? &before->profile : nullptr) {}

  std::unique_ptr<Window> plan() const;

 private:
  bool repair_from_rest(Window& window) const;
  bool repair_in_motion(Window& window, Knots* finer) const;
  bool refine(Knots& knots, const Window& window) const;
  static bool may_tighten(const Window& window);
  static bool exceeds_only_where_it_begins(const Window& window);
  bool emit(Window& window) const;
  bool add_stop(Window& window) const;
  bool prove(Window& window) const;
  template <class Work>
  bool spend_on(const SpeedProfile& profile, Work work) const;

  const Section& section_;
  const constraints::Constraints& constraints_;
  const PlannedRange& range_;
  const std::optional<Continuation>& continuation_;
  Aim aim_;
  std::size_t most_intervals_;
  Effort& effort_;
  const SpeedProfile* before_;
};

/// Work of Newton's method. False if it was the last that there is effort for.
template <class Work>
bool WindowPlanner::spend_on(const SpeedProfile& profile, Work work) const {
  const int before = profile.newton_steps();
  work();
  return effort_.spend(static_cast<double>(profile.newton_steps() - before) * static_cast<double>(profile.intervals()));
}

/// Time law of the window, proven or not: `worst` ratio, and `factors` by which limits are exceeded. False if it cannot
/// come to rest at its end.
bool WindowPlanner::emit(Window& window) const {
  SpeedProfile& profile = window.profile;
  const std::size_t n = profile.intervals();
  window.worst = 0;
  window.turns_back = false;
  window.factors.assign(n, Ratios{});
  if (!profile.ends_at_rest()) {
    window.last_interval = commit_until(profile, section_, constraints_, range_.closeness > 1);
    window.after = profile.continuation(window.last_interval);
    if (!window.after) {
      profile.unlevel();
      window.after = profile.continuation(window.last_interval);
    }
  }
  Emission emission = planner::emit(profile, range_.begin, range_.end);
  window.segments = std::move(emission.segments);
  window.intervals = std::move(emission.intervals);
  window.places = std::move(emission.places);
  window.end = range_.end;
  window.to_rest = profile.ends_at_rest();
  return add_stop(window) && prove(window);
}

/// The stop of a window that ends in motion; of one that is to rest, the soonest. False if none is found.
bool WindowPlanner::add_stop(Window& window) const {
  const SpeedProfile& profile = window.profile;
  const std::size_t n = profile.intervals();
  const auto stop_from = [&](const PathState& from, double longest) {
    return come_to_rest(from, range_.end - from.s, longest, section_, constraints_);
  };
  std::optional<Segment> stop;
  std::size_t stops = window.segments.size();
  if (!profile.ends_at_rest()) {
    stop = stop_from(state_at(profile, n - 1, 1), infinity);
    if (!stop) return false;
  }
  if (aim_ == Aim::rest) {  // where that is soonest
    const Segment& last = window.segments.back();
    double soonest = (last.begin + last.duration).value() + (stop ? stop->duration.value() : 0);
    for (std::size_t k = 0; k < window.segments.size(); ++k) {
      const Segment& segment = window.segments[k];
      const double begin = segment.begin.value();
      if (begin >= soonest) break;
      std::optional<Segment> here = stop_from(evaluate(segment, 0), soonest - begin);
      if (!here) continue;
      soonest = begin + here->duration.value();
      stop = here;
      stops = k;
      window.to_rest = true;
    }
    window.to_rest = window.to_rest || stop.has_value();
  }
  if (!stop) return true;
  window.intervals.push_back(n);
  window.places.push_back(0);
  window.segments.resize(stops);
  window.intervals.resize(stops + 1);
  window.places.resize(stops + 1);
  if (stops > 0) stop->begin = window.segments.back().begin + window.segments.back().duration;
  window.end = evaluate(*stop, stop->duration.value()).s;
  window.segments.push_back(*stop);
  return true;
}

/// Ratios of every segment, and by how much limits are exceeded around it. False where effort is at its end.
bool WindowPlanner::prove(Window& window) const {
  const SpeedProfile& profile = window.profile;
  const std::size_t n = profile.intervals();
  const double feed_factor = profile.is_too_fast() || aim_ == Aim::rest ? infinity : range_.feed_factor;
  if (!effort_.spend(effort_of_proof * static_cast<double>(window.segments.size()))) return false;
  for (std::size_t k = 0; k < window.segments.size(); ++k) {
    const int looks =
        !profile.ends_at_rest() && window.intervals[k] + stopping_intervals > n ? close_looks : usual_looks;
    const Ratios ratios = greatest_ratios(window.segments[k], section_, constraints_, feed_factor, looks);
    window.worst = std::max(window.worst, ratios.worst());
    window.turns_back = window.turns_back || ratios.turns_back;
    if (ratios.worst() <= 1) continue;
    const std::size_t interval = std::min(window.intervals[k], n - 1);
    for (std::size_t i = interval > 0 ? interval - 1 : 0; i <= std::min(interval + 1, n - 1); ++i) {
      Ratios& factors = window.factors[i];
      if (ratios.speed > 1) factors.speed = std::max(factors.speed, ratios.speed);
      if (ratios.rows > 1) factors.rows = std::max(factors.rows, ratios.rows);
    }
  }
  return true;
}

std::unique_ptr<Window> WindowPlanner::plan() const {
  Knots knots = place_knots(section_, constraints_, range_, most_intervals_, effort_);
  if (knots.intervals < 2) return nullptr;
  if (!continuation_) {
    auto window = std::make_unique<Window>(SpeedProfile(section_, constraints_, std::move(knots), range_.feed_factor));
    return repair_from_rest(*window) ? std::move(window) : nullptr;
  }
  for (int refinement = 0; refinement <= refinements; ++refinement) {
    const std::size_t intervals = knots.intervals;
    auto window = std::make_unique<Window>(
        SpeedProfile(section_, constraints_, knots, *continuation_, range_.feed_factor, before_));
    if (!(window->profile.greatest_ratio() < 1)) return nullptr;
    const bool may_refine = (range_.changes_from > 0 || range_.closeness > 1) && refinement < refinements;
    if (repair_in_motion(*window, may_refine ? &knots : nullptr)) return window;
    if (knots.intervals == intervals || !effort_.goes_on()) return nullptr;
  }
  return nullptr;
}

/// Plans until the proof is kept, and slows down what is left: from rest to rest or into creep that always helps, but
/// where motion turns back, for which there is only creep itself. False if it cannot come to rest at its end.
bool WindowPlanner::repair_from_rest(Window& window) const {
  SpeedProfile& profile = window.profile;
  if (!(profile.greatest_ratio() < 1)) return false;
  double first_gap = cold_gap;
  for (int round = 0;; ++round) {
    if (!spend_on(profile, [&] { profile.optimize(first_gap, gap); })) return false;
    profile.level_cruises();
    if (!emit(window)) return false;
    if (window.worst <= 1) return true;
    if (window.worst <= allowed_slowing || round == repairs) {
      if (window.turns_back) {
        profile.creep();
        if (!emit(window) || window.turns_back) return false;
      }
      if (!std::isfinite(window.worst)) return false;
      slow_down(window, 1 / std::max(1.0, window.worst));
      return true;
    }
    for (std::size_t i = 0; i < window.factors.size(); ++i) profile.tighten(i, window.factors[i].raised(repair_margin));
    profile.retreat(far_inside);
    first_gap = repair_gap;
    if (profile.greatest_ratio() < 1) continue;
    profile.creep();
    first_gap = cold_gap;
  }
}

/// Is the profile so far inside that its rows can be tightened as the window's factors say, with as much room left?
bool WindowPlanner::may_tighten(const Window& window) {
  for (std::size_t i = 0; i < window.factors.size(); ++i) {
    const Ratios factors = window.factors[i].raised(repair_margin);
    if (factors.worst() == 1) continue;
    const Ratios margin = window.profile.margin(i);
    if (factors.speed > (1 + margin.speed) / 2 || factors.rows > (1 + margin.rows) / 2) return false;
  }
  return true;
}

bool WindowPlanner::exceeds_only_where_it_begins(const Window& window) {
  const auto exceeds = [](const Ratios& factors) { return factors.worst() > 1; };
  return std::none_of(window.factors.begin() + 2, window.factors.end(), exceeds);
}

/// Plans until the proof is kept. False if it is not kept for all repairs, or if `finer` knots are needed first.
bool WindowPlanner::repair_in_motion(Window& window, Knots* finer) const {
  SpeedProfile& profile = window.profile;
  if (aim_ == Aim::fastest && profile.is_too_fast() && !spend_on(profile, [&] { profile.descend(); })) return false;
  double first_gap = warm_gap;
  const int rounds = range_.changes_from > 0 ? repairs_of_change : repairs;
  for (int round = 0; round <= rounds; ++round) {
    const bool last_round = round == rounds;
    const auto find_optimum = [&] {
      aim_ == Aim::rest ? profile.descend_to_creep(tuning::descent::cold_gap, tuning::descent::last_gap)
                        : profile.optimize(first_gap, gap_of_round(round, rounds));
    };
    if (!last_round && !spend_on(profile, find_optimum)) return false;
    if (aim_ == Aim::fastest) profile.level_cruises();
    if (!emit(window)) return false;
    if (window.worst <= 1) return true;
    if (round == 0 && aim_ == Aim::fastest && profile.move_inside(window.factors)) {
      profile.level_cruises();
      if (!emit(window)) return false;
      if (window.worst <= 1) return true;
    }
    // Or repairs have not helped.
    const bool coarse = range_.changes_from > 0 ? window.worst > coarse_knots || round + 1 >= rounds
                                                : window.worst > coarse_knots || round > 0;
    if (finer != nullptr && coarse && refine(*finer, window)) return false;
    if (last_round) return false;
    // Where it begins, motion is what it was: nothing that can be tightened.
    if (round + 2 < rounds && exceeds_only_where_it_begins(window)) round = rounds - 2;
    first_gap = 2 * near_inside;
    profile.retreat(near_inside);
    if (round > 0 || !may_tighten(window)) {
      profile.retreat(far_inside);
      if (!spend_on(profile, [&] { profile.center(deep_gap); })) return false;
      first_gap = deep_gap;
    }
    for (std::size_t i = 0; i < window.factors.size(); ++i) {  // half of the margin at most
      const Ratios factors = window.factors[i].raised(repair_margin);
      if (factors.worst() == 1) continue;
      const Ratios margin = profile.margin(i);
      profile.tighten(i,
                      {std::min(factors.speed, (1 + margin.speed) / 2), std::min(factors.rows, (1 + margin.rows) / 2)});
    }
    if (!(profile.greatest_ratio() < 1)) return false;
  }
  return false;
}

/// Knots come between those that lie too far apart for what the window does: where the proof is not kept, and, where feed has
/// changed, wherever speed does, if that adds no more than may be added. False if none come.
bool WindowPlanner::refine(Knots& knots, const Window& window) const {
  const SpeedProfile& profile = window.profile;
  const std::size_t n = profile.intervals();
  if (n < 2 * intervals_at_end) return false;
  // What was known ends in coefficients that have been lowered since: nothing comes between its last knots.
  const std::vector<double>& known = continuation_->s;
  const double from = known[known.size() - std::min(known.size(), intervals_at_end + 4)], to = known.back();
  const auto parts_if = [&](bool everywhere, double wider) {
    std::vector<double> widths(n - intervals_at_end, infinity);
    for (std::size_t k = 0; k < widths.size(); ++k) {
      const machine::Derivatives limits = tangent_limits(section_.jets(knots.s[k], Side::right), constraints_);
      const double slope = std::max(std::abs(profile.square_slope(k, 0)), std::abs(profile.square_slope(k, 1)));
      const double ramp = wider * ramp_width(limits, std::min(profile.square(k, 0), profile.square(k, 1)));
      if (window.factors[k].worst() > 1)
        widths[k] = wider < infinity ? std::min(profile.width(k) / 2, ramp) : profile.width(k) / 2;
      else if (everywhere && slope / 2 > cruising * limits.acceleration)
        widths[k] = 1.5 * ramp;
    }
    const auto grade = [&](std::size_t k, std::size_t by) {
      widths[k] = std::min(widths[k], steepest * std::min(widths[by], profile.width(by)));
    };
    for (std::size_t k = 1; k < widths.size(); ++k) grade(k, k - 1);
    for (std::size_t k = widths.size() - 1; k-- > 0;) grade(k, k + 1);
    std::vector<std::size_t> parts;
    for (std::size_t k = 0; k < widths.size(); ++k) {
      if (knots.s[k + 1] > from && knots.s[k] < to) widths[k] = infinity;
      parts.push_back(static_cast<std::size_t>(std::clamp(std::round(profile.width(k) / widths[k]), 1.0, most_parts)));
    }
    return parts;
  };
  const bool changes = range_.changes_from > 0;
  const std::size_t most_added = n < most_refined ? most_refined - n : 0;
  const auto added_by = [](const std::vector<std::size_t>& parts) {
    return std::accumulate(parts.begin(), parts.end(), std::size_t{0}) - parts.size();
  };
  std::vector<std::size_t> parts = changes ? parts_if(true, 1) : parts_if(false, infinity);
  for (double wider = 1; added_by(parts) > most_added && wider < widest; wider *= 1.5) parts = parts_if(false, wider);
  if (added_by(parts) > most_added) parts = parts_if(false, infinity);
  if (added_by(parts) == 0 || added_by(parts) > most_added) return false;
  std::vector<double> s;
  std::vector<bool> breaks;
  for (std::size_t k = 0; k < knots.s.size(); ++k) {
    s.push_back(knots.s[k]);
    breaks.push_back(knots.breaks[k]);
    for (std::size_t part = 1; k < parts.size() && part < parts[k]; ++part) {
      s.push_back(knots.s[k] + profile.width(k) * static_cast<double>(part) / static_cast<double>(parts[k]));
      breaks.push_back(false);
    }
  }
  knots.s = std::move(s);
  knots.breaks = std::move(breaks);
  knots.intervals += added_by(parts);
  return true;
}

}  // namespace

std::unique_ptr<Window> plan_window(const Section& section, const constraints::Constraints& constraints,
                                    const PlannedRange& range, const std::optional<Continuation>& continuation, Aim aim,
                                    std::size_t most_intervals, Effort& effort, const Window* before) {
  return WindowPlanner(section, constraints, range, continuation, aim, most_intervals, effort, before).plan();
}

}  // namespace leadscrew::planner
