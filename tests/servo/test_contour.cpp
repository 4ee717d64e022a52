// Contours under two loops: the simulated ones beside the closed forms, and those beside their textbook approximations.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <complex>
#include <leadscrew/servo/contour.hpp>
#include <random_numbers.hpp>

#include "loops.hpp"

namespace leadscrew::servo::testing {
namespace test_contour {

using testing_support::any;
using testing_support::logarithmic;

AxisLoop loop_of(const PositionLoop& loop, double period) {
  return proportional_loop(loop.gain, loop.time_constant, period);
}

/// Kv·τ from well damped to a loop that rings, settled after the same count of time constants.
PositionLoop any_loop() {
  const double gain = logarithmic(10, 50);
  return {gain, logarithmic(0.05, 1) / gain};
}

/// A sampled proportional loop follows a ramp V/Kv behind, too: its command is constant there.
RC_GTEST_PROP(LineContour, ErrorIsThatOfTheUnequalGains, ()) {
  const PositionLoop x = any_loop(), y = any_loop();
  const double period = 1e-3, speed = logarithmic(1, 100), angle = any(-314, 315) / 100.0;
  AxisLoop in_x = loop_of(x, period), in_y = loop_of(y, period);
  const double c = std::cos(angle), s = std::sin(angle);
  for (int k = 0; k < 8000; ++k) {
    in_x.follow({speed * k * period * c});
    in_y.follow({speed * k * period * s});
  }
  const double across = in_y.axis().slide() * c - in_x.axis().slide() * s;
  RC_ASSERT(std::fabs(across - line_contour_error(speed, angle, x, y)) <= 1e-9 * speed);
}

/// Beside the form in which it is known: half the speed, at 45°.
TEST(LineContour, ErrorOfKnownGains) {
  EXPECT_NEAR(line_contour_error(10, std::atan(1.0), {20, 0.02}, {25, 0.02}), 5 * (0.05 - 0.04), 1e-15);
  EXPECT_EQ(line_contour_error(10, 0.7, {20, 0.02}, {20, 0.01}), 0);
}

/// τh″ + h′ + Kv·h = 0 from h = 0, h′ = Kv/τ, by Runge and Kutta's classical method.
RC_GTEST_PROP(GreatestGain, IsTheIntegralOfTheImpulseResponse, ()) {
  const PositionLoop loop{logarithmic(5, 50), logarithmic(0.001, 0.2)};
  const double step = std::min(loop.time_constant, 1 / loop.gain) / 200;
  const double end = 50 * std::max(loop.time_constant, 1 / loop.gain);
  double h = 0, slope = loop.gain / loop.time_constant, sum = 0;
  const auto pull = [&](double at, double v) { return -(v + loop.gain * at) / loop.time_constant; };
  for (double time = 0; time < end; time += step) {
    const double before = h;
    const double v1 = slope, a1 = pull(h, v1), v2 = v1 + step / 2 * a1, a2 = pull(h + step / 2 * v1, v2);
    const double v3 = v1 + step / 2 * a2, a3 = pull(h + step / 2 * v2, v3), v4 = v1 + step * a3;
    const double a4 = pull(h + step * v3, v4);
    h += step / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    slope += step / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    sum += step * std::fabs(before + h) / 2;
  }
  RC_ASSERT(std::fabs(sum / greatest_gain(loop) - 1) <= 1e-4);
}

/// Least and greatest distance from the centre in the last turn of several.
SemiAxes travelled(double radius, double frequency, const PositionLoop& x, const PositionLoop& y, double period) {
  AxisLoop in_x = loop_of(x, period), in_y = loop_of(y, period);
  SemiAxes seen{0, 1e300};
  const double turn = 2 * 3.14159265358979323846 / frequency;
  const auto settled = static_cast<int>(80 / std::min(x.gain, y.gain) / period);
  const int last = settled + static_cast<int>(turn / period) + 1;
  for (int k = 0; k < last; ++k) {
    if (k >= settled) {
      const double distance = std::hypot(in_x.axis().slide(), in_y.axis().slide());
      seen.major = std::max(seen.major, distance);
      seen.minor = std::min(seen.minor, distance);
    }
    in_x.follow({radius * std::cos(frequency * k * period)});
    in_y.follow({radius * std::sin(frequency * k * period)});
  }
  return seen;
}

/// Of the loop that is sampled with a zero-order hold: G(z) at z = e^(jωT), from the plant's pulse response.
double sampled_amplitude(const PositionLoop& loop, double frequency, double period) {
  const std::complex<double> z = std::polar(1.0, frequency * period);
  const double decay = std::exp(-period / loop.time_constant), lag = loop.time_constant;
  // x₊ = x + τ(1 − E)v + (T − τ(1 − E))w,  v₊ = E·v + (1 − E)w
  const std::complex<double> v = (1 - decay) / (z - decay);
  const std::complex<double> g = (lag * (1 - decay) * v + period - lag * (1 - decay)) / (z - 1.0);
  return std::abs(loop.gain * g / (1.0 + loop.gain * g));
}

RC_GTEST_PROP(CircleContour, OfEqualLoopsHasTheRadiusOfTheSampledResponse, ()) {
  const PositionLoop loop = any_loop();
  const double radius = logarithmic(1, 100), frequency = logarithmic(0.5, 10), period = 2e-3;
  const SemiAxes seen = travelled(radius, frequency, loop, loop, period);
  const double expected = radius * sampled_amplitude(loop, frequency, period);
  RC_ASSERT(std::fabs(seen.major - expected) <= 1e-9 * radius);
  RC_ASSERT(std::fabs(seen.minor - expected) <= 1e-9 * radius);
}

/// As the period shrinks, what is travelled becomes what the loops without sampling travel, in proportion to it.
TEST(CircleContour, OfUnequalLoopsIsTheEllipseOfTheirResponses) {
  const double radius = 20, frequency = 2;
  const PositionLoop x{25, 0.03}, y{18, 0.01};
  const SemiAxes formula = circle_semi_axes(radius, frequency, x, y);
  double error_before = 0;
  for (const double period : {1e-3, 2.5e-4, 6.25e-5}) {
    const SemiAxes seen = travelled(radius, frequency, x, y, period);
    const double error = std::max(std::fabs(seen.major - formula.major), std::fabs(seen.minor - formula.minor));
    EXPECT_LT(error, radius * period) << period;
    if (error_before > 0) {
      EXPECT_NEAR(error_before / error, 4, 0.5) << period;
    }
    error_before = error;
  }
}

TEST(CircleContour, SemiAxesAreTheExtremesOfTheEllipse) {
  for (const double frequency : {0.3, 3.0, 15.0}) {
    const PositionLoop x{25, 0.03}, y{15, 0.05};
    const Response of_x = response(x, frequency), of_y = response(y, frequency);
    double major = 0, minor = 1e300;
    for (int k = 0; k < 200000; ++k) {
      const double angle = k * 3.14159265358979e-5;
      const double distance =
          std::hypot(of_x.amplitude * std::cos(angle + of_x.phase), of_y.amplitude * std::sin(angle + of_y.phase));
      major = std::max(major, distance);
      minor = std::min(minor, distance);
    }
    const SemiAxes axes = circle_semi_axes(1, frequency, x, y);
    EXPECT_NEAR(axes.major, major, 1e-8) << frequency;
    EXPECT_NEAR(axes.minor, minor, 1e-8) << frequency;
  }
}

/// The transfer function itself, in complex numbers.
TEST(CircleContour, ResponseIsThatOfTheTransferFunction) {
  for (const double frequency : {0.0, 0.1, 5.0, 40.0, 300.0}) {
    const std::complex<double> s(0, frequency);
    const std::complex<double> h = 20.0 / (0.02 * s * s + s + 20.0);
    const Response got = response({20, 0.02}, frequency);
    EXPECT_NEAR(got.amplitude, std::abs(h), 1e-15) << frequency;
    EXPECT_NEAR(got.phase, std::arg(h), 1e-14) << frequency;
  }
}

/// R(1 − |H|) ≈ R·ω²(1 − 2Kv·τ)/(2Kv²), and with unequal gains ±(V/2)(1/Kx − 1/Ky) more.
TEST(CircleContour, ErrorsAreTheTextbooksAtLowSpeed) {
  const double radius = 50, frequency = 0.05;
  const SemiAxes equal = circle_semi_axes(radius, frequency, {20, 0.01}, {20, 0.01});
  EXPECT_NEAR(equal.major, equal.minor, 1e-12);
  const double smaller = radius * frequency * frequency * (1 - 2 * 20 * 0.01) / (2 * 20 * 20);
  EXPECT_NEAR(radius - equal.major, smaller, 1e-4 * smaller);
  const SemiAxes unequal = circle_semi_axes(radius, frequency, {20, 0}, {25, 0});
  const double across = radius * frequency / 2 * (1.0 / 20 - 1.0 / 25);
  EXPECT_NEAR((unequal.major - unequal.minor) / 2, across, 1e-4 * across);
}

}  // namespace test_contour
}  // namespace leadscrew::servo::testing
