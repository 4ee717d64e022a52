#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/pipeline/path_survey.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/tolerance_space.hpp>
#include <leadscrew/toolpath/travel.hpp>
#include <limits>

namespace leadscrew::pipeline {

namespace {

// What of a move's length, mm, may be cut off at both its ends.
double cut_off(const gcode::Move& move) {
  return move.path_mode == gcode::PathMode::blend ? 2 * std::max(move.tolerance, move.naive_cam_tolerance) : 0;
}

// The same of the angle of a rotary axis, degrees.
double angle_cut_off(const gcode::Move& move) {
  if (move.path_mode != gcode::PathMode::blend) return 0;
  return move.is_of_tip ? 2 * move.orientation_tolerance
                        : cut_off(move) / toolpath::ToleranceSpace{}.millimetres_per_degree;
}

// Of a line, where what is cut off is more than that share of it, it is taken together with its neighbours.
constexpr double short_share = 0.05;

// The share of a length that remains.
double remaining(double length, double cut) {
  return length > cut ? (length - cut) / length : 0;
}

// That a line of rotary axes alone takes, s, by their velocities, and at its feed where no more than a twentieth is cut off:
// shorter ones may become one curve with their neighbours. 0 of other lines.
double angle_time(const gcode::Move& move, const base::AxisVector& slowness) {
  const double cut = angle_cut_off(move);
  double square = 0, by_axes = 0;
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    const double distance = std::fabs(move.end[i] - move.start[i]);
    if (distance != 0 && !base::is_rotary(axis)) return 0;
    square += distance * distance;
    by_axes = std::max(by_axes, (distance - cut) * slowness[i]);
  }
  const double length = std::sqrt(square), share = remaining(length, cut);
  const bool is_fed = move.feed.mode == gcode::Feed::Mode::units_per_second && share >= 1 - short_share;
  return std::max(by_axes, is_fed ? length / move.feed.value * share : 0);
}

// In X, Y and Z.
double distance_of(const geometry::Point& start, const geometry::Point& end) {
  return numeric::hypot(end[0] - start[0], end[1] - start[1], end[2] - start[2]);
}

// What a path beside the move is long at least: an arc on its inner side, the chord of a curve.
double least_length(const gcode::Move& move, double length) {
  if (move.kind != gcode::Move::Kind::arc) return distance_of(move.start, move.end);
  const double radius = numeric::hypot(move.start[base::index(gcode::first_axis(move.plane))] - move.center_first,
                                       move.start[base::index(gcode::second_axis(move.plane))] - move.center_second);
  return length * remaining(radius, cut_off(move));
}

}  // namespace

QuickSurvey::QuickSurvey(base::Borrowed<machine::Machine> machine, const geometry::Point& start)
    : Survey(start), machine_(*machine), constraints_(machine_), feeds_(constraints_) {
  for (const base::Axis axis : base::all_axes) {
    if (machine_.has(axis)) slowness_[base::index(axis)] = 1 / constraints_.of_axis(axis).velocity;
  }
}

std::optional<FeedExcess> QuickSurvey::observe(const gcode::Move& move) {
  const bool rests = move.kind == gcode::Move::Kind::dwell || move.kind == gcode::Move::Kind::event;
  if (move.kind == gcode::Move::Kind::event && base::is_in_step(move.event.kind)) is_in_step_ = move.event.value > 0;
  if (machine_.threads_follow() && !rests && (move.feed.per_revolution > 0 || is_in_step_)) {
    const std::optional<FeedExcess> excess = move.is_of_tip ? std::nullopt : feeds_.observe(move);
    gcode::Move fastest = move;
    fastest.feed.per_revolution = 0;
    fastest.feed.value = std::numeric_limits<double>::infinity();
    observe_move(fastest);
    return excess;
  }
  return observe_move(move);
}

std::optional<FeedExcess> QuickSurvey::observe_move(const gcode::Move& move) {
  const bool rests = move.kind == gcode::Move::Kind::dwell || move.kind == gcode::Move::Kind::event;
  if (move.is_of_tip && !rests) {
    observe_tip(move);
    return std::nullopt;
  }
  switch (move.kind) {
    case gcode::Move::Kind::line:
      return observe_line(move);
    case gcode::Move::Kind::dwell:
      end_chain();
      seconds_ += move.dwell_seconds;
      return std::nullopt;
    case gcode::Move::Kind::event:
      return std::nullopt;
    default:
      return observe_curve(move);
  }
}

