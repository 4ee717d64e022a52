// The nearest point of an arc or a helix is the nearest there is.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <leadscrew/referee/piece_source.hpp>

#include "track.hpp"

namespace leadscrew::referee::test {
namespace {

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
  PieceSource source(source_of(program.moves), metric);
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

}  // namespace
}  // namespace leadscrew::referee::test
