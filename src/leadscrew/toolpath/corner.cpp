#include <algorithm>
#include <array>
#include <leadscrew/toolpath/corner.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/frechet.hpp>
#include <leadscrew/toolpath/leg.hpp>
#include <leadscrew/toolpath/swing.hpp>
#include <leadscrew/toolpath/tolerance_space.hpp>
#include <leadscrew/toolpath/tuning.hpp>
#include <utility>
#include <vector>

namespace leadscrew::toolpath {

using geometry::Point;
using geometry::PointJet;

namespace {

using namespace tuning::corner;

/// A curve of length l between the ends of a chord c is no farther from it than √(l² − c²)/2, Fréchet's distance: what
/// is at the share t of the length is at most √(t(1 − t)(l² − c²)) from the place at that share of the chord.
bool is_chord(double length, const Point& a, const Point& b, double allowed) {
  const double chord = distance(a, b);
  return (length - chord) * (length + chord) <= 4 * allowed * allowed;
}

/// Appends points that stand for the curve between two of its lengths, the last one included. rate: mm per length.
void follow(const geometry::Curve& curve, const ToleranceSpace& space, double rate, double from, const Point& a,
            double to, const Point& b, double allowed, int depth, std::vector<Point>& points) {
  if (depth == 0 || is_chord(rate * (to - from) * (1 + table_of_length), a, b, allowed)) {
    points.push_back(b);
    return;
  }
  const double middle = (from + to) / 2;
  const Point place = space.to_millimetres(geometry::evaluate(curve, middle));
  follow(curve, space, rate, from, a, middle, place, allowed, depth - 1, points);
  follow(curve, space, rate, middle, place, to, b, allowed, depth - 1, points);
}

/// What was programmed where the curve is to be replaced, between `from` and `to` of its length, within `allowed` mm of
/// it.
std::vector<Point> programmed(const geometry::Curve& curve, std::span<const Vertex> polyline,
                              const ToleranceSpace& space, double from, double to, double allowed) {
  std::vector<Point> points;
  const auto* const nurbs = std::get_if<geometry::Nurbs>(&curve);
  if (polyline.empty() || !nurbs) {
    const Point a = space.to_millimetres(geometry::evaluate(curve, from)),
                b = space.to_millimetres(geometry::evaluate(curve, to));
    points.push_back(a);
    if (std::holds_alternative<geometry::Line>(curve))
      points.push_back(b);
    else
      follow(curve, space, millimetres_per_length(curve, space), from, a, to, b, allowed, deepest, points);
    return points;
  }
  const double begin = nurbs->parameter(from), end = nurbs->parameter(to);
  const auto between = [&](std::size_t i, double u) {
    const Vertex &a = polyline[i - 1], &b = polyline[i];
    return sum(a.position, (u - a.u) / (b.u - a.u), difference(b.position, a.position));
  };
  for (std::size_t i = 0; i < polyline.size(); ++i) {
    const double u = polyline[i].u, before = i > 0 ? polyline[i - 1].u : u;
    if (i > 0 && before < begin && begin < u) points.push_back(between(i, begin));
    if (u >= begin && u <= end) points.push_back(polyline[i].position);
    if (i > 0 && before < end && end < u) points.push_back(between(i, end));
  }
  return points;
}

/// The quintic Bézier curve with these ends, derivatives by 0 ≤ u ≤ 1.
geometry::NurbsForm quintic(const Point& start, const Point& start_first, const Point& start_second, const Point& end,
                            const Point& end_first, const Point& end_second) {
  geometry::NurbsForm form;
  form.degree = 5;
  form.knots = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1};
  form.weights.assign(6, 1.0);
  form.points.assign(6, start);
  for (std::size_t i = 0; i < start.size(); ++i) {
    form.points[1][i] = start[i] + start_first[i] / 5;
    form.points[2][i] = start[i] + (2 * start_first[i] / 5 + start_second[i] / 20);
    form.points[3][i] = end[i] - (2 * end_first[i] / 5 - end_second[i] / 20);
    form.points[4][i] = end[i] - end_first[i] / 5;
    form.points[5][i] = end[i];
  }
  return form;
}

geometry::NurbsForm form_of(const Corner& corner, double before, double behind) {
  const PointJet a = geometry::jets(corner.before, geometry::length(corner.before) - before),
                 b = geometry::jets(corner.behind, behind);
  Point start{}, start_first{}, start_second{}, end{}, end_first{}, end_second{};
  for (std::size_t i = 0; i < start.size(); ++i) {
    start[i] = a[i].value;
    start_first[i] = 3 * before * a[i].first;
    start_second[i] = 9 * before * before * a[i].second - 6 * before * a[i].first;
    end[i] = b[i].value;
    end_first[i] = 3 * behind * b[i].first;
    end_second[i] = 9 * behind * behind * b[i].second + 6 * behind * b[i].first;
  }
  return quintic(start, start_first, start_second, end, end_first, end_second);
}

using ControlPoints = std::array<Point, 6>;

ControlPoints control_points(const geometry::NurbsForm& form, const ToleranceSpace& space) {
  ControlPoints points;
  std::transform(form.points.begin(), form.points.end(), points.begin(),
                 [&](const Point& point) { return space.to_millimetres(point); });
  return points;
}

/// de Casteljau's algorithm: to the place at u, through the control points of what lies before and behind it.
std::pair<ControlPoints, ControlPoints> split(ControlPoints p, double u) {
  ControlPoints before, behind;
  for (std::size_t r = 0; r < p.size(); ++r) {
    before[r] = p[0];
    behind[p.size() - 1 - r] = p[p.size() - 1 - r];
    for (std::size_t i = 0; i + r + 1 < p.size(); ++i) p[i] = sum(p[i], u, difference(p[i + 1], p[i]));
  }
  return {before, behind};
}

/// The same for the blend, which is no longer than its control polygon.
void follow(const ControlPoints& p, double allowed, int depth, std::vector<Point>& points) {
  double length = 0;
  for (std::size_t i = 1; i < p.size(); ++i) length += distance(p[i - 1], p[i]);
  if (depth == 0 || is_chord(length, p.front(), p.back(), allowed)) {
    points.push_back(p.back());
    return;
  }
  const auto [before, behind] = split(p, 0.5);
  follow(before, allowed, depth - 1, points);
  follow(behind, allowed, depth - 1, points);
}

/// At even steps of the parameter.
std::array<Point, looks> shape_of(const ControlPoints& points) {
  std::array<Point, looks> shape;
  for (std::size_t k = 0; k < looks; ++k)
    shape[k] = split(points, static_cast<double>(k) / static_cast<double>(looks - 1)).second[0];
  return shape;
}

/// Does it turn back nearly on the spot, as the blend of much of two curves may? Motion would all but stop there.
bool turns_back(const std::array<Point, looks>& shape) {
  for (std::size_t k = 2; k < shape.size(); ++k) {
    const Point in = difference(shape[k - 1], shape[k - 2]), out = difference(shape[k], shape[k - 1]);
    if (turn_between(in, out) > sharpest_between_looks) return true;
  }
  return false;
}

bool is_inside(const Corner& corner, const ControlPoints& blend, double before, double behind, double margin) {
  const double length = geometry::length(corner.before), allowed = polyline_share * margin;
  std::vector<Point> path =
      programmed(corner.before, corner.programmed_before, corner.space, length - before, length, allowed);
  const std::vector<Point> rest = programmed(corner.behind, corner.programmed_behind, corner.space, 0, behind, allowed);
  path.insert(path.end(), rest.begin(), rest.end());
  std::vector<Point> shape{blend.front()};
  follow(blend, allowed, deepest, shape);
  return is_frechet_within(path, shape, margin - 2 * allowed);
}

/// What takes the place of these lengths; none if it is not smooth or a detour.
std::optional<Blend> blend_of(const geometry::NurbsForm& form, double before, double behind, double taken_before,
                              double taken_behind, double deviation, const Corner& corner) {
  std::vector<geometry::Nurbs> pieces = fitted_pieces(form, corner.tables, corner.space);
  if (pieces.size() != 1) return std::nullopt;
  if (pieces.front().length() > most_lengthened * (taken_before + taken_behind)) return std::nullopt;
  const double middle = pieces.front().length() * taken_before / (taken_before + taken_behind);
  return Blend{std::move(pieces.front()), before, behind, middle, deviation};
}

/// Of two lines, with the tangents by their lengths; none where there is too little room for one worth it.
std::optional<Blend> swing_wide(const Corner& corner, const PointJet& leaving, const PointJet& entering, double turn,
                                double margin) {
  const double rate_before = norm(corner.space.derivative(leaving, &numeric::Jet<>::first)),
               rate_behind = norm(corner.space.derivative(entering, &numeric::Jet<>::first));
  const Swing swing(turn);
  const double full = swing.reach_within(margin), share = turn > sharp_swing ? share_of_sharp : 1;
  double taken = std::min({full, share * rate_before * corner.most_before, share * rate_behind * corner.most_behind});
  for (const double most : {rate_before * corner.most_before, rate_behind * corner.most_behind}) {
    if (taken > (1 - least_rest) * most && taken < most) taken = (1 - least_rest) * most;
  }
  if (taken < (turn < tuning::corner_turn ? least_swing : least_swing_of_corner) * full) return std::nullopt;
  const auto length = [&](double rate, double most) { return taken == rate * most ? most : taken / rate; };
  const double before = length(rate_before, corner.most_before), behind = length(rate_behind, corner.most_behind);
  geometry::NurbsForm form;
  form.degree = 3;
  form.knots = {0, 0, 0, 0, swing.w(), 1 - swing.w(), 1, 1, 1, 1};
  form.weights.assign(6, 1.0);
  form.points.resize(6);
  const std::array<double, 6> values = swing.control_values();
  const double scale = taken / swing.reach();
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double a = scale / rate_before * values[values.size() - 1 - k], b = scale / rate_behind * values[k];
    for (std::size_t i = 0; i < leaving.size(); ++i)
      form.points[k][i] = entering[i].value - a * leaving[i].first + b * entering[i].first;
  }
  return blend_of(form, before, behind, before * rate_before, behind * rate_behind, scale * swing.deviation(), corner);
}

}  // namespace

