#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/gauss.hpp>
#include <leadscrew/toolpath/corner.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/smoother.hpp>
#include <leadscrew/toolpath/tolerance_space.hpp>
#include <utility>

namespace leadscrew::toolpath {

using geometry::Curve;
using geometry::Point;

namespace {

constexpr double corner_turn = 1.3;  // |t⁺ − t⁻| = 2 sin(θ/2): 81°
constexpr double sharp_turn = 1.4;   // a corner even if the path goes on turning
constexpr double concentrated = 1.5;
constexpr double turn_window = 8;    // tolerances
constexpr double widest_window = 4;  // turn windows, where the leg is as long
constexpr double reach_into = 6;     // lengths of a span
constexpr double same_direction = 1e-9;
constexpr double rounding = 1e-9;
constexpr double allowed_time = 0.005;  // s that what is made may cost more by feed than what it takes the place of
constexpr int most_shortened = 40;      // times
constexpr double uncut_share = 0.9;     // of a curve that the blend at its end may take, if there was none at its start

Point position(const Curve& curve, double s) {
  return to_millimetres(geometry::evaluate(curve, s));
}

/// Does the second go on where the first ends with the same direction and curvature?
bool goes_on(const Curve& first, const Curve& second) {
  const geometry::PointJet a = geometry::jets(first, geometry::length(first)), b = geometry::jets(second, 0);
  const double ra = norm(derivative(a, &numeric::Jet<>::first)), rb = norm(derivative(b, &numeric::Jet<>::first));
  for (std::size_t i = 0; i < a.size(); ++i) {
    // Where a curve ends in a cusp they are no numbers.
    if (!(std::abs(a[i].first / ra - b[i].first / rb) <= same_direction)) return false;
    if (!(std::abs(a[i].second / (ra * ra) - b[i].second / (rb * rb)) <= same_direction)) return false;
  }
  return true;
}

/// Would a curve through both lose time? Where much of a move is rotary, what the curve takes of its neighbour's travel
/// into it, no more than the tolerance, is fed as slowly as its own.
bool costs_time(const Leg& before, const Leg& behind, double tolerance) {
  const auto feed_share = [](const Leg& leg) {
    return rate(geometry::jets(leg.curve, 0), leg.feed_axes) / millimetres_per_length(leg.curve);
  };
  const double seconds_per_mm = std::abs(1 / before.feed - 1 / behind.feed);
  return tolerance * std::abs(feed_share(before) - feed_share(behind)) * seconds_per_mm > allowed_time;
}

/// The lines that a part of a piece was asked for by.
struct Lines {
  base::Line first{};
  std::vector<LineMark> marks;  ///< of the others, from the beginning of the part
};

/// Between two path lengths; places are told by what stands for that part, which is so much longer.
Lines lines_between(const Piece& piece, double from, double to, double longer = 1) {
  Lines lines{piece.line, {}};
  if (!piece.lines) return lines;
  for (const LineMark& mark : *piece.lines) {
    if (mark.s <= from) {
      lines.first = mark.line;
    } else if (mark.s < to) {
      lines.marks.push_back({longer * (mark.s - from), mark.line});
    }
  }
  return lines;
}

void name(Piece& piece, Lines lines) {
  piece.line = lines.first;
  piece.lines = lines.marks.empty() ? nullptr : std::make_shared<const std::vector<LineMark>>(std::move(lines.marks));
}

/// Leaves what lies between two path lengths.
void trim(Piece& piece, double from, double to) {
  if (from == 0 && to == geometry::length(piece.curve)) return;
  piece.curve = geometry::part(piece.curve, from, to);
  name(piece, lines_between(piece, from, to));
}

/// How long a part of a piece takes by feed alone, s: where feed is counted by some of the axes that move, a blend of
/// two moves may have more of them than either.
double time_by_feed(const Piece& piece, double from, double to) {
  if (piece.feed_axes == FeedAxes::none || !std::isfinite(piece.feed)) return (to - from) / piece.feed;
  const auto per_length = [&](double s) { return rate(geometry::jets(piece.curve, s), piece.feed_axes) / piece.feed; };
  const double middle = (from + to) / 2;
  return numeric::integrate_gauss_8(per_length, from, middle) + numeric::integrate_gauss_8(per_length, middle, to);
}
double time_by_feed(const std::vector<Piece>& pieces) {
  double time = 0;
  for (const Piece& piece : pieces) time += time_by_feed(piece, 0, geometry::length(piece.curve));
  return time;
}

/// The blend between two, each half with the lines and the feed of what it takes the place of.
std::vector<Piece> pieces_of(const Blend& blend, const Stretch& before, const Stretch& behind) {
  const double length = blend.curve.length(), length_before = geometry::length(before.piece.curve);
  Lines first = lines_between(before.piece, length_before - blend.before, length_before, blend.corner / blend.before);
  Lines second = lines_between(behind.piece, 0, blend.behind, (length - blend.corner) / blend.behind);
  Piece one{blend.curve, before.piece.feed, {}, false, nullptr, to_be_named(before.axes, blend.curve.moving())};
  Piece other = one;
  other.feed = behind.piece.feed;
  other.feed_axes = to_be_named(behind.axes, blend.curve.moving());
  if (one.is_fed_as(other)) {
    const base::Line last = first.marks.empty() ? first.first : first.marks.back().line;
    if (second.first != last) first.marks.push_back({blend.corner, second.first});
    for (const LineMark& mark : second.marks) first.marks.push_back({blend.corner + mark.s, mark.line});
    name(one, std::move(first));
    return {one};
  }
  one.curve = blend.curve.part(0, blend.corner);
  other.curve = blend.curve.part(blend.corner, length);
  name(one, std::move(first));
  name(other, std::move(second));
  return {one, other};
}

}  // namespace

Smoother::Smoother(double tolerance, double cam_tolerance)
    : allowance_{tolerance, cam_tolerance}, reduction_(std::min(tolerance, cam_tolerance)) {}

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
  return turn_between(difference(here, from), difference(to, here));
}

