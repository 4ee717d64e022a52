// The nearest point of an arc, a helix or a segment of a curve is the nearest there is; lengths and bounds of segments
// hold.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <leadscrew/referee/piece_source.hpp>

#include "curves.hpp"

namespace leadscrew::referee::test {
namespace test_nearest {

RC_GTEST_PROP(Nearest, NothingOnThePieceIsNearer, (std::uint64_t seed)) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const machine::Machine machine = five_axes();
  const Metric metric(machine);
  const double radius = std::exp(uniform(-2, 4));
  const double pitch = *rc::gen::element(0.0, 0.1, 3.0, 100.0);
  Program program;
  at(program.position, Axis::X) = radius;
  AxisVector end = program.position;
  at(end, Axis::Z) = uniform(-pitch, pitch);
  at(end, Axis::C) = uniform(-pitch, pitch);
  program.arc(end, gcode::Plane::XY, 0, 0, *rc::gen::element(-2, -1, 1, 3));
  PieceSource source(source_of(program.moves), metric, false);
  Piece piece;
  while (source.next(piece)) {
    Point point = point_at(metric, piece, uniform(0, piece.span));
    for (std::size_t i = 0; i < metric.dimensions(); ++i) point[i] += uniform(-0.3, 0.3) * radius;
    const Nearest nearest = nearest_on(metric, piece, point);
    RC_ASSERT(nearest.place >= 0 && nearest.place <= piece.span);
    const double there = metric.distance(point, point_at(metric, piece, nearest.place));
    RC_ASSERT(std::abs(there - nearest.distance) <= 1e-12 * (1 + radius));
    for (int i = 0; i <= 1000; ++i) {
      const double other = metric.distance(point, point_at(metric, piece, piece.span * i / 1000));
      RC_ASSERT(nearest.distance <= other + 1e-9 * radius);
    }
  }
}

NurbsCurve any_curve(std::mt19937_64& random) {
  const int degree = *rc::gen::inRange(1, 6);
  return random_curve(random, degree, *rc::gen::inRange(degree + 1, degree + 7), *rc::gen::element(0.1, 20.0), 100);
}

RC_GTEST_PROP(CurvePieces, FollowOneAnotherTurnLittleAndHaveOneNearestPoint, (std::uint64_t seed)) {
  std::mt19937_64 random(seed);
  const machine::Machine machine = five_axes();
  const Metric metric(machine);
  const Program program = program_of(any_curve(random));
  PieceSource source(source_of(program.moves), metric, false);
  Piece piece;
  Point end = metric.point(program.moves[0].start);
  while (source.next(piece)) {
    RC_ASSERT(metric.distance(piece.from, end) <= 1e-11);
    end = piece.to;
    double longest = 0;  // shorter than a thousandth of a nanometre, a piece is as good as a point
    for (int i = 0; i <= 50; ++i) {
      longest = std::max(longest, metric.distance(piece.from, point_at(metric, piece, i / 50.0)));
    }
    Point before = piece.from;
    Point direction{};
    for (int i = 1; i <= 50; ++i) {
      const Point here = point_at(metric, piece, i / 50.0);
      Point step{};
      for (std::size_t k = 0; k < metric.dimensions(); ++k) step[k] = here[k] - before[k];
      const double squared = metric.dot(step, step);
      if (squared > 1e-18 && metric.dot(direction, direction) > 1e-18) {
        const double cosine = metric.dot(step, direction) / std::sqrt(squared * metric.dot(direction, direction));
        RC_ASSERT(cosine >= std::sqrt(0.5) - 1e-3);
      }
      if (i == 1) direction = step;
      before = here;
      const Nearest nearest = nearest_on(metric, piece, here);
      RC_ASSERT(nearest.distance <= 1e-11 || longest <= 1e-9);
      const double away = metric.distance(point_at(metric, piece, nearest.place), here);
      RC_ASSERT(std::abs(away - nearest.distance) <= 1e-15);
    }
  }
  RC_ASSERT(metric.distance(end, metric.point(program.moves[0].end)) <= 1e-11);
}

RC_GTEST_PROP(CurvePieces, NothingOnThePieceIsNearer, (std::uint64_t seed)) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const machine::Machine machine = five_axes();
  const Metric metric(machine);
  const Program program = program_of(any_curve(random));
  PieceSource source(source_of(program.moves), metric, false);
  Piece piece;
  while (source.next(piece)) {
    const double size = metric.distance(piece.from, piece.to);
    Point point = point_at(metric, piece, uniform(0, 1));
    for (std::size_t i = 0; i < metric.dimensions(); ++i) point[i] += uniform(-0.05, 0.05) * size;
    const Nearest nearest = nearest_on(metric, piece, point);
    RC_ASSERT(nearest.place >= 0 && nearest.place <= piece.span);
    for (int i = 0; i <= 1000; ++i) {
      RC_ASSERT(nearest.distance <= metric.distance(point, point_at(metric, piece, i / 1000.0)) + 1e-9 * size + 1e-9);
    }
  }
}

