// What a racing line's motions are as pieces of the path.

#include <cmath>
#include <leadscrew/toolpath/corridor_start.hpp>
#include <leadscrew/toolpath/event_marks.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/knot_removal.hpp>
#include <leadscrew/toolpath/racing_line.hpp>
#include <leadscrew/toolpath/stretch.hpp>
#include <leadscrew/toolpath/tuning.hpp>
#include <utility>

namespace leadscrew::toolpath {

namespace {

using geometry::Point;

/// A curve of the path from one time to another, in intervals.
struct Timed {
  geometry::Curve curve;
  double from = 0, to = 0;
  int cubed = 0;  ///< a line from rest (1) or to rest (−1): s grows with the cube of time

  double length_at(double time) const {
    const double share = (time - from) / (to - from), length = geometry::length(curve);
    if (time <= from) return 0;
    if (time >= to) return length;
    if (cubed > 0) return share * share * share * length;
    if (cubed < 0) return (1 - (1 - share) * (1 - share) * (1 - share)) * length;
    const auto* const nurbs = std::get_if<geometry::Nurbs>(&curve);
    return nurbs ? toolpath::length_at(*nurbs, time) : share * length;
  }
};

/// What applies from a time on.
struct Mark {
  double time = 0;
  double feed = 0;
  base::Line line{};
};

}  // namespace

/// The knot span at which the motion stands for u.
double RacingLine::time_at(const Plan& plan, double u) const {
  std::size_t leg = 0;
  while (leg + 1 < plan.count && borders_[leg + 1] <= u) ++leg;
  const std::vector<double>& passes = plan.motion.passes;
  double low = leg > 0 ? passes[leg - 1] : 0;
  double high = leg < passes.size() ? passes[leg] : static_cast<double>(plan.motion.intervals());
  if (u <= borders_[leg]) return low;
  const double s = (u - borders_[leg]) / (borders_[leg + 1] - borders_[leg]) * legs_[leg].length;
  constexpr int halvings = 30;
  for (int k = 0; k < halvings; ++k) {
    const double middle = (low + high) / 2;
    (legs_[leg].advance(plan.motion.at(middle)) < s ? low : high) = middle;
  }
  return high;
}

namespace {

Point point_of(const Vector<3>& place, Point others) {
  for (std::size_t i = 0; i < 3; ++i) others[i] = place[i];
  return others;
}

std::optional<Timed> straight_part(const Point& from, const Point& to, double begin, double end, int cubed) {
  const double length = line_length(from, to);
  if (!(length > 0)) return std::nullopt;
  return Timed{geometry::Line(from, to, length), begin, end, cubed};
}

void add_spline(const TimeSpline<3>& motion, std::size_t first, std::size_t last, const Nearness& near,
                const Point& others, std::vector<Timed>& curves) {
  const SparseSpline sparse = without_needless_knots(motion, first, last, near);
  geometry::NurbsForm form;
  form.degree = 3;
  for (const Vector<3>& place : sparse.points) form.points.push_back(point_of(place, others));
  form.weights.assign(form.points.size(), 1.0);
  form.knots = {sparse.knots.front() - 2, sparse.knots.front() - 1};
  form.knots.insert(form.knots.end(), sparse.knots.begin(), sparse.knots.end());
  form.knots.insert(form.knots.end(), {sparse.knots.back() + 1, sparse.knots.back() + 2});
  for (geometry::Nurbs& piece : fitted_pieces(form)) {
    const double begin = piece.first_parameter(), end = piece.last_parameter();
    curves.push_back({std::move(piece), begin, end});
  }
}

/// The motion between two knots; next to rest its first and last interval are straight.
std::vector<Timed> curves_of(const TimeSpline<3>& motion, std::size_t from, std::size_t to, bool from_rest,
                             bool to_rest, const Nearness& near, const Point& others) {
  const std::size_t first = from + (from_rest ? 1 : 0), last = to - (to_rest ? 1 : 0);
  const auto at = [](std::size_t knot) { return static_cast<double>(knot); };
  std::vector<Timed> curves;
  if (last > first) add_spline(motion, first, last, near, others, curves);
  if (curves.empty()) return curves;
  if (from_rest) {
    const Point rest = point_of(motion.points[from], others);
    if (auto line = straight_part(rest, geometry::start(curves.front().curve), at(from), at(first), 1))
      curves.insert(curves.begin(), std::move(*line));
  }
  if (to_rest) {
    const Point rest = point_of(motion.points[to + 2], others);
    if (auto line = straight_part(geometry::end(curves.back().curve), rest, at(last), at(to), -1))
      curves.push_back(std::move(*line));
  }
  return curves;
}

/// Feeds that follow each other sooner than speed can change are held at the least of them.
std::vector<Mark> held(const std::vector<Mark>& marks, double end, double least) {
  std::vector<Mark> feeds;
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const double until = i + 1 < marks.size() ? marks[i + 1].time : end;
    if (!feeds.empty() && marks[i].feed == feeds.back().feed) continue;
    if (!feeds.empty() && (marks[i].time - feeds.back().time < least || until - marks[i].time < least)) {
      if (marks[i].feed < feeds.back().feed) feeds.back().feed = marks[i].feed;
      continue;
    }
    feeds.push_back(marks[i]);
  }
  return feeds;
}

}  // namespace