Smoother::Joint Smoother::joint_kind(std::size_t joint) const {
  const Leg &before = legs_[joint], &behind = legs_[joint + 1];
  if (axes_of(before) != axes_of(behind)) return goes_on(before.curve, behind.curve) ? Joint::through : Joint::corner;
  const bool are_long = allowance_.is_long(before) && allowance_.is_long(behind);
  const bool fits = allowance_.cam_tolerance >= least_tolerance || are_long;
  // Short lines may run straight on by chance, where what they stand for bends.
  const bool may_stand_for_a_curve = fits && !are_long && (is_line(before.curve) || is_line(behind.curve));
  if (!may_stand_for_a_curve && goes_on(before.curve, behind.curve)) return Joint::through;
  if (!fits) return Joint::corner;
  if (costs_time(before, behind, allowance_.tolerance)) return Joint::corner;
  const double window = turn_window * allowance_.tolerance, turn = turns_[joint];
  if (turn < corner_turn) return Joint::smooth;
  for (std::size_t i = joint; i > 0 && ends_[joint + 1] - ends_[i] <= window; --i) {
    if (turns_[i - 1] > turn) return Joint::smooth;
  }
  for (std::size_t i = joint + 1; i < turns_.size() && ends_[i + 1] - ends_[joint + 1] <= window; ++i) {
    if (turns_[i] >= turn) return Joint::smooth;
  }
  return turn > sharp_turn || turn_at(joint, 2 * window) <= concentrated * turn ? Joint::corner : Joint::smooth;
}

