#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>
#include <leadscrew/toolpath/tube_spline.hpp>

#include "polylines.hpp"

namespace leadscrew::toolpath::testing {
namespace test_tube_spline {

using Outcome = TubeSpline::Outcome;

struct Task {
  State start, end;
  std::vector<Vertex> vertices;
  double longest = 0;
};

struct Fit {
  std::vector<QuinticSpline> stretches;
  Outcome outcome = Outcome::wants_more;
  double greatest_share = 0;
};

/// Is a stretch to be asked for after this vertex?
using Asks = std::function<bool(std::size_t vertex)>;

Fit fit(const Task& task, const Asks& asks) {
  TubeSpline spline(task.start, task.vertices.front(), task.longest);
  Fit fit;
  const auto settle = [&] {
    while ((fit.outcome = spline.settle()) == Outcome::settled || fit.outcome == Outcome::ended) {
      fit.stretches.push_back(spline.stretch());
      fit.greatest_share = spline.greatest_share();
      if (fit.outcome == Outcome::ended) return;
    }
  };
  for (std::size_t i = 1; i < task.vertices.size() && fit.outcome != Outcome::failed; ++i) {
    spline.append(task.vertices[i]);
    if (asks(i)) settle();
  }
  if (fit.outcome == Outcome::failed) return fit;
  spline.close(task.end);
  settle();
  return fit;
}

Fit fit(const Task& task) {
  return fit(task, [](std::size_t) { return true; });
}

/// From the first vertex to the last, the tangents there free.
Task task_along(std::vector<Vertex> vertices, double longest) {
  Task task;
  task.start.derivative[0] = vertices.front().position;
  task.end.derivative[0] = vertices.back().position;
  task.vertices = std::move(vertices);
  task.longest = longest;
  return task;
}

/// Chords over two decades of three decades of margins, turning by up to `most_turn`; sometimes with other margins here
/// and there.
Task random_task(double most_turn) {
  std::vector<std::size_t> coordinates{0, 1};
  for (std::size_t i = 2; i < base::axis_count; ++i) {
    if (any(0, 4) == 0) coordinates.push_back(i);
  }
  const double margin = logarithmic(1e-3, 1), chord = margin * logarithmic(1, 100);
  const bool is_even = any(0, 2) == 0;
  Polyline polyline{scaled(uniform(0, 100), random_direction(coordinates))};
  Point direction = random_direction(coordinates);
  for (int count = any(1, 60); count > 0; --count) {
    polyline.push_back(sum(polyline.back(), chord * logarithmic(0.1, 10), direction));
    direction = turned(direction, uniform(0, most_turn), coordinates);
  }
  std::vector<Vertex> vertices = vertices_of(polyline, margin);
  if (!is_even) {
    for (Vertex& vertex : vertices) vertex.margin *= logarithmic(0.2, 1);
  }
  return task_along(vertices, 2 * std::max(logarithmic(0.1, 1), std::min(10 * margin, 3.0)));
}

double size_of(const Task& task) {
  double size = 0;
  for (const Vertex& vertex : task.vertices) {
    for (const double x : vertex.position) size = std::max(size, std::abs(x));
  }
  return size;
}

/// The largest distance at equal parameter of a great many places, over the margin there.
double share_of_margin(const Task& task, const std::vector<QuinticSpline>& stretches) {
  const std::vector<Vertex>& vertices = task.vertices;
  double share = 0;
  std::size_t chord = 1;
  for (const QuinticSpline& stretch : stretches) {
    std::vector<std::pair<double, std::size_t>> places;
    for (std::size_t span = 0; span < stretch.spans(); ++span) {
      const double from = stretch.span_begin(span), to = stretch.span_end(span);
      for (int k = 0; k <= 24; ++k) places.emplace_back(std::min(to, from + (to - from) * k / 24), span);
    }
    for (const Vertex& vertex : vertices) {
      if (vertex.u < stretch.span_begin(0) || vertex.u > stretch.span_end(stretch.spans() - 1)) continue;
      places.emplace_back(vertex.u, stretch.span_at(vertex.u));
    }
    std::sort(places.begin(), places.end());
    for (const auto& [u, span] : places) {
      while (chord + 1 < vertices.size() && vertices[chord].u < u) ++chord;
      const Vertex &a = vertices[chord - 1], &b = vertices[chord];
      const Point there = sum(a.position, (u - a.u) / (b.u - a.u), difference(b.position, a.position));
      share = std::max(share, distance(stretch.value(span, u), there) / b.margin);
    }
  }
  return share;
}

/// Do two states agree, as far as rounding of points of this size allows on spans of this width?
bool agree(const State& a, const State& b, std::size_t count, double size, double width) {
  double factor = 1e-14 * size;
  for (std::size_t r = 0; r < count; ++r, factor *= 10 / width) {
    const double apart = distance(a.derivative[r], b.derivative[r]);
    if (!(apart <= 1e-9 * norm(a.derivative[r]) + factor)) return false;
  }
  return true;
}

State state_at_start(const Fit& fit) {
  const QuinticSpline& first = fit.stretches.front();
  return first.state(0, first.span_begin(0));
}

State state_at_end(const QuinticSpline& spline) {
  return spline.state(spline.spans() - 1, spline.span_end(spline.spans() - 1));
}

RC_GTEST_PROP(TubeSpline, StaysInTheTube, ()) {
  const Task task = random_task(uniform(0, 3));
  const Fit made = fit(task);
  RC_CLASSIFY(made.outcome == Outcome::failed);
  const double rounding = 2e-14 * size_of(task) / task.vertices.front().tolerance;
  RC_ASSERT(made.greatest_share <= 1);
  RC_ASSERT(share_of_margin(task, made.stretches) <= made.greatest_share + rounding);
}

RC_GTEST_PROP(TubeSpline, ProvesWhatLiesBetweenItsSamples, ()) {
  // Where margins differ, it comes nearest to leaving the tube somewhere on a chord rather than at a vertex.
  for (int k = 0; k < 20; ++k) {
    Polyline polyline{{0, 0}};
    Point direction{1, 0};
    for (int i = 0; i < 4; ++i) {
      polyline.push_back(sum(polyline.back(), uniform(0.3, 3), direction));
      direction = turned(direction, uniform(0, 0.5), {0, 1});
    }
    std::vector<Vertex> vertices = vertices_of(polyline, 1);
    for (Vertex& vertex : vertices) vertex.margin = logarithmic(0.01, 1), vertex.tolerance = 0.01;
    const Task task = task_along(vertices, logarithmic(0.5, 6));
    const Fit made = fit(task);
    RC_ASSERT(share_of_margin(task, made.stretches) <= made.greatest_share + 1e-12);
  }
}

/// Chords of a circle of radius 10.
Task circle(double pitch, double length, double margin, double longest) {
  Polyline points;
  for (double angle = 0; angle < length / 10; angle += pitch / 10)
    points.push_back({10 * std::cos(angle), 10 * std::sin(angle)});
  return task_along(vertices_of(points, margin), longest);
}

TEST(TubeSpline, ProvesNotMuchMoreThanIsTrueOnSmoothRuns) {
  for (const double pitch : {0.003, 0.03, 0.3, 1.0, 3.0}) {
    for (const double margin : {0.01, 0.03}) {
      const Task task = circle(pitch, 15, margin, 1);  // fine chords: one window
      const Fit made = fit(task);
      ASSERT_EQ(made.outcome, Outcome::ended);
      EXPECT_LE(made.greatest_share, 1.1 * share_of_margin(task, made.stretches)) << pitch << ' ' << margin;
    }
  }
}

TEST(TubeSpline, ProvesNotMuchMoreThanIsTrueOfWhatIsSettled) {
  // The windows' far ends are free, and farther from the polyline than what becomes of them.
  const Task task = circle(0.03, 30, 0.01, 1);
  const Fit made = fit(task);
  EXPECT_LE(made.greatest_share, 1.3 * share_of_margin(task, made.stretches));
}

TEST(TubeSpline, BendsAsEvenlyInTheMiddleOfALongRunAsOfAShortOne) {
  // Nothing in the tube about this circle asks for a shorter smoothing length; only the windows' far ends do.
  const auto narrowest = [](double length) {
    double width = INFINITY;
    const Task task = circle(0.03, length, 0.01, 2);
    for (const QuinticSpline& stretch : fit(task).stretches) {
      for (std::size_t span = 0; span < stretch.spans(); ++span) {
        const double from = stretch.span_begin(span), to = stretch.span_end(span);
        if (from > 10 && to < task.vertices.back().u - 10) width = std::min(width, to - from);
      }
    }
    return width;
  };
  EXPECT_GE(narrowest(60), 0.9 * narrowest(30));
}

RC_GTEST_PROP(TubeSpline, GoesOnWithPositionAndFourDerivatives, ()) {
  const Task task = random_task(uniform(0, 3));
  const Fit made = fit(task);
  for (std::size_t i = 1; i < made.stretches.size(); ++i) {
    const QuinticSpline &before = made.stretches[i - 1], &behind = made.stretches[i];
    const double u = behind.span_begin(0),
                 width = std::min(u - before.span_begin(before.spans() - 1), behind.span_end(0) - u);
    RC_ASSERT(before.span_end(before.spans() - 1) == u);
    RC_ASSERT(agree(state_at_end(before), behind.state(0, u), State::most, size_of(task), width));
  }
}

RC_GTEST_PROP(TubeSpline, BeginsAndEndsAsItIsTold, ()) {
  Task task = random_task(uniform(0, 1));
  const auto pin = [&](State& state, const Vertex& here, const Vertex& next) {
    state.count = any<std::size_t>(1, State::most);
    double size = 1e-1 / task.longest;
    state.derivative[1] = scaled(1 / distance(here.position, next.position), difference(next.position, here.position));
    for (std::size_t r = 2; r < state.count; ++r, size /= task.longest)
      state.derivative[r] = scaled(uniform(-size, size), random_direction({0, 1, 2}));
  };
  pin(task.start, task.vertices[0], task.vertices[1]);
  pin(task.end, task.vertices.back(), task.vertices[task.vertices.size() - 2]);
  const Fit made = fit(task);
  RC_CLASSIFY(made.outcome == Outcome::failed);
  if (made.stretches.empty()) return;
  const QuinticSpline &first = made.stretches.front(), &last = made.stretches.back();
  const double size = size_of(task);
  RC_ASSERT(agree(task.start, state_at_start(made), task.start.count, size, first.span_end(0) - first.span_begin(0)));
  if (made.outcome == Outcome::failed) return;
  State end = state_at_end(last);
  for (std::size_t r = 1; r < State::most; r += 2) end.derivative[r] = scaled(-1, end.derivative[r]);
  RC_ASSERT(
      agree(task.end, end, task.end.count, size, last.span_end(last.spans() - 1) - last.span_begin(last.spans() - 1)));
}

bool same(const Fit& a, const Fit& b) {
  if (a.outcome != b.outcome || a.stretches.size() != b.stretches.size()) return false;
  for (std::size_t i = 0; i < a.stretches.size(); ++i) {
    if (a.stretches[i].knots != b.stretches[i].knots || a.stretches[i].points != b.stretches[i].points) return false;
  }
  return true;
}

RC_GTEST_PROP(TubeSpline, IsTheSameHoweverMuchOfThePolylineIsKnown, ()) {
  const Task task = random_task(uniform(0, 3));
  const Fit made = fit(task);
  RC_ASSERT(same(made, fit(task, [](std::size_t) { return false; })));
  RC_ASSERT(same(made, fit(task, [](std::size_t) { return any(0, 4) == 0; })));
}

TEST(TubeSpline, IsTheSameWhereJustEnoughIsKnown) {
  for (const double longest : {0.3, 0.37, 1.0, 1.3, 2.0, 0.7}) {
    TubeSpline spline({}, {}, longest);
    Polyline polyline{{0, 0}, {spline.reach(), 0}, {2 * spline.reach(), 1}};
    const Task task = task_along(vertices_of(polyline, 0.01), longest);
    EXPECT_TRUE(same(fit(task), fit(task, [](std::size_t) { return false; }))) << longest;
  }
}

RC_GTEST_PROP(TubeSpline, IsStraightAlongAStraightLine, ()) {
  const Point direction = random_direction({0, 1, 2, 3, 8});
  Polyline line{scaled(uniform(0, 100), random_direction({0, 1, 2}))};
  const Point from = line.front();
  double length = 0;
  for (int count = any(1, 100); count > 0; --count) {
    length += logarithmic(1e-2, 10);
    line.push_back(sum(from, length, direction));
  }
  const Task task = task_along(vertices_of(line, logarithmic(1e-3, 1)), logarithmic(0.2, 6));
  const Fit made = fit(task);
  RC_ASSERT(made.outcome == Outcome::ended);
  for (const QuinticSpline& stretch : made.stretches) {
    for (std::size_t span = 0; span < stretch.spans(); ++span) {
      const double u = (stretch.span_begin(span) + stretch.span_end(span)) / 2;
      RC_ASSERT(distance_to_segment(stretch.value(span, u), line.front(), line.back()) <= 1e-8);
    }
  }
}

/// A curve of the size of a part, whose radii go down to millimetres, with its words rounded to a micrometre.
Polyline rounded_words(double pitch) {
  Polyline words;
  double x = 0;
  while (x < 30) {
    const Point p{x, 4 * std::sin(x / 4) + std::cos(x), 2 * std::sin(x / 7)};
    words.push_back({std::round(p[0] * 1000) / 1000, std::round(p[1] * 1000) / 1000, std::round(p[2] * 1000) / 1000});
    x += pitch / std::hypot(1, std::cos(x / 4) - std::sin(x));
  }
  return words;
}

TEST(TubeSpline, IsFoundInTubesOfRoundedWords) {
  for (const double pitch : {0.003, 0.01, 0.03, 0.1, 0.3}) {
    for (const double margin : {0.002, 0.005, 0.01}) {
      for (const double longest : {0.2, 1.0, 2.0}) {
        const Fit made = fit(task_along(vertices_of(rounded_words(pitch), margin), longest));
        EXPECT_EQ(made.outcome, Outcome::ended) << pitch << ' ' << margin << ' ' << longest;
      }
    }
  }
}

}  // namespace test_tube_spline
}  // namespace leadscrew::toolpath::testing
