#include <algorithm>
#include <cmath>
#include <leadscrew/toolpath/corner.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/smoother.hpp>
#include <leadscrew/toolpath/tolerance_space.hpp>
#include <utility>

namespace leadscrew::toolpath {

using geometry::Curve;
using geometry::Point;

namespace {

constexpr double kept_share = 0.98;   // of the tolerance; the rest is for the rounding of words and of samples
constexpr double arc_sagitta = 0.02;  // of the tolerance: chords that stand for an arc
constexpr double corner_turn = 1.3;   // |t⁺ − t⁻| = 2 sin(θ/2): 81°
constexpr double sharp_turn = 1.4;    // a corner even if the path goes on turning
constexpr double concentrated = 1.5;
constexpr double turn_window = 8;                                           // tolerances
constexpr double widest_window = 4;                                         // turn windows, where the leg is as long
constexpr double long_leg = 15, reach_into = 6;                             // lengths of a span
constexpr double longest_smoothing = 2;                                     // lengths of a span
constexpr double shortest_smoothing = 0.5;                                  // tolerances
constexpr double span_time = 0.005, shortest_span = 0.1, longest_span = 1;  // s, mm
constexpr double span_of_tolerance = 10, longest_of_tolerance = 3;          // mm
constexpr double least_cam_tolerance = 2e-4;                                // mm; below, lines are not fitted
constexpr double same_direction = 1e-9;
constexpr double least_corner = 0.2;  // |t⁺ − t⁻| of one that is made where no spline fits
constexpr double split_window = 32;   // tolerances: how far from there
constexpr double rounding = 1e-9;
constexpr double uncut_share = 0.9;  // of a curve that the blend at its end may take, if there was none at its start

/// Length of a span of the splines at this feed, mm.
double span_length(const Leg& leg, double tolerance) {
  const double by_feed = span_time * leg.feed * millimetres_per_length(leg.curve);
  return std::max(std::clamp(by_feed, shortest_span, longest_span),
                  std::min(span_of_tolerance * tolerance, longest_of_tolerance));
}

double length_of(const Leg& leg) {
  return geometry::length(leg.curve) * millimetres_per_length(leg.curve);
}

bool is_line(const Curve& curve) {
  return std::holds_alternative<geometry::Line>(curve);
}

Point position(const Curve& curve, double s) {
  return to_millimetres(geometry::evaluate(curve, s));
}

/// Does the second go on where the first ends with the same direction and curvature?
bool goes_on(const Curve& first, const Curve& second) {
  const geometry::PointJet a = geometry::jets(first, geometry::length(first)), b = geometry::jets(second, 0);
  const double ra = norm(derivative(a, &numeric::Jet::first)), rb = norm(derivative(b, &numeric::Jet::first));
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(a[i].first / ra - b[i].first / rb) > same_direction) return false;
    if (std::abs(a[i].second / (ra * ra) - b[i].second / (rb * rb)) > same_direction) return false;
  }
  return true;
}

/// What a curve says of itself at s: position and three derivatives by mm.
State state_at(const Curve& curve, double s, bool backwards) {
  const geometry::PointJet jet = geometry::jets(curve, std::clamp(s, 0.0, geometry::length(curve)));
  const double per_mm = (backwards ? -1 : 1) / millimetres_per_length(curve);
  State state;
  state.count = 4;
  state.derivative[0] = position(curve, s);
  state.derivative[1] = derivative(jet, &numeric::Jet::first);
  state.derivative[2] = derivative(jet, &numeric::Jet::second);
  state.derivative[3] = derivative(jet, &numeric::Jet::third);
  double scale = 1;
  for (std::size_t r = 1; r < state.count; ++r) {
    scale *= per_mm;
    for (double& x : state.derivative[r]) x *= scale;
  }
  return state;
}

