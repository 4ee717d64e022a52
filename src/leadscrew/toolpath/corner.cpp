#include <algorithm>
#include <leadscrew/toolpath/corner.hpp>
#include <leadscrew/toolpath/tolerance_space.hpp>
#include <limits>
#include <vector>

namespace leadscrew::toolpath {

using geometry::Point;
using geometry::PointJet;

namespace {

constexpr double turned_back = 1.99;  // |t_A − t_B|: from here on a stop is faster than any blend
constexpr std::size_t looks = 33;     // at a blend, and at what it takes the place of
constexpr double shrinking = 0.8;
constexpr int most_tries = 40;

/// What was programmed near the corner, from it on, as far as `length` of the curve and somewhat farther.
struct Programmed {
  std::vector<Point> points;
  std::size_t replaced = 0;  ///< the first so many lie on what the blend takes the place of
};

Programmed programmed(const geometry::Curve& curve, std::span<const Point> polyline, double length, bool at_end) {
  Programmed result;
  if (polyline.empty()) {
    const std::size_t count = std::holds_alternative<geometry::Line>(curve) ? 2 : looks;
    for (std::size_t k = 0; k < count; ++k) {
      const double way = length * static_cast<double>(k) / static_cast<double>(count - 1);
      const double s = at_end ? geometry::length(curve) - way : way;
      result.points.push_back(to_millimetres(geometry::evaluate(curve, s)));
    }
    result.replaced = count;
    return result;
  }
  const auto point = [&](std::size_t i) -> const Point& { return polyline[at_end ? polyline.size() - 1 - i : i]; };
  result.points.push_back(point(0));
  double way = 0;
  for (std::size_t i = 1; i < polyline.size() && way < 1.5 * length; ++i) {
    way += distance(point(i - 1), point(i));
    result.points.push_back(point(i));
    if (way <= length) result.replaced = i + 1;
  }
  return result;
}

double distance_to(const std::vector<Point>& polyline, const Point& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < polyline.size(); ++i)
    least = std::min(least, distance_to_segment(p, polyline[i - 1], polyline[i]));
  return least;
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

Point bezier_point(const geometry::NurbsForm& form, double u) {
  std::vector<Point> p = form.points;
  for (std::size_t n = p.size(); n-- > 1;) {
    for (std::size_t i = 0; i < n; ++i) p[i] = sum(p[i], u, difference(p[i + 1], p[i]));
  }
  return to_millimetres(p[0]);
}

bool is_inside(const Corner& corner, const geometry::NurbsForm& form, double before, double behind, double room) {
  const Programmed there = programmed(corner.before, corner.programmed_before, before, true);
  const Programmed back = programmed(corner.behind, corner.programmed_behind, behind, false);
  std::vector<Point> shape;
  for (std::size_t k = 0; k < looks; ++k)
    shape.push_back(bezier_point(form, static_cast<double>(k) / static_cast<double>(looks - 1)));
  const auto is_near = [&](const Point& p) {
    return std::min(distance_to(there.points, p), distance_to(back.points, p)) <= room;
  };
  if (!std::all_of(shape.begin(), shape.end(), is_near)) return false;
  const auto keeps = [&](const Programmed& way) {
    return std::all_of(way.points.begin(), way.points.begin() + static_cast<std::ptrdiff_t>(way.replaced),
                       [&](const Point& p) { return distance_to(shape, p) <= room; });
  };
  return keeps(there) && keeps(back);
}

}  // namespace

std::optional<Blend> blend(const Corner& corner, double room) {
  const double length_before = geometry::length(corner.before);
  const Point leaving = derivative(geometry::jets(corner.before, length_before), &numeric::Jet::first);
  const Point entering = derivative(geometry::jets(corner.behind, 0), &numeric::Jet::first);
  const double rate_before = norm(leaving), rate_behind = norm(entering);
  if (!(rate_before > 0) || !(rate_behind > 0)) return std::nullopt;
  double apart = 0;
  for (std::size_t i = 0; i < leaving.size(); ++i) {
    const double d = leaving[i] / rate_before - entering[i] / rate_behind;
    apart += d * d;
  }
  apart = std::sqrt(apart);
  if (!(apart > 0) || apart >= turned_back) return std::nullopt;

  const bool lines =
      std::holds_alternative<geometry::Line>(corner.before) && std::holds_alternative<geometry::Line>(corner.behind);
  double d = std::min({8 * room / apart, corner.most_before * rate_before, corner.most_behind * rate_behind});
  const double least = 1e-3 * d;
  for (int k = 0; k < most_tries && d > least; ++k, d *= shrinking) {
    // What would be left of a curve is all of it or enough to be one.
    const double before = std::min(d / rate_before, corner.most_before);
    const double behind = std::min(d / rate_behind, corner.most_behind);
    const geometry::NurbsForm form = form_of(corner, before, behind);
    if (!lines && !is_inside(corner, form, before, behind, room)) continue;
    std::vector<geometry::Nurbs> pieces = geometry::smooth_pieces(form);
    if (pieces.size() != 1) return std::nullopt;
    return Blend{std::move(pieces.front()), before, behind};
  }
  return std::nullopt;
}

}  // namespace leadscrew::toolpath
