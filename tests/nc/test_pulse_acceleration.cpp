// Acceleration of the pulses themselves: second differences of each axis' steps over many spans of time.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "pulses.hpp"

namespace leadscrew::nc {
namespace test_pulse_acceleration {

using testing::Conditions;
using testing::pulse;
using testing::Pulsed;
using testing::TimedPulse;

/// Positions of the first three axes by time, every `grid` clocks.
struct Sampled {
  std::array<std::vector<double>, 3> axes;
  Pulsed pulsed;
};

Sampled sample(const std::string& text, const Conditions& conditions, std::int64_t grid) {
  Sampled sampled;
  std::array<double, 3> at{};
  std::int64_t until = grid;
  const auto store = [&](std::int64_t tick) {
    for (; until <= tick; until += grid) {
      for (std::size_t i = 0; i < 3; ++i) sampled.axes[i].push_back(at[i]);
    }
  };
  for (std::size_t i = 0; i < 3; ++i) sampled.axes[i].assign(2'000, 0);  // at rest before
  sampled.pulsed = pulse(text, conditions, [&](const TimedPulse& made) {
    store(made.tick - 1);
    for (std::size_t i = 0; i < 3; ++i) at[i] += made.pulse.step[i];
  });
  store(sampled.pulsed.last + 1'000 * grid);  // and behind
  return sampled;
}

/// The most by which |p(t + W) − 2p(t) + p(t − W)| exceeds a W², in steps, over spans of 1, 2, 4 … samples.
double worst_excess(const Sampled& sampled, double acceleration, double grid_seconds) {
  double worst = -1;
  for (const std::vector<double>& p : sampled.axes) {
    for (std::size_t width = 1; width <= 512; width *= 2) {
      const double span = static_cast<double>(width) * grid_seconds;
      for (std::size_t i = width; i + width < p.size(); ++i) {
        const double second = std::abs(p[i + width] - 2 * p[i] + p[i - width]);
        worst = std::max(worst, second - acceleration * span * span);
      }
    }
  }
  return worst;
}

constexpr double steps_per_s2 = 1000 / 0.001;  // of the machine's axes
constexpr double allowed = 6;                  // steps

double excess(const std::string& text, Conditions conditions, Shape shape) {
  conditions.options.shape = shape;
  constexpr std::int64_t grid = 200;  // clocks
  return worst_excess(sample(text, conditions, grid), steps_per_s2,
                      grid / static_cast<double>(conditions.options.clock_pps));
}

const std::string contour =
    "G61 G0 X20 Y10 Z-5\nG1 X40 F9000\nG3 X40 Y30 I0 J10\nG1 X38\nX0 Y31\nG4 P0.02\nX-10 Z0\nX-9 Y30\nX-8.9\nX-8.8\n"
    "G2 X-8.8 Y30 I3 P2 Z-4\nG3 X-5 Y26 R4\nG61.1 G1 Y20\nY10\nG0 X0 Y0 Z0\n";

TEST(PulseAcceleration, IsKeptAlongAContour) {
  for (const PulseMethod method : {PulseMethod::koren, PulseMethod::dda, PulseMethod::point_comparison,
                                   PulseMethod::min_error, PulseMethod::improved_min_error, PulseMethod::bresenham}) {
    Conditions conditions;
    conditions.options.method = method;
    EXPECT_LT(excess(contour, conditions, Shape::accelerate), allowed) << static_cast<int>(method);
  }
}

TEST(PulseAcceleration, WouldBeSeenToBeExceeded) {
  EXPECT_GT(excess(contour, {}, Shape::constant), 10 * allowed);
}

TEST(PulseAcceleration, IsKeptInExamples) {
  for (const char* example : {"01-plate.ngc", "04-square.ngc", "09-butterfly.ngc", "10-cubic.ngc", "11-splines.ngc"}) {
    EXPECT_LT(excess(testing::text_of(example), {}, Shape::accelerate), allowed) << example;
  }
}

RC_GTEST_PROP(PulseAcceleration, IsKeptAlongRandomLines, ()) {
  std::string text = "G61 F" + std::to_string(*rc::gen::inRange(100, 12'000)) + "\n";
  double x = 0, y = 0;
  const int lines = *rc::gen::inRange(2, 30);
  const int longest = *rc::gen::element(20, 300, 3000);  // hundredths of a mm
  for (int i = 0; i < lines; ++i) {
    x += *rc::gen::inRange(-longest / 8, longest) / 100.0;
    y += *rc::gen::inRange(-longest / 8, longest / 4) / 100.0;
    text += "G1 X" + std::to_string(x) + " Y" + std::to_string(y) + "\n";
  }
  RC_LOG() << text;
  RC_ASSERT(excess(text, {}, Shape::accelerate) < allowed);
}

/// Of one step to hundreds: that they follow a straight line or turn about cannot be told from the shortest.
RC_GTEST_PROP(PulseAcceleration, IsKeptAlongRandomLinesOfFewSteps, ()) {
  Conditions conditions;
  conditions.options.method =
      *rc::gen::element(PulseMethod::koren, PulseMethod::dda, PulseMethod::point_comparison, PulseMethod::bresenham);
  std::string text = "G61 F" + std::to_string(*rc::gen::inRange(100, 12'000)) + "\n";
  const int lines = *rc::gen::inRange(100, 1000), turn = *rc::gen::element(0, 2, 10, 60);  // degrees
  const int shortest = *rc::gen::inRange(5, 30), longest = *rc::gen::element(30, 300, 3000);
  double x = 0, y = 0, angle = *rc::gen::inRange(0, 360);
  for (int i = 0; i < lines; ++i) {
    angle += *rc::gen::inRange(-turn, turn + 1);
    const double length = *rc::gen::element(shortest, shortest, shortest, longest) / 1e4;
    x += length * std::cos(angle / 57.29578);
    y += length * std::sin(angle / 57.29578);
    text += "G1 X" + std::to_string(x) + " Y" + std::to_string(y) + "\n";
  }
  RC_LOG() << text;
  RC_ASSERT(excess(text, conditions, Shape::accelerate) < allowed);
}

TEST(PulseAcceleration, CostsWhatATrapezoidCosts) {
  Conditions conditions;
  conditions.options.shape = Shape::accelerate;
  // 100 mm at 100 mm/s with 0.8 of 1000 mm/s²: 1 s and once v/a.
  const Pulsed pulsed = pulse("G61 G1 X100 F6000\n", conditions);
  EXPECT_NEAR(static_cast<double>(pulsed.last) / 1e6, 1.125, 0.003);
}

/// By words, which have the jerk's limit besides, the butterfly takes 5.9 s; with a third of that acceleration across
/// its path more. Joints of chords are no corners.
TEST(PulseAcceleration, FollowsCurvesAsTheyBend) {
  Conditions conditions;
  conditions.options.shape = Shape::accelerate;
  EXPECT_LT(static_cast<double>(pulse(testing::text_of("09-butterfly.ngc"), conditions).last) / 1e6, 8);
  EXPECT_LT(static_cast<double>(pulse(testing::text_of("10-cubic.ngc"), conditions).last) / 1e6, 0.55);
}

TEST(PulseAcceleration, CarriesSpeedAlongOneDirection) {
  Conditions conditions;
  conditions.options.shape = Shape::accelerate;
  std::string text = "G61 F6000\n";
  for (int x = 1; x <= 200; ++x) text += "G1 X" + std::to_string(x / 2.0) + "\n";
  EXPECT_NEAR(static_cast<double>(pulse(text, conditions).last) / 1e6, 1.125, 0.003);
}

/// Blocks of different feeds: none is entered faster than its own asks for, whatever an override makes of them.
TEST(PulseAcceleration, EntersNoBlockFasterThanItsFeed) {
  Conditions conditions;
  conditions.options.shape = Shape::accelerate;
  for (const PulseMethod method : {PulseMethod::koren, PulseMethod::bresenham, PulseMethod::point_comparison}) {
    conditions.options.method = method;
    // 10 mm, half a millimetre at 1 mm/s, 9.5 mm: 100 mm/s and back take 0.125 s for 6.25 mm each.
    const Pulsed between = pulse("G61 F6000\nG1 X10\nX10.5 F60\nX20 F6000\n", conditions);
    EXPECT_NEAR(static_cast<double>(between.last) / 1e6, 0.5 + 0.1 + 0.095 + 2 * 0.125, 0.01);
    const Pulsed into = pulse("G61\nG0 Z-10\nG1 Z-11 F60\n", conditions);
    EXPECT_GT(static_cast<double>(into.last) / 1e6, 1.2);
    double x = 0, slow = 0, fast = 0;  // s
    pulse("G61 F600\nG1 X1\nX2 F60\nX3 F600\nX4 F60\n", conditions, [&](const TimedPulse& made) {
      x += made.pulse.step[0];
      if (x == 1001) fast = static_cast<double>(made.tick) / 1e6;
      if (x == 2000) slow = static_cast<double>(made.tick) / 1e6;
    });
    EXPECT_NEAR(slow - fast, 0.999, 0.002);
  }
}

/// Lines of a step or two, whatever their course: 10 mm at 9 mm/s, with what is known ahead of them.
TEST(PulseAcceleration, CarriesSpeedAlongLinesOfAStep) {
  Conditions conditions;
  conditions.options.shape = Shape::accelerate;
  for (const PulseMethod method : {PulseMethod::koren, PulseMethod::bresenham, PulseMethod::point_comparison}) {
    conditions.options.method = method;
    for (const double degrees : {0.0, 30.0, 45.0, 77.0}) {
      for (const double step : {0.001, 0.0015, 0.003}) {
        std::string text = "G61 F540\n";
        for (double distance = step; distance < 10; distance += step) {
          text += "G1 X" + std::to_string(distance * std::cos(degrees / 57.29578)) + " Y" +
                  std::to_string(distance * std::sin(degrees / 57.29578)) + "\n";
        }
        const Pulsed pulsed = pulse(text, conditions);
        // The path on the lattice may be longer by up to the square root of two.
        const double seconds = static_cast<double>(pulsed.last) / 1e6;
        EXPECT_LT(seconds, 1.45 * 10 / 9 + 0.03) << degrees << " degrees, " << step << " mm";
        EXPECT_GT(seconds, 10.0 / 9 + 0.005);
      }
    }
  }
}

}  // namespace test_pulse_acceleration
}  // namespace leadscrew::nc