/// Of the legs at hand: is the end of each that of a block, or of a chord within a curve?
std::vector<bool> RacingLine::block_ends() const {
  std::vector<bool> ends;
  auto source = sources_.begin();
  for (std::size_t leg = 0; leg < legs_.size(); ++leg) {
    while (source != sources_.end() && source->u < borders_[leg + 1]) ++source;
    ends.push_back(source == sources_.end() ? leg + 1 == legs_.size() : source->u == borders_[leg + 1]);
  }
  return ends;
}

Nearness RacingLine::nearness_of(const Plan& plan) const {
  using namespace tuning::knot_removal;
  Nearness near{unlimited, {}, 1};
  if (stop_time() > many_to_stop * plan.motion.interval) near.longest_span = most_in_one;
  for (std::size_t leg = 0; leg < plan.count; ++leg)
    near.tolerance = std::min(near.tolerance, tolerance_share * legs_[leg].margin);
  const double h = plan.motion.interval;
  for (std::size_t i = 0; i < 3; ++i) near.jerk_step[i] = jerk_share * limits_.jerk[i] * h * h * h;
  return near;
}

void RacingLine::emit(const Plan& plan, std::size_t from, std::size_t to) {
  const double begin = static_cast<double>(from), end = static_cast<double>(to);
  const bool is_end = to == plan.motion.intervals();
  const bool to_rest = is_end && plan.motion.points[to] == plan.motion.points[to + 2];
  const bool from_rest = !is_moving_ && from == 0;
  const std::vector<Timed> curves = curves_of(plan.motion, from, to, from_rest, to_rest, nearness_of(plan), others_);
  std::vector<Mark> marks;
  std::vector<std::pair<double, base::Event>> events;
  for (const Source& source : sources_) {
    const auto mark = [&](double s, base::Line line) {
      const double u = source.u + s;
      if (u >= borders_[plan.count]) return;
      const double time = u <= borders_[0] ? begin : time_at(plan, u);
      if (time <= begin) marks.clear();
      marks.push_back({std::max(time, begin), source.leg->feed, line});
    };
    mark(0, source.leg->line);
    for (const LineMark& line : source.leg->lines) mark(line.s, line.line);
  }
  for (; !events_.empty(); events_.pop_front()) {
    const UpcomingEvent& next = events_.front();
    if (next.u > borders_[plan.count] || (next.u == borders_[plan.count] && !to_rest)) break;
    const double time = next.u <= borders_[0] ? begin : time_at(plan, next.u);
    if (time >= end && !to_rest) break;
    events.emplace_back(std::clamp(time, begin, end), next.event);
  }
  while (!marks.empty() && marks.back().time >= end) marks.pop_back();
  const std::vector<Mark> feeds = held(marks, end, tuning::run::least_hold / plan.motion.interval);
  std::size_t feed = 0, mark = 0, event = 0;
  for (const Timed& curve : curves) {
    for (double time = curve.from; time < curve.to;) {
      while (feed + 1 < feeds.size() && feeds[feed + 1].time <= time) ++feed;
      double until = feed + 1 < feeds.size() ? std::min(feeds[feed + 1].time, curve.to) : curve.to;
      const double length = geometry::length(curve.curve), s = curve.length_at(time);
      double next = curve.length_at(until);
      if (length - next < 1e-9 * length) until = curve.to, next = length;
      if (next - s < 1e-9 * length && until < curve.to) {
        ++feed;
        continue;
      }
      while (mark + 1 < marks.size() && marks[mark + 1].time <= time) ++mark;
      Piece piece{s > 0 || next < length ? geometry::part(curve.curve, s, next) : curve.curve, feeds[feed].feed,
                  marks[mark].line};
      piece.is_of_least_time = true;
      std::vector<LineMark> lines;
      for (std::size_t k = mark + 1; k < marks.size() && marks[k].time < until; ++k) {
        if (marks[k].line == (lines.empty() ? piece.line : lines.back().line)) continue;
        lines.push_back({std::clamp(curve.length_at(marks[k].time) - s, 0.0, next - s), marks[k].line});
      }
      if (!lines.empty()) piece.lines = std::make_shared<const std::vector<LineMark>>(std::move(lines));
      std::vector<EventMark> passed;
      for (; event < events.size() && (events[event].first < until || (until >= end && to_rest)); ++event)
        passed.push_back({std::clamp(curve.length_at(events[event].first) - s, 0.0, next - s), events[event].second});
      set_events(piece, std::move(passed));
      give(std::move(piece));
      time = until;
    }
  }
}

