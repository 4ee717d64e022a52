#include <cmath>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/numeric/gauss.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/tolerance_space.hpp>

namespace leadscrew::toolpath {

namespace {

using base::Axis;
using base::index;
using geometry::Point;

struct Turn {
  double radius = 0;
  numeric::DoubleDouble sweep;
};

Turn turn(const gcode::Move& move) {
  const std::size_t first = index(gcode::first_axis(move.plane)), second = index(gcode::second_axis(move.plane));
  const double x = move.start[first] - move.center_first, y = move.start[second] - move.center_second;
  return {numeric::hypot(x, y), geometry::sweep_angle(x, y, move.end[first] - move.center_first,
                                                      move.end[second] - move.center_second, move.turns)};
}

double arc_length(const gcode::Move& move, const Turn& turn) {
  const std::size_t normal = index(gcode::normal_axis(move.plane));
  return geometry::Arc::helix_length(turn.radius, turn.sweep, move.end[normal] - move.start[normal]);
}

/// What moves beside X Y Z goes on evenly with them.
double with_others(double length, const gcode::Move& move, const ToleranceSpace& space) {
  Point others = difference(space.to_millimetres(move.end), space.to_millimetres(move.start));
  for (const Axis axis : {Axis::X, Axis::Y, Axis::Z}) others[index(axis)] = 0;
  return numeric::hypot(length, norm(others));
}

std::size_t first_of(FeedAxes axes) {
  return index(axes == FeedAxes::xyz ? Axis::X : axes == FeedAxes::uvw ? Axis::U : Axis::A);
}

geometry::Curve arc(const gcode::Move& move, const Turn& turn, double length) {
  return geometry::Arc(move.start, move.end, index(gcode::first_axis(move.plane)),
                       index(gcode::second_axis(move.plane)), move.center_first, move.center_second, turn.sweep,
                       length);
}

}  // namespace

FeedAxes feed_axes(base::AxisSet moving) {
  for (const FeedAxes axes : {FeedAxes::xyz, FeedAxes::uvw, FeedAxes::abc}) {
    for (std::size_t i = first_of(axes); i < first_of(axes) + 3; ++i) {
      if (moving.contains(base::all_axes[i])) return axes;
    }
  }
  return FeedAxes::none;
}

FeedAxes to_be_named(FeedAxes axes, base::AxisSet moving) {
  if (axes == FeedAxes::abc) return axes;  // in degrees
  for (std::size_t i = first_of(axes); i < first_of(axes) + 3; ++i) moving.erase(base::all_axes[i]);
  return moving.empty() ? FeedAxes::none : axes;
}

double line_length(const Point& start, const Point& end) {
  const FeedAxes axes = feed_axes(geometry::moving(start, end));
  if (axes == FeedAxes::none) return 0;
  const std::size_t i = first_of(axes);
  return numeric::hypot(end[i] - start[i], end[i + 1] - start[i + 1], end[i + 2] - start[i + 2]);
}

double feed_length(const gcode::Move& move) {
  if (move.kind == gcode::Move::Kind::line) return line_length(move.start, move.end);
  if (move.kind == gcode::Move::Kind::arc) return arc_length(move, turn(move));
  double length = 0;
  if (move.kind == gcode::Move::Kind::nurbs) {
    for (const geometry::Nurbs& piece : geometry::smooth_pieces(geometry::form_of(move.curve)))
      length += piece.length();
  }
  return length;
}

std::optional<Piece> straight_piece(const Point& start, const Point& end, FeedAxes axes, const ToleranceSpace& space) {
  const FeedAxes named = to_be_named(axes, geometry::moving(start, end));
  const double length = named == FeedAxes::none ? line_length(start, end)
                                                : distance(space.to_millimetres(start), space.to_millimetres(end));
  if (!(length > 0)) return std::nullopt;
  return Piece{geometry::Line(start, end, length), 0, {}, false, nullptr, named};
}

std::vector<Piece> pieces_of(const gcode::Move& move, const ToleranceSpace& space,
                             const std::optional<geometry::MapTolerance>& told) {
  std::vector<Piece> pieces;
  if (move.kind == gcode::Move::Kind::line) {
    const FeedAxes axes = feed_axes(geometry::moving(move.start, move.end));
    if (std::optional<Piece> piece = straight_piece(move.start, move.end, axes, space))
      pieces.push_back(std::move(*piece));
  } else if (move.kind == gcode::Move::Kind::arc) {
    const Turn turned = turn(move);
    const double around = arc_length(move, turned);
    if (!(around > 0)) return pieces;
    const FeedAxes named = to_be_named(FeedAxes::xyz, geometry::moving(move.start, move.end));
    const double length = named == FeedAxes::none ? around : with_others(around, move, space);
    pieces.push_back({arc(move, turned, length), 0, {}, false, nullptr, named});
  } else if (move.kind == gcode::Move::Kind::nurbs) {
    const geometry::NurbsForm curve = geometry::form_of(move.curve);
    base::AxisSet moving;
    for (const Point& point : curve.points) moving.insert(geometry::moving(curve.points.front(), point));
    const bool is_mixed = to_be_named(feed_axes(moving), moving) != FeedAxes::none;
    const std::optional<Point> weights = is_mixed ? std::optional(space.weights_of_length()) : std::nullopt;
    const auto contact = move.curve.contact.empty() ? nullptr : std::make_shared<const ContactRate>(move.curve);
    const geometry::MapTolerance tables = told.value_or(move.is_of_tip ? tables_for_motion : geometry::MapTolerance{});
    for (const geometry::Nurbs& piece : geometry::smooth_pieces(curve, tables, weights)) {
      const FeedAxes axes = to_be_named(feed_axes(piece.moving()), piece.moving());
      Piece& made = pieces.emplace_back(Piece{piece, 0, {}, false, nullptr, contact ? FeedAxes::contact : axes});
      made.contact = contact;
      if (!contact) made.curve = simplest(piece, space);
    }
  }
  for (Piece& piece : pieces) piece.line = move.line;
  return pieces;
}

geometry::Curve simplest(const geometry::Curve& curve, const ToleranceSpace& space) {
  const auto* const nurbs = std::get_if<geometry::Nurbs>(&curve);
  if (!nurbs || nurbs->moving().size() != 1) return curve;
  const Point &start = nurbs->start(), &end = nurbs->end();
  return geometry::Line(start, end, distance(space.to_millimetres(start), space.to_millimetres(end)));
}

std::vector<geometry::Nurbs> fitted_pieces(const geometry::NurbsForm& form, const geometry::MapTolerance& tables,
                                           const ToleranceSpace& space) {
  return geometry::smooth_pieces(form, tables, space.weights_of_length());
}

double rate(const geometry::PointJet& jet, FeedAxes axes) {
  if (axes == FeedAxes::none) return 1;
  const std::size_t first = first_of(axes);
  return numeric::hypot(jet[first].first, jet[first + 1].first, jet[first + 2].first);
}

numeric::Pair rate(const geometry::PointJetOf<numeric::Pair>& jet, FeedAxes axes) {
  if (axes == FeedAxes::none) return numeric::all<numeric::Pair>(1);
  const std::size_t first = first_of(axes);
  const numeric::Pair x = jet[first].first, y = jet[first + 1].first, z = jet[first + 2].first;
  return numeric::Pair{numeric::hypot(x[0], y[0], z[0]), numeric::hypot(x[1], y[1], z[1])};
}

double rate(const geometry::Curve& curve, double s, FeedAxes axes) {
  if (axes == FeedAxes::none) return 1;
  const auto [x, y, z] = geometry::rates(curve, s, first_of(axes));
  return numeric::hypot(x, y, z);
}

double time_by_feed(const Piece& piece, double from, double to) {
  if (piece.feed_axes == FeedAxes::none || !std::isfinite(piece.feed)) return (to - from) / piece.feed;
  const auto per_length = [&](double s) { return piece.feed_rate(s) / piece.feed; };
  const double middle = (from + to) / 2;
  return numeric::integrate_gauss_8(per_length, from, middle) + numeric::integrate_gauss_8(per_length, middle, to);
}

}  // namespace leadscrew::toolpath