/// Follows the legs whose ends are known.
void Smoother::classify(bool all) {
  const double window = turn_window * allowance_.tolerance, ahead = widest_window * window;
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
  if (!allowance_.is_long(leg) && (comes_smoothly || goes_smoothly)) {
    if (!run_) begin_run(leg, 0, before == Joint::through);
    run_->extend(leg, 0, length);
    if (!goes_smoothly) run_->end(leg, length, behind == Joint::through);
    take_run(goes_smoothly);
  } else {
    const double reach = std::min(reach_into * allowance_.span_length(leg) / rate, length / 2);
    const double from = comes_smoothly ? reach : 0, to = goes_smoothly ? length - reach : length;
    if (comes_smoothly) {
      run_->extend(leg, 0, from);
      run_->end(leg, from, true);
      take_run(false);
    }
    if (to > from) add_exact(leg, from, to);
    if (goes_smoothly) {
      begin_run(leg, to, true);
      run_->extend(leg, to, length);
      take_run(true);
    }
  }
  if (behind == Joint::corner) corner_ = true;
}

void Smoother::begin_run(const Leg& leg, double from, bool pinned) {
  run_.emplace(allowance_, leg, from, pinned, std::exchange(corner_, false));
}

/// What has been settled of the run.
void Smoother::take_run(bool goes_on) {
  for (Stretch& stretch : run_->take()) add(std::move(stretch));
  if (!goes_on) run_.reset();
}

void Smoother::add_exact(const Leg& leg, double from, double to) {
  Stretch stretch{{leg.curve, leg.feed, leg.line, false, nullptr, leg.feed_axes},
                  axes_of(leg),
                  std::exchange(corner_, false),
                  {},
                  leg.spent};
  if (!leg.lines.empty()) stretch.piece.lines = std::make_shared<const std::vector<LineMark>>(leg.lines);
  trim(stretch.piece, from, to);
  add(std::move(stretch));
}

/// Corners are cut as soon as both sides are known.
void Smoother::add(Stretch stretch) {
  if (last_ && stretch.corner_before) cut_corner(stretch);
  if (last_) emit(std::move(last_->piece));
  last_ = std::move(stretch);
}

void Smoother::cut_corner(Stretch& behind) {
  const double length_before = geometry::length(last_->piece.curve),
               length_behind = geometry::length(behind.piece.curve);
  // Half of each neighbour at most; all that a blend at its start has left, if that is no more.
  double most = last_->cut ? last_->length / 2 : uncut_share * length_before;
  if (most > (1 - rounding) * length_before) most = length_before;
  Corner corner{last_->piece.curve, behind.piece.curve, last_->programmed, behind.programmed, most, length_behind / 2};
  const double margin = allowance_.margin_beside(std::max(last_->spent, behind.spent));
  std::optional<Blend> found = blend(corner, margin);
  std::vector<Piece> pieces;
  for (int k = 0; found; ++k) {
    pieces = pieces_of(*found, *last_, behind);
    const double costs = time_by_feed(pieces) -
                         time_by_feed(last_->piece, length_before - found->before, length_before) -
                         time_by_feed(behind.piece, 0, found->behind);
    if (costs <= allowed_time) break;
    if (k == most_shortened) return;
    // Nearly in proportion to its size.
    const double share = std::max(0.5, 0.9 * allowed_time / costs);
    corner.most_before = share * found->before;
    corner.most_behind = share * found->behind;
    found = blend(corner, margin);
  }
  if (!found) return;
  const double left = length_before - found->before;
  if (left > 0) {
    trim(last_->piece, 0, left);
    emit(std::move(last_->piece));
  }
  behind.length = length_behind;
  behind.cut = true;
  trim(behind.piece, found->behind, length_behind);
  if (pieces.size() > 1) emit(std::move(pieces.front()));
  last_->piece = std::move(pieces.back());
}

/// What no corner can cut any more.
void Smoother::emit(Piece piece) {
  piece.curve = simplest(piece.curve);
  done_.push_back(std::move(piece));
}

void Smoother::release() {
  if (last_) emit(std::move(last_->piece));
  last_.reset();
}

}  // namespace leadscrew::toolpath
