#include <algorithm>
#include <leadscrew/toolpath/allowance.hpp>
#include <leadscrew/toolpath/builder.hpp>
#include <limits>

namespace leadscrew::toolpath {

namespace {

double speed(const gcode::Feed& feed, double length) {
  switch (feed.mode) {
    case gcode::Feed::Mode::units_per_second:
      return feed.value;
    case gcode::Feed::Mode::per_second:
      return feed.value * length;
    case gcode::Feed::Mode::rapid:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

FeedAxes feed_axes_of(const geometry::Curve& curve) {
  if (std::holds_alternative<geometry::Line>(curve)) return feed_axes(geometry::start(curve), geometry::end(curve));
  if (std::holds_alternative<geometry::Arc>(curve)) return FeedAxes::xyz;
  const geometry::PointJet jet = geometry::jets(curve, geometry::length(curve) / 2);
  geometry::Point direction{};
  for (std::size_t i = 0; i < direction.size(); ++i) direction[i] = jet[i].first;
  return feed_axes({}, direction);
}

}  // namespace

void Builder::push(const gcode::Move& move) {
  switch (move.kind) {
    case gcode::Move::Kind::dwell:
      flush();
      settled_.emplace_back(Dwell{move.start, move.dwell_seconds, move.line});
      return;
    case gcode::Move::Kind::event:
      flush();
      settled_.emplace_back(move.event);
      return;
    default:
      move_along(move);
  }
}

void Builder::move_along(const gcode::Move& move) {
  std::vector<geometry::Curve> curves = curves_of(move);
  double length = 0;
  for (const geometry::Curve& curve : curves) length += geometry::length(curve);
  const double feed = speed(move.feed, length);
  const FeedAxes axes = curves.empty() ? FeedAxes::none : feed_axes_of(curves.front());
  const auto is_alike = [&](const geometry::Curve& curve) { return feed_axes_of(curve) == axes; };
  // A spline whose parts are counted by different axes is kept as it is.
  const bool blends = move.path_mode == gcode::PathMode::blend && move.tolerance >= least_tolerance &&
                      std::all_of(curves.begin(), curves.end(), is_alike);
  if (!blends) flush();
  if (!blends || curves.empty()) {
    for (geometry::Curve& curve : curves)
      settled_.emplace_back(Piece{std::move(curve), feed, move.line, false, nullptr});
  } else {
    const FeedAxes named = to_be_named(axes, move);
    if (named != FeedAxes::none) curves = curves_of(move, Length::of_tolerance);
    if (smoother_ && (smoother_->tolerance() != move.tolerance ||
                      smoother_->cam_tolerance() != move.naive_cam_tolerance || axes_ != axes)) {
      flush();
    }
    if (!smoother_) smoother_.emplace(move.tolerance, move.naive_cam_tolerance);
    axes_ = axes;
    for (geometry::Curve& curve : curves) smoother_->push(Leg{std::move(curve), feed, move.line, {}, 0, axes, named});
  }
  if (move.path_mode != gcode::PathMode::exact_stop || curves.empty()) return;
  if (auto* const last = std::get_if<Piece>(&settled_.back())) last->stop = true;
}

/// What follows cannot change what was pushed so far.
void Builder::flush() {
  if (!smoother_) return;
  smoother_->finish();
  while (std::optional<Piece> piece = smoother_->pop()) settled_.emplace_back(std::move(*piece));
  smoother_.reset();
}

std::optional<Element> Builder::pop() {
  if (settled_.empty() && smoother_) {
    if (std::optional<Piece> piece = smoother_->pop()) return Element(std::move(*piece));
  }
  if (settled_.empty()) return std::nullopt;
  std::optional<Element> element(std::move(settled_.front()));
  settled_.pop_front();
  return element;
}

}  // namespace leadscrew::toolpath