void RacingLine::emit_exact(double from, double to) {
  for (const Source& source : sources_) {
    const double length = geometry::length(source.leg->curve);
    const double begin = std::max(from - source.u, 0.0), end = std::min(to - source.u, length);
    if (!(end > begin)) continue;
    Piece piece{source.leg->curve, source.leg->feed, source.leg->line, false, nullptr, source.leg->feed_axes};
    if (!source.leg->lines.empty()) piece.lines = std::make_shared<const std::vector<LineMark>>(source.leg->lines);
    std::vector<EventMark> passed;
    for (; !events_.empty() && events_.front().u <= source.u + end; events_.pop_front())
      passed.push_back({std::clamp(events_.front().u - source.u, begin, end), events_.front().event});
    set_events(piece, std::move(passed));
    constexpr double rounding = 1e-12;
    if (begin > rounding * length || end < (1 - rounding) * length) trim(piece, begin, end);
    give(std::move(piece));
  }
}

/// Up to where the corner at its end has an influence, a long leg is what it is.
bool RacingLine::emit_long_start() {
  if (rest_ || !is_long(0)) return false;
  const double length = legs_[0].length, until = length - reach_of(legs_[0]);
  const double per_length = (borders_[1] - borders_[0]) / length;
  emit_exact(borders_[0] + (is_moving_ ? begin_ : 0) * per_length, borders_[0] + until * per_length);
  is_moving_ = true;
  begin_ = until;
  const Corridor<3> one{{legs_[0]}, limits_};
  given_interval_ = suitable_interval(one);
  given_ = points_at(legs_[0], until, given_interval_);
  begins_on_leg_ = true;
  return true;
}

void RacingLine::give(Piece piece) {
  piece.curve = simplest(piece.curve);
  carry_events(piece, carried_);
  done_.push_back(std::move(piece));
}

}  // namespace leadscrew::toolpath
