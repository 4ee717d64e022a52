#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "follower.h"

// A spindle of which only the place of each period is known, and a line of a thread in step with it.

namespace {

constexpr double velocity = 200, acceleration = 1000, jerk = 20000, period = 1e-3;

/// Revolutions after `t` s, at `speed` per second that wanders by a share, so many times a second.
double revolutions(double t, double speed, double wander, double times) {
  const double w = 2 * std::numbers::pi * times;
  return speed * (t + wander * (1 - std::cos(w * t)) / w);
}

/// The greatest share of the limits that differences of these places show.
double burden(const std::vector<double>& places) {
  double most = 0;
  for (std::size_t i = 3; i < places.size(); ++i) {
    const double v = (places[i] - places[i - 1]) / period;
    const double a = (places[i] - 2 * places[i - 1] + places[i - 2]) / (period * period);
    const double j = (places[i] - 3 * places[i - 1] + 3 * places[i - 2] - places[i - 3]) / (period * period * period);
    most = std::max({most, std::abs(v) / velocity, std::abs(a) / acceleration, std::abs(j) / jerk});
  }
  return most;
}

TEST(Follower, IsInStepWithAWanderingSpindleBehindItsRunInAndEndsAtTheEnd) {
  for (const double speed : {5.0, 15.0, 50.0}) {
    for (const double lead : {0.5, 1.0, 2.0}) {
      leadscrew_tp_follower follower;
      leadscrew_tp_follower_begin(&follower, velocity, acceleration, jerk, period);
      const double end = 2.5 * speed * lead;  // so many mm in 2.5 s
      std::vector<double> places(4, 0.0);
      double worst = 0;
      bool has_ended = false;
      for (int n = 0; n < 5000 && !has_ended; ++n) {
        const double place = lead * revolutions(n * period, speed, 0.05, 1);
        has_ended = leadscrew_tp_follower_follow(&follower, place, end);
        places.push_back(follower.s);
        const double now = lead * revolutions((n + 1) * period, speed, 0.05, 1);
        if (n > 1000 && n < 2000) worst = std::max(worst, std::abs(follower.s - now));
      }
      places.insert(places.end(), 4, follower.s);
      EXPECT_TRUE(has_ended) << speed << " of " << lead;
      EXPECT_EQ(follower.s, end);
      EXPECT_LE(worst, 0.01) << speed << " of " << lead;
      EXPECT_LE(burden(places), 1.001) << speed << " of " << lead;
    }
  }
}

/// Places on a line without an end, along which the spindle asks for lead · revolutions.
std::vector<double> followed(const std::function<double(double)>& place, double seconds, double cycle = period) {
  leadscrew_tp_follower follower;
  leadscrew_tp_follower_begin(&follower, velocity, acceleration, jerk, cycle);
  std::vector<double> places;
  for (int n = 0; n * cycle < seconds; ++n) {
    leadscrew_tp_follower_follow(&follower, place(n * cycle), std::numeric_limits<double>::infinity());
    places.push_back(follower.s);
  }
  return places;
}

TEST(Follower, RunsInWithinWhatIsTold) {
  // s at mm/s, of a spindle that wanders by 5 %: then within 10 µm.
  for (const auto& [speed, run_in] : {std::pair{10.0, 0.1}, {30.0, 0.22}, {50.0, 0.3}}) {
    const auto place = [speed](double t) { return revolutions(t, speed, 0.05, 1); };
    const std::vector<double> places = followed(place, 3);
    double worst = 0;
    for (std::size_t n = 0; n < places.size(); ++n) {
      const double t = period * static_cast<double>(n);
      if (t >= run_in) worst = std::max(worst, std::abs(places[n] - place(t + period)));
    }
    EXPECT_LE(worst, 0.01) << speed;
    EXPECT_LE(burden(places), 1.001) << speed;
  }
}

TEST(Follower, IsInStepWhereASpindleTurnsBack) {
  // 10 turns of 1 mm a second, and back by 50 a second².
  const auto place = [](double t) {
    const double turning = std::clamp(t - 1, 0.0, 0.4);
    return 10 * std::min(t, 1.0) + 10 * turning - 25 * turning * turning - 10 * std::max(0.0, t - 1.4);
  };
  const std::vector<double> places = followed(place, 2.5);
  double worst = 0;
  for (std::size_t n = 500; n < places.size(); ++n)
    worst = std::max(worst, std::abs(places[n] - place(period * static_cast<double>(n + 1))));
  EXPECT_LE(worst, 0.01);
  EXPECT_LE(burden(places), 1.001);
}

TEST(Follower, IsInStepWithLongPeriodsToo) {
  constexpr double cycle = 0.02;
  const std::vector<double> places = followed([](double t) { return 10 * t; }, 4, cycle);
  for (std::size_t n = 100; n < places.size(); ++n)
    EXPECT_NEAR(places[n], 10 * cycle * static_cast<double>(n + 1), 0.01) << n;
}

TEST(Follower, TurnsBackWithTheSpindleAndGoesToWhereItBegan) {
  leadscrew_tp_follower follower;
  leadscrew_tp_follower_begin(&follower, velocity, acceleration, jerk, period);
  std::vector<double> places(4, 0.0);
  constexpr double everywhere = std::numeric_limits<double>::infinity();
  // To and fro, as a tap goes: 10 mm deep, turning for 2 s.
  for (int n = 0; n < 2000; ++n) {
    leadscrew_tp_follower_follow(&follower, 5 * (1 - std::cos(std::numbers::pi * n * period)), everywhere);
    places.push_back(follower.s);
  }
  EXPECT_NEAR(follower.s, 0, 0.05);
  bool rests = false;
  for (int n = 0; n < 1000 && !rests; ++n) {
    rests = leadscrew_tp_follower_stop(&follower);
    places.push_back(follower.s);
  }
  EXPECT_TRUE(rests);
  rests = false;
  for (int n = 0; n < 1000 && !rests; ++n) {
    rests = leadscrew_tp_follower_go(&follower, 0);
    places.push_back(follower.s);
  }
  EXPECT_TRUE(rests);
  EXPECT_EQ(follower.s, 0);
  places.insert(places.end(), 4, follower.s);
  EXPECT_LE(burden(places), 1.001);
}

TEST(Follower, EndsShortLinesWithinLimitsToo) {
  for (const double end : {0.1, 0.5, 1.0, 3.0}) {
    leadscrew_tp_follower follower;
    leadscrew_tp_follower_begin(&follower, velocity, acceleration, jerk, period);
    std::vector<double> places(4, 0.0);
    bool has_ended = false;
    for (int n = 0; n < 5000 && !has_ended; ++n) {
      has_ended = leadscrew_tp_follower_follow(&follower, 30 * n * period, end);
      places.push_back(follower.s);
    }
    places.insert(places.end(), 4, follower.s);
    EXPECT_TRUE(has_ended) << end;
    EXPECT_EQ(follower.s, end);
    EXPECT_LE(burden(places), 1.001) << end;
  }
}

}  // namespace