/// |t⁺ − t⁻| at b.
double turn_between(const Point& a, const Point& b, const Point& c) {
  const Point in = difference(b, a), out = difference(c, b);
  const double in_length = norm(in), out_length = norm(out);
  Point apart;
  for (std::size_t i = 0; i < apart.size(); ++i) apart[i] = out[i] / out_length - in[i] / in_length;
  return norm(apart);
}

/// Where a chord from s ends that stays within `sagitta` of the curve, or nearly: at `to` at last.
double chord_end(const Curve& curve, double s, double to, double sagitta) {
  constexpr int most_halvings = 20;
  constexpr double fewest_chords = 4, nearly_all = 0.75;
  const auto longest_at = [&](double place) {
    const double bend = norm(derivative(geometry::jets(curve, place), &numeric::Jet::second));
    return std::sqrt(8 * sagitta / std::max(bend, 1e-12));
  };
  double step = std::min(longest_at(s), geometry::length(curve) / fewest_chords);
  // Looked at inside too: a bulge need not show at the ends.
  const auto is_too_long = [&] {
    if (geometry::borders(curve, s, std::min(s + step, to)) > 1) return true;
    for (const double share : {0.2, 0.4, 0.6, 0.8, 1.0}) {
      if (longest_at(std::min(s + share * step, to)) < nearly_all * step) return true;
    }
    return false;
  };
  for (int k = 0; k < most_halvings && is_too_long(); ++k) step /= 2;
  return s + step < to && s + step > s ? s + step : to;
}

/// Arc length at parameter u: false position, which soon finds it where u is nearly the length, and bisection.
double length_at(const geometry::Nurbs& curve, double u) {
  const double enough = 1e-10 * (curve.last_parameter() - curve.first_parameter());
  double low = 0, high = curve.length(), u_low = curve.first_parameter(), u_high = curve.last_parameter();
  for (int k = 0; k < 60; ++k) {
    const double share = k % 3 == 2 ? 0.5 : (u - u_low) / (u_high - u_low);
    const double s = low + std::clamp(share, 0.0, 1.0) * (high - low), here = curve.parameter(s);
    if (std::abs(here - u) <= enough) return s;
    (here < u ? low : high) = s;
    (here < u ? u_low : u_high) = here;
  }
  return low;
}

/// Leaves what lies between two path lengths.
void trim(Piece& piece, double from, double to) {
  if (from == 0 && to == geometry::length(piece.curve)) return;
  piece.curve = geometry::part(piece.curve, from, to);
  if (!piece.lines) return;
  std::vector<LineMark> lines;
  base::Line first = piece.line;
  for (const LineMark& mark : *piece.lines) {
    if (mark.s <= from) {
      first = mark.line;
    } else if (mark.s < to) {
      lines.push_back({mark.s - from, mark.line});
    }
  }
  piece.line = first;
  piece.lines = lines.empty() ? nullptr : std::make_shared<const std::vector<LineMark>>(std::move(lines));
}

}  // namespace

/// A run that is being fitted.
struct Smoother::Run {
  struct Mark {
    double u = 0;
    double feed = 0;
    base::Line line{};
  };

  TubeSpline spline;
  double u = 0;                 ///< as far as it is known
  std::deque<Mark> marks{};     ///< by u; the first holds where the next stretch begins
  Point start{}, end{};         ///< where the spline begins and is to end, in the axes' units
  double spent = 0;             ///< by any of its legs
  bool is_first = true;         ///< has nothing of the spline been settled?
  bool corner_before = false;   ///< of the spline
  std::optional<State> last{};  ///< at the end of the run, once that is known
  Point last_point{};           ///< likewise, in the axes' units
  std::vector<Vertex> rest{};   ///< from where the spline is to end, if that is not the end of the run
};

Smoother::Smoother(double tolerance, double cam_tolerance, FeedAxes axes)
    : tolerance_(tolerance),
      cam_tolerance_(cam_tolerance),
      axes_(axes),
      reduction_(std::min(tolerance, cam_tolerance)) {}
Smoother::~Smoother() = default;

