// The milling force: its mean over a turn, the volume it cuts, and its noise.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <leadscrew/servo/cutting_force.hpp>
#include <random_numbers.hpp>

namespace leadscrew::servo::testing {
namespace test_cutting_force {

using testing_support::any;
using testing_support::logarithmic;

MillingOptions any_mill() {
  return {.teeth = any(1, 9),
          .diameter = logarithmic(1, 60),
          .spindle_speed = logarithmic(1, 500),
          .cutting_coefficient = logarithmic(200, 4000),
          .edge_coefficient = any(0, 2) * logarithmic(1, 30)};
}

RC_GTEST_PROP(MillingForce, HasTheMeanOfItsFormula, ()) {
  const MillingOptions options = any_mill();
  MillingForce mill = MillingForce::create(options).value();
  const double feed = logarithmic(0.5, 100);
  const Engagement engagement{logarithmic(0.1, 10), options.diameter * any(1, 101) / 100.0};
  constexpr int parts = 20000;
  double sum = 0;
  for (int k = 0; k < parts; ++k) sum += mill.after(1 / options.spindle_speed / parts, feed, engagement);
  RC_ASSERT(std::fabs(sum / parts / mill.mean(feed, engagement) - 1) <= 1e-3 * options.diameter / engagement.width);
}

/// Without edges: force times cutting speed π·D·n is Kt times the volume ap·ae·feed.
RC_GTEST_PROP(MillingForce, CutsTheVolumeThatItsPowerSays, ()) {
  MillingOptions options = any_mill();
  options.edge_coefficient = 0;
  const MillingForce mill = MillingForce::create(options).value();
  const double feed = logarithmic(0.5, 100);
  const Engagement engagement{logarithmic(0.1, 10), options.diameter * any(1, 101) / 100.0};
  const double power = mill.mean(feed, engagement) * 3.14159265358979323846 * options.diameter * options.spindle_speed;
  const double volume = engagement.depth * engagement.width * feed;
  RC_ASSERT(std::fabs(power / (options.cutting_coefficient * volume) - 1) <= 1e-9);
}

TEST(MillingForce, DoublesWithTheDepth) {
  const MillingForce mill = MillingForce::create({.cutting_coefficient = 1000, .edge_coefficient = 10}).value();
  EXPECT_DOUBLE_EQ(mill.mean(10, {4, 5}), 2 * mill.mean(10, {2, 5}));
  EXPECT_EQ(mill.mean(10, {0, 5}), 0);
  EXPECT_EQ(mill.mean(10, {2, 0}), 0);
}

TEST(MillingForce, NoiseHasItsDeviationAndItsSeed) {
  const MillingOptions options{.cutting_coefficient = 1000, .noise = 7, .seed = 42};
  MillingForce one = MillingForce::create(options).value(), same = one;
  MillingOptions other_seed = options;
  other_seed.seed = 43;
  MillingForce other = MillingForce::create(other_seed).value();
  double sum = 0, squares = 0;
  int alike = 0;
  constexpr int count = 200000;
  for (int k = 0; k < count; ++k) {
    const double noise = one.after(1e-4, 0, {0, 0});
    EXPECT_EQ(noise, same.after(1e-4, 0, {0, 0}));
    alike += noise == other.after(1e-4, 0, {0, 0}) ? 1 : 0;
    EXPECT_LE(std::fabs(noise), 7 * std::sqrt(6.0));
    sum += noise;
    squares += noise * noise;
  }
  EXPECT_NEAR(sum / count, 0, 0.1);
  EXPECT_NEAR(std::sqrt(squares / count), 7, 0.05);
  EXPECT_LT(alike, 10);
}

std::string refusal(const MillingOptions& options) {
  const auto mill = MillingForce::create(options);
  return mill ? "" : std::string(mill.error().code) + ": " + mill.error().message;
}

TEST(MillingForce, SaysWhichOptionIsWrong) {
  EXPECT_EQ(refusal({.cutting_coefficient = 1000}), "");
  EXPECT_EQ(refusal({.teeth = 0, .cutting_coefficient = 1000}), "servo-milling: the number of teeth is 0");
  EXPECT_EQ(refusal({.diameter = 0, .cutting_coefficient = 1000}), "servo-milling: the diameter is 0");
  EXPECT_EQ(refusal({}), "servo-milling: the cutting coefficient is 0");
  EXPECT_EQ(refusal({.cutting_coefficient = 1000, .noise = -1}), "servo-milling: noise is -1");
}

}  // namespace test_cutting_force
}  // namespace leadscrew::servo::testing
