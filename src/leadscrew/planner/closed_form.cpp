#include <algorithm>
#include <cmath>
#include <leadscrew/numeric/bisection.hpp>
#include <leadscrew/planner/closed_form.hpp>
#include <leadscrew/planner/emission.hpp>
#include <leadscrew/planner/limit_ratios.hpp>
#include <leadscrew/planner/piece_limits.hpp>
#include <leadscrew/planner/speed_change.hpp>
#include <utility>

namespace leadscrew::planner {

namespace {

using base::MotionState;
using numeric::DoubleDouble;

/// To the section's end, of its length: a stop that ends nearer goes on to there, for what it left could not be
/// planned.
constexpr double nearest_rest = 1e-6;

/// Lays phases of constant jerk end to end, in double-double.
class Phases {
 public:
  Phases() = default;
  explicit Phases(const PathState& from) : s_(from.s), v_(from.speed), acceleration_(from.acceleration) {}

  void add(double jerk, double duration, MotionState state) {
    if (duration <= 0) return;
    Segment segment;
    segment.begin = begin_;
    segment.duration = duration;
    segment.s0 = s_;
    segment.v0 = v_;
    segment.c2 = acceleration_ / 2;
    segment.c3 = jerk / 6;
    segment.state = state;
    const DoubleDouble c2 = segment.c2, c3 = segment.c3;
    s_ = s_ + (v_ + (c2 + c3 * duration) * duration) * duration;
    v_ = v_ + (c2 * 2.0 + c3 * 3.0 * duration) * duration;
    acceleration_ += jerk * duration;
    begin_ = begin_ + duration;
    segments_.push_back(segment);
  }
  /// The acceleration that a phase ends with is known; rounding must not leave some of it to the next.
  void acceleration_is(double acceleration) { acceleration_ = acceleration; }
  void add(const SpeedChange& change) {
    for (const auto& [jerk, duration] : change.phases) add(jerk, duration, MotionState::changing);
    acceleration_is(0);
  }

  DoubleDouble distance() const { return s_; }

  /// Rounding has left the distance a few units in the last place off the end: spread that evenly over time. The speed
  /// that this takes goes to the lesser part of v0, so that a motion from rest is seen to begin at speed 0.
  std::vector<Segment> take(double end) {
    const DoubleDouble defect_rate = (DoubleDouble(end) - s_) / begin_;
    for (Segment& segment : segments_) {
      segment.s0 = segment.s0 + defect_rate * segment.begin;
      segment.v0.lo += defect_rate.value();
    }
    return std::move(segments_);
  }

