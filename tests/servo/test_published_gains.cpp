// Lin and Koren's two sets of gains, (P, I, D) = (2, 2, 15) and (6, 50, 25) at T = 10 ms, on their plane cubic at 10
// mm/s. The paper shows the measured velocity √(vx² + vy²) but names no plant: with the first gains it runs smoothly,
// with the second it overshoots far. The figures here belong to two plants K/(s(τs + 1)), the same for both axes, and
// to reference words that march along the curve by Taylor's series of second order.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "loops.hpp"

namespace leadscrew::servo::testing {
namespace test_published_gains {

constexpr double period = 0.01;
constexpr double feed = 10;

struct Point {
  double x, y;
};

/// x = 20u, y = −50u³ + 80u² − 10u; Δu = VT/|C′| − (C′·C″)(VT)²/(2|C′|⁴).
std::vector<Point> cubic_words() {
  std::vector<Point> words = {{0, 0}};
  for (double u = 0; u < 1;) {
    const double dx = 20, dy = -150 * u * u + 160 * u - 10, ddy = -300 * u + 160;
    const double step_length = feed * period, square = dx * dx + dy * dy;
    u = std::min(1.0,
                 u + step_length / std::sqrt(square) - dy * ddy * step_length * step_length / (2 * square * square));
    words.push_back({20 * u, ((-50 * u + 80) * u - 10) * u});
  }
  return words;
}

std::vector<Point> straight_words() {
  std::vector<Point> words;
  for (int k = 0; k < 300; ++k) words.push_back({feed * period * k, 0});
  return words;
}

/// Greatest √(vx² + vy²) over the feed, less 1: at the ends of the periods, as tachometers are read.
double overshoot(const std::vector<Point>& words, const PidGains& gains, double gain, double time_constant) {
  const AxisOptions axis{.drive = velocity_drive(gain, time_constant)};
  AxisLoop x = pid_loop(axis, {.gains = gains}, period), y = x;
  double fastest = 0;
  for (const Point& word : words) {
    x.follow({word.x});
    y.follow({word.y});
    fastest = std::max(fastest, std::hypot(x.axis().screw().velocity, y.axis().screw().velocity));
  }
  return fastest / feed - 1;
}

constexpr PidGains low{2, 2, 15}, high{6, 50, 25};

TEST(PublishedGains, OvershootOnTheCubic) {
  const auto words = cubic_words();
  EXPECT_EQ(words.size(), 300u);  // 3.0 s
  EXPECT_NEAR(overshoot(words, low, 10, 0.02), 0.031, 0.0005);
  EXPECT_NEAR(overshoot(words, high, 10, 0.02), 0.435, 0.0005);
  EXPECT_NEAR(overshoot(words, low, 17.8, 0.05), 0.019, 0.0005);
  EXPECT_NEAR(overshoot(words, high, 17.8, 0.05), 0.541, 0.0005);
}

/// A straight line has next to the same: the overshoot is the answer to a step of velocity.
TEST(PublishedGains, OvershootOnALine) {
  const auto words = straight_words();
  EXPECT_NEAR(overshoot(words, low, 10, 0.02), 0.0337, 0.0001);
  EXPECT_NEAR(overshoot(words, high, 10, 0.02), 0.4348, 0.0001);
  EXPECT_NEAR(overshoot(words, low, 17.8, 0.05), 0.0206, 0.0001);
  EXPECT_NEAR(overshoot(words, high, 17.8, 0.05), 0.5407, 0.0001);
}

/// Were D divided by T, these gains would not hold these plants at all.
TEST(PublishedGains, AreUnstableInTheStandardForm) {
  AxisLoop loop = pid_loop({.drive = velocity_drive(10, 0.02)}, {.gains = low, .form = PidForm::standard}, period);
  for (int k = 0; k < 100; ++k) loop.follow({feed * period * k});
  EXPECT_GT(std::fabs(loop.axis().screw().velocity), 1e6);
}

}  // namespace test_published_gains
}  // namespace leadscrew::servo::testing