void Smoother::push(Leg leg) {
  if (std::optional<Leg> reduced = reduction_.push(std::move(leg))) take(std::move(*reduced));
}

void Smoother::finish() {
  if (std::optional<Leg> reduced = reduction_.finish()) take(std::move(*reduced));
  classify(true);
  release();
}

std::optional<Piece> Smoother::pop() {
  if (done_.empty()) return std::nullopt;
  std::optional<Piece> piece(std::move(done_.front()));
  done_.pop_front();
  return piece;
}

void Smoother::take(Leg leg) {
  ends_.push_back(ends_.back() + length_of(leg));
  legs_.push_back(std::move(leg));
  classify(false);
}

/// Where the path is at u, mm; ends_.front() ≤ u ≤ ends_.back().
Point Smoother::place_at(double u) const {
  const auto behind = std::upper_bound(ends_.begin() + 1, ends_.end() - 1, u);
  const auto leg = static_cast<std::size_t>(behind - ends_.begin()) - 1;
  const Leg& at = legs_[leg];
  const double share = std::clamp((u - ends_[leg]) / (ends_[leg + 1] - ends_[leg]), 0.0, 1.0);
  return position(at.curve, share * geometry::length(at.curve));
}

/// |t⁺ − t⁻| at the end of leg `joint`, of the mean directions before and behind it.
double Smoother::turn_at(std::size_t joint, double window) const {
  const double u = ends_[joint + 1];
  const auto width = [&](std::size_t leg, double known) {
    const double chord = ends_[leg + 1] - ends_[leg];
    return std::min(std::max(window, std::min(chord, widest_window * window)), known);
  };
  const double before = width(joint, u - ends_.front()), behind = width(joint + 1, ends_.back() - u);
  const Point here = place_at(u), from = place_at(u - before), to = place_at(u + behind);
  const Point in = difference(here, from), out = difference(to, here);
  const double in_length = norm(in), out_length = norm(out);
  if (!(in_length > 0) || !(out_length > 0)) return 2;
  Point apart;
  for (std::size_t i = 0; i < apart.size(); ++i) apart[i] = out[i] / out_length - in[i] / in_length;
  return norm(apart);
}

Smoother::Joint Smoother::joint_kind(std::size_t joint) const {
  const Leg &before = legs_[joint], &behind = legs_[joint + 1];
  const bool are_long = is_long(before) && is_long(behind);
  const bool fits = cam_tolerance_ >= least_cam_tolerance || are_long;
  // Short lines may run straight on by chance, where what they stand for bends.
  const bool may_stand_for_a_curve = fits && !are_long && (is_line(before.curve) || is_line(behind.curve));
  if (!may_stand_for_a_curve && goes_on(before.curve, behind.curve)) return Joint::through;
  if (!fits) return Joint::corner;
  const double window = turn_window * tolerance_, turn = turns_[joint];
  if (turn < corner_turn) return Joint::smooth;
  for (std::size_t i = joint; i-- > 0 && ends_[joint + 1] - ends_[i + 1] <= window;) {
    if (turns_[i] > turn) return Joint::smooth;
  }
  for (std::size_t i = joint + 1; i < turns_.size() && ends_[i + 1] - ends_[joint + 1] <= window; ++i) {
    if (turns_[i] >= turn) return Joint::smooth;
  }
  return turn > sharp_turn || turn_at(joint, 2 * window) <= concentrated * turn ? Joint::corner : Joint::smooth;
}

