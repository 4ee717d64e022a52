// How far the next line may be.

#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/vectors.hpp>
#include <leadscrew/surfaces/pass_lines.hpp>
#include <leadscrew/surfaces/step_over.hpp>
#include <utility>

namespace leadscrew::surfaces {

namespace {

constexpr std::size_t fewest_in_span = 6;

}  // namespace

/// Where the next pass comes back and the tool leans by the pass, it has the same side of the tool towards this one as this has towards it.
double step_at(PassLog& log, const Contact& contact, const LinePlace& place, const Vector& towards) {
  const Machining& machining = *log.machining;
  const double h = machining.scallop;
  if (!(h > 0)) return machining.step;
  const Cutter& cutter = machining.cutter;
  const Bending& bending = contact.bending;
  double step = 0;
  if (cutter.is_ball()) {
    step = step_over(cutter.radius, bending.surface.bb, h);
  } else {
    const bool same_way = machining.pattern == Pattern::zig || machining.pattern == Pattern::spiral_in ||
                          machining.orientation.rule == Orientation::Rule::fixed;
    const double side = numeric::dot(bending.b, towards) < 0 ? -1 : 1;
    const double near = outline_arc(cutter, bending.axis, bending.surface, h, side);
    step = near + (same_way ? outline_arc(cutter, bending.axis, bending.surface, h, -side) : near);
  }
  if (!(step > 0)) log.fail(PassFailure::Kind::no_step, place.u.value, place.v.value);
  return std::min(step, 2 * cutter.radius);
}

Course course_of(const Machining& machining, Direction along) {
  const int corner = machining.start_corner;
  const bool u_rises = corner == 1 || corner == 4, v_rises = corner <= 2, is_u = along == Direction::u;
  const Range &run = is_u ? machining.u : machining.v, &width = is_u ? machining.v : machining.u;
  const bool runs_up = is_u ? u_rises : v_rises, goes_up = is_u ? v_rises : u_rises;
  return {along, runs_up ? run.from : run.to, runs_up ? run.to : run.from, goes_up ? width.from : width.to,
          goes_up ? width.to : width.from};
}

std::vector<double> places_along(const Surface& surface, Direction along, const Range& range, std::size_t least) {
  std::vector<double> cuts = {range.from}, places;
  for (const double cut : surface.breaks(along)) {
    if (cut > range.from && cut < range.to) cuts.push_back(cut);
  }
  cuts.push_back(range.to);
  const std::size_t spans = cuts.size() - 1, parts = std::max(fewest_in_span, (least - 1 + spans - 1) / spans);
  for (std::size_t k = 0; k < spans; ++k) {
    for (std::size_t i = 0; i < parts; ++i) {
      places.push_back(cuts[k] + (cuts[k + 1] - cuts[k]) * static_cast<double>(i) / static_cast<double>(parts));
    }
  }
  places.push_back(range.to);
  return places;
}

std::vector<double> section_places(const Surface& surface, const Course& course, std::size_t coordinate,
                                   const std::vector<double>& places) {
  const Range width = course.width();
  const double least = least_section_gap * (places.back() - places.front());
  std::vector<double> lines = {width.from}, found = places;
  for (const double cut : surface.breaks(course.along == Direction::u ? Direction::v : Direction::u)) {
    if (cut > width.from && cut < width.to) lines.push_back(cut);
  }
  lines.push_back(width.to);
  for (const double across : lines) {
    const auto rises = [&](double place) {
      const LinePlace at = line_place(course.along, place, 1, across);
      const SurfaceJet jet = surface.jet_of_first_order(at.u.value, at.v.value);
      return (course.along == Direction::u ? jet.u : jet.v)[coordinate] > 0;
    };
    for (std::size_t k = 1; k < places.size(); ++k) {
      double low = places[k - 1], high = places[k];
      const bool before = rises(low);
      if (before == rises(high)) continue;
      for (int round = 0; round < 50; ++round) {
        const double middle = (low + high) / 2;
        (rises(middle) == before ? low : high) = middle;
      }
      const double extreme = (low + high) / 2;
      if (extreme - places[k - 1] > least && places[k] - extreme > least) found.push_back(extreme);
    }
  }
  std::sort(found.begin(), found.end());
  const auto last = std::unique(found.begin(), found.end(), [&](double a, double b) { return b - a <= least; });
  found.erase(last, found.end());
  return found;
}

double least_of(const std::vector<double>& places, const std::vector<double>& values) {
  const auto k = static_cast<std::size_t>(std::min_element(values.begin(), values.end()) - values.begin());
  if (k == 0 || k + 1 == values.size()) return values[k];
  const double a = places[k - 1] - places[k], b = places[k + 1] - places[k];
  const double rise_a = (values[k - 1] - values[k]) / a, rise_b = (values[k + 1] - values[k]) / b;
  const double bend = (rise_b - rise_a) / (b - a), slope = rise_a - bend * a;
  return bend > 0 ? std::max(values[k] - slope * slope / (4 * bend), 0.9 * values[k]) : values[k];
}

std::vector<StepPlace> steps_along(PassLog& log, Direction along, const std::vector<double>& places, double across,
                                   double direction, double towards) {
  std::vector<StepPlace> steps;
  steps.reserve(places.size());
  for (const double place : places) {
    const LinePlace at = line_place(along, place, direction, across);
    const std::optional<Contact> contact = contact_at(log, at);
    if (!contact) return {};
    const Vector& by_across = along == Direction::u ? contact->jet.v : contact->jet.u;
    const double step = step_at(log, *contact, at, numeric::sum(Vector{}, towards, by_across));
    if (log.failure) return {};
    steps.push_back({step, width_of(contact->frame, along)});
  }
  return steps;
}

double step_between(const StepPlace& here, const StepPlace& middle, const StepPlace& there) {
  return (here.step + 2 * middle.step + there.step) / 4 * 6 / (here.width + 4 * middle.width + there.width);
}

namespace {

double least_between(const std::vector<double>& places, const std::vector<StepPlace>& here,
                     const std::vector<StepPlace>& middle, const std::vector<StepPlace>& there) {
  std::vector<double> steps(places.size());
  for (std::size_t k = 0; k < steps.size(); ++k) steps[k] = step_between(here[k], middle[k], there[k]);
  return least_of(places, steps);
}

}  // namespace

double least_on(const std::vector<double>& places, const std::vector<StepPlace>& line) {
  return least_between(places, line, line, line);
}

double LineSteps::next(PassLog& log, double across, double left, double direction, double towards, double guess) {
  if (!has_reach(*log.machining)) return by_rule(log, across, left, direction, towards, guess);
  const double first = guess > 0 ? guess : by_rule(log, across, left, direction, towards, 0);
  if (log.failure) return 0;
  if (const std::optional<double> step = by_reach(log, across, left, direction, towards, first)) return *step;
  return log.failure ? 0 : by_rule(log, across, left, direction, towards, first);
}

std::optional<Reaches> LineSteps::reaches_of(PassLog& log, double across, double direction, double towards) const {
  std::vector<std::optional<LinePlace>> line;
  for (const double place : places_) line.emplace_back(line_place(along_, place, direction, across));
  return reaches_along(log, along_, line, towards);
}

std::optional<LineReach> LineSteps::reach(PassLog& log, double across, double direction, double towards) const {
  LineReach reach;
  for (const double side : {towards, -towards}) {
    const std::optional<Reaches> reaches = reaches_of(log, across, direction, side);
    if (!reaches) return std::nullopt;
    std::vector<double> found;
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const ReachEnd& end = *(*reaches)[k];
      const bool is_u = along_ == Direction::u;
      found.push_back(side * ((is_u ? end.v : end.u) - across));
      const double ahead = direction * ((is_u ? end.u : end.v) - places_[k]);
      reach.ahead = std::max(reach.ahead, ahead);
      reach.behind = std::max(reach.behind, -ahead);
    }
    if (side == towards) reach.across = std::max(least_of(places_, found), 0.0);
  }
  return reach;
}

