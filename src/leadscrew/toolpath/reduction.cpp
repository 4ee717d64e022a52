#include <algorithm>
#include <leadscrew/toolpath/event_marks.hpp>
#include <leadscrew/toolpath/reduction.hpp>
#include <leadscrew/toolpath/tolerance_space.hpp>
#include <leadscrew/toolpath/tuning.hpp>
#include <utility>

namespace leadscrew::toolpath {

using geometry::Point;

namespace {

using namespace tuning::reduction;

constexpr double straight = 2e-7;  // mm: what rounding and three decimals of inches leave
constexpr double rounding = 1e-9;
constexpr double nothing = 1e-9;  // mm: of two lines one of which is no longer, the other stands for both

/// That feed lets a curve take whose direction is nearly that at its start, s.
double least_time(const geometry::Curve& curve, double feed, FeedAxes axes) {
  return geometry::length(curve) * rate(geometry::jets(curve, 0), axes) / feed;
}

}  // namespace

/// Is the open leg and this one a single line?
bool Reduction::join(const Leg& leg) {
  const auto* const open = std::get_if<geometry::Line>(&open_->curve);
  const auto* const line = std::get_if<geometry::Line>(&leg.curve);
  if (!open || !line || open_->lines.size() >= most_lines) return false;
  const Point end = leg.space.to_millimetres(line->end());
  const double off = distance_to_segment(end_, start_, end);
  const Allowance allowance = lesser(open_->allowance, leg.allowance);
  const double length_before = distance(start_, end_), length_behind = distance(end_, end);
  const bool is_one_nothing = std::min(length_before, length_behind) <= nothing && axes_of(*open_) == axes_of(leg);
  const bool is_alike = open_->feed == leg.feed && open_->allowance == leg.allowance;
  const bool is_straight =
      open_->spent + off <= straight && (is_one_nothing || (is_alike && distance(start_, end) > length_before));
  // All that lies in a ball may be taken for its centre.
  const double radius = std::max(radius_, length_before);
  const bool is_in_ball = std::max(radius, distance(start_, end)) <= ball_share * allowance.fitted();
  if (!is_straight && !is_in_ball) return false;
  const double spent = std::min(open_->spent + off, radius);
  if (!is_straight && spent > most_spent * allowance.fitted()) return false;
  // Told in the same axes as before, or not at all.
  const FeedAxes axes = axes_of(*open_);
  const std::optional<Piece> one = straight_piece(open->start(), line->end(), axes, leg.space);
  if (!one || feed_axes(geometry::moving(one->curve)) != axes) return false;
  const double length = geometry::length(one->curve);
  const double feed_of_longer = length_before > length_behind ? open_->feed : leg.feed;
  const double feed = is_one_nothing ? feed_of_longer : std::min(open_->feed, leg.feed);
  // The lesser feed is kept by all of it, but no longer than all of them would take one by one.
  const double seconds = seconds_ + least_time(leg.curve, leg.feed, leg.feed_axes);
  if (!is_one_nothing && least_time(one->curve, feed, one->feed_axes) > seconds * (1 + rounding)) return false;
  // What became one line may be shorter than its parts were.
  open_->lines.push_back({open->length(), leg.line});
  for (auto mark = open_->lines.rbegin(); mark != open_->lines.rend() && mark->s > length; ++mark) mark->s = length;
  append_events(open_->events, leg.events, open->length());
  for (auto mark = open_->events.rbegin(); mark != open_->events.rend() && mark->s > length; ++mark) mark->s = length;
  open_->curve = one->curve;
  open_->feed_axes = one->feed_axes;
  open_->feed = feed;
  open_->allowance = allowance;
  seconds_ = seconds;
  open_->spent = spent;
  open_->kept = std::max(open_->kept, leg.kept);
  radius_ = radius;
  end_ = end;
  return true;
}

std::optional<Leg> Reduction::push(Leg leg) {
  if (open_ && join(leg)) return std::nullopt;
  std::optional<Leg> done = finish();
  start_ = leg.space.to_millimetres(geometry::start(leg.curve));
  end_ = leg.space.to_millimetres(geometry::end(leg.curve));
  radius_ = 0;
  seconds_ = least_time(leg.curve, leg.feed, leg.feed_axes);
  open_ = std::move(leg);
  return done;
}

std::optional<Leg> Reduction::finish() {
  return std::exchange(open_, std::nullopt);
}

}  // namespace leadscrew::toolpath