/// Follows the legs whose ends are known.
void Smoother::classify(bool all) {
  const double window = turn_window * tolerance_, ahead = widest_window * window;
  while (turns_.size() + 1 < legs_.size() && (all || ends_.back() - ends_[turns_.size() + 1] >= ahead))
    turns_.push_back(turn_at(turns_.size(), window));
  while (joints_.size() < turns_.size() && (all || ends_[turns_.size()] - ends_[joints_.size() + 1] > window)) {
    joints_.push_back(joint_kind(joints_.size()));
  }
  if (all && !legs_.empty()) joints_.push_back(Joint::end);
  while (followed_ < joints_.size()) {
    follow(legs_[followed_], before_, joints_[followed_]);
    before_ = joints_[followed_++];
  }
  // Turns look back at legs that are done.
  while (followed_ > 1 && turns_.size() > 1 && ends_[turns_.size()] - ends_[1] > 2 * ahead) {
    legs_.pop_front();
    ends_.pop_front();
    joints_.pop_front();
    turns_.pop_front();
    --followed_;
  }
}

void Smoother::follow(const Leg& leg, Joint before, Joint behind) {
  const double length = geometry::length(leg.curve), rate = millimetres_per_length(leg.curve);
  const bool comes_smoothly = before == Joint::smooth, goes_smoothly = behind == Joint::smooth;
  const double span = span_length(leg, tolerance_);
  if (!is_long(leg) && (comes_smoothly || goes_smoothly)) {
    if (!run_) begin_run(leg, 0, before == Joint::through);
    extend_run(leg, 0, length);
    if (!goes_smoothly) end_run(leg, length, behind == Joint::through);
  } else {
    const double reach = std::min(reach_into * span / rate, length / 2);
    const double from = comes_smoothly ? reach : 0, to = goes_smoothly ? length - reach : length;
    if (comes_smoothly) {
      extend_run(leg, 0, from);
      end_run(leg, from, true);
    }
    if (to > from) add_exact(leg, from, to);
    if (goes_smoothly) {
      begin_run(leg, to, true);
      extend_run(leg, to, length);
    }
  }
  if (behind == Joint::corner) corner_ = true;
}

void Smoother::add_exact(const Leg& leg, double from, double to) {
  Stretch stretch{
      {leg.curve, leg.feed, leg.line, false, nullptr, leg.feed_axes}, std::exchange(corner_, false), {}, leg.spent};
  if (!leg.lines.empty()) stretch.piece.lines = std::make_shared<const std::vector<LineMark>>(leg.lines);
  trim(stretch.piece, from, to);
  add(std::move(stretch));
}

void Smoother::begin_run(const Leg& leg, double from, bool pinned) {
  State state = state_at(leg.curve, from, false);
  if (!pinned) state.count = 1;
  const Vertex vertex{state.derivative[0], 0, room_about(leg)};
  run_.reset(new Run{.spline = TubeSpline(state, vertex, longest_smoothing * span_length(leg, tolerance_),
                                          shortest_smoothing * tolerance_)});
  run_->start = geometry::evaluate(leg.curve, from);
  run_->corner_before = std::exchange(corner_, false);
}

bool Smoother::is_long(const Leg& leg) const {
  return length_of(leg) > long_leg * span_length(leg, tolerance_);
}

/// Legs that are fitted as a whole are what Q is for.
double Smoother::tolerance_for(const Leg& leg) const {
  return is_long(leg) ? tolerance_ : std::min(tolerance_, cam_tolerance_);
}

/// How far the polyline that stands for the leg may be from what was programmed, mm.
double Smoother::spent_by(const Leg& leg) const {
  return leg.spent + (is_line(leg.curve) ? 0 : arc_sagitta * tolerance_for(leg));
}

/// What a spline may be off, mm.
double Smoother::room_about(const Leg& leg) const {
  return kept_share * tolerance_for(leg) - spent_by(leg);
}

void Smoother::extend_run(const Leg& leg, double from, double to) {
  const double rate = millimetres_per_length(leg.curve);
  const double first = run_->u;
  base::Line line = leg.line;
  for (const LineMark& mark : leg.lines) {
    if (mark.s <= from) line = mark.line;
  }
  run_->marks.push_back({first, leg.feed, line});
  for (const LineMark& mark : leg.lines) {
    if (mark.s > from && mark.s < to) run_->marks.push_back({first + (mark.s - from) * rate, leg.feed, mark.line});
  }
  const double room = room_about(leg);
  run_->spent = std::max(run_->spent, spent_by(leg));
  const double sagitta = arc_sagitta * tolerance_for(leg);
  for (double s = from; s < to;) {
    s = is_line(leg.curve) ? to : chord_end(leg.curve, s, to, sagitta);
    run_->spline.append({position(leg.curve, s), first + (s - from) * rate, room});
  }
  run_->u = first + (to - from) * rate;
  settle_run();
}