std::optional<Blend> blend(const Corner& corner, double margin) {
  const double length_before = geometry::length(corner.before);
  const PointJet before_corner = geometry::jets(corner.before, length_before),
                 behind_corner = geometry::jets(corner.behind, 0);
  const Point leaving = corner.space.derivative(before_corner, &numeric::Jet<>::first);
  const Point entering = corner.space.derivative(behind_corner, &numeric::Jet<>::first);
  const double rate_before = norm(leaving), rate_behind = norm(entering), apart = turn_between(leaving, entering);

  const bool lines =
      std::holds_alternative<geometry::Line>(corner.before) && std::holds_alternative<geometry::Line>(corner.behind);
  if (!(apart < turned_back) || (lines && !(apart > 0))) return std::nullopt;
  if (lines && corner.may_swing) {
    if (std::optional<Blend> found = swing_wide(corner, before_corner, behind_corner, apart, margin)) return found;
  }
  const double provable = lines ? margin : (1 - 2.5 * polyline_share) * margin;
  const double longest = 8 * provable / std::max(apart, 1e-12);  // by the turn; where only curvature steps, by trying
  double d = std::min({longest, corner.most_before * rate_before, corner.most_behind * rate_behind});
  const double least = 1e-3 * d;
  for (int k = 0; k < most_tries && d > least; ++k, d *= shrinking) {
    // Where nearly all that may be taken of a curve is to be taken, all of it is: no short remainder is left.
    const auto share = [&](double rate, double most) {
      return most <= longest / rate && d / rate > nearly_whole * most ? most : d / rate;
    };
    const double before = share(rate_before, corner.most_before), behind = share(rate_behind, corner.most_behind);
    const geometry::NurbsForm form = form_of(corner, before, behind);
    if (!lines) {
      const ControlPoints points = control_points(form, corner.space);
      if (turns_back(shape_of(points)) || !is_inside(corner, points, before, behind, margin)) continue;
    }
    const double taken_before = before * rate_before, taken_behind = behind * rate_behind;
    const double deviation = lines ? std::max(taken_before, taken_behind) * apart / 8 : margin;
    std::optional<Blend> found = blend_of(form, before, behind, taken_before, taken_behind, deviation, corner);
    if (found) return found;
  }
  return std::nullopt;
}

}  // namespace leadscrew::toolpath
