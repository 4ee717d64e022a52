#include <algorithm>
#include <cmath>
#include <leadscrew/toolpath/event_marks.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/run.hpp>
#include <leadscrew/toolpath/tolerance_space.hpp>
#include <leadscrew/toolpath/tuning.hpp>
#include <utility>

namespace leadscrew::toolpath {

using geometry::Curve;
using geometry::Point;

namespace {

using namespace tuning::run;

constexpr double rounding = 1e-9;

Point position(const Curve& curve, double s, const ToleranceSpace& space) {
  return space.to_millimetres(geometry::evaluate(curve, s));
}

/// What a curve says of itself at s: position and three derivatives by mm; at a cusp, where it has none, the position.
State state_at(const Curve& curve, double s, bool backwards, const ToleranceSpace& space) {
  const geometry::PointJet jet = geometry::jets(curve, std::clamp(s, 0.0, geometry::length(curve)));
  const double per_mm = (backwards ? -1 : 1) / millimetres_per_length(curve, space);
  State state;
  state.count = 4;
  state.derivative[0] = position(curve, s, space);
  state.derivative[1] = space.derivative(jet, &numeric::Jet<>::first);
  state.derivative[2] = space.derivative(jet, &numeric::Jet<>::second);
  state.derivative[3] = space.derivative(jet, &numeric::Jet<>::third);
  double scale = 1;
  for (std::size_t r = 1; r < state.count; ++r) {
    scale *= per_mm;
    for (double& x : state.derivative[r]) x *= scale;
  }
  const auto is_number = [](double x) { return std::isfinite(x); };
  for (std::size_t r = state.count; r-- > 1;) {
    if (!std::all_of(state.derivative[r].begin(), state.derivative[r].end(), is_number)) state.count = 1;
  }
  return state;
}

}  // namespace

Run::Run(const Leg& leg, double from, bool pinned, bool corner_before, const geometry::MapTolerance& tables)
    : tables_(tables),
      space_(leg.space),
      axes_(axes_of(leg)),
      allowance_(leg.allowance),
      start_(geometry::evaluate(leg.curve, from)),
      corner_before_(corner_before),
      spline_(spline_from(leg, from, pinned)) {}

TubeSpline Run::spline_from(const Leg& leg, double from, bool pinned) {
  State state = state_at(leg.curve, from, false, leg.space);
  if (!pinned) state.count = 1;
  const Vertex vertex{state.derivative[0], 0, margin_about(leg), 0, leg.allowance.tolerance, margin_of_words(leg)};
  return {state, vertex, longest_smoothing * span_length(leg)};
}

void Run::extend(const Leg& leg, double from, double to) {
  const double rate = millimetres_per_length(leg.curve, space_);
  const double first = u_, speed = greatest_speed(leg);
  base::Line line = leg.line;
  for (const LineMark& mark : leg.lines) {
    if (mark.s <= from) line = mark.line;
  }
  marks_.push_back({first, leg.feed, speed, line});
  for (const LineMark& mark : leg.lines) {
    if (mark.s > from && mark.s < to) marks_.push_back({first + (mark.s - from) * rate, leg.feed, speed, mark.line});
  }
  const PathPart part{from, to, geometry::length(leg.curve)};
  for (const EventMark& mark : leg.events) {
    if (part.has(mark.s)) events_.push_back({first + (mark.s - from) * rate, mark.event});
  }
  const double margin = margin_about(leg), off = sagitta(leg);
  spent_ = std::max(spent_, spent_by(leg));
  if (std::exchange(allowance_, leg.allowance) != leg.allowance) spline_.lengthen(longest_smoothing * span_length(leg));
  for (double s = from; s < to;) {
    s = is_line(leg.curve) ? to : chord_end(leg.curve, s, to, off, space_);
    spline_.append({position(leg.curve, s, space_), first + (s - from) * rate, margin, 1 / speed,
                    leg.allowance.tolerance, margin_of_words(leg)});
  }
  u_ = first + (to - from) * rate;
  settle();
}

void Run::end(const Leg& leg, double to, bool pinned) {
  State state = state_at(leg.curve, to, true, space_);
  if (!pinned) state.count = 1;
  end_ = last_point_ = geometry::evaluate(leg.curve, to);
  last_ = state;
  spline_.close(state);
  settle();
}

void Run::settle() {
  while (spline_.knows_enough()) {
    const std::vector<Vertex> around = spline_.vertices();
    const double from = spline_.settled();
    switch (spline_.settle()) {
      case TubeSpline::Outcome::wants_more:
        return;
      case TubeSpline::Outcome::settled:
        add_spline(around, from, false);
        break;
      case TubeSpline::Outcome::ended:
        add_spline(around, from, true);
        if (!begin_rest(true)) return;
        break;
      case TubeSpline::Outcome::failed:
        if (!retreat()) return;
        break;
    }
  }
}

/// The run goes on behind the spline, if it does.
bool Run::begin_rest(bool corner) {
  const std::vector<Vertex> vertices = std::exchange(rest_, {});
  if (vertices.empty() || (vertices.size() == 1 && last_)) return false;
  State state;
  state.derivative[0] = vertices.front().position;
  spline_ = TubeSpline(state, vertices.front(), spline_.longest());
  for (std::size_t i = 1; i < vertices.size(); ++i) spline_.append(vertices[i]);
  start_ = space_.from_millimetres(vertices.front().position);
  is_first_ = true;
  corner_before_ = corner;
  if (last_) {
    spline_.close(*last_);
    end_ = last_point_;
  }
  return true;
}

/// No spline was found: it is to end at the sharpest vertex near by, with a corner there; where there is none, where it
/// was farthest outside. Where that is the next vertex, a straight line leads there: it stays inside the tube wherever
/// in it the curve has come to, and the motion stops at its ends. False if the run ends there.
bool Run::retreat() {
  const std::vector<Vertex> vertices = spline_.vertices();
  const double settled = spline_.settled();
  std::size_t next = 1;
  while (next + 1 < vertices.size() && vertices[next].u <= settled) ++next;
  const Vertex& worst = vertices[spline_.worst()];
  std::size_t end = next;
  double sharpest = least_corner;
  for (std::size_t i = next; i + 1 < vertices.size(); ++i) {
    if (std::abs(vertices[i].u - worst.u) > split_window * worst.tolerance) continue;
    const double turn = turn_between(difference(vertices[i].position, vertices[i - 1].position),
                                     difference(vertices[i + 1].position, vertices[i].position));
    if (turn > sharpest) {
      sharpest = turn;
      end = i;
    }
  }
  if (sharpest <= least_corner && spline_.worst() + 1 < vertices.size()) end = std::max(end, spline_.worst());
  const bool splits = sharpest > least_corner || end > next;
  const bool is_last = last_ && end + 1 == vertices.size() && rest_.empty();
  rest_.insert(rest_.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(end),
               rest_.empty() ? vertices.end() : vertices.end() - 1);
  if (splits) {
    State state;
    state.derivative[0] = vertices[end].position;
    spline_.retreat_to(end);
    spline_.close(state);
    end_ = space_.from_millimetres(vertices[end].position);
    return true;
  }
  const Point here = is_first_ ? start_ : space_.from_millimetres(spline_.position());
  const Point there = is_last ? last_point_ : space_.from_millimetres(vertices[end].position);
  if (std::optional<Piece> line = straight_piece(here, there, axes_, space_)) {
    std::deque<Mark>& marks = marks_;
    while (marks.size() > 1 && marks[1].u <= settled) marks.pop_front();
    const Mark& mark = marks.front();
    line->feed = mark.feed;
    line->line = mark.line;
    const double u = vertices[end].u, length = geometry::length(line->curve);
    std::vector<EventMark> events;
    for (const Passing& passing : events_before(u))
      events.push_back({length * std::clamp((passing.u - settled) / (u - settled), 0.0, 1.0), passing.event});
    set_events(*line, std::move(events));
    done_.push_back({.piece = std::move(*line),
                     .axes = axes_,
                     .corner_before = is_first_ && corner_before_,
                     .tolerance = vertices[end].tolerance,
                     .spent = spent_});
  }
  return begin_rest(false);
}

/// What has been settled of the spline, from `from` on, as pieces. `around`: the polyline there.
void Run::add_spline(const std::vector<Vertex>& around, double from, bool is_last) {
  const QuinticSpline& spline = spline_.stretch();
  geometry::NurbsForm form;
  form.degree = static_cast<int>(quintic_degree);
  form.knots = spline.knots;
  form.weights.assign(spline.points.size(), 1.0);
  for (const Point& point : spline.points) form.points.push_back(space_.from_millimetres(point));
  if (is_first_) form.points.front() = start_;
  if (is_last) form.points.back() = end_;

  std::deque<Mark>& marks = marks_;
  while (marks.size() > 1 && marks[1].u <= from) marks.pop_front();
  bool corner = is_first_ && corner_before_;
  is_first_ = false;
  for (const geometry::Nurbs& curve : fitted_pieces(form, tables_, space_)) {
    double u = curve.first_parameter();
    std::size_t mark = mark_at(u, 0);
    for (double begin = 0; begin < curve.length();) {
      Stretch stretch{.piece = {curve, 0, marks[mark].line, false, nullptr},
                      .axes = axes_,
                      .corner_before = std::exchange(corner, false),
                      .programmed = around,
                      .spent = spent_};
      const double end = fed_until(curve, begin, stretch.piece.feed, u);
      stretch.piece.feed_axes = to_be_named(axes_, curve.moving());
      stretch.piece.sagitta = spline_.sagitta();
      std::vector<LineMark> lines;
      while (mark + 1 < marks.size() && marks[mark + 1].u < u) {
        const double s = length_at(curve, marks[++mark].u);
        if (s > end - rounding * curve.length()) continue;
        if (s - begin <= rounding * curve.length())  // it begins here too
          stretch.piece.line = marks[mark].line;
        else
          lines.push_back({s - begin, marks[mark].line});
      }
      mark = mark_at(u, mark);
      if (!lines.empty()) stretch.piece.lines = std::make_shared<const std::vector<LineMark>>(std::move(lines));
      std::vector<EventMark> events;
      for (const Passing& passing : events_before(u))
        events.push_back({std::clamp(length_at(curve, passing.u) - begin, 0.0, end - begin), passing.event});
      set_events(stretch.piece, std::move(events));
      if (begin > 0 || end < curve.length()) stretch.piece.curve = curve.part(begin, end);
      done_.push_back(std::move(stretch));
      begin = end;
    }
  }
}

/// Takes the events before u.
std::vector<Run::Passing> Run::events_before(double u) {
  std::vector<Passing> passed;
  for (; !events_.empty() && events_.front().u < u; events_.pop_front()) passed.push_back(events_.front());
  return passed;
}

std::vector<base::Event> Run::events_left() const {
  std::vector<base::Event> events;
  for (const Passing& passing : events_) events.push_back(passing.event);
  return events;
}

std::size_t Run::mark_at(double u, std::size_t from) const {
  while (from + 1 < marks_.size() && marks_[from + 1].u <= u) ++from;
  return from;
}

/// From u, on the part of this mark. Where feed words follow each other sooner than speed can change, the least is held
/// for a while; one that holds for longer begins where it was programmed.
Run::Hold Run::hold_from(double u, std::size_t mark) const {
  double feed = marks_[mark].feed, speed = marks_[mark].speed;
  for (; mark + 1 < marks_.size(); ++mark) {
    const Mark& next = marks_[mark + 1];
    const bool is_least = marks_[mark].feed == feed;
    if (is_least && next.feed == feed) continue;
    const double least = std::min(speed, next.speed);
    if (next.u >= u + least_hold * least) break;
    feed = std::min(feed, next.feed);
    speed = least;
  }
  const double end = mark + 1 < marks_.size() ? marks_[mark + 1].u : u_;
  return {feed, marks_[mark].feed == feed ? end : std::clamp(u + least_hold * speed, marks_[mark].u, end)};
}

/// Of the curve, from a place on it that is u: how far it has one feed, and which. Moves u to there.
double Run::fed_until(const geometry::Nurbs& curve, double begin, double& feed, double& u) {
  const double tiny = rounding * curve.length(), last = curve.last_parameter();
  if (!(hold_.until > u)) hold_ = hold_from(u, mark_at(u, 0));
  feed = hold_.feed;
  while (hold_.until < last) {
    u = hold_.until;
    const double s = length_at(curve, u);
    if (s > curve.length() - tiny) break;
    hold_ = hold_from(u, mark_at(u, 0));
    if (s - begin <= tiny) feed = hold_.feed;  // it begins here too
    if (feed != hold_.feed) return s;
  }
  u = last;
  return curve.length();
}

}  // namespace leadscrew::toolpath