void Smoother::end_run(const Leg& leg, double to, bool pinned) {
  State state = state_at(leg.curve, to, true);
  if (!pinned) state.count = 1;
  run_->end = run_->last_point = geometry::evaluate(leg.curve, to);
  run_->last = state;
  run_->spline.close(state);
  settle_run();
  run_.reset();
}

void Smoother::settle_run() {
  while (run_->spline.knows_enough()) {
    const std::vector<Vertex> around = run_->spline.vertices();
    const double from = run_->spline.settled();
    switch (run_->spline.settle()) {
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
bool Smoother::begin_rest(bool corner) {
  const std::vector<Vertex> vertices = std::exchange(run_->rest, {});
  if (vertices.empty() || (vertices.size() == 1 && run_->last)) return false;
  State state;
  state.derivative[0] = vertices.front().position;
  run_->spline = TubeSpline(state, vertices.front(), run_->spline.longest(), shortest_smoothing * tolerance_);
  for (std::size_t i = 1; i < vertices.size(); ++i) run_->spline.append(vertices[i]);
  run_->start = from_millimetres(vertices.front().position);
  run_->is_first = true;
  run_->corner_before = corner;
  if (run_->last) {
    run_->spline.close(*run_->last);
    run_->end = run_->last_point;
  }
  return true;
}

/// No spline was found: it is to end at the sharpest vertex near by, with a corner there. Where there is none, a
/// straight line leads to the next vertex: it stays inside the tube wherever in it the curve has come to, and the
/// motion stops at its ends. False if the run ends there.
bool Smoother::retreat() {
  const std::vector<Vertex> vertices = run_->spline.vertices();
  const double settled = run_->spline.settled();
  std::size_t next = 1;
  while (next + 1 < vertices.size() && vertices[next].u <= settled) ++next;
  const double worst = vertices[run_->spline.worst()].u;
  std::size_t end = next;
  double sharpest = least_corner;
  for (std::size_t i = next; i + 1 < vertices.size(); ++i) {
    if (std::abs(vertices[i].u - worst) > split_window * tolerance_) continue;
    const double turn = turn_between(vertices[i - 1].position, vertices[i].position, vertices[i + 1].position);
    if (turn > sharpest) {
      sharpest = turn;
      end = i;
    }
  }
  const bool splits = sharpest > least_corner;
  const bool is_last = run_->last && end + 1 == vertices.size() && run_->rest.empty();
  run_->rest.insert(run_->rest.begin(), vertices.begin() + static_cast<std::ptrdiff_t>(end),
                    run_->rest.empty() ? vertices.end() : vertices.end() - 1);
  if (splits) {
    State state;
    state.derivative[0] = vertices[end].position;
    run_->spline.retreat_to(end);
    run_->spline.close(state);
    run_->end = from_millimetres(vertices[end].position);
    return true;
  }
  const Point here = run_->is_first ? run_->start : from_millimetres(run_->spline.position());
  const Point there = is_last ? run_->last_point : from_millimetres(vertices[end].position);
  if (std::optional<Piece> line = straight_piece(here, there)) {
    std::deque<Run::Mark>& marks = run_->marks;
    while (marks.size() > 1 && marks[1].u <= settled) marks.pop_front();
    line->feed = marks.front().feed;
    line->line = marks.front().line;
    add({std::move(*line), run_->is_first && run_->corner_before, {}, run_->spent});
  }
  return begin_rest(false);
}

/// What has been settled of the spline, from `from` on, as pieces. `around`: the polyline there.
void Smoother::add_spline(const std::vector<Vertex>& around, double from, bool is_last) {
  const QuinticSpline& spline = run_->spline.stretch();
  geometry::NurbsForm form;
  form.degree = static_cast<int>(quintic_degree);
  form.knots = spline.knots;
  form.weights.assign(spline.points.size(), 1.0);
  for (const Point& point : spline.points) form.points.push_back(from_millimetres(point));
  if (run_->is_first) form.points.front() = run_->start;
  if (is_last) form.points.back() = run_->end;

  std::deque<Run::Mark>& marks = run_->marks;
  while (marks.size() > 1 && marks[1].u <= from) marks.pop_front();
  bool corner = run_->is_first && run_->corner_before;
  run_->is_first = false;
  const FeedAxes feed_axes = beside_others(axes_, form.points);
  for (const geometry::Nurbs& curve : fitted_pieces(form, feed_axes)) {
    std::size_t mark = 0;
    while (mark + 1 < marks.size() && marks[mark + 1].u <= curve.first_parameter()) ++mark;
    for (double begin = 0; begin < curve.length();) {
      Stretch stretch{{curve, marks[mark].feed, marks[mark].line, false, nullptr, feed_axes},
                      std::exchange(corner, false),
                      around,
                      run_->spent};
      std::vector<LineMark> lines;
      double end = curve.length();
      while (++mark < marks.size() && marks[mark].u < curve.last_parameter()) {
        const double s = length_at(curve, marks[mark].u);
        if (s > (1 - rounding) * curve.length()) continue;
        if (s - begin <= rounding * curve.length()) {  // it begins here too
          stretch.piece.feed = marks[mark].feed;
          stretch.piece.line = marks[mark].line;
          continue;
        }
        if (marks[mark].feed != stretch.piece.feed && s > begin) {
          end = s;
          break;
        }
        lines.push_back({s - begin, marks[mark].line});
      }
      if (!lines.empty()) stretch.piece.lines = std::make_shared<const std::vector<LineMark>>(std::move(lines));
      if (begin > 0 || end < curve.length()) stretch.piece.curve = curve.part(begin, end);
      add(std::move(stretch));
      begin = end;
    }
  }
}

/// Corners are cut as soon as both sides are known.
void Smoother::add(Stretch stretch) {
  if (last_ && stretch.corner_before) cut_corner(stretch);
  if (last_) done_.push_back(std::move(last_->piece));
  last_ = std::move(stretch);
}

void Smoother::cut_corner(Stretch& behind) {
  const double length_before = geometry::length(last_->piece.curve),
               length_behind = geometry::length(behind.piece.curve);
  // Half of each neighbour at most; all that a blend at its start has left, if that is no more.
  double most = last_->cut ? last_->length / 2 : uncut_share * length_before;
  if (most > (1 - rounding) * length_before) most = length_before;
  const FeedAxes feed_axes = std::max(last_->piece.feed_axes, behind.piece.feed_axes);  // axes_ or none
  const Corner corner{last_->piece.curve, behind.piece.curve, last_->programmed, behind.programmed, most,
                      length_behind / 2,  feed_axes};
  std::optional<Blend> found = blend(corner, kept_share * tolerance_ - std::max(last_->spent, behind.spent));
  if (!found) return;
  Piece curve{found->curve, std::min(last_->piece.feed, behind.piece.feed), last_->piece.last_line(), false, nullptr,
              feed_axes};
  const double left = length_before - found->before;
  if (left > 0) {
    trim(last_->piece, 0, left);
    done_.push_back(std::move(last_->piece));
  }
  behind.length = length_behind;
  behind.cut = true;
  trim(behind.piece, found->behind, length_behind);
  last_->piece = std::move(curve);
}

void Smoother::release() {
  if (last_) done_.push_back(std::move(last_->piece));
  last_.reset();
}

}  // namespace leadscrew::toolpath