 private:
  std::vector<Segment> segments_;
  DoubleDouble begin_, s_, v_;
  double acceleration_ = 0;
};

std::vector<Segment> laid_out(const RestToRest& motion, double length) {
  const double peak = motion.peak_acceleration(), jerk = motion.jerk;
  Phases phases;
  phases.add(jerk, motion.jerk_time, MotionState::changing);
  phases.acceleration_is(peak);
  phases.add(0, motion.acceleration_time, MotionState::changing);
  phases.add(-jerk, motion.jerk_time, MotionState::changing);
  phases.acceleration_is(0);
  phases.add(0, motion.cruise_time, MotionState::constant);
  phases.add(-jerk, motion.jerk_time, MotionState::changing);
  phases.acceleration_is(-peak);
  phases.add(0, motion.acceleration_time, MotionState::changing);
  phases.add(jerk, motion.jerk_time, MotionState::changing);
  return phases.take(length);
}

/// Is the closed form as good as the optimum? On a line it is the optimum; on an arc through so small an angle, the
/// axes' limits along the path hardly change.
bool has_closed_form(const Section& section) {
  const auto is_line = [&](const toolpath::Piece& piece) {
    // Where feed is counted by some axes only, lines may differ in how fast it lets them be travelled.
    const bool is_alike = piece.feed == section.piece(0).feed && piece.feed_axes == toolpath::FeedAxes::none;
    return piece.axes().line() && (is_alike || section.size() == 1);
  };
  if (std::all_of(section.pieces().begin(), section.pieces().end(), is_line)) return true;
  const geometry::Arc* arc = section.piece(0).axes().arc();
  constexpr double small_angle = 0.02;  // rad
  return section.size() == 1 && arc && std::abs(arc->angle_rate()) * arc->length() < small_angle;
}

/// The section as one piece: its curve is made of curves, so that axes are asked for as of any piece.
toolpath::Piece whole(const Section& section) {
  toolpath::Piece piece = section.piece(0);
  if (section.size() == 1) return piece;
  const toolpath::Piece& last = section.piece(section.size() - 1);
  piece.curve = geometry::Line(geometry::start(piece.curve), geometry::end(last.curve), section.length());
  return piece;
}

DoubleDouble end_of(const Segment& segment) {
  return segment.begin + segment.duration;
}

}  // namespace

std::optional<ClosedForm> ClosedForm::plan(const Section& section, const constraints::Constraints& constraints,
                                           double feed_factor) {
  if (!has_closed_form(section)) return std::nullopt;
  ClosedForm form(section, constraints);
  form.factor_ = feed_factor;
  toolpath::Piece piece = whole(section);
  piece.feed *= feed_factor;
  const RestToRest motion = plan_piece(piece, constraints);
  const geometry::Line* line = piece.axes().line();
  // On an arc those of its motion, which is proven for them; a change is looked at before it is made.
  form.limits_ = line
                     ? line_limits(*line, constraints)
                     : machine::Derivatives{motion.peak_speed() / feed_factor, motion.peak_acceleration(), motion.jerk};
  std::vector<Segment> segments = laid_out(motion, section.length());
  if (section.size() == 1) {
    form.motion_ = {std::move(segments), {}, section.length()};
    form.motion_.duration = end_of(form.motion_.segments.back());
    return form;
  }
  auto laid = form.along(std::move(segments), section.length());
  if (!laid) return std::nullopt;
  form.motion_ = std::move(*laid);
  return form;
}

/// Along the pieces from where motion is now. Nothing where lines that are nearly one are not one, or an arc bends too
/// much for it.
std::optional<ClosedForm::Motion> ClosedForm::along(std::vector<Segment> segments, double end) const {
  Motion motion{std::move(segments), {}, end};
  motion.duration = end_of(motion.segments.back());
  const bool is_line = section_.piece(0).axes().line() != nullptr;
  if (section_.size() == 1 && is_line) return motion;
  if (section_.size() > 1) motion.segments = along_pieces(motion.segments, section_, end, 0);
  Chunk all;
  all.pieces.assign(section_.pieces().begin(), section_.pieces().end());
  all.segments = motion.segments;
  constraints::LimitRatios ratios;
  raise_limit_ratios(all, constraints_, ratios);
  if (ratios.greatest() > 1 + 1e-10) return std::nullopt;
  return motion;
}

/// To rest on the way, as soon as the limits allow; nothing where the motion there is comes to rest as soon.
std::optional<ClosedForm::Motion> ClosedForm::stop(const PathState& from) const {
  const SpeedChange stop = change_speed(from.speed, from.acceleration, 0, limits_);
  if (stop.distance >= motion_.end - from.s) return std::nullopt;
  Phases phases(from);
  phases.add(stop);
  const double end = phases.distance().value();
  if (!(from.s < end && end < motion_.end - nearest_rest * section_.length())) return std::nullopt;
  return along(phases.take(end), end);
}

/// On the section, where the last slice ends.
PathState ClosedForm::here() const {
  const auto next = std::find_if(motion_.segments.begin(), motion_.segments.end(),
                                 [&](const Segment& each) { return now_ < end_of(each); });
  PathState state = evaluate(*next, (now_ - next->begin).value());
  state.s += section_.offset(next->piece);
  return state;
}

void ClosedForm::override_feed(double factor) {
  if (factor == factor_ || is_done()) return;
  factor_ = factor;
  const PathState from = here();
  std::optional<Motion> changed = factor > 0 ? change(from) : stop(from);
  if (!changed) return;
  motion_ = std::move(*changed);
  now_ = 0;
}

/// To the speed that is wanted, and from it to rest at the section's end; nothing where what is left is too short for
/// it.
std::optional<ClosedForm::Motion> ClosedForm::change(const PathState& from) const {
  const toolpath::Piece piece = whole(section_);
  const double feed = piece.greatest_speed(0, piece.axes().jets(0)) * factor_;
  const double left = section_.length() - from.s;
  const auto distance = [&](double speed) {
    return change_speed(from.speed, from.acceleration, speed, limits_).distance +
           change_speed(speed, 0, 0, limits_).distance;
  };
  double speed = std::min(limits_.velocity, feed);
  if (distance(speed) > left) {
    if (distance(0) >= left) return std::nullopt;
    speed = numeric::bisect(0, speed, 60, [&](double lower) { return !(distance(lower) > left); }).from;
  }
  Phases phases(from);
  phases.add(change_speed(from.speed, from.acceleration, speed, limits_));
  if (speed > 0) phases.add(0, (left - distance(speed)) / speed, MotionState::constant);
  phases.add(change_speed(speed, 0, 0, limits_));
  return along(phases.take(section_.length()), section_.length());
}

/// The segments that lie at least partly between two times.
std::vector<Segment> ClosedForm::between(DoubleDouble from, DoubleDouble to) const {
  std::vector<Segment> part;
  for (const Segment& segment : motion_.segments) {
    if (from < end_of(segment) && segment.begin < to) part.push_back(segment);
  }
  return part;
}

Chunk ClosedForm::next(double slice) {
  const DoubleDouble from = now_;
  const double from_s = s_;
  const bool is_last = !((motion_.duration - from).value() > 1.5 * slice);
  now_ = is_last ? motion_.duration : from + slice;
  Chunk chunk;
  chunk.begin = from;
  chunk.duration = now_ - from;
  chunk.segments = between(from, now_);
  s_ = is_last ? motion_.end : here().s;
  rest_before_ = rest_;
  rest_ = motion_.end;
  if (!is_last) {
    const PathState end = here();
    if (is_rest(end)) {
      rest_ = s_;  // a hold that is given up in its last phase passes through rest
      chunk.segments.back().duration = now_ - chunk.segments.back().begin;
    } else if (std::optional<Motion> tail = stop(end)) {
      rest_ = tail->end;
      chunk.stop_tail = std::move(tail->segments);
      for (Segment& segment : chunk.stop_tail) segment.begin = segment.begin + now_;
    } else {
      chunk.stop_tail = between(now_, motion_.duration);
    }
  }
  chunk.length = s_ - from_s;
  chunk.tail_length = rest_ - s_;
  place(chunk);
  return chunk;
}

/// On the pieces that the chunk goes along.
void ClosedForm::place(Chunk& chunk) const {
  const std::uint32_t first = chunk.segments.front().piece;
  const std::uint32_t last = (chunk.stop_tail.empty() ? chunk.segments : chunk.stop_tail).back().piece;
  for (std::uint32_t piece = first; piece <= last; ++piece) chunk.pieces.push_back(section_.piece(piece));
  for (std::vector<Segment>* part : {&chunk.segments, &chunk.stop_tail}) {
    for (Segment& segment : *part) segment.piece -= first;
  }
  const toolpath::Piece& piece = section_.piece(last);
  const bool is_at_end = rest_ >= section_.offset(last + 1);
  const double on_piece = is_at_end ? piece.axes().length() : rest_ - section_.offset(last);
  chunk.rest = piece.axes().position(on_piece);
  chunk.rest_line = is_at_end ? piece.last_line() : piece.line_at(on_piece);
}

}  // namespace leadscrew::planner
