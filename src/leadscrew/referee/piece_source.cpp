#include <algorithm>
#include <leadscrew/referee/piece_source.hpp>
#include <limits>
#include <numbers>

namespace leadscrew::referee {

namespace {

double distance_over(FeedAxes axes, const base::AxisVector& a, const base::AxisVector& b) {
  double sum = 0;
  for (const base::Axis axis : axes_of(axes)) {
    const double step = b[base::index(axis)] - a[base::index(axis)];
    sum += step * step;
  }
  return std::sqrt(sum);
}

/// Whether the block moves in these axes.
bool moves_in(FeedAxes axes, const gcode::Move& move, Piece::Kind kind) {
  if (kind != Piece::Kind::curve) return distance_over(axes, move.start, move.end) > 0;
  const std::vector<gcode::ControlPoint>& points = move.curve.points;
  return std::any_of(points.begin(), points.end(), [&](const gcode::ControlPoint& point) {
    return distance_over(axes, points.front().position, point.position) > 0;
  });
}

FeedAxes feed_axes_of(const gcode::Move& move, Piece::Kind kind) {
  if (kind == Piece::Kind::arc || moves_in(FeedAxes::xyz, move, kind)) return FeedAxes::xyz;
  return moves_in(FeedAxes::uvw, move, kind) ? FeedAxes::uvw : FeedAxes::abc;
}

/// The ends of an arc in its plane, seen from the centre.
struct ArcEnds {
  double start_first, start_second, end_first, end_second, chord_first, chord_second;

  explicit ArcEnds(const gcode::Move& move) {
    const std::size_t first = base::index(gcode::first_axis(move.plane));
    const std::size_t second = base::index(gcode::second_axis(move.plane));
    start_first = move.start[first] - move.center_first;
    start_second = move.start[second] - move.center_second;
    end_first = move.end[first] - move.center_first;
    end_second = move.end[second] - move.center_second;
    chord_first = move.end[first] - move.start[first];
    chord_second = move.end[second] - move.start[second];
  }

  double start_radius() const { return std::hypot(start_first, start_second); }
  double end_radius() const { return std::hypot(end_first, end_second); }
};

/// Radians turned, positive. Ends closer than the rounding of their coordinates coincide.
double sweep_of(const gcode::Move& move, const ArcEnds& ends) {
  const double whole = 2 * std::numbers::pi * (std::abs(move.turns) - 1);
  const double side = move.turns > 0 ? 1 : -1;
  const double size = ends.start_radius() + std::hypot(move.center_first, move.center_second);
  if (std::hypot(ends.chord_first, ends.chord_second) <= 8 * std::numeric_limits<double>::epsilon() * size) {
    return whole + 2 * std::numbers::pi;
  }
  const double across = side * (ends.start_first * ends.chord_second - ends.start_second * ends.chord_first);
  const double along = ends.start_first * ends.end_first + ends.start_second * ends.end_second;
  const double angle = std::atan2(across, along);
  return whole + (angle > 0 ? angle : angle + 2 * std::numbers::pi);
}

bool turns(const gcode::Move& move) {
  return distance_over(FeedAxes::abc, move.start, move.end) > 0 || moves_in(FeedAxes::abc, move, Piece::Kind::curve);
}

/// mm. Of the tip, where rotary axes turn it: no more than what keeps its direction within the tolerance of that, whatever
/// axis turns.
double tolerance_of(const gcode::Move& move, double per_degree) {
  if (move.path_mode != gcode::PathMode::blend) return 0;
  if (!move.is_of_tip || !turns(move)) return move.tolerance;
  return std::min(move.tolerance, move.orientation_tolerance * per_degree);
}

}  // namespace

double PieceSource::greatest_feed() const {
  return greatest_linear_feed_ > 0 ? greatest_linear_feed_ : greatest_rotary_feed_;
}

/// Length of the block in these axes, mm or degrees.
double PieceSource::length_of(const gcode::Move& move, FeedAxes axes) const {
  if (whole_.kind == Piece::Kind::arc) {
    const std::size_t normal = base::index(gcode::normal_axis(move.plane));
    return std::hypot(whole_.radius * sweep_, move.end[normal] - move.start[normal]);
  }
  if (whole_.kind == Piece::Kind::curve) {
    const double length = curve_.length_in(coordinates_of(metric_, axes));
    return axes == FeedAxes::abc ? length / metric_.per_degree() : length;
  }
  return distance_over(axes, move.start, move.end);
}

ProgrammedFeed PieceSource::feed_of(const gcode::Move& move) const {
  ProgrammedFeed feed;
  feed.axes = feed_axes_of(move, whole_.kind);
  if (threads_follow_ && (is_in_step_ || move.feed.per_revolution > 0)) {
    feed.value = std::numeric_limits<double>::infinity();
    return feed;
  }
  switch (move.feed.mode) {
    case gcode::Feed::Mode::rapid:
      feed.value = std::numeric_limits<double>::infinity();
      break;
    case gcode::Feed::Mode::units_per_second:
      feed.value = move.feed.value;
      feed.is_of_contact = whole_.kind == Piece::Kind::curve && !move.curve.contact.empty();
      break;
    case gcode::Feed::Mode::per_second:
      feed.value = move.feed.value * length_of(move, feed.axes);
      break;
  }
  return feed;
}

void PieceSource::begin(const gcode::Move& move) {
  whole_ = {};
  whole_.line = move.line;
  whole_.block = block_;
  whole_.tool = move.tool;
  whole_.tolerance = tolerance_of(move, metric_.per_degree());
  if (move.is_of_tip && move.path_mode == gcode::PathMode::blend) {
    whole_.orientation_tolerance = move.orientation_tolerance;
    largest_orientation_tolerance_ = std::max(largest_orientation_tolerance_, move.orientation_tolerance);
  }
  whole_.from = metric_.point(move.start);
  whole_.to = metric_.point(move.end);
  if (block_ == 0) {
    start_ = whole_.from;
    start_tolerance_ = whole_.tolerance;
  }
  end_ = whole_.to;
  end_tolerance_ = whole_.tolerance;
  end_line_ = move.line;
  probes_ = move.is_probing();
  ++block_;
  largest_tolerance_ = std::max(largest_tolerance_, whole_.tolerance);
  next_piece_ = 0;
  pieces_ = 0;
  const bool begun = (move.kind == gcode::Move::Kind::arc && begin_arc(move)) ||
                     (move.kind == gcode::Move::Kind::nurbs && begin_curve(move));
  if (!begun) begin_line();
  whole_.feed = feed_of(move);
  if (whole_.feed.value < std::numeric_limits<double>::infinity()) {
    double& greatest = whole_.feed.axes == FeedAxes::abc ? greatest_rotary_feed_ : greatest_linear_feed_;
    greatest = std::max(greatest, whole_.feed.value);
  }
}

void PieceSource::begin_line() {
  const double length = metric_.distance(whole_.from, whole_.to);
  if (!(length > 0)) return;
  whole_.span = length;
  for (std::size_t i = 0; i < metric_.dimensions(); ++i) whole_.slope[i] = (whole_.to[i] - whole_.from[i]) / length;
  pieces_ = 1;
}

bool PieceSource::begin_arc(const gcode::Move& move) {
  const std::size_t first = metric_.coordinate(gcode::first_axis(move.plane));
  const std::size_t second = metric_.coordinate(gcode::second_axis(move.plane));
  const ArcEnds ends(move);
  if (first == metric_.dimensions() || second == metric_.dimensions() || move.turns == 0 ||
      !(ends.start_radius() > 0)) {
    return false;
  }
  whole_.kind = Piece::Kind::arc;
  whole_.first = static_cast<std::uint8_t>(first);
  whole_.second = static_cast<std::uint8_t>(second);
  whole_.center_first = move.center_first;
  whole_.center_second = move.center_second;
  whole_.radial_first = ends.start_first;
  whole_.radial_second = ends.start_second;
  whole_.side = move.turns > 0 ? 1 : -1;
  whole_.radius = ends.start_radius();
  sweep_ = sweep_of(move, ends);
  whole_.radius_slope = (ends.end_radius() - whole_.radius) / sweep_;
  for (std::size_t i = 0; i < metric_.dimensions(); ++i) {
    if (i != first && i != second) whole_.slope[i] = (whole_.to[i] - whole_.from[i]) / sweep_;
  }
  whole_.squared_slope = metric_.dot(whole_.slope, whole_.slope);
  whole_.helix = whole_.squared_slope > 0;
  pieces_ = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(sweep_ / (std::numbers::pi / 2) - 1e-9)));
  return true;
}

