#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/toolpath/corridor_plan.hpp>
#include <leadscrew/toolpath/corridor_stops.hpp>
#include <leadscrew/toolpath/event_marks.hpp>
#include <leadscrew/toolpath/racing_line.hpp>
#include <leadscrew/toolpath/tolerance_space.hpp>
#include <leadscrew/toolpath/tuning.hpp>
#include <numbers>
#include <utility>

namespace leadscrew::toolpath {

namespace {

using namespace tuning::corridor;
using geometry::Point;

Vector<3> place_of(const Point& point) {
  return {point[0], point[1], point[2]};
}

CorridorLimits<3> limits_of(const machine::Machine& machine) {
  CorridorLimits<3> limits;
  for (std::size_t i = 0; i < 3; ++i) {
    const base::Axis axis = base::all_axes[i];
    limits.velocity[i] = limits.acceleration[i] = limits.jerk[i] = unlimited;
    if (!machine.has(axis)) continue;
    limits.velocity[i] = machine.limits(axis).velocity;
    limits.acceleration[i] = machine.limits(axis).acceleration;
    limits.jerk[i] = machine.limits(axis).jerk;
  }
  return limits;
}

double margin_of(const Leg& leg) {
  return margin_about(leg, corridor_share);
}

/// A part of a leg in the corridor, and how much of the leg's own length that is.
struct LegPart {
  CorridorLeg<3> leg;
  double length = 0;
  bool is_exact = true;  ///< else a chord, which meets the leg at its ends only
};

/// As a corridor: a line, an arc in a plane in parts of at most half a turn, anything else by chords.
std::vector<LegPart> corridor_of(const Leg& leg) {
  const geometry::Curve& curve = leg.curve;
  const double length = geometry::length(curve);
  const auto at = [&](double s) { return place_of(geometry::evaluate(curve, s)); };
  std::vector<LegPart> legs;
  if (is_line(curve)) return {{line_leg<3>(at(0), at(length), margin_of(leg), leg.feed), length}};
  const auto* const arc = std::get_if<geometry::Arc>(&curve);
  // About a center nearer than that the nearest place of an arc says little of where motion is on it.
  constexpr double far_from_center = 4;  // margins
  if (arc && arc->first() < 3 && arc->second() < 3 && geometry::moving(curve).size() == 2 &&
      arc->radius() > far_from_center * margin_of(leg)) {
    const geometry::Arc::Turn turn = arc->turn();
    Vector<3> center = at(0);
    center[arc->first()] = turn.center_first;
    center[arc->second()] = turn.center_second;
    const double sweep = arc->angle_rate() * length,
                 parts = std::ceil(std::abs(sweep) / (std::numbers::pi * (1 + 1e-9)));
    for (double k = 0; k < parts; ++k) {
      legs.push_back({arc_leg<3>(at(length * k / parts), at(length * (k + 1) / parts), arc->first(), arc->second(),
                                 center, sweep / parts, margin_of(leg) + sagitta(leg), leg.feed),
                      length / parts});
    }
    return legs;
  }
  for (double s = 0; s < length;) {
    const double next = chord_end(curve, s, length, sagitta(leg), leg.space);
    legs.push_back({line_leg<3>(at(s), at(next), margin_of(leg), leg.feed), next - s, false});
    s = next;
  }
  return legs;
}

}  // namespace

RacingLine::RacingLine(const machine::Machine& machine)
    : limits_(limits_of(machine)), least_{unlimited, unlimited, unlimited} {
  for (std::size_t i = 0; i < 3; ++i) {
    least_.velocity = std::min(least_.velocity, limits_.velocity[i]);
    least_.acceleration = std::min(least_.acceleration, limits_.acceleration[i]);
    least_.jerk = std::min(least_.jerk, limits_.jerk[i]);
  }
}

bool RacingLine::takes(const Leg& leg) {
  if (leg.feed_axes != FeedAxes::none || leg.allowance.tolerance < finest_tolerance || !may_be_fitted(leg))
    return false;
  for (const base::Axis axis : base::all_axes) {
    if (base::index(axis) >= 3 && geometry::moving(leg.curve).contains(axis)) return false;
  }
  return true;
}

void RacingLine::push(Leg leg) {
  if (std::optional<Leg> reduced = reduction_.push(std::move(leg))) take(std::move(*reduced));
}

void RacingLine::finish() {
  if (std::optional<Leg> reduced = reduction_.finish()) take(std::move(*reduced));
  advance(true);
}

std::optional<Piece> RacingLine::pop() {
  if (done_.empty()) return std::nullopt;
  std::optional<Piece> piece(std::move(done_.front()));
  done_.pop_front();
  return piece;
}

void RacingLine::take(Leg leg) {
  others_ = geometry::start(leg.curve);
  if (borders_.empty()) borders_.push_back(0);
  const std::vector<LegPart> parts = corridor_of(leg);
  const double most = speed_along(parts.front().leg);
  for (EventMark& mark : leg.events) events_.push_back({borders_.back() + mark.s, std::move(mark.event)});
  leg.events.clear();
  sources_.push_back({borders_.back(), std::make_shared<const Leg>(std::move(leg))});
  for (const LegPart& part : parts) {
    if (merge(part.leg, part.length, most)) continue;
    append(part.leg, part.length);
    is_exact_.back() = part.is_exact;
  }
  advance(false);
}

void RacingLine::append(const CorridorLeg<3>& leg, double length) {
  merged_.clear();
  merged_margin_ = leg.margin;
  legs_.push_back(leg);
  is_exact_.push_back(true);
  borders_.push_back(borders_.back() + length);
  fastest_ = std::max(fastest_, speed_along(leg));
  // Of the leg before it is known now.
  const std::size_t last = legs_.size() - 1;
  if (last > 0) clock_[last - 1] = (last > 1 ? clock_[last - 2] : clock_begin_) + seconds_along(last - 1);
  clock_.push_back(0);
}

/// Lines that are passed within an interval and lie nearly in one become one.
bool RacingLine::merge(const CorridorLeg<3>& line, double length, double speed) {
  constexpr std::size_t most_merged = 64;
  if (legs_.size() < (is_moving_ ? 2U : 1U) || line.is_arc || merged_.size() >= most_merged) return false;
  const CorridorLeg<3>& last = legs_.back();
  if (last.is_arc) return false;
  const double margin = std::min(merged_margin_, line.margin), allowed = merged_share * margin;
  const double interval = interval_of_corner * numeric::cbrt(margin / least_.jerk);
  if (std::max(last.length, line.length) > speed * interval) return false;
  CorridorLeg<3> one = line_leg<3>(last.from, line.to, margin, std::min(last.feed, line.feed));
  double farthest = 0, off = size(one.nearest(line.from).offset);
  for (const Place& place : merged_) {
    off = std::max(off, size(one.nearest(place).offset));
    const double advanced = one.advance(place);
    if (advanced < farthest) return false;
    farthest = advanced;
  }
  if (!(one.length > last.length) || off > allowed || one.advance(line.from) < farthest) return false;
  merged_margin_ = std::min(merged_margin_, line.margin);
  one.margin = merged_margin_ - off;
  merged_.push_back(line.from);
  legs_.back() = one;
  is_exact_.back() = false;
  borders_.back() += length;
  return true;
}

/// As fast as feed and the machine allow, mm/s.
double RacingLine::speed_along(const CorridorLeg<3>& leg) const {
  double speed = std::min(leg.feed, least_.velocity);
  if (leg.is_arc) {
    speed = std::min({speed, nearly_all * std::sqrt(least_.acceleration * leg.radius),
                      nearly_all * numeric::cbrt(least_.jerk * leg.radius * leg.radius)});
  }
  return speed;
}

/// What it takes to come to that speed from rest and to go across the corridor, mm: farther away a corner has no influence.
double RacingLine::reach_of(const CorridorLeg<3>& leg) const {
  const double speed = speed_along(leg);
  const double seconds =
      std::max(speed / least_.acceleration + least_.acceleration / least_.jerk, 2 * std::sqrt(speed / least_.jerk));
  return std::max(speed * seconds, reach_in_margins * leg.margin);
}

/// So long that its middle stays what it is, where it is what was programmed: beside a chord motion would begin anew.
bool RacingLine::is_long(std::size_t leg) const {
  if (!is_exact_[leg]) return false;
  const double begun = leg == 0 && is_moving_ ? begin_ : 0;
  return legs_[leg].length - begun > reaches_of_long * reach_of(legs_[leg]);
}

double RacingLine::speed_at(std::size_t joint) const {
  const CorridorLeg<3>&before = legs_[joint], &behind = legs_[joint + 1];
  const double turn = size(between(before.tangent(before.length), behind.tangent(0)));
  const double margin = std::min(before.margin, behind.margin);
  const double interval = interval_of_corner * numeric::cbrt(margin / least_.jerk);
  return std::min({speed_along(before), speed_along(behind), start_step * margin / (std::max(turn, 1e-9) * interval)});
}

/// From so far that it is fast before. Then motion rests there: a path that passes as near to a cusp as the corridor asks
/// is travelled more slowly than with a stop.
bool RacingLine::turns_back(std::size_t joint) const {
  const CorridorLeg<3>&before = legs_[joint], &behind = legs_[joint + 1];
  if (std::min(before.length, behind.length) < far_back * reach_of(before)) return false;
  return size(along(before.tangent(before.length), 1, behind.tangent(0))) < least_angle_back;
}

/// About, s.
double RacingLine::seconds_along(std::size_t leg) const {
  const double length = legs_[leg].length, a = start_acceleration * least_.acceleration;
  const double from = leg > 0 ? speed_at(leg - 1) : 0, to = leg + 1 < legs_.size() ? speed_at(leg) : 0;
  return std::max(length / speed_along(legs_[leg]), length / std::max((from + to) / 2, 0.5 * std::sqrt(a * length)));
}

/// To rest from the greatest speed so far, s.
double RacingLine::stop_time() const {
  return fastest_ / least_.acceleration + least_.acceleration / least_.jerk;
}

std::optional<RacingLine::Window> RacingLine::choose(bool all) const {
  const std::size_t last = legs_.size() - 1;
  for (std::size_t joint = 0; joint < last; ++joint) {
    if (turns_back(joint)) return Window{joint + 1, CorridorEnd::rest, legs_[joint].length, false};
  }
  if (last > 0 && is_long(last)) return Window{last + 1, CorridorEnd::moving, reach_of(legs_[last]), false};
  if (all) return Window{last + 1, CorridorEnd::rest, legs_[last].length, false};
  // The last leg may still grow.
  if (last == 0 || (rest_ && last <= rest_->count)) return std::nullopt;
  const double done = is_moving_ ? begin_ / legs_[0].length * (clock_[0] - clock_begin_) : 0;
  const bool is_enough = clock_[last - 1] - clock_begin_ - done > (stops_ahead + stops_planned) * stop_time();
  if (!is_enough && last < most_legs) return std::nullopt;
  return Window{last, CorridorEnd::rest, legs_[last - 1].length, true};
}

/// Control points of a motion along the leg whose knot is there; the middle one is nearest.
std::array<Vector<3>, 3> RacingLine::points_at(const CorridorLeg<3>& leg, double s, double interval) const {
  const double step = speed_along(leg) * interval;
  const Place here = leg.at(s), tangent = leg.tangent(s);
  Place bend{};
  if (leg.is_arc) {
    bend = between(here, leg.center);
    for (std::size_t i = 0; i < 3; ++i)
      bend[i] = i == leg.first || i == leg.second ? bend[i] * step * step / (leg.radius * leg.radius) : 0;
  }
  const Place middle = along(here, -1.0 / 6, bend);
  return {along(along(middle, -step, tangent), 0.5, bend), middle, along(along(middle, step, tangent), 0.5, bend)};
}

std::optional<RacingLine::Plan> RacingLine::plan(const Window& window) {
  Corridor<3> corridor;
  corridor.legs.assign(legs_.begin(), legs_.begin() + static_cast<std::ptrdiff_t>(window.count));
  corridor.limits = limits_;
  corridor.begin = is_moving_ ? CorridorEnd::moving : CorridorEnd::rest;
  corridor.end = window.end;
  const bool goes_on = is_moving_ || window.end == CorridorEnd::moving;
  // Where motion goes on, its interval should come out as the one that its control points there were made for: those on legs
  // are made for the one that came out; those of an earlier plan are what they are.
  const bool is_on_legs = !is_moving_ || begins_on_leg_;
  double wanted = is_on_legs ? suitable_interval(corridor) : given_interval_, begun_with = wanted / interval_ratio_;
  // At a low feed, behind a plan that was made for a high one, from rest instead.
  if (!is_on_legs && seconds_by_feed(corridor) > most_intervals_of_window * wanted) return std::nullopt;
  std::optional<Plan> found;
  for (int k = 0; k < (goes_on && is_on_legs ? most_intervals_on_legs : most_intervals); ++k) {
    CorridorEnds<3> ends{is_moving_ ? begin_ : 0, window.finish, given_, {}};
    if (is_moving_ && begins_on_leg_) ends.points_at_begin = points_at(corridor.legs.front(), begin_, wanted);
    if (window.end == CorridorEnd::moving) ends.points_at_end = points_at(corridor.legs.back(), window.finish, wanted);
    std::optional<TimeSpline<3>> motion = plan_in(corridor, ends, begun_with);
    if (!motion) break;
    const double off = motion->interval / wanted;
    found = Plan{std::move(*motion), window.count};
    if (!goes_on) {
      if (off < coarse_interval) break;
    } else if (std::abs(off - 1) < (is_on_legs ? allowed_interval_on_legs : allowed_interval)) {
      break;
    }
    if (goes_on && is_on_legs) {
      wanted *= off;
    } else {
      interval_ratio_ = std::clamp(interval_ratio_ * off, 0.25, 4.0);
      begun_with = wanted / interval_ratio_;
    }
  }
  // Where motion goes on, its speed there and with it the time is only about right: as right as its interval.
  const double allowed = 1 + (!goes_on ? 0 : is_on_legs ? allowed_interval_on_legs : allowed_interval);
  const double stopping = time_with_stops(corridor, is_moving_ ? begin_ : 0, window.finish);
  if (found && found->motion.seconds() > allowed * stopping) return std::nullopt;
  return found;
}

/// One move alone stays what it is, up to where it turns back or ends.
bool RacingLine::stays(const Window& window) const {
  if (window.is_provisional || rest_ || window.end != CorridorEnd::rest || (is_moving_ && !begins_on_leg_))
    return false;
  return sources_.size() == 1 || sources_[1].u >= borders_[window.count];
}

/// Plans as far as enough is known, or to the end.
void RacingLine::advance(bool all) {
  while (!legs_.empty()) {
    if (emit_long_start()) continue;
    const std::optional<Window> window = choose(all);
    if (!window) return;
    if (stays(*window)) {
      const double per_length = (borders_[1] - borders_[0]) / legs_[0].length;
      emit_exact(borders_[0] + (is_moving_ ? begin_ : 0) * per_length, borders_[window->count]);
      is_moving_ = false;
      drop_before(window->count);
      continue;
    }
    if (std::optional<Plan> found = plan(*window)) {
      accept(std::move(*found), *window);
    } else {
      retreat(*window);
    }
  }
}

void RacingLine::accept(Plan plan, const Window& window) {
  const std::size_t intervals = plan.motion.intervals();
  given_interval_ = plan.motion.interval;
  if (!window.is_provisional) {
    emit(plan, 0, intervals);
    rest_.reset();
    drop_before(window.end == CorridorEnd::rest ? window.count : window.count - 1);
    is_moving_ = window.end == CorridorEnd::moving;
    begin_ = window.finish;
    begins_on_leg_ = true;
    std::copy_n(plan.motion.points.end() - 3, 3, given_.begin());
    return;
  }
  // The next begins where a stop at the end of this one has no influence, as far from joints as may be.
  const double ahead = stops_ahead * stop_time() / plan.motion.interval;
  const double n = static_cast<double>(intervals), last = std::max(n - ahead, n / 3), first = std::max(0.7 * last, 6.0);
  std::size_t knot = static_cast<std::size_t>(std::max(last, 6.0));
  double farthest = 0;
  for (double k = std::ceil(first); k <= last; ++k) {
    double apart = n;
    for (const double pass : plan.motion.passes) apart = std::min(apart, std::abs(k - pass));
    if (apart > farthest) farthest = apart, knot = static_cast<std::size_t>(k);
  }
  emit(plan, 0, knot);
  const auto passed = static_cast<std::size_t>(
      std::lower_bound(plan.motion.passes.begin(), plan.motion.passes.end(), static_cast<double>(knot)) -
      plan.motion.passes.begin());
  std::copy_n(plan.motion.points.begin() + static_cast<std::ptrdiff_t>(knot), 3, given_.begin());
  TimeSpline<3>& motion = plan.motion;
  motion.points.erase(motion.points.begin(), motion.points.begin() + static_cast<std::ptrdiff_t>(knot));
  motion.passes.erase(motion.passes.begin(), motion.passes.begin() + static_cast<std::ptrdiff_t>(passed));
  for (double& pass : motion.passes) pass -= static_cast<double>(knot);
  plan.count -= passed;
  drop_before(passed);
  is_moving_ = true;
  begin_ = legs_[0].advance(given_[1]);
  begins_on_leg_ = false;
  rest_ = std::move(plan);
}

/// No motion was found: what was planned before ends at rest, or legs stay what they are, with stops.
void RacingLine::retreat(const Window& window) {
  if (rest_) {
    const Plan plan = std::move(*rest_);
    rest_.reset();
    emit(plan, 0, plan.motion.intervals());
    drop_before(plan.count);
  } else {
    const double begun = is_moving_ ? begin_ / legs_[0].length : 0;
    // A window that ends in motion leaves the leg to the next.
    std::size_t count = is_moving_ ? 1 : window.end == CorridorEnd::moving ? window.count - 1 : window.count;
    const std::vector<bool> ends = block_ends();
    while (count < legs_.size() && !ends[count - 1]) ++count;  // not within a curve
    emit_exact(borders_[0] + begun * (borders_[1] - borders_[0]), borders_[count]);
    drop_before(count);
  }
  is_moving_ = false;
}

void RacingLine::drop_before(std::size_t leg) {
  const auto count = static_cast<std::ptrdiff_t>(leg);
  if (leg > 0) clock_begin_ = clock_[leg - 1];
  clock_.erase(clock_.begin(), clock_.begin() + count);
  legs_.erase(legs_.begin(), legs_.begin() + count);
  is_exact_.erase(is_exact_.begin(), is_exact_.begin() + count);
  borders_.erase(borders_.begin(), borders_.begin() + count);
  while (sources_.size() > 1 && sources_[1].u <= borders_.front()) sources_.pop_front();
}

}  // namespace leadscrew::toolpath
