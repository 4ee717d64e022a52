// The matching in order against all matchings in order, and against places that are known.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <leadscrew/servo/contour_matcher.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random_numbers.hpp>

namespace leadscrew::servo::testing {
namespace test_contour_matcher {

using testing_support::any;

constexpr base::AxisVector planar = {1, 1, 0};
constexpr double infinite = std::numeric_limits<double>::infinity();

struct Period {
  base::AxisVector commanded{}, actual{};
};

std::vector<double> matched(const std::vector<Period>& periods, const ContourWindow& window,
                            const base::AxisVector& scale = planar) {
  ContourMatcher matcher(scale, window);
  std::vector<double> errors;
  const auto take = [&] {
    for (const Contour& contour : matcher.take()) {
      double squares = 0;
      for (std::size_t k = 0; k < base::axis_count; ++k) {
        squares += std::pow((contour.actual[k] - contour.nearest[k]) * scale[k], 2);
      }
      EXPECT_NEAR(std::sqrt(squares), contour.distance, 1e-9);
      errors.push_back(contour.distance);
    }
  };
  for (const Period& period : periods) {
    matcher.observe(period.commanded, period.actual);
    take();
  }
  matcher.finish();
  take();
  return errors;
}

double from_line(const base::AxisVector& p, const base::AxisVector& a, const base::AxisVector& b) {
  const double ux = b[0] - a[0], uy = b[1] - a[1], vx = p[0] - a[0], vy = p[1] - a[1];
  const double squared = ux * ux + uy * uy, along = vx * ux + vy * uy;
  if (squared == 0 || along <= 0) return std::hypot(vx, vy);
  if (along >= squared) return std::hypot(p[0] - b[0], p[1] - b[1]);
  return std::fabs(ux * vy - uy * vx) / std::sqrt(squared);
}

/// Every period against every line of its window, to the end: a full table, backwards in time.
std::vector<double> by_brute_force(const std::vector<Period>& periods, const ContourWindow& window) {
  std::vector<base::AxisVector> path;
  std::vector<int> due;
  for (const Period& period : periods) {
    if (path.empty() || period.commanded != path.back()) path.push_back(period.commanded);
    due.push_back(static_cast<int>(path.size()) - 1);
  }
  path.push_back(path.back());
  const std::size_t lines = path.size() - 1, count = periods.size();
  std::vector<std::vector<double>> rest(count + 1, std::vector<double>(lines, 0));  // least sum from a line on
  // Of the path that is known when the period is looked at.
  const auto distance = [&](std::size_t k, std::size_t j) {
    const auto known = static_cast<std::size_t>(due[std::min(k + static_cast<std::size_t>(window.ahead), count - 1)]);
    const int line = static_cast<int>(j), last = std::max(static_cast<int>(known) - 1, due[k]);
    if (line < due[k] - window.behind || line > std::min(due[k] + window.ahead, last)) return infinite;
    return from_line(periods[k].actual, path[j], path[std::min(j + 1, known)]);
  };
  const auto squared = [&](std::size_t k, std::size_t j) { return std::pow(distance(k, j), 2); };
  for (std::size_t k = count; k-- > 0;) {
    double least = infinite;
    for (std::size_t j = lines; j-- > 0;) {
      least = std::min(least, squared(k, j) + rest[k + 1][j]);
      rest[k][j] = least;
    }
  }
  std::vector<double> errors;
  std::size_t line = 0;
  for (std::size_t k = 0; k < count; ++k) {
    while (squared(k, line) + rest[k + 1][line] > rest[k][line] * (1 + 1e-12) + 1e-30) ++line;
    errors.push_back(distance(k, line));
  }
  return errors;
}

double sum_of_squares(const std::vector<double>& errors) {
  double sum = 0;
  for (const double error : errors) sum += error * error;
  return sum;
}

/// Turns, loops and stops, followed with a lag, a lead and a sway.
std::vector<Period> any_motion() {
  const int count = any(1, 500);
  const double lag = any(0, 100) / 10.0, sway = any(0, 20) / 100.0;
  std::vector<base::AxisVector> words;
  double x = 0, y = 0, heading = 0;
  for (int left = 0; static_cast<int>(words.size()) < count;) {
    left = any(1, 30);
    const double turn = any(0, 3) == 0 ? 0 : any(-40, 41) / 100.0;
    heading += any(0, 3) == 0 ? any(-31, 32) / 10.0 : 0;
    const double speed = any(0, 5) == 0 ? 0 : any(1, 20) / 10.0;
    for (; left > 0; --left) {
      words.push_back({x, y});
      x += speed * std::cos(heading);
      y += speed * std::sin(heading);
      heading += turn;
    }
  }
  std::vector<Period> periods;
  base::AxisVector actual = words[0];
  for (std::size_t k = 0; k < words.size(); ++k) {
    for (int i = 0; i < 2; ++i) {
      const auto axis = static_cast<std::size_t>(i);
      actual[axis] += (words[k][axis] - actual[axis]) / (1 + lag);
    }
    Period period{words[k], actual};
    period.actual[0] += sway * std::sin(0.7 * static_cast<double>(k));
    period.actual[1] += sway * std::cos(1.1 * static_cast<double>(k));
    periods.push_back(period);
  }
  return periods;
}

RC_GTEST_PROP(ContourMatcher, FindsTheBestOfAllMatchingsInOrder, ()) {
  const std::vector<Period> periods = any_motion();
  const ContourWindow window{255, 255};
  const std::vector<double> errors = matched(periods, window), expected = by_brute_force(periods, window);
  RC_ASSERT(errors.size() == expected.size());
  RC_ASSERT(std::fabs(sum_of_squares(errors) - sum_of_squares(expected)) <= 1e-9 * (1 + sum_of_squares(expected)));
}

/// Decisions are taken after as many periods as the window has, not at the end. Where axes sway about a place for
/// longer, that may cost a hundredth.
RC_GTEST_PROP(ContourMatcher, DecidesInTimeAsWellAsAtTheEnd, ()) {
  const std::vector<Period> periods = any_motion();
  const ContourWindow window{90, 30};
  const std::vector<double> errors = matched(periods, window), expected = by_brute_force(periods, window);
  RC_ASSERT(errors.size() == expected.size());
  const double sum = sum_of_squares(errors), least = sum_of_squares(expected);
  RC_ASSERT(std::fabs(sum - least) <= 1e-3 * least + 1e-12);
}

/// What lags on the path, is on it: round a corner, back from a tip, and where two passes lie closer than the lag.
TEST(ContourMatcher, FindsNoErrorInALagAlongThePath) {
  std::vector<base::AxisVector> path;
  for (int k = 0; k <= 100; ++k) path.push_back({0.1 * k, 0});
  for (int k = 1; k <= 100; ++k) path.push_back({10 - 0.1 * k, 0});
  for (int k = 1; k <= 3; ++k) path.push_back({0, 0.01 * k});
  for (int k = 1; k <= 100; ++k) path.push_back({0.1 * k, 0.03});
  std::vector<Period> periods;
  for (std::size_t k = 0; k < path.size() + 20; ++k) {
    periods.push_back({path[std::min(k, path.size() - 1)], path[k < 20 ? 0 : k - 20]});
  }
  const auto errors = matched(periods, {60, 20});
  ASSERT_EQ(errors.size(), periods.size());
  EXPECT_LT(*std::max_element(errors.begin(), errors.end()), 1e-12);
}

/// A loop's crossing, and the pass beside a pass: the nearest line is not the one.
TEST(ContourMatcher, IsNotMisledByAnotherPass) {
  std::vector<Period> periods;
  const auto go = [&](double x, double y, double wrong) { periods.push_back({{x, y}, {x, y + wrong}}); };
  for (int k = 0; k <= 50; ++k) go(0.1 * k, 0, 0.08);
  go(5, 0.05, 0.08);
  for (int k = 50; k >= 0; --k) go(0.1 * k, 0.1, 0.08);  // the first pass lies 0.1 below
  const auto errors = matched(periods, {200, 60});
  EXPECT_NEAR(errors[25], 0.08, 1e-9);
  EXPECT_NEAR(errors[80], 0.08, 1e-9);
}

/// Long standing is no path; the window is one of lines, so that the lag before a dwell may last through it.
TEST(ContourMatcher, StandsForAsLongAsItTakes) {
  std::vector<Period> periods;
  for (int k = 0; k < 50; ++k) periods.push_back({{0.1 * k, 0}, {std::max(0.0, 0.1 * k - 1), 0.02}});
  for (int k = 0; k < 5000; ++k) periods.push_back({{4.9, 0}, {4.9, 0.02 / (k + 1)}});
  const auto errors = matched(periods, {30, 10});
  ASSERT_EQ(errors.size(), periods.size());
  EXPECT_NEAR(errors[30], 0.02, 1e-12);
  EXPECT_NEAR(errors.back(), 0.02 / 5000, 1e-12);
}

/// A window of 5000 periods is seen by every tenth of them.
TEST(ContourMatcher, LooksAtFewerPeriodsOfALongWindow) {
  std::vector<Period> periods;
  for (int k = 0; k < 20000; ++k) {
    const double now = 1e-4 * k, then = 1e-4 * std::max(0, k - 3000);
    periods.push_back({{10 * std::cos(now), 10 * std::sin(now)}, {9.9 * std::cos(then), 9.9 * std::sin(then)}});
  }
  ContourMatcher matcher(planar, {4000, 1000});
  EXPECT_EQ(matcher.stride(), 10);
  const auto errors = matched(periods, {4000, 1000});
  ASSERT_EQ(errors.size(), 2000u);
  for (const double error : errors) EXPECT_NEAR(error, 0.1, 1e-6);
}

/// A degree counts what it is told to.
TEST(ContourMatcher, ScalesAxes) {
  std::vector<Period> periods;
  base::AxisVector scale{};
  scale[0] = 1;
  scale[3] = 0.5;
  for (int k = 0; k < 20; ++k) {
    Period period{{0.1 * k}, {0.1 * k, 7}};
    period.actual[3] = 0.2;
    periods.push_back(period);
  }
  for (const double error : matched(periods, {4, 4}, scale)) EXPECT_NEAR(error, 0.1, 1e-12);
}

}  // namespace test_contour_matcher
}  // namespace leadscrew::servo::testing
