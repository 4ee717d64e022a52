#include <algorithm>
#include <cmath>
#include <leadscrew/toolpath/corner.hpp>
#include <leadscrew/toolpath/event_marks.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/smoother.hpp>
#include <leadscrew/toolpath/swing.hpp>
#include <leadscrew/toolpath/tolerance_space.hpp>
#include <leadscrew/toolpath/tuning.hpp>
#include <utility>

namespace leadscrew::toolpath {

using geometry::Curve;
using geometry::Point;

namespace {

using namespace tuning::smoother;
using tuning::allowed_time;
using tuning::corner_turn;
using tuning::corner::least_in_place_of_spline;
using tuning::corner::least_swing_of_corner;
using tuning::corner::sharp_swing;

Point position(const Curve& curve, double s, const ToleranceSpace& space) {
  return space.to_millimetres(geometry::evaluate(curve, s));
}

/// Is the one so much more than the other that it should not be held to it?
bool is_much_wider(double margin, double narrow) {
  return margin >= much_wider * narrow;
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
  std::vector<EventMark> events = events_on({length_before - blend.before, length_before, length_before},
                                            events_of(before.piece), blend.corner / blend.before);
  const std::vector<EventMark> events_behind =
      events_on({0, blend.behind, geometry::length(behind.piece.curve)}, events_of(behind.piece),
                (length - blend.corner) / blend.behind);
  Piece one{blend.curve, before.piece.feed, {}, false, nullptr, to_be_named(before.axes, blend.curve.moving())};
  Piece other = one;
  other.feed = behind.piece.feed;
  other.feed_axes = to_be_named(behind.axes, blend.curve.moving());
  if (one.is_fed_as(other)) {
    const base::Line last = first.marks.empty() ? first.first : first.marks.back().line;
    if (second.first != last) first.marks.push_back({blend.corner, second.first});
    for (const LineMark& mark : second.marks) first.marks.push_back({blend.corner + mark.s, mark.line});
    name(one, std::move(first));
    append_events(events, events_behind, blend.corner);
    set_events(one, std::move(events));
    return {one};
  }
  one.curve = blend.curve.part(0, blend.corner);
  other.curve = blend.curve.part(blend.corner, length);
  name(one, std::move(first));
  name(other, std::move(second));
  set_events(one, std::move(events));
  set_events(other, events_behind);
  return {one, other};
}

/// A blend, and what it is as pieces.
struct Cut {
  Blend blend;
  std::vector<Piece> pieces;
};

/// The blend of a corner within a tolerance, which takes at most these lengths of its neighbours.
std::optional<Cut> cut_within(double tolerance, const Stretch& before, double most_before, const Stretch& behind,
                              double most_behind, const Sampling& sampling, const geometry::MapTolerance& tables,
                              const ToleranceSpace& space) {
  Corner corner{before.piece.curve, behind.piece.curve, before.programmed, behind.programmed, most_before, most_behind};
  corner.tables = tables;
  corner.space = space;
  const double spent = std::max(before.spent, behind.spent);
  const Division division = sampling.at_corner(before.piece, behind.piece, tolerance, space);
  if (division.rounding == Rounding::none) return std::nullopt;
  corner.may_swing = division.rounding == Rounding::wide;
  const double of_words = margin_beside(tolerance, spent), margin = of_words - division.kept;
  const double length = geometry::length(before.piece.curve);
  for (int k = 0; k <= most_shortened; ++k) {
    std::optional<Blend> found = blend(corner, margin);
    if (!found) return std::nullopt;
    std::vector<Piece> pieces = pieces_of(*found, before, behind);
    for (Piece& piece : pieces) piece.sagitta = of_words - found->deviation;
    const double costs = time_by_feed(pieces) - time_by_feed(before.piece, length - found->before, length) -
                         time_by_feed(behind.piece, 0, found->behind);
    if (costs <= allowed_time) return Cut{std::move(*found), std::move(pieces)};
    // Nearly in proportion to its size.
    const double share = std::max(0.5, 0.9 * allowed_time / costs);
    corner.most_before = share * found->before;
    corner.most_behind = share * found->behind;
  }
  return std::nullopt;
}

}  // namespace

void Smoother::push(Leg leg) {
  leg.kept = sampling_.kept_beside_spline(leg);
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
  if (!legs_.empty() && legs_.back().allowance != leg.allowance)
    changes_.push_back({ends_.back(), legs_.back().allowance.tolerance, leg.allowance.tolerance});
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
  return position(at.curve, share * geometry::length(at.curve), space_);
}

/// What both legs at the end of leg `joint` allow, mm.
double Smoother::tolerance_at(std::size_t joint) const {
  return std::min(legs_[joint].allowance.tolerance, legs_[joint + 1].allowance.tolerance);
}

/// |t⁺ − t⁻| at the end of leg `joint`, of the mean directions before and behind it.
double Smoother::turn_at(std::size_t joint, double window) const {
  const double u = ends_[joint + 1];
  const auto width = [&](std::size_t leg, double known) {
    const double chord = ends_[leg + 1] - ends_[leg];
    return std::min(std::max(window, std::min(chord, widest_window * window)), known);
  };
  // What is allowed much less does not turn with it.
  const double tolerance = tolerance_at(joint);
  double first = ends_.front(), last = ends_.back();
  for (const Change& change : changes_) {
    if (change.u <= u && is_much_wider(tolerance, change.before)) first = std::max(first, change.u);
    if (change.u >= u && is_much_wider(tolerance, change.behind)) {
      last = change.u;
      break;
    }
  }
  const double before = width(joint, u - first), behind = width(joint + 1, last - u);
  const Point here = place_at(u), from = place_at(u - before), to = place_at(u + behind);
  return turn_between(difference(here, from), difference(to, here));
}

/// mm of either line at the end of leg `joint` that the longest blend of their corner takes; none where they are none.
std::optional<double> Smoother::wanted_at(std::size_t joint) const {
  const Leg &before = legs_[joint], &behind = legs_[joint + 1];
  if (!is_line(before.curve) || !is_line(behind.curve)) return std::nullopt;
  const double turn = turn_between(space_.derivative(geometry::jets(before.curve, 0), &numeric::Jet<>::first),
                                   space_.derivative(geometry::jets(behind.curve, 0), &numeric::Jet<>::first));
  if (!(turn > 0 && turn < sharp_swing)) return std::nullopt;
  const double tolerance = tolerance_at(joint);
  const Division division = sampling_.at_joint(before, behind, tolerance);
  if (division.rounding != Rounding::wide) return std::nullopt;
  return Swing(turn).reach_within(margin_beside(tolerance, std::max(before.spent, behind.spent)) - division.kept);
}

/// Are both lines so long that their corner is passed sooner by a blend that swings wide than by a spline?
bool Smoother::swings_wide(std::size_t joint) const {
  const std::optional<double> wanted = wanted_at(joint);
  if (!wanted) return false;
  const double least = turns_[joint] < corner_turn ? least_in_place_of_spline : least_swing_of_corner;
  return least * *wanted < std::min(length_of(legs_[joint]), length_of(legs_[joint + 1])) / 2;
}

/// u at the last change before the leg, or where the path begins.
double Smoother::changed_before(std::size_t leg) const {
  double u = 0;
  for (const Change& change : changes_) {
    if (change.u <= ends_[leg]) u = change.u;
  }
  return u;
}

/// Does a part of the path begin or end there that is allowed much more, so that it is faster with a corner at its end? A
/// spline's smoothing length grows but slowly from a vertex that it must come close to; and blends need not keep Q.
bool Smoother::is_beside_wide(std::size_t joint) const {
  const Leg &before = legs_[joint], &behind = legs_[joint + 1];
  if (before.allowance == behind.allowance) return false;
  const bool narrows = margin_about(behind) < margin_about(before);
  const Leg &wide = narrows ? before : behind, &narrow = narrows ? behind : before;
  const double margin = margin_about(narrow);
  if (!is_much_wider(margin_about(wide), margin)) return false;
  if (is_much_wider(tolerance_at(joint), margin)) return turns_[joint] >= least_without_q;
  const double span = span_length(wide), least = std::max(least_without_q, tight_spans * margin / span);
  const double length = narrows ? ends_[joint + 1] - changed_before(joint) : length_of(wide);
  if (turns_[joint] < (length > span ? least : std::max(least, least_beside_short))) return false;
  const std::size_t next = narrows ? joint - 1 : joint + 2;
  return next >= legs_.size() || is_much_wider(margin_about(legs_[next]), margin);
}

Smoother::Joint Smoother::joint_kind(std::size_t joint) const {
  const Leg &before = legs_[joint], &behind = legs_[joint + 1];
  if (axes_of(before) != axes_of(behind))
    return goes_on(before.curve, behind.curve, space_) ? Joint::through : Joint::corner;
  const bool are_long = is_long(before) && is_long(behind);
  const bool fits = may_be_fitted(before) && may_be_fitted(behind);
  // Short lines may run straight on by chance, where what they stand for bends.
  const bool may_stand_for_a_curve = fits && !are_long && (is_line(before.curve) || is_line(behind.curve));
  if (!may_stand_for_a_curve && goes_on(before.curve, behind.curve, space_)) return Joint::through;
  if (!fits) return Joint::corner;
  if (costs_time(before, behind, tolerance_at(joint))) return Joint::corner;
  if (swings_wide(joint)) return Joint::wide;
  const double window = turn_window * tolerance_at(joint), turn = turns_[joint];
  if (is_beside_wide(joint)) return Joint::corner;
  if (!sampling_.suits_spline(before, turn) || !sampling_.suits_spline(behind, turn)) return Joint::corner;
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
  const auto window = [&](std::size_t joint) { return turn_window * tolerance_at(joint); };
  const auto ahead = [&](std::size_t joint) { return widest_window * window(joint); };
  while (turns_.size() + 1 < legs_.size() && (all || ends_.back() - ends_[turns_.size() + 1] >= ahead(turns_.size())))
    turns_.push_back(turn_at(turns_.size(), window(turns_.size())));
  while (joints_.size() < turns_.size() &&
         (all || ends_[turns_.size()] - ends_[joints_.size() + 1] > window(joints_.size()))) {
    joints_.push_back(joint_kind(joints_.size()));
  }
  if (all && !legs_.empty()) joints_.push_back(Joint::end);
  while (followed_ < joints_.size()) {
    follow(legs_[followed_], before_, joints_[followed_]);
    before_ = joints_[followed_++];
  }
  // Turns look back at legs that are done.
  while (followed_ > 1 && turns_.size() > 1 && ends_[turns_.size()] - ends_[1] > 2 * ahead(turns_.size() - 1)) {
    legs_.pop_front();
    ends_.pop_front();
    if (changes_.size() > 1 && changes_[1].u < ends_.front()) changes_.pop_front();
    joints_.pop_front();
    turns_.pop_front();
    --followed_;
  }
}

void Smoother::follow(const Leg& leg, Joint before, Joint behind) {
  const double length = geometry::length(leg.curve), rate = millimetres_per_length(leg.curve, space_);
  const bool comes_smoothly = before == Joint::smooth, goes_smoothly = behind == Joint::smooth;
  // Next to a corner that swings wide a line stays what it is.
  const bool stays = is_long(leg) || before == Joint::wide || behind == Joint::wide;
  if (!stays && (comes_smoothly || goes_smoothly)) {
    if (!run_) begin_run(leg, 0, before == Joint::through);
    run_->extend(leg, 0, length);
    if (!goes_smoothly) run_->end(leg, length, behind == Joint::through);
    take_run(goes_smoothly);
  } else {
    const double reach = std::min(reach_into * span_length(leg) / rate, length / 2);
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
  if (behind == Joint::corner || behind == Joint::wide) corner_ = true;
}

void Smoother::begin_run(const Leg& leg, double from, bool pinned) {
  run_.emplace(leg, from, pinned, std::exchange(corner_, false), tables_);
}

/// What has been settled of the run.
void Smoother::take_run(bool goes_on) {
  for (Stretch& stretch : run_->take()) add(std::move(stretch));
  if (goes_on) return;
  // Those at its end.
  for (const base::Event& event : run_->events_left()) {
    if (!last_) {
      carried_.push_back({0, event});
      continue;
    }
    std::vector<EventMark> events(events_of(last_->piece).begin(), events_of(last_->piece).end());
    events.push_back({geometry::length(last_->piece.curve), event});
    set_events(last_->piece, std::move(events));
  }
  run_.reset();
}

void Smoother::add_exact(const Leg& leg, double from, double to) {
  Stretch stretch{.piece = {leg.curve, leg.feed, leg.line, false, nullptr, leg.feed_axes},
                  .axes = axes_of(leg),
                  .corner_before = std::exchange(corner_, false),
                  .tolerance = leg.allowance.tolerance,
                  .spent = leg.spent};
  const Joint behind = joints_[followed_];  // of this leg
  if (to < geometry::length(leg.curve) || (behind != Joint::corner && behind != Joint::wide)) {
    stretch.wanted_behind = 0;
  } else if (const std::optional<double> wanted = wanted_at(followed_)) {
    stretch.wanted_behind = *wanted / millimetres_per_length(leg.curve, space_);
  }
  if (!leg.lines.empty()) stretch.piece.lines = std::make_shared<const std::vector<LineMark>>(leg.lines);
  set_events(stretch.piece, leg.events);
  trim(stretch.piece, from, to);
  add(std::move(stretch));
}

/// Corners are cut as soon as both sides are known.
void Smoother::add(Stretch stretch) {
  if (last_ && stretch.corner_before) cut_corner(stretch);
  if (last_) emit(std::move(last_->piece));
  last_ = std::move(stretch);
}

/// Half of each neighbour at most; all that a blend at its start has left, if that is no more. As far as its tolerance
/// holds: where a lesser one is near, the greater of the blends within the one and the other.
void Smoother::cut_corner(Stretch& behind) {
  const double length_before = geometry::length(last_->piece.curve),
               length_behind = geometry::length(behind.piece.curve);
  // Of the one before all that a blend at its start has left; of the one behind half, or more where the corner at its end
  // wants less.
  const double most = last_->cut ? length_before : uncut_share * length_before;
  const double most_behind =
      std::max(length_behind / 2, std::min(uncut_share * length_behind, length_behind - behind.wanted_behind));
  std::optional<Cut> cut;
  double tolerance =
      std::min(toolpath::tolerance_at(*last_, StretchEnd::last), toolpath::tolerance_at(behind, StretchEnd::first));
  for (int k = 0; k < most_tolerances && tolerance > 0; ++k) {
    const Reach before = reach_within(*last_, StretchEnd::last, tolerance, most),
                beyond = reach_within(behind, StretchEnd::first, tolerance, most_behind);
    std::optional<Cut> found =
        cut_within(tolerance, *last_, before.length, behind, beyond.length, sampling_, tables_, space_);
    if (found && (!cut || found->blend.curve.length() > cut->blend.curve.length())) cut = std::move(found);
    tolerance = std::max(before.beyond, beyond.beyond);
  }
  if (!cut) return;
  const double left = length_before - cut->blend.before;
  if (left > 0) {
    trim(last_->piece, 0, left);
    emit(std::move(last_->piece));
  }
  behind.length = length_behind;
  behind.cut = true;
  trim(behind.piece, cut->blend.behind, length_behind);
  if (cut->pieces.size() > 1) emit(std::move(cut->pieces.front()));
  last_->piece = std::move(cut->pieces.back());
}

/// What no corner can cut any more.
void Smoother::emit(Piece piece) {
  piece.curve = simplest(piece.curve, space_);
  carry_events(piece, carried_);
  done_.push_back(std::move(piece));
}

void Smoother::release() {
  if (last_) emit(std::move(last_->piece));
  last_.reset();
}

}  // namespace leadscrew::toolpath
