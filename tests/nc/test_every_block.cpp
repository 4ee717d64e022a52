// Lines and arcs in the form in which programs are interpolated: all of them up to some size.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/nc/block_interpolator.hpp>
#include <numbers>
#include <vector>

namespace leadscrew::nc {
namespace test_every_block {

using pulse::Arc;
using pulse::Direction;
using pulse::Point;

/// As `run` does.
constexpr InterpolationOptions as_run{.places = 16};

struct Bound {
  const char* name;
  PulseMethod method;
  double line, arc;      ///< greatest error, BLU
  double exception = 0;  ///< that of arcs of R² = 2, where it is greater
};

/// What a block makes in the plane.
struct Made {
  Point end;
  std::int64_t commands = 0;
  bool ends = false;
  double worst = 0;  ///< BLU
};

template <typename Error>
Made make(Block& block, PulseMethod method, Point at, const Error& error) {
  ArcTape tape;
  count_commands(block, method, as_run, tape);
  BlockInterpolator interpolator(block, method, as_run, tape);
  Made made{at};
  const std::int64_t too_many = 2 * block.commands + 100;
  for (; !interpolator.done() && made.commands < too_many; ++made.commands) {
    const AxisPulse pulse = interpolator.step();
    made.end = {made.end.x + pulse.step[0], made.end.y + pulse.step[1]};
    made.worst = std::max(made.worst, error(made.end));
  }
  made.ends = interpolator.done() && made.commands == block.commands;
  return made;
}

class EveryBlock : public ::testing::TestWithParam<Bound> {
 protected:
  void try_lines(std::int64_t reach) const {
    double worst = 0;
    for (std::int64_t a = -reach; a <= reach; ++a) {
      for (std::int64_t b = -reach; b <= reach; ++b) {
        if (a == 0 && b == 0) continue;
        Block block;
        block.delta = {a, b};
        const double length = std::hypot(static_cast<double>(a), static_cast<double>(b));
        const Made made = make(block, GetParam().method, {},
                               [&](Point at) { return std::abs(static_cast<double>(at.x * b - at.y * a)) / length; });
        ASSERT_TRUE(made.ends) << a << ' ' << b;
        ASSERT_EQ(made.end, (Point{a, b}));
        worst = std::max(worst, made.worst);
      }
    }
    EXPECT_LE(worst, GetParam().line);
  }
};

TEST_P(EveryBlock, OfALineEndsThereWithinItsBound) {
  try_lines(64);
}

TEST_P(EveryBlock, OfAnArcEndsThereWithinItsBound) {
  constexpr std::int64_t greatest_square = 900;
  std::vector<std::vector<Point>> circles(greatest_square + 1);
  for (std::int64_t x = -30; x <= 30; ++x) {
    for (std::int64_t y = -30; y <= 30; ++y) {
      const std::int64_t square = x * x + y * y;
      if (square > 0 && square <= greatest_square) circles[static_cast<std::size_t>(square)].push_back({x, y});
    }
  }
  std::int64_t arcs = 0;
  double worst = 0, exception = 0;
  for (std::size_t square = 1; square < circles.size(); ++square) {
    const double radius = std::sqrt(static_cast<double>(square));
    for (const Point& start : circles[square]) {
      for (const Point& end : circles[square]) {
        for (const Direction direction : {Direction::clockwise, Direction::counterclockwise}) {
          Block block;
          block.kind = Block::Kind::arc;
          block.arc = {start, end, direction};
          const Made made = make(block, GetParam().method, start, [&](Point at) {
            return std::abs(std::hypot(static_cast<double>(at.x), static_cast<double>(at.y)) - radius);
          });
          ++arcs;
          ASSERT_TRUE(made.ends) << start.x << ' ' << start.y << " to " << end.x << ' ' << end.y;
          ASSERT_EQ(made.end, end);
          double& greatest = square == 2 && GetParam().exception > 0 ? exception : worst;
          greatest = std::max(greatest, made.worst);
        }
      }
    }
  }
  EXPECT_NEAR(exception, GetParam().exception, 1e-12);
  EXPECT_EQ(arcs, 63'328);
  EXPECT_LE(worst, GetParam().arc);
}

class LongEveryBlock : public EveryBlock {};
TEST_P(LongEveryBlock, OfALineEndsThereWithinItsBound) {
  try_lines(256);
}

const auto bounds =
    ::testing::Values(Bound{"Koren", PulseMethod::koren, 0.7072, 1.92}, Bound{"Dda", PulseMethod::dda, 0.7072, 1.65},
                      Bound{"MinError", PulseMethod::min_error, 0.5001, 0.5},
                      Bound{"ImprovedMinError", PulseMethod::improved_min_error, 0.5001, 0.5, 2 - std::numbers::sqrt2},
                      Bound{"Bresenham", PulseMethod::bresenham, 0.5001, 0.5},
                      Bound{"PointComparison", PulseMethod::point_comparison, 1, 0.9995});
const auto name_of = [](const auto& test) { return std::string(test.param.name); };
INSTANTIATE_TEST_SUITE_P(Methods, EveryBlock, bounds, name_of);
INSTANTIATE_TEST_SUITE_P(LongMethods, LongEveryBlock, bounds, name_of);

}  // namespace test_every_block
}  // namespace leadscrew::nc
