#include <gtest/gtest.h>

#include <algorithm>
#include <leadscrew/pulse/linear.hpp>

#include "tracing.hpp"

// "Linear interpolators and closed loops" (lecture); Koren's feed-rate example.

namespace leadscrew::pulse::testing {
namespace test_linear {

static_assert(root(25, 0) == 5 && root(24, 0) == 5 && root(20, 0) == 4 && root(0, 8) == 0);
static_assert(root(2, 16) == 92682);  // √2·2¹⁶ = 92681.9
static_assert(root((std::int64_t{1} << 62) - 1, 0) == std::int64_t{1} << 31);
static_assert(capacity_for(25) == 5 && capacity_for(26) == 6 && capacity_for(0) == 1);

constexpr std::int64_t reach = 256;  // BLU, of the lines tried

template <typename Make>
void expect_on_every_line(const Make& make, double bound) {
  double worst = 0;
  for (std::int64_t a = -reach; a <= reach; ++a) {
    for (std::int64_t b = -reach; b <= reach; ++b) {
      if (a == 0 && b == 0) continue;
      const Trace found = trace_line(make(Point{a, b}), {a, b});
      ASSERT_TRUE(found.ends) << a << ' ' << b;
      worst = std::max(worst, found.worst);
    }
  }
  EXPECT_LE(worst, bound);
}

LinearDda<2> along(Point delta, std::int64_t capacity, Preload preload) {
  return {{delta.x, delta.y}, capacity, preload};
}

TEST(LinearDda, KeepsWithinABluWhereItsCapacityIsTheLength) {
  const auto capacity = [](Point delta) { return capacity_for(delta.x * delta.x + delta.y * delta.y); };
  expect_on_every_line([&](Point delta) { return along(delta, capacity(delta), Preload::none); }, 0.9999);
  expect_on_every_line([&](Point delta) { return along(delta, capacity(delta), Preload::half); }, 0.7072);
}

TEST(LinearDda, KeepsWithinABluInABinaryRegister) {
  expect_on_every_line([](Point delta) { return along(delta, 512, Preload::none); }, 0.9999);
  expect_on_every_line([](Point delta) { return along(delta, 512, Preload::half); }, 0.7072);
}

/// m = 2ⁿ.
TEST(LinearDda, TakesAsManyClocksAsItsRegisterHasValues) {
  for (int bits = 1; bits <= 8; ++bits) {
    const std::int64_t capacity = std::int64_t{1} << bits;
    for (std::int64_t a = 1; a < capacity; ++a) {
      for (const Preload preload : {Preload::none, Preload::half}) {
        LinearDda<1> line({a}, capacity, preload);
        std::int64_t steps = 0;
        for (std::int64_t clock = 0; clock < capacity; ++clock) steps += line.step().step[0];
        EXPECT_EQ(steps, a);
        EXPECT_TRUE(line.done());
      }
    }
  }
}

/// "Design and implementation of digital integral interpolator based on LabVIEW": m = 2ⁿ, k = 1/2ⁿ, every end of
/// two axes.
TEST(DigitalIntegrals, ReachEveryEndAfter2ToTheNCycles) {
  for (int bits = 1; bits <= 8; ++bits) {
    const std::int64_t capacity = std::int64_t{1} << bits;
    for (const std::int64_t preload : {std::int64_t{0}, capacity / 2}) {
      for (std::int64_t x = 0; x < capacity; ++x) {
        for (std::int64_t y = 0; y < capacity; ++y) {
          LinearDda<2> line({x, -y}, capacity, preload);
          Point at;
          for (std::int64_t cycle = 0; cycle < capacity; ++cycle) {
            const auto [dx, dy] = line.step().step;
            at = {at.x + dx, at.y + dy};
          }
          ASSERT_EQ(at, (Point{x, -y})) << bits;
          ASSERT_TRUE(line.done());
        }
      }
    }
  }
}

TEST(LinearDda, CarriesNineAxesToTheirEnd) {
  const std::array<std::int64_t, 9> delta = {7, -1000, 0, 999, 1, -3, 500, 333, -64};
  LinearDda<9> line(delta, 1000, Preload::half);
  std::array<std::int64_t, 9> at{};
  for (int clock = 0; clock <= 1000; ++clock) {
    const Pulse<9> pulse = line.step();
    for (std::size_t i = 0; i < at.size(); ++i) {
      at[i] += pulse.step[i];
      EXPECT_LE(std::abs(static_cast<double>(at[i]) - static_cast<double>(delta[i]) * std::min(clock + 1, 1000) / 1000),
                1);
    }
  }
  EXPECT_EQ(at, delta);
  EXPECT_TRUE(line.done());
}

TEST(LinearPointComparison, KeepsWithinABlu) {
  expect_on_every_line([](Point delta) { return LinearPointComparison<2>({delta.x, delta.y}); }, 1);
}

TEST(LinearPointComparison, StepsOneAxisAClock) {
  const Trace found = trace_line(LinearPointComparison<2>({4, -3}), {4, -3});
  EXPECT_EQ(found.clocks, 7);
  EXPECT_EQ(found.pulses, 7);
}

/// The first of those that have the greatest share of their distance left: of nine axes, two of which stand still.
TEST(LinearPointComparison, StepsTheAxisThatIsFurthestBehind) {
  const std::array<std::int64_t, 9> delta = {0, -100, 7, 0, 64, -3, 50, 33, -64};
  LinearPointComparison<9> line(delta);
  std::array<std::int64_t, 9> at{};
  for (int clock = 0; clock < 100 + 7 + 64 + 3 + 50 + 33 + 64; ++clock) {
    const auto share_left = [&](std::size_t i) {
      return 1 - static_cast<double>(at[i]) / static_cast<double>(delta[i]);
    };
    const Pulse<9> pulse = line.step();
    const auto stepped = static_cast<std::size_t>(
        std::ranges::find_if(pulse.step, [](std::int8_t step) { return step != 0; }) - pulse.step.begin());
    ASSERT_LT(stepped, 9u);
    for (std::size_t i = 0; i < delta.size(); ++i) {
      if (delta[i] == 0 || i == stepped) continue;
      const double ahead = share_left(stepped) - share_left(i);  // two shares are equal or 1/6400 apart
      ASSERT_TRUE(ahead > 1e-6 || (ahead > -1e-6 && stepped < i)) << clock << ' ' << i;
    }
    for (std::size_t i = 0; i < at.size(); ++i) at[i] += pulse.step[i];
    ASSERT_EQ(line.left(stepped), std::abs(delta[stepped] - at[stepped]));
  }
  EXPECT_EQ(at, delta);
  EXPECT_TRUE(line.done());
}

/// Shares of the longest distances are told apart: by products.
TEST(LinearPointComparison, TellsSharesOfTheLongestDistancesApart) {
  constexpr std::int64_t most = greatest_coordinate;
  const std::array<std::int64_t, 5> delta = {most - 1, -most, most - 2, most, most / 2 - 1};
  LinearPointComparison<5> line(delta);
  std::array<std::int64_t, 5> left = {most - 1, most, most - 2, most, most / 2 - 1};
  const auto whole = left;
  for (int clock = 0; clock < 200'000; ++clock) {
    std::size_t last = 0;
    for (std::size_t i = 1; i < left.size(); ++i) {
      if (left[last] * whole[i] < left[i] * whole[last]) last = i;
    }
    const Pulse<5> pulse = line.step();
    for (std::size_t i = 0; i < left.size(); ++i) ASSERT_EQ(pulse.step[i], i == last ? sign(delta[i]) : 0) << clock;
    --left[last];
  }
}

TEST(LinearBresenham, KeepsWithinHalfABlu) {
  expect_on_every_line([](Point delta) { return LinearBresenham(delta); }, 0.5);
}

TEST(LinearBresenham, TakesAsManyClocksAsTheLongerAxisHasSteps) {
  EXPECT_EQ(trace_line(LinearBresenham({-40, 23}), {-40, 23}).clocks, 40);
  EXPECT_EQ(trace_line(LinearBresenham({0, 23}), {0, 23}).clocks, 23);
}

// ---------------------------------------------------------------------------------------------------------------------

std::int64_t commands(FeedDda feed, std::int64_t clocks) {
  std::int64_t count = 0;
  for (std::int64_t clock = 0; clock < clocks; ++clock) count += feed.step();
  return count;
}

/// f = 100·V0, q0 = 3000, 5000 interrupts a second: V0 = 30 in/min gives a command each, 12.34 in/min 2056.67 a second.
TEST(KorenFeed, GivesSoManyCommandsASecond) {
  constexpr std::int64_t minute = 5000 * 60;
  EXPECT_EQ(commands({3000, 3000}, 5000), 5000);
  EXPECT_EQ(commands({3000, 1234}, minute), 123400);  // 2056.67 a second
  EXPECT_EQ(commands({3000, 0}, minute), 0);
}

/// Equations 1 to 5 overflow where r > q: as where r ≥ q from a remainder that is lower by one. Beside the closed form,
/// ⌈(r + kp)/q⌉ − 1 overflows after k additions.
TEST(KorenEquations1To5, OverflowAsARemainderLowerByOneDoesAtQ) {
  for (std::int64_t capacity = 1; capacity <= 24; ++capacity) {
    for (std::int64_t integrand = 0; integrand <= capacity; ++integrand) {
      for (std::int64_t remainder = 0; remainder <= capacity; ++remainder) {
        Integrator integrator(capacity, remainder - 1);
        std::int64_t pulses = 0;
        for (std::int64_t k = 1; k <= 3 * capacity; ++k) {
          pulses += integrator.add(integrand);
          ASSERT_EQ(pulses, std::max<std::int64_t>(0, (remainder + k * integrand + capacity - 1) / capacity - 1))
              << capacity << ' ' << integrand << ' ' << remainder << ' ' << k;
        }
      }
    }
  }
}

/// A 13-bit register clocked 1024 times a second, with the loads 1, 2 and 4: first overflow after 8, 4 and 2 s.
TEST(LectureTimer, Takes8And4And2Seconds) {
  for (const std::int64_t load : {1, 2, 4}) {
    Integrator timer(std::int64_t{1} << 13, 0);
    std::int64_t clock = 1;
    while (!timer.add(load)) ++clock;
    EXPECT_EQ(clock, 1024 * 8 / load);
  }
}

/// Where only r > q overflows, q = 8192: as r ≥ q does with a remainder that begins one lower.
TEST(LectureTimer, IsOneClockLateWhereOnlyMoreOverflows) {
  for (const std::int64_t load : {1, 2, 4}) {
    std::int64_t strict = 0, clocks = 0;
    for (; strict <= 8192; ++clocks) strict += load;
    Integrator timer(8192, -1);
    std::int64_t clock = 1;
    while (!timer.add(load)) ++clock;
    EXPECT_EQ(clock, 8192 / load + 1) << load;
    EXPECT_EQ(clock, clocks) << load;
  }
}

}  // namespace test_linear
}  // namespace leadscrew::pulse::testing
