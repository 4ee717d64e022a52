// How evenly words travel where feed is planned constant, against motions whose unevenness is known in closed form.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/referee/feed_ripple.hpp>

#include "track.hpp"

namespace leadscrew::referee::test {
namespace test_feed_ripple {

constexpr base::Period millisecond{1'000'000};
constexpr ProgrammedFeed programmed{FeedAxes::xyz, 50};

/// Words of a helix about Z of radius 5 mm, as many as these places along it, mm.
double ripple_of_helix(const std::vector<double>& places, std::optional<double> planned) {
  FeedRipple ripple(millisecond);
  constexpr double radius = 5, rise = 0.6;  // of a millimetre along the path
  const double turn = std::sqrt(1 - rise * rise) / radius;
  for (const double s : places) {
    AxisVector position{};
    at(position, Axis::X) = radius * std::cos(turn * s);
    at(position, Axis::Y) = radius * std::sin(turn * s);
    at(position, Axis::Z) = rise * s;
    ripple.observe(position, planned, programmed);
  }
  return ripple.greatest().value_or(-1);
}

std::vector<double> places(double step, double modulation, int count = 400) {
  std::vector<double> places;
  for (int n = 0; n < count; ++n) places.push_back(step * (n + modulation * std::sin(0.3 * n)));
  return places;
}

TEST(FeedRipple, IsNoneOnACircleAtConstantSpeed) {
  EXPECT_LT(ripple_of_helix(places(0.05, 0), 50), 1e-9);
  EXPECT_LT(ripple_of_helix(places(0.5, 0), 500), 1e-6);  // a tenth of a radius a word
}

/// The greatest step of s = V·(n + ε sin ωn) is longer by 2ε sin(ω/2), where its middle is at a whole turn.
TEST(FeedRipple, IsTheDepartureOfTheTravel) {
  for (const double modulation : {1e-3, 0.1}) {
    const double departure = 2 * modulation * std::sin(0.15);
    EXPECT_NEAR(ripple_of_helix(places(0.05, modulation, 4000), 50), departure, 1e-3 * departure);
  }
}

TEST(FeedRipple, IsOfTheFeedThatIsPlanned) {
  EXPECT_NEAR(ripple_of_helix(places(0.05, 0), 40), 0.25, 1e-9);
  EXPECT_NEAR(ripple_of_helix(places(0.05, 0), 100), 0.5, 1e-9);
}

TEST(FeedRipple, IsNotKnownWithoutAPlan) {
  EXPECT_EQ(ripple_of_helix(places(0.05, 0.1), std::nullopt), -1);
}

TEST(FeedRipple, LooksOnlyWhereFourWordsAreOfOneFeed) {
  FeedRipple ripple(millisecond);
  double x = 0;
  for (int n = 0; n < 100; ++n) {
    const bool steps = n % 4 == 3;  // never four words of one feed without one
    ripple.observe({x}, steps ? 51.0 : 50.0, programmed);
    x += steps ? 1 : 0.05;
  }
  EXPECT_EQ(ripple.greatest(), 0);
}

TEST(FeedRipple, DoesNotCountRapids) {
  FeedRipple ripple(millisecond);
  for (int n = 0; n < 10; ++n) ripple.observe({n * n * 1.0}, 200, {FeedAxes::xyz, HUGE_VAL});
  EXPECT_EQ(ripple.greatest(), 0);
}

/// Feed is degrees/s where the rotary axes alone are fed, whatever else stands.
TEST(FeedRipple, CountsTheAxesOfTheFeed) {
  FeedRipple ripple(millisecond);
  for (int n = 0; n < 10; ++n) {
    AxisVector position{};
    at(position, Axis::A) = 0.05 * n;
    ripple.observe(position, 50, {FeedAxes::abc, 50});
  }
  EXPECT_LT(ripple.greatest(), 1e-9);
}

}  // namespace test_feed_ripple
}  // namespace leadscrew::referee::test