bool PieceSource::begin_curve(const gcode::Move& move) {
  if (!curve_.begin(move.curve)) return false;
  whole_.kind = Piece::Kind::curve;
  whole_.span = 1;
  return true;
}

bool PieceSource::read() {
  if (!std::exchange(has_begun_, true)) read_ahead();
  if (!ahead_) return false;
  begin(*ahead_);
  read_ahead();
  return true;
}

/// Up to the next move, so that what stands between is known while words come to the end of this one.
void PieceSource::read_ahead() {
  if (!ahead_) ahead_.emplace();
  while (moves_(*ahead_)) {
    using Kind = gcode::Move::Kind;
    if (ahead_->kind != Kind::dwell && ahead_->kind != Kind::event) {
      if (any_move() && (probes_ || ahead_->is_probing())) stops_.push_back({end_, end_tolerance_, ahead_->line});
      return;
    }
    if (ahead_->kind == Kind::event && base::is_in_step(ahead_->event.kind)) is_in_step_ = ahead_->event.value > 0;
    const bool rests =
        ahead_->kind == Kind::dwell || (ahead_->event.waits && ahead_->event.kind != base::Event::Kind::program_end);
    if (rests && any_move()) stops_.push_back({end_, end_tolerance_, ahead_->line});
  }
  ahead_.reset();
}

void PieceSource::cut_arc(Piece& piece, std::int64_t number) const {
  const double share = sweep_ / static_cast<double>(pieces_);
  const double from = share * static_cast<double>(number);
  piece.angle_before = from;
  piece.span = share;
  if (number > 0) {
    piece.from = point_at(metric_, whole_, from);
    piece.radial_first = piece.from[piece.first] - piece.center_first;
    piece.radial_second = piece.from[piece.second] - piece.center_second;
    piece.radius = std::hypot(piece.radial_first, piece.radial_second);
  }
  if (number + 1 < pieces_) piece.to = point_at(metric_, whole_, share * static_cast<double>(number + 1));
}

bool PieceSource::next_of_block(Piece& piece) {
  if (whole_.kind == Piece::Kind::curve) {
    Bezier segment;
    if (!curve_.next(segment)) return false;
    piece = whole_;
    piece.segment = segment;
    piece.from = point_at(metric_, segment, 0);
    piece.to = point_at(metric_, segment, 1);
    piece.number = next_piece_++;
    piece.feed.value *= curve_.tip_per_contact();
    return true;
  }
  if (next_piece_ == pieces_) return false;
  piece = whole_;
  if (whole_.kind == Piece::Kind::arc) cut_arc(piece, next_piece_);
  ++next_piece_;
  return true;
}

bool PieceSource::next(Piece& piece) {
  while (!next_of_block(piece)) {
    if (!read()) return false;
  }
  piece.serial = serial_++;
  return true;
}

}  // namespace leadscrew::referee
