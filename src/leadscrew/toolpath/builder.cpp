#include <algorithm>
#include <cmath>
#include <leadscrew/toolpath/builder.hpp>
#include <leadscrew/toolpath/event_marks.hpp>
#include <leadscrew/toolpath/leg.hpp>
#include <leadscrew/toolpath/tolerance_space.hpp>
#include <limits>
#include <utility>

namespace leadscrew::toolpath {

namespace {

constexpr double most_of_speed = 1.6;  // S over that for which feeds per revolution are planned, either way
constexpr double most_stretched = 64;  // space of tolerances, either way

double feed_of(const gcode::Move& move) {
  switch (move.feed.mode) {
    case gcode::Feed::Mode::units_per_second:
      return move.feed.value;
    case gcode::Feed::Mode::per_second:
      return move.feed.value * feed_length(move);
    case gcode::Feed::Mode::rapid:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

bool stands(const geometry::Curve& curve) {
  const auto* line = std::get_if<geometry::Line>(&curve);
  return line && line->start() == line->end();
}

/// Where control of the tip begins or ends, its place is computed anew, and a program that tells it once more asks for a move of
/// some units in the last place of the axes: as good as none.
bool is_of_rounding(const gcode::Move& move, const kinematics::Transformation* transformation) {
  if (!transformation || move.kind != gcode::Move::Kind::line) return false;
  double greatest = 0, farthest = 0;
  for (std::size_t i = 0; i < move.start.size(); ++i) {
    greatest = std::max(greatest, std::abs(move.start[i]));
    farthest = std::max(farthest, std::abs(move.end[i] - move.start[i]));
  }
  if (farthest > 1e-9) return false;
  for (const double axis : transformation->axes_of(move.start)) greatest = std::max(greatest, std::abs(axis));
  return farthest <= 8 * std::numeric_limits<double>::epsilon() * greatest;
}

}  // namespace

/// A racing line uses all of the tolerance, and acceleration: it leaves nothing for chords between words.
Builder::Builder(base::Borrowed<machine::Machine> machine, const geometry::MapTolerance& tables)
    : machine_(&*machine),
      sampling_(*machine),
      tables_(tables),
      seeks_least_time_(machine->smoothing == machine::Smoothing::least_time && !sampling_.needs_share()) {}

void Builder::push(const gcode::Move& move) {
  change_transformation(move);
  switch (move.kind) {
    case gcode::Move::Kind::dwell:
      return rest(move.start, move.dwell_seconds, move.line);
    case gcode::Move::Kind::event:
      if (!move.event.waits) {
        passed_.push_back({0, move.event});
        return;
      }
      flush();
      settle_events(move.event.kind != base::Event::Kind::program_end);
      settled_.emplace_back(move.event);
      // What follows may depend on what the input is: the event comes out before it is known.
      if (base::is_input(move.event.kind)) settled_.emplace_back(Dwell{move.start, 0, move.line});
      return;
    default:
      if (move.is_probing()) rest(move.start, 0, move.line);
      move_along(move);
      if (move.is_probing()) rest(move.end, 0, move.line);
  }
}

void Builder::rest(const base::AxisVector& place, double seconds, base::Line line) {
  flush();
  settle_events(true);
  settled_.emplace_back(Dwell{transformation_ ? transformation_->axes_of(place) : place, seconds, line});
}

/// Motion rests where coordinates begin to mean something else.
void Builder::change_transformation(const gcode::Move& move) {
  const auto& of_move = transformations_.of(move, machine_);
  if (of_move == transformation_) return;
  flush();
  transformation_ = of_move;
  space_.reset();
}

/// Of both rotary axes together, degrees: what keeps the tool's direction within E.
double Builder::turning_allowed(const gcode::Move& move) const {
  return move.orientation_tolerance / kinematics::most_turned(transformation_->chain);
}

/// A degree counts as P/E mm, as the first move of the tip has them that is rounded. Later ones with others are rounded in the
/// same space, so that motion need not rest.
void Builder::take_space(const gcode::Move& move) {
  const bool is_rounded = move.path_mode == gcode::PathMode::blend && move.tolerance >= least_tolerance;
  if (space_ || !transformation_ || !is_rounded || !(move.orientation_tolerance > 0)) return;
  const ToleranceSpace usual;
  const double greatest = most_stretched * usual.millimetres_per_degree,
               least = usual.millimetres_per_degree / most_stretched;
  flush();
  space_ = {std::clamp(move.tolerance / turning_allowed(move), least, greatest)};
}

/// Of the tip no more of P than what keeps its direction within E where rotary axes turn: no coordinate is farther off than
/// all are together.
Allowance Builder::allowance_of(const gcode::Move& move, const Piece& piece) const {
  Allowance allowance{move.tolerance, move.naive_cam_tolerance};
  if (!transformation_) return allowance;
  const base::AxisSet moving = geometry::moving(piece.curve);
  for (const kinematics::Turn& turn : transformation_->chain.turns()) {
    if (!moving.contains(turn.axis)) continue;
    const double turned = turning_allowed(move) * space_.value_or(ToleranceSpace{}).millimetres_per_unit(turn.axis);
    allowance = lesser(allowance, {turned, turned});
  }
  return allowance;
}

void Builder::move_along(const gcode::Move& move) {
  take_space(move);
  if (told_speed_) take_revolutions(move);
  const ToleranceSpace space = space_.value_or(ToleranceSpace{});
  std::vector<Piece> pieces;
  if (!is_of_rounding(move, transformation_.get())) pieces = pieces_of(move, space);
  const bool is_per_revolution = told_speed_ && move.feed.per_revolution > 0;
  const double feed = pieces.empty() ? 0 : is_per_revolution ? *told_speed_ * move.feed.per_revolution : feed_of(move);
  for (Piece& piece : pieces) piece.feed = feed;
  if (!pieces.empty()) note_feed(move.line, feed);
  if (told_tool_ && !pieces.empty()) note_tool(move);
  if (!pieces.empty()) set_events(pieces.front(), std::exchange(passed_, {}));
  const bool blends = move.path_mode == gcode::PathMode::blend && move.tolerance >= least_tolerance &&
                      move.curve.contact.empty();  // whose feed is told along the curve as it is
  if (!blends) flush();
  if (!blends || pieces.empty()) {
    for (Piece& piece : pieces) settle_piece(std::move(piece));
  } else {
    for (Piece& piece : pieces) {
      const Allowance allowance = allowance_of(move, piece);
      if (allowance.tolerance < least_tolerance) {
        flush();
        settle_piece(std::move(piece));
        continue;
      }
      const auto events = events_of(piece);
      blend(Leg{std::move(piece.curve),
                feed,
                move.line,
                {},
                0,
                piece.feed_axes,
                allowance,
                {events.begin(), events.end()},
                space});
    }
  }
  if (move.path_mode != gcode::PathMode::exact_stop || pieces.empty()) return;
  std::get<Piece>(settled_.back()).stop = true;
}

/// Motion comes to rest between legs of one kind and of the other: behind one that no racing line takes, splines go on.
void Builder::blend(Leg leg) {
  if (seeks_least_time_ && !transformation_ && !smoother_ && RacingLine::takes(leg)) {
    if (!racing_line_) racing_line_.emplace(*machine_);
    racing_line_->push(std::move(leg));
  } else {
    settle(racing_line_);
    if (!smoother_) smoother_.emplace(sampling_, tables_, leg.space);
    smoother_->push(std::move(leg));
  }
}

template <class Blending>
void Builder::settle(std::optional<Blending>& blending) {
  if (!blending) return;
  blending->finish();
  take_settled(blending);
  for (const EventMark& mark : blending->events_at_end()) settled_.emplace_back(mark.event);
  blending.reset();
}

template <class Blending>
void Builder::take_settled(std::optional<Blending>& blending) {
  if (!blending) return;
  while (std::optional<Piece> piece = blending->pop()) settle_piece(std::move(*piece));
}

/// Where no rotary axis turns, a curve of the tip is one of the axes. Of what corners leave of a move that is hardly one, the axes
/// may round to none.
void Builder::settle_piece(Piece piece) {
  piece.is_of_tip = transformation_ != nullptr;
  if (transformation_) {
    auto curve = piece.feed_axes == FeedAxes::contact ? std::nullopt : standing_curve(*transformation_, piece.curve);
    if (curve) {
      if (stands(*curve)) {
        for (const EventMark& mark : events_of(piece)) passed_.push_back({0, mark.event});
        return;
      }
      piece.curve = std::move(*curve);
    } else {
      piece.transformation = transformation_;
    }
  }
  settled_.emplace_back(std::move(piece));
}

/// Where the next move begins.
void Builder::note_feed(base::Line line, double feed) {
  const double told = std::isfinite(feed) ? feed : 0;
  if (!told_feed_ || *told_feed_ == told) return;
  told_feed_ = told;
  passed_.push_back({0, {base::Event::Kind::programmed_feed, told, line, 0, false}});
}

/// Motion rests where feeds per revolution begin and end; rapid motion between them is of either. All between are planned for
/// one speed, so that motion goes on smoothly while the spindle takes up another S, as long as the factor of it leaves room.
void Builder::take_revolutions(const gcode::Move& move) {
  if (move.feed.mode == gcode::Feed::Mode::rapid) return;
  const double each = move.feed.per_revolution, speed = each > 0 ? move.feed.value / each : 0;
  if (speed > 0 ? speed <= most_of_speed * *told_speed_ && *told_speed_ <= most_of_speed * speed : *told_speed_ == 0)
    return;
  flush();
  told_speed_ = speed;
  settle_events(true);
  settled_.emplace_back(base::Event{base::Event::Kind::feed_per_revolution, speed, move.line, 0, true});
}

/// Likewise.
void Builder::note_tool(const gcode::Move& move) {
  using Kind = base::Event::Kind;
  for (std::size_t i = 0; i < move.tool.size(); ++i) {
    if (told_tool_->offset[i] == move.tool[i]) continue;
    passed_.push_back({0, {Kind::tool_offset, move.tool[i], move.line, static_cast<std::int32_t>(i), false}});
  }
  if (told_tool_->is_of_tip != move.is_of_tip)
    passed_.push_back({0, {Kind::tip_control, move.is_of_tip ? 1.0 : 0.0, move.line, 0, false}});
  told_tool_ = {move.tool, move.is_of_tip};
}

/// What follows cannot change what was pushed so far.
void Builder::flush() {
  settle(racing_line_);
  settle(smoother_);
}

void Builder::finish() {
  flush();
  settle_events(false);
}

/// Motion rests here: what was to be passed stands by itself, but for what is to happen as motion begins again.
void Builder::settle_events(bool motion_follows) {
  std::vector<EventMark> kept;
  for (const EventMark& mark : passed_) {
    if (motion_follows && base::is_with_motion(mark.event.kind)) {
      kept.push_back(mark);
    } else {
      settled_.emplace_back(mark.event);
    }
  }
  passed_ = std::move(kept);
}

std::optional<Element> Builder::pop() {
  if (settled_.empty()) {
    take_settled(racing_line_);
    take_settled(smoother_);
  }
  std::optional<Element> element;
  if (settled_.empty()) return element;
  element.emplace(std::move(settled_.front()));
  settled_.pop_front();
  return element;
}

}  // namespace leadscrew::toolpath