// Where the axes go, of which no more is known than that; of the time, what rotary axes and feed take.
void QuickSurvey::observe_tip(const gcode::Move& move) {
  end_chain();
  const auto& transformation = transformations_.of(move, &machine_);
  const double cut = cut_off(move);
  double by_axes = 0;
  const double angle_cut = angle_cut_off(move);
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    const double distance = std::fabs(move.end[i] - move.start[i]) - (base::is_rotary(axis) ? angle_cut : cut);
    if (i >= 3) by_axes = std::max(by_axes, distance * slowness_[i]);
  }
  for (toolpath::Piece& piece : toolpath::pieces_of(move, {}, toolpath::tables_for_times)) {
    piece.transformation = transformation;
    toolpath::widen(piece, machine_.axis_set(), least_, greatest_);
  }
  const double length = distance_of(move.start, move.end);
  double by_feed = 0;
  if (length > 0 && move.feed.mode != gcode::Feed::Mode::rapid) {
    const bool is_by_time = move.feed.mode == gcode::Feed::Mode::per_second;
    by_feed = (is_by_time ? 1 : length) / move.feed.value * remaining(length, cut);
  }
  seconds_ += std::max({by_axes, by_feed, angle_time(move, slowness_)});
}

// What is cut off a blended line's ends is told of X, Y and Z; of rotary axes beside them, only where none is.
std::optional<FeedExcess> QuickSurvey::observe_line(const gcode::Move& move) {
  const double cut = cut_off(move);
  double by_axes = 0, uncut = 0, square = 0;
  for (std::size_t i = 0; i < base::axis_count; ++i) {
    const double distance = std::fabs(move.end[i] - move.start[i]);
    least_[i] = std::min(least_[i], move.end[i]);
    greatest_[i] = std::max(greatest_[i], move.end[i]);
    uncut = std::max(uncut, distance * slowness_[i]);
    if (i < 3 || cut == 0) by_axes = std::max(by_axes, (distance - cut) * slowness_[i]);
    square += i < 3 ? distance * distance : 0;
  }
  if (move.feed.mode == gcode::Feed::Mode::rapid || square == 0) {
    end_chain();
    seconds_ += std::max(by_axes, angle_time(move, slowness_));
    return move.feed.mode == gcode::Feed::Mode::rapid ? std::nullopt : feeds_.observe(move);
  }
  const double length = std::sqrt(square);
  const bool by_time = move.feed.mode == gcode::Feed::Mode::per_second;
  const double by_feed = by_time ? 1 / move.feed.value : length / move.feed.value;
  const double share = remaining(length, cut);
  if (!by_time && share < 1 - short_share) {
    chain_on(move);
  } else {
    end_chain();
    seconds_ += std::max(by_feed * share, by_axes);
  }
  return by_time || uncut > by_feed ? feeds_.observe(move) : std::nullopt;
}

void QuickSurvey::chain_on(const gcode::Move& move) {
  if (chain_.feed == 0) chain_.start = move.start;
  chain_.end = move.end;
  chain_.feed = std::max(chain_.feed, move.feed.value);
  chain_.cut = std::max(chain_.cut, cut_off(move));
  if (distance_of(chain_.start, chain_.end) * short_share > chain_.cut) end_chain();
}

void QuickSurvey::end_chain() {
  if (chain_.feed == 0) return;
  const double length = distance_of(chain_.start, chain_.end);
  seconds_ += length / chain_.feed * remaining(length, chain_.cut);
  chain_ = {};
}

std::optional<FeedExcess> QuickSurvey::observe_curve(const gcode::Move& move) {
  end_chain();
  for (const toolpath::Piece& piece : toolpath::pieces_of(move, {}, toolpath::tables_for_times)) {
    toolpath::widen(piece, machine_.axis_set(), least_, greatest_);
  }
  const double length = toolpath::feed_length(move);
  if (move.feed.mode == gcode::Feed::Mode::units_per_second) {
    const double least = std::min(length, least_length(move, length));
    seconds_ += least / move.feed.value * remaining(least, cut_off(move));
  }
  return feeds_.observe(move);
}

}  // namespace leadscrew::pipeline
