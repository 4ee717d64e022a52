#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <leadscrew/toolpath/corner.hpp>
#include <leadscrew/toolpath/feed_length.hpp>
#include <leadscrew/toolpath/frechet.hpp>
#include <leadscrew/toolpath/swing.hpp>
#include <numbers>

#include "polylines.hpp"

namespace leadscrew::toolpath::testing {
namespace test_corner {

using geometry::Curve;
using numeric::Jet;

/// Which way a curve is to go from the corner: as it is, or as what leads to it.
enum class Side { before, behind };

/// From the corner, in mm, that far in a direction; or to the corner.
Curve line(const Point& corner, const Point& direction, double millimetres, Side side) {
  const Point here = ToleranceSpace{}.from_millimetres(corner);
  const Point away =
      ToleranceSpace{}.from_millimetres(sum(corner, side == Side::before ? -millimetres : millimetres, direction));
  const Point &start = side == Side::before ? away : here, &end = side == Side::before ? here : away;
  return geometry::Line(start, end, line_length(start, end));
}

/// In one of the three planes, of a random radius and sweep, sometimes a helix.
Curve random_arc(const Point& corner, Side side) {
  const std::size_t first = any<std::size_t>(0, 3), second = (first + 1) % 3, normal = (first + 2) % 3;
  const double radius = logarithmic(1, 50), sweep = (any(0, 2) == 0 ? 1 : -1) * uniform(0.2, 4);
  const double rise = any(0, 3) == 0 ? uniform(-10, 10) : 0, angle = uniform(0, 2 * std::numbers::pi);
  const double turn = side == Side::before ? -sweep : sweep;
  const double x = corner[first] + radius * std::cos(angle), y = corner[second] + radius * std::sin(angle);
  Point other = corner;
  other[first] = x - radius * std::cos(angle + turn);
  other[second] = y - radius * std::sin(angle + turn);
  other[normal] += side == Side::before ? -rise : rise;
  const auto [start, end] = side == Side::before ? std::pair{other, corner} : std::pair{corner, other};
  return geometry::Arc(start, end, first, second, x, y, sweep, geometry::Arc::helix_length(radius, sweep, rise));
}

/// A cubic that turns gently.
Curve random_nurbs(const Point& corner, Side side) {
  const double size = logarithmic(1, 10);
  Point direction = random_direction({0, 1, 2});
  geometry::NurbsForm form{3, {0, 0, 0, 0, 1, 1, 1, 1}, {corner}, {1, 1, 1, 1}};
  for (int k = 0; k < 3; ++k) {
    form.points.push_back(sum(form.points.back(), size * uniform(0.5, 1), direction));
    direction = turned(direction, uniform(0, 0.7), {0, 1, 2});
  }
  if (side == Side::before) std::reverse(form.points.begin(), form.points.end());
  return geometry::smooth_pieces(form).at(0);
}

/// One that may turn back round a tip, as long as a blend of that margin reaches.
Curve sharp_nurbs(const Point& corner, double margin, Side side) {
  geometry::NurbsForm form{3, {0, 0, 0, 0, 1, 1, 1, 1}, {corner}, {1, 1, 1, 1}};
  for (int k = 0; k < 3; ++k)
    form.points.push_back(sum(form.points.back(), margin * uniform(0.5, 5), random_direction({0, 1})));
  if (side == Side::before) std::reverse(form.points.begin(), form.points.end());
  const std::vector<geometry::Nurbs> pieces = geometry::smooth_pieces(form);
  return side == Side::before ? pieces.back() : pieces.front();
}

Point random_place() {
  return {uniform(-100, 100), uniform(-100, 100), uniform(-100, 100)};
}

/// The blend may take random parts of both.
Corner corner_of(Curve before, Curve behind) {
  Corner corner{std::move(before), std::move(behind), {}, {}, 0, 0};
  corner.most_before = geometry::length(corner.before) * uniform(0.05, 1);
  corner.most_behind = geometry::length(corner.behind) * uniform(0.05, 1);
  return corner;
}

/// Two or three that feed is counted by, and some of those that go with them.
std::vector<std::size_t> random_axes() {
  static constexpr std::array<std::size_t, 9> by_rank = {0, 1, 2, 6, 7, 8, 3, 4, 5};  // X Y Z, U V W, A B C
  const std::size_t group = 3 * any<std::size_t>(0, 3);
  std::vector<std::size_t> axes{by_rank[group], by_rank[group + 1]};
  for (std::size_t i = group + 2; i < by_rank.size(); ++i) {
    if (any(0, 3) == 0) axes.push_back(by_rank[i]);
  }
  return axes;
}

/// Of the directions in the three axes that feed is counted by.
double turn_of_feed(const Point& one, const Point& other, std::size_t first) {
  Point a{}, b{};
  for (std::size_t i = first; i < first + 3; ++i) a[i] = one[i], b[i] = other[i];
  return std::acos(std::clamp(dot(a, b) / (norm(a) * norm(b)), -1.0, 1.0));
}

/// Lines that turn by an angle, and not all the way back in what feed is counted by.
Corner corner_of_lines(double angle) {
  const std::vector<std::size_t> axes = random_axes();
  const Point place = scaled(uniform(0, 100), random_direction(axes));
  Point in, out;
  do {
    in = random_direction(axes);
    out = turned(in, angle, axes);
  } while (turn_of_feed(in, out, axes[0]) > std::max(angle, 2.9) + 1e-6);
  return corner_of(line(place, in, logarithmic(0.1, 50), Side::before),
                   line(place, out, logarithmic(0.1, 50), Side::behind));
}

double line_length_in_millimetres(const Curve& line) {
  return distance(ToleranceSpace{}.to_millimetres(geometry::start(line)),
                  ToleranceSpace{}.to_millimetres(geometry::end(line)));
}

/// Unit tangent, and the curvature by mm.
struct Bend {
  Point tangent, curvature;
};

Bend bend_at(const Curve& curve, double s) {
  const geometry::PointJet jet = geometry::jets(curve, s);
  const Point first = ToleranceSpace{}.derivative(jet, &Jet<>::first),
              second = ToleranceSpace{}.derivative(jet, &Jet<>::second);
  const double rate = norm(first);
  const Point tangent = scaled(1 / rate, first);
  return {tangent, scaled(1 / (rate * rate), sum(second, -dot(second, tangent), tangent))};
}

bool joins(const Curve& a, double at_a, const Curve& b, double at_b, double length) {
  const Bend one = bend_at(a, at_a), other = bend_at(b, at_b);
  const Point gap = difference(ToleranceSpace{}.to_millimetres(geometry::evaluate(a, at_a)),
                               ToleranceSpace{}.to_millimetres(geometry::evaluate(b, at_b)));
  return norm(gap) <= 1e-12 && distance(one.tangent, other.tangent) <= 1e-6 &&
         distance(one.curvature, other.curvature) <= 1e-6 * (norm(one.curvature) + 1 / length);
}

Polyline places_on(const Curve& curve, double from, double to, int count) {
  Polyline places;
  for (int k = 0; k <= count; ++k)
    places.push_back(ToleranceSpace{}.to_millimetres(geometry::evaluate(curve, from + (to - from) * k / count)));
  return places;
}

/// Evenly by its parameter.
Polyline places_on(const geometry::Nurbs& curve, int count) {
  Polyline places;
  for (int k = 0; k <= count; ++k) {
    const double share = static_cast<double>(k) / count;
    const double u = curve.first_parameter() + share * (curve.last_parameter() - curve.first_parameter());
    places.push_back(ToleranceSpace{}.derivative(curve.jets_at(u), &Jet<>::value));
  }
  return places;
}

/// Is it a blend of that corner that goes no farther than it may?
void check_blend(const Corner& corner, const Blend& blend, double margin) {
  const double length = geometry::length(corner.before);
  RC_ASSERT(blend.before > 0);
  RC_ASSERT(blend.before <= corner.most_before);
  RC_ASSERT(blend.behind > 0);
  RC_ASSERT(blend.behind <= corner.most_behind);
  const Curve curve = blend.curve;
  const double size = blend.curve.length();
  RC_ASSERT(joins(corner.before, length - blend.before, curve, 0, size));
  RC_ASSERT(joins(curve, size, corner.behind, blend.behind, size));
  Polyline legs = places_on(corner.before, length - blend.before, length, 200);
  const Polyline behind = places_on(corner.behind, 0, blend.behind, 200);
  legs.insert(legs.end(), behind.begin() + 1, behind.end());
  const Polyline places = places_on(blend.curve, 200);
  RC_ASSERT(is_frechet_within(legs, places, 1.001 * margin));
}

RC_GTEST_PROP(Blend, OfLinesStaysInTheRoom, ()) {
  const Corner corner = corner_of_lines(uniform(0.01, 2.9));
  const double margin = logarithmic(1e-3, 1);
  const std::optional<Blend> found = blend(corner, margin);
  RC_ASSERT(found);
  check_blend(corner, *found, margin);
}

RC_GTEST_PROP(Blend, OfLinesAndArcsStaysInTheRoom, ()) {
  const Point place = random_place();
  const Curve arc_before = random_arc(place, Side::before), arc_behind = random_arc(place, Side::behind);
  const Point direction = random_direction({0, 1, 2, 3});
  const int kind = any(0, 3);
  const Corner corner = corner_of(kind == 0 ? line(place, direction, logarithmic(0.1, 50), Side::before) : arc_before,
                                  kind == 1 ? line(place, direction, logarithmic(0.1, 50), Side::behind) : arc_behind);
  const double margin = logarithmic(1e-3, 0.1);
  const std::optional<Blend> found = blend(corner, margin);
  RC_CLASSIFY(!found);
  if (found) check_blend(corner, *found, margin);
}

RC_GTEST_PROP(Blend, OfLinesAndArcsThatTurnALittleStaysInTheRoom, ()) {
  const Point place = random_place();
  const Curve arc = random_arc(place, Side::behind);
  const Point direction = turned(bend_at(arc, 0).tangent, logarithmic(1e-3, 1), {0, 1, 2});
  const Corner corner = corner_of(line(place, direction, logarithmic(0.1, 50), Side::before), arc);
  const double margin = logarithmic(1e-3, 0.1);
  const std::optional<Blend> found = blend(corner, margin);
  RC_CLASSIFY(!found);
  if (found) check_blend(corner, *found, margin);
}

RC_GTEST_PROP(Blend, OfNurbsStaysInTheRoom, ()) {
  const Point place = random_place();
  const int kind = any(0, 4);
  const auto other = [&](Side side) {
    return any(0, 2) == 0 ? random_arc(place, side)
                          : line(place, random_direction({0, 1, 2}), logarithmic(0.1, 50), side);
  };
  const Corner corner = corner_of(kind < 2 ? random_nurbs(place, Side::before) : other(Side::before),
                                  kind > 0 ? random_nurbs(place, Side::behind) : other(Side::behind));
  const double margin = logarithmic(1e-3, 0.1);
  const std::optional<Blend> found = blend(corner, margin);
  RC_CLASSIFY(!found);
  if (found) check_blend(corner, *found, margin);
}

/// Even looks need not see a tip.
RC_GTEST_PROP(Blend, OfSharpNurbsStaysInTheRoom, ()) {
  const Point place = random_place();
  const double margin = logarithmic(1e-3, 0.1);
  const Curve other = line(place, random_direction({0, 1}), 10 * margin, Side::behind);
  const Corner corner = corner_of(sharp_nurbs(place, margin, Side::before),
                                  any(0, 2) == 0 ? other : sharp_nurbs(place, margin, Side::behind));
  const std::optional<Blend> found = blend(corner, margin);
  RC_CLASSIFY(!found);
  if (!found) return;
  const double length = geometry::length(corner.before);
  Polyline legs = places_on(corner.before, length - found->before, length, 600);
  const Polyline behind = places_on(corner.behind, 0, found->behind, 600);
  legs.insert(legs.end(), behind.begin() + 1, behind.end());
  // Between places they are no farther than half a step from a curve.
  const double step = (found->before + found->behind) / 600 + found->curve.length() / 300;
  RC_ASSERT(is_frechet_within(legs, places_on(found->curve, 300), margin + step / 2));
}

/// How near the blend passes the corner.
double passes_at(const Corner& corner, const Blend& blend) {
  const Point place = ToleranceSpace{}.to_millimetres(geometry::start(corner.behind));
  double nearest = INFINITY;
  for (const Point& point : places_on(blend.curve, 200)) nearest = std::min(nearest, distance(point, place));
  return nearest;
}

/// How far it goes from either line, up to the corner and behind.
std::pair<double, double> swings_by(const Corner& corner, const Blend& blend) {
  const Point from = ToleranceSpace{}.to_millimetres(geometry::start(corner.before)),
              place = ToleranceSpace{}.to_millimetres(geometry::end(corner.before)),
              to = ToleranceSpace{}.to_millimetres(geometry::end(corner.behind));
  const Polyline places = places_on(blend.curve, 2000);
  std::pair<double, double> farthest;
  for (std::size_t k = 0; k < places.size(); ++k) {
    // Around the corner it is on neither.
    if (k < 700) farthest.first = std::max(farthest.first, distance_to_segment(places[k], from, place));
    if (k > 1300) farthest.second = std::max(farthest.second, distance_to_segment(places[k], place, to));
  }
  return farthest;
}

Corner corner_of_whole_lines(double angle) {
  Corner corner = corner_of_lines(angle);
  corner.most_before = geometry::length(corner.before);
  corner.most_behind = geometry::length(corner.behind);
  return corner;
}

RC_GTEST_PROP(Blend, OfLongLinesUsesTheToleranceThreeTimes, ()) {
  const Corner corner = corner_of_whole_lines(uniform(0.3, 2.9));
  const double margin = 1e-4;
  const std::optional<Blend> found = blend(corner, margin);
  RC_ASSERT(found);
  const auto [before, behind] = swings_by(corner, *found);
  RC_ASSERT(std::abs(passes_at(corner, *found) - margin) <= 1e-6 * margin);
  RC_ASSERT(std::abs(before - margin) <= 1e-4 * margin);
  RC_ASSERT(std::abs(behind - margin) <= 1e-4 * margin);
}

RC_GTEST_PROP(Blend, OfShortLinesOnlyCutsTheCorner, ()) {
  const double margin = 1e-4, angle = uniform(0.3, 2.9);
  Corner corner = corner_of_whole_lines(angle);
  // A third of what a blend that swings wide takes, in the lengths of either line.
  const double room = Swing(2 * std::sin(angle / 2)).reach_within(margin) / 3;
  corner.most_before = room * corner.most_before / line_length_in_millimetres(corner.before);
  corner.most_behind = room * corner.most_behind / line_length_in_millimetres(corner.behind);
  const std::optional<Blend> found = blend(corner, margin);
  RC_ASSERT(found);
  RC_ASSERT(std::abs(passes_at(corner, *found) - margin) <= 1e-6 * margin);
  const auto [before, behind] = swings_by(corner, *found);
  RC_ASSERT(before <= 0.75 * margin);
  RC_ASSERT(behind <= 0.75 * margin);
}

RC_GTEST_PROP(Blend, IsNoneWhereLinesTurnBack, ()) {
  RC_ASSERT(!blend(corner_of_lines(uniform(2.95, std::numbers::pi)), logarithmic(1e-3, 1)));
}

RC_GTEST_PROP(Blend, IsNoneWhereCurvesTurnBack, ()) {
  const Point place = random_place();
  const Curve behind = any(0, 2) == 0 ? random_arc(place, Side::behind) : random_nurbs(place, Side::behind);
  const Point back = turned(scaled(-1, bend_at(behind, 0).tangent), uniform(0, 0.19), {0, 1, 2});
  RC_ASSERT(!blend(corner_of(line(place, back, 10, Side::before), behind), logarithmic(1e-3, 1)));
}

TEST(Blend, IsNoneWhereLinesGoStraightOn) {
  const Curve before = line({0, 0}, {1, 0}, 10, Side::before), behind = line({0, 0}, {1, 0}, 10, Side::behind);
  EXPECT_FALSE(blend({before, behind, {}, {}, 5, 5}, 0.01));
}

}  // namespace test_corner
}  // namespace leadscrew::toolpath::testing