RC_GTEST_PROP(CurvePieces, TheFarthestFromAChordIsTheLargestThereIs, (std::uint64_t seed)) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const machine::Machine machine = five_axes();
  const Metric metric(machine);
  const Program program = program_of(any_curve(random));
  PieceSource source(source_of(program.moves), metric, false);
  Piece piece;
  while (source.next(piece)) {
    const double from = uniform(0, 0.5), to = uniform(0.5, 1);
    const double size = metric.distance(piece.from, piece.to) * uniform(0, 1);
    Point begin = piece.from, end = piece.to;
    for (std::size_t i = 0; i < metric.dimensions(); ++i) begin[i] += uniform(-0.1, 0.1) * size;
    for (std::size_t i = 0; i < metric.dimensions(); ++i) end[i] += uniform(-0.1, 0.1) * size;
    const Chord chord = chord_between(metric, begin, end);
    double largest = 0;
    for (int i = 0; i <= 2000; ++i) {
      const Point point = point_at(metric, piece, from + (to - from) * i / 2000);
      largest = std::max(largest, distance_to_chord(metric, chord, point));
    }
    const double farthest = farthest_from_chord(metric, piece, from, to, chord, 0, 0);
    RC_ASSERT(farthest >= largest - 2e-9);
    RC_ASSERT(farthest <= largest + 1e-4 * size + 1e-9);
    RC_ASSERT(farthest_from_chord(metric, piece, from, to, chord, 0, 1.5 * largest + 1e-9) <= 1.5 * largest + 1e-9);
  }
}

/// Chords in the arc's plane, beside it and across it; of arcs and of helices.
RC_GTEST_PROP(ArcPieces, TheFarthestFromAChordIsTheLargestThereIs, (std::uint64_t seed)) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const machine::Machine machine = five_axes();
  const Metric metric(machine);
  const double radius = std::exp(uniform(-6, 4));
  Program program;
  at(program.position, Axis::X) = radius;
  AxisVector end_of_arc = program.position;
  at(end_of_arc, Axis::Z) = *rc::gen::element(0.0, 0.0, 0.5) * radius;
  program.arc(end_of_arc, gcode::Plane::XY, 0, 0, *rc::gen::element(-2, -1, 1, 3));
  const double aside = *rc::gen::element(0.0, 0.1, 2.0) * radius, across = *rc::gen::element(0.0, 0.0, 0.2) * radius;
  const std::size_t z = metric.coordinate(Axis::Z);
  PieceSource source(source_of(program.moves), metric, false);
  Piece piece;
  while (source.next(piece)) {
    const double from = uniform(-0.5, 0.5) * piece.span, to = uniform(0.5, 1.5) * piece.span;
    const double begin_of_part = std::max(from, 0.0), end_of_part = std::min(to, piece.span);
    Point begin = piece.from;
    for (std::size_t i = 0; i < 2; ++i) begin[i] = uniform(-2, 2) * radius;
    Point end = begin;
    for (std::size_t i = 0; i < 2; ++i) end[i] += *rc::gen::element(0.0, 1e-3, 1.0) * uniform(-1, 1) * radius;
    begin[z] += aside;
    end[z] += aside + across;
    const Chord chord = chord_between(metric, begin, end);
    double inside = 0;
    for (int i = 1; i < 2000; ++i) {
      const Point point = point_at(metric, piece, begin_of_part + (end_of_part - begin_of_part) * i / 2000);
      inside = std::max(inside, distance_to_chord(metric, chord, point));
    }
    double at_ends = 0;
    for (const double place : {begin_of_part, end_of_part})
      at_ends = std::max(at_ends, distance_to_chord(metric, chord, point_at(metric, piece, place)));
    const double farthest =
        std::max(at_ends, farthest_from_chord(metric, piece, begin_of_part, end_of_part, chord, at_ends, 0));
    RC_ASSERT(farthest >= std::max(at_ends, inside) - 1e-6 * radius);
    RC_ASSERT(farthest <= std::max(at_ends, inside) + 1e-6 * radius);
  }
}