/// The reach of the next line is held against that of this one, and the step grows by the least overlap. In zigzag the next line is gone
/// back.
std::optional<double> LineSteps::by_reach(PassLog& log, double across, double left, double direction, double towards,
                                          double guess) const {
  const std::optional<Reaches> here = reaches_of(log, across, direction, towards);
  const double back = log.machining->pattern == Pattern::zigzag ? -direction : direction;
  double step = guess;
  for (int round = 0; round < 6 && here; ++round) {
    const double tried = std::min(step, left);
    const std::optional<Reaches> there = reaches_of(log, across + towards * tried, back, -towards);
    if (!there) return std::nullopt;
    std::vector<double> places, steps;
    for (const Overlap& overlap : overlaps_between(along_, *here, *there, towards)) {
      places.push_back(overlap.along);
      steps.push_back(std::max(tried + overlap.across, tried / 4));
    }
    if (places.empty()) return std::nullopt;
    step = std::min(least_of(places, steps), 4 * tried);
    if (std::abs(step - tried) < widest_gap * step || (tried == left && step > left)) return step;
  }
  return std::nullopt;
}

/// The middle and the next line are found from the step, and the step from them.
double LineSteps::by_rule(PassLog& log, double across, double left, double direction, double towards, double guess) {
  const auto steps_at = [&](double at) { return steps_along(log, along_, places_, at, direction, towards); };
  const std::vector<StepPlace> here = there_.empty() ? steps_at(across) : std::exchange(there_, {});
  double step = guess;
  for (int round = 0; round < 4 && !log.failure; ++round) {
    if (!(step > 0)) step = least_on(places_, here);
    const double reach = std::min(step, left);
    const std::vector<StepPlace> middle = steps_at(across + towards * reach / 2),
                                 there = steps_at(across + towards * reach);
    if (log.failure) return 0;
    const double found = least_between(places_, here, middle, there);
    const bool is_near = std::abs(found - step) < 1e-3 * found;
    step = found;
    if (!is_near) continue;
    if (log.machining->cutter.is_ball()) there_ = there;
    break;
  }
  return step;
}

bool are_too_many(PassLog& log, const Course& course, const std::vector<double>& places) {
  constexpr int parts = 8;
  double count = 1;
  const double width = course.last - course.first, direction = course.from < course.to ? 1 : -1;
  for (int k = 0; k <= parts; ++k) {
    const double across = course.first + width * k / parts;
    const std::vector<StepPlace> steps =
        steps_along(log, course.along, places, across, direction, course.sign_across());
    if (log.failure) return true;
    const double step = least_on(places, steps);
    count += (k == 0 || k == parts ? 0.5 : 1) * std::abs(width) / parts / step;
  }
  if (!(count <= static_cast<double>(most_passes))) {
    const LinePlace begin = line_place(course.along, course.from, direction, course.first);
    log.fail(PassFailure::Kind::too_many, begin.u.value, begin.v.value, count);
  }
  return log.failure.has_value();
}

}  // namespace leadscrew::surfaces
