#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <leadscrew/planner/planner.hpp>

#include "random_section.hpp"

// Chunks as they leave the planner: how they follow one another, how each could stop, what they ask of the axes.

namespace test_look_ahead {

using namespace leadscrew;
using planner::Chunk;
using planner::Planner;
using planner::Segment;
using testing_support::any;
using testing_support::arc_piece;
using testing_support::line_piece;

/// Where the motion is at a time within a segment, from the polynomial written out here.
struct At {
  double s = 0, speed = 0, acceleration = 0, jerk = 0;
};
At at(const Segment& g, double t) {
  const double s0 = g.s0.value(), v0 = g.v0.value();
  return {s0 + v0 * t + g.c2 * t * t + g.c3 * t * t * t + g.c4 * std::pow(t, 4) + g.c5 * std::pow(t, 5),
          v0 + 2 * g.c2 * t + 3 * g.c3 * t * t + 4 * g.c4 * std::pow(t, 3) + 5 * g.c5 * std::pow(t, 4),
          2 * g.c2 + 6 * g.c3 * t + 12 * g.c4 * t * t + 20 * g.c5 * t * t * t,
          6 * g.c3 + 24 * g.c4 * t + 60 * g.c5 * t * t};
}
At end_of(const Segment& segment) {
  return at(segment, segment.duration.value());
}

double distance(const geometry::Point& a, const geometry::Point& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

/// The largest value over limit of any axis, and of the speed over the feed times a factor.
double brute_force_ratio(const std::vector<Segment>& part, const Chunk& chunk, const machine::Machine& machine,
                         double feed_factor = 1) {
  constexpr int looks = 24;
  double worst = 0;
  for (const Segment& segment : part) {
    if (segment.state == base::MotionState::rest) continue;
    const toolpath::Piece& piece = chunk.pieces[segment.piece];
    const double length = geometry::length(piece.curve), aside = 1e-10 * length, from = segment.s0.value(),
                 to = end_of(segment).s;
    for (int k = 0; k <= looks; ++k) {
      const At now = at(segment, segment.duration.value() * k / looks);
      // A third derivative may jump where a segment begins or ends: look from inside.
      double s = now.s;
      if (to - from > 4 * aside) s = std::clamp(s, from + aside, to - aside);
      const auto jets = geometry::jets(piece.curve, std::clamp(s, 0.0, length));
      const double v = now.speed, a = now.acceleration, j = now.jerk;
      for (const base::Axis axis : base::all_axes) {
        if (!machine.has(axis)) continue;
        const auto& q = jets[base::index(axis)];
        const machine::AxisLimits& limits = machine.limits(axis);
        worst = std::max({worst, std::abs(q.first * v) / limits.velocity,
                          std::abs(q.second * v * v + q.first * a) / limits.acceleration,
                          std::abs(q.third * v * v * v + 3 * q.second * v * a + q.first * j) / limits.jerk});
      }
      worst = std::max(worst, v / (feed_factor * piece.feed));
    }
  }
  return worst;
}

/// Segments go on where the one before ends, in time and along the path; the first may have begun before.
void is_contiguous(const Chunk& chunk, const std::vector<Segment>& part, double begin, double scale) {
  RC_ASSERT(part.front().begin.value() <= begin + 1e-12 * (1 + begin));
  RC_ASSERT(part.front().begin.value() + part.front().duration.value() >= begin - 1e-12 * (1 + begin));
  double time = part.front().begin.value();
  for (std::size_t k = 0; k < part.size(); ++k) {
    RC_ASSERT(std::abs(part[k].begin.value() - time) <= 1e-12 * (1 + time));
    RC_ASSERT(part[k].duration.value() >= 0);
    time = part[k].begin.value() + part[k].duration.value();
    if (k == 0) continue;
    const At before = end_of(part[k - 1]), now = at(part[k], 0);
    RC_ASSERT(std::abs(now.speed - before.speed) <= 1e-9 * scale);
    const geometry::Curve &old_curve = chunk.pieces[part[k - 1].piece].curve,
                          &curve = chunk.pieces[part[k].piece].curve;
    RC_ASSERT(part[k].piece == part[k - 1].piece || part[k].piece == part[k - 1].piece + 1);
    RC_ASSERT(distance(geometry::evaluate(old_curve, before.s), geometry::evaluate(curve, now.s)) <= 1e-9);
    // Rounding is that of the path length since the section began, however short the piece.
    RC_ASSERT(before.s <= geometry::length(old_curve) * (1 + 1e-12) + 1e-12 && now.s >= -1e-12);
  }
}

/// A chunk, and what follows it or its tail, begin where it leaves off: `begin` in the time of what follows.
void goes_on(const Chunk& before, const std::vector<toolpath::Piece>& pieces, const Segment& next, double begin,
             const machine::Machine& machine) {
  const Segment& last = before.segments.back();
  const At leaving = at(last, (before.end() - last.begin).value());
  const At entering = at(next, begin - next.begin.value());
  const geometry::Curve& old_curve = before.pieces[last.piece].curve;
  const geometry::Curve& curve = pieces[next.piece].curve;
  const double size = std::max(geometry::length(old_curve), geometry::length(curve));
  RC_ASSERT(distance(geometry::evaluate(old_curve, leaving.s), geometry::evaluate(curve, entering.s)) <=
            1e-9 * (1 + size));
  RC_ASSERT(std::abs(leaving.speed - entering.speed) <= 1e-9 * leaving.speed + planner::rest_speed);
  double greatest = 0;
  for (const auto& axis : machine.axes) {
    if (axis) greatest = std::max(greatest, axis->acceleration);
  }
  RC_ASSERT(std::abs(leaving.acceleration - entering.acceleration) <= 1e-9 * greatest);
}

void ends_at_rest(const Chunk& chunk, const machine::Machine& machine) {
  const Segment& last = chunk.stop_tail.empty() ? chunk.segments.back() : chunk.stop_tail.back();
  const At end = end_of(last);
  double velocity = 0, acceleration = 0;
  for (const auto& axis : machine.axes) {
    if (axis) velocity = std::max(velocity, axis->velocity), acceleration = std::max(acceleration, axis->acceleration);
  }
  RC_ASSERT(std::abs(end.speed) <= 1e-9 * velocity);
  RC_ASSERT(std::abs(end.acceleration) <= 1e-9 * acceleration);
  const geometry::Curve& curve = chunk.pieces[last.piece].curve;
  RC_ASSERT(last.piece + 1 == chunk.pieces.size());
  RC_ASSERT(end.s <= geometry::length(curve) * (1 + 1e-9));
  RC_ASSERT(distance(geometry::evaluate(curve, end.s), chunk.rest) <= 1e-9 * (1 + geometry::length(curve)));
  RC_ASSERT(chunk.rest_line == chunk.pieces[last.piece].line);
}

struct Planned {
  std::vector<Chunk> chunks;
  std::int64_t refused = 0;
};

Planned planned(const std::vector<toolpath::Piece>& pieces, const machine::Machine& machine) {
  Planner planner(machine, geometry::start(pieces[0].curve));
  for (const toolpath::Piece& piece : pieces) planner.push(piece);
  planner.finish();
  Planned result;
  while (auto chunk = planner.pop()) result.chunks.push_back(std::move(*chunk));
  result.refused = planner.refused_windows();
  return result;
}

/// Many pieces, and a machine for which they are many windows: up to `ramps` lengths of a ramp.
struct Random {
  machine::Machine machine = testing_support::random_machine();
  std::vector<toolpath::Piece> pieces;

  explicit Random(double ramps, int most_pieces = 60) {
    pieces = testing_support::random_path(most_pieces);
    testing_support::soften(machine, pieces, ramps);
    if (any(0, 4) == 0) pieces[any<std::size_t>(0, pieces.size())].stop = true;
  }
};

RC_GTEST_PROP(LookAhead, ChunksFollowOneAnother, ()) {
  const Random random(150);
  const Planned plan = planned(random.pieces, random.machine);
  RC_ASSERT(!plan.chunks.empty());
  double travelled = 0, length = 0;
  for (const toolpath::Piece& piece : random.pieces) length += geometry::length(piece.curve);
  for (std::size_t k = 0; k < plan.chunks.size(); ++k) {
    const Chunk& chunk = plan.chunks[k];
    RC_ASSERT(!chunk.segments.empty() && !chunk.pieces.empty());
    const double duration = chunk.duration.value(), scale = 500;
    is_contiguous(chunk, chunk.segments, 0, scale);
    const Segment& last = chunk.segments.back();
    RC_ASSERT(std::abs(last.begin.value() + last.duration.value() - duration) <= 1e-12 * (1 + duration));
    travelled += chunk.length;
    if (!chunk.stop_tail.empty()) {
      is_contiguous(chunk, chunk.stop_tail, duration, scale);
      goes_on(chunk, chunk.pieces, chunk.stop_tail.front(), duration, random.machine);
      RC_ASSERT(chunk.tail_length > 0);
    } else {
      RC_ASSERT(chunk.tail_length == 0);
    }
    if (k + 1 < plan.chunks.size()) {
      const Chunk& next = plan.chunks[k + 1];
      RC_ASSERT(next.begins_at_rest() == chunk.stop_tail.empty());
      goes_on(chunk, next.pieces, next.segments.front(), 0, random.machine);
    }
  }
  RC_ASSERT(plan.chunks.front().begins_at_rest());
  RC_ASSERT(plan.chunks.back().stop_tail.empty());
  RC_ASSERT(distance(plan.chunks.back().rest, geometry::end(random.pieces.back().curve)) <= 1e-14 * (1 + length));
  RC_ASSERT(std::abs(travelled / length - 1) <= 1e-12 * static_cast<double>(plan.chunks.size()));
}

RC_GTEST_PROP(LookAhead, EveryChunkCanStopOnThePath, ()) {
  const Random random(80);
  for (const Chunk& chunk : planned(random.pieces, random.machine).chunks) ends_at_rest(chunk, random.machine);
}

/// The planner looks eight times a segment. Between its looks a parabola of jerk rises by parts of a thousand, most
/// where knots lie far apart, in the last intervals of a tail.
RC_GTEST_PROP(LookAhead, KeepsEveryLimitInChunksAndTails, ()) {
  const Random random(50);
  for (const Chunk& chunk : planned(random.pieces, random.machine).chunks) {
    const double committed = brute_force_ratio(chunk.segments, chunk, random.machine);
    const double tail = brute_force_ratio(chunk.stop_tail, chunk, random.machine);
    RC_LOG() << "committed " << committed << ", tail " << tail << '\n';
    RC_ASSERT(committed <= 1.001);
    RC_ASSERT(tail <= 1.001);
  }
}

/// Feed override and hold, from slice to slice, along sections of any kind: what is handed out goes on from what came
/// before, keeps every limit, and ends where the section does.
RC_GTEST_PROP(LookAhead, KeepsEveryLimitThroughChangesOfFeed, ()) {
  const Random random(20, 12);
  Planner planner(random.machine, geometry::start(random.pieces[0].curve));
  planner.slice(0.02);
  for (const toolpath::Piece& piece : random.pieces) planner.push(piece);
  planner.finish();
  const auto wait = [] { return testing_support::logarithmic(0.01, 1); };
  double travelled = 0, length = 0, until_change = wait();
  for (const toolpath::Piece& piece : random.pieces) length += geometry::length(piece.curve);
  std::optional<Chunk> before;
  bool held = false;
  double greatest_factor = 1;  // asked so far: while speed falls to a lower one it may still be that of this
  constexpr int most_changes = 5;
  for (int changes = 0;;) {
    std::optional<Chunk> chunk = planner.pop();
    if (!chunk && !held) break;
    if (!chunk) {
      planner.override_feed(1);
      held = false;
      continue;
    }
    is_contiguous(*chunk, chunk->segments, chunk->begin.value(), 500);
    if (before) goes_on(*before, chunk->pieces, chunk->segments.front(), chunk->begin.value(), random.machine);
    RC_ASSERT(brute_force_ratio(chunk->segments, *chunk, random.machine, greatest_factor) <= 1.001);
    RC_ASSERT(brute_force_ratio(chunk->stop_tail, *chunk, random.machine, greatest_factor) <= 1.001);
    ends_at_rest(*chunk, random.machine);
    travelled += chunk->length;
    until_change -= chunk->duration.value();
    if (until_change < 0 && changes < most_changes) {
      const double factor =
          ++changes == most_changes ? 1.0 : *rc::gen::element(0.0, 0.0, 0.1, 0.3, 0.5, 0.9, 1.0, 1.3, 2.0);
      planner.override_feed(factor);
      if (changes == most_changes) planner.slice(0.5);
      greatest_factor = std::max(greatest_factor, factor);
      held = factor == 0;
      until_change = wait();
    }
    before = std::move(chunk);
  }
  RC_ASSERT(planner.refused_windows() == 0);
  RC_ASSERT(before && before->stop_tail.empty());
  RC_ASSERT(distance(before->rest, geometry::end(random.pieces.back().curve)) <= 1e-14 * (1 + length));
  RC_ASSERT(std::abs(travelled / length - 1) <= 1e-9);
}

/// Arcs of one circle on a mill whose axes are alike.
RC_GTEST_PROP(LookAhead, RefusesNoWindowOfACircle, ()) {
  machine::Machine machine = machine::mill3();
  const double acceleration = testing_support::logarithmic(100, 5000);
  const double jerk = acceleration * testing_support::logarithmic(10, 100);
  for (auto& axis : machine.axes) {
    if (axis) axis->acceleration = acceleration, axis->jerk = jerk;
  }
  const double feed = testing_support::logarithmic(5, 200), sweep = testing_support::logarithmic(1, 9);
  const int count = any(1, 40);
  std::vector<toolpath::Piece> pieces;
  geometry::Point point{testing_support::logarithmic(1, 50)};
  for (int k = 0; k < count; ++k) {
    pieces.push_back(arc_piece(point, 0, 0, sweep / count, feed));
    point = geometry::end(pieces.back().curve);
  }
  RC_ASSERT(planned(pieces, machine).refused == 0);
}

RC_GTEST_PROP(LookAhead, RefusesNoWindow, ()) {
  const Random random(150);
  RC_ASSERT(planned(random.pieces, random.machine).refused == 0);
}

bool same_bits(const Segment& a, const Segment& b) {
  const auto same = [](const numeric::DoubleDouble& x, const numeric::DoubleDouble& y) {
    return x.hi == y.hi && x.lo == y.lo;
  };
  return same(a.begin, b.begin) && same(a.duration, b.duration) && same(a.s0, b.s0) && same(a.v0, b.v0) &&
         a.c2 == b.c2 && a.c3 == b.c3 && a.c4 == b.c4 && a.c5 == b.c5 && a.piece == b.piece && a.state == b.state;
}

RC_GTEST_PROP(LookAhead, PlansTheSameBitsHoweverElementsCome, ()) {
  const Random random(80);
  const Planned all = planned(random.pieces, random.machine);
  Planner planner(random.machine, geometry::start(random.pieces[0].curve));
  std::vector<Chunk> chunks;
  const auto take = [&] {
    while (auto chunk = planner.pop()) chunks.push_back(std::move(*chunk));
  };
  for (const toolpath::Piece& piece : random.pieces) {
    planner.push(piece);
    if (any(0, 3) > 0) take();
  }
  planner.finish();
  take();
  RC_ASSERT(chunks.size() == all.chunks.size());
  for (std::size_t k = 0; k < chunks.size(); ++k) {
    const Chunk &a = chunks[k], &b = all.chunks[k];
    RC_ASSERT(std::equal(a.segments.begin(), a.segments.end(), b.segments.begin(), b.segments.end(), same_bits));
    RC_ASSERT(std::equal(a.stop_tail.begin(), a.stop_tail.end(), b.stop_tail.begin(), b.stop_tail.end(), same_bits));
    RC_ASSERT(a.rest == b.rest && a.length == b.length && a.tail_length == b.tail_length);
    RC_ASSERT(a.pieces.size() == b.pieces.size());
  }
}

/// One piece or many, a path is as fast; what windows lose and repairs cost is a thousandth.
RC_GTEST_PROP(LookAhead, LosesNothingToTheNumberOfPieces, ()) {
  const double radius = testing_support::logarithmic(1, 50), sweep = any(2000, 9000) / 1000.0;
  const machine::Machine machine = machine::mill3();
  const auto time = [&](int count) {
    std::vector<toolpath::Piece> pieces;
    geometry::Point point{radius};
    for (int k = 0; k < count; ++k) {
      pieces.push_back(arc_piece(point, 0, 0, sweep / count, 60));
      point = geometry::end(pieces.back().curve);
    }
    double sum = 0;
    for (const Chunk& chunk : planned(pieces, machine).chunks) sum += chunk.duration.value();
    return sum;
  };
  RC_ASSERT(std::abs(time(any(2, 400)) / time(1) - 1) <= 2e-3);
}

}  // namespace test_look_ahead