RC_GTEST_PROP(CurvePieces, LengthsAreThoseOfFinePolylines, (std::uint64_t seed)) {
  std::mt19937_64 random(seed);
  const machine::Machine machine = five_axes();
  const Metric metric(machine);
  const NurbsCurve curve = any_curve(random);
  double length = 0;
  for (const std::size_t span : spans_of(curve)) {
    constexpr int steps = 4000;
    AxisVector before = position_on(curve, span, curve.knots[span]);
    for (int i = 1; i <= steps; ++i) {
      const long double from = curve.knots[span], to = curve.knots[span + 1];
      const AxisVector here = position_on(curve, span, from + (to - from) * i / steps);
      length += std::hypot(here[0] - before[0], here[1] - before[1], here[2] - before[2]);
      before = here;
    }
  }
  Nurbs nurbs(metric);
  RC_ASSERT(nurbs.begin(curve));
  const Coordinates linear = coordinates_of(metric, FeedAxes::xyz);
  RC_ASSERT(std::abs(nurbs.length_in(linear) - length) <= 2e-5 * length + 1e-12);
  Bezier segment;
  double sum = 0;
  while (nurbs.next(segment)) sum += length_in(metric, linear, segment);
  RC_ASSERT(std::abs(sum - length) <= 2e-5 * length + 1e-12);
}

TEST(CurvePieces, EveryPointIsFoundWhereUnequalWeightsMakeTheCurveStandStill) {
  const machine::Machine machine = five_axes();
  const Metric metric(machine);
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    std::mt19937_64 random(seed);
    const int degree = 1 + static_cast<int>(seed % 5);
    NurbsCurve curve = random_curve(random, degree, degree + 1 + static_cast<int>(seed % 4), 20, 100);
    std::uniform_real_distribution<double> exponent(-9, 9);
    for (gcode::ControlPoint& point : curve.points) point.weight = std::pow(10, exponent(random));
    Nurbs nurbs(metric);
    ASSERT_TRUE(nurbs.begin(curve));
    Bezier segment;
    while (nurbs.next(segment)) {
      for (int i = 0; i <= 50; ++i) {
        const Point point = point_at(metric, segment, i / 50.0);
        const double place = nearest_place(metric, segment, point);
        EXPECT_LE(metric.distance(point, point_at(metric, segment, place)), 1e-9) << seed << " at " << i / 50.0;
      }
    }
  }
}

TEST(CurvePieces, LengthOfACircle) {
  const machine::Machine machine = machine::mill3();
  const Metric metric(machine);
  Nurbs nurbs(metric);
  ASSERT_TRUE(nurbs.begin(circle_curve(100, 100, 10)));
  EXPECT_NEAR(nurbs.length_in(coordinates_of(metric, FeedAxes::xyz)), 20 * std::numbers::pi, 1e-7);
}

}  // namespace test_nearest
}  // namespace leadscrew::referee::test
