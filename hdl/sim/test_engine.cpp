#include <Vmotion_core.h>
#include <Vmotion_core_6.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "core_bench.hpp"

// The engine of rtl/motion_core.sv beside pulse/: lines of three axes and arcs, every step at its tick.

namespace leadscrew::hardware {
namespace test_engine {

using Core24 = Core<Vmotion_core, 24, 40>;
using Core6 = Core<Vmotion_core_6, 6, 8>;

CorePulse in_plane(const pulse::Pulse<2>& pulse, std::size_t x, std::size_t y) {
  CorePulse made;
  made.step[x] = pulse.step[0];
  made.step[y] = pulse.step[1];
  return made;
}

std::string text_of(const pulse::Arc& arc) {
  return "(" + std::to_string(arc.start.x) + ", " + std::to_string(arc.start.y) + ") -> (" + std::to_string(arc.end.x) +
         ", " + std::to_string(arc.end.y) + ") " + (arc.is_counterclockwise() ? "ccw" : "cw");
}

/// A step at each tick; the same ones, and no more.
template <typename AnyCore, typename State, typename Placed>
testing::AssertionResult same(AnyCore& core, std::vector<CoreCommand> commands, State state, std::int64_t most,
                              const Placed& placed) {
  for (CoreCommand& command : commands) command.feed = command.feed_straight = AnyCore::every_tick;
  if (!commands.empty()) commands.back().final = true;
  std::int64_t ticks = 0, wrong = 0;
  core.run(commands, most, [&](const CorePulse& pulse) {
    ++ticks;
    if ((state.done() || pulse != placed(state.step())) && wrong == 0) wrong = ticks;
  });
  if (wrong != 0) return testing::AssertionFailure() << "another step at tick " << wrong;
  if (!state.done()) return testing::AssertionFailure() << "ends early, after " << ticks << " ticks";
  if (core->error != 0) return testing::AssertionFailure() << "error " << int{core->error};
  return testing::AssertionSuccess();
}

template <typename AnyCore>
testing::AssertionResult same_line(AnyCore& core, const CoreVector& delta) {
  return same(core, {line_command(delta)}, line_of_pulse(delta), std::int64_t{1} << 25,
              [](const CorePulse& pulse) { return pulse; });
}

template <typename AnyCore>
testing::AssertionResult same_arc(AnyCore& core, const pulse::Arc& arc, std::size_t x, std::size_t y) {
  std::vector<CoreCommand> commands;
  push_arc(commands, arc, x, y);
  return same(core, commands, CircleOfPulse(arc), std::int64_t{1} << 25,
              [=](const pulse::Pulse<2>& pulse) { return in_plane(pulse, x, y); });
}

/// All lattice points within half a BLU of the circle through `start`.
std::vector<pulse::Point> ends_for(pulse::Point start) {
  std::vector<pulse::Point> ends;
  const auto radius = std::sqrt(static_cast<double>(start.x * start.x + start.y * start.y));
  const auto most = static_cast<std::int64_t>(radius + 0.5);
  for (std::int64_t x = -most; x <= most; ++x) {
    for (std::int64_t y = -most; y <= most; ++y) {
      const double off = std::hypot(static_cast<double>(x), static_cast<double>(y)) - radius;
      if (off <= 0.5 && off >= -0.5) ends.push_back({x, y});
    }
  }
  return ends;
}

TEST(Engine, MakesEveryLineOfWidth6InAnyPlane) {
  Core6 core;
  for (std::int64_t a = -31; a <= 31; ++a) {
    for (std::int64_t b = -31; b <= 31; ++b) {
      if (a == 0 && b == 0) continue;
      ASSERT_TRUE(same_line(core, {a, b, 0})) << a << ' ' << b;
      ASSERT_TRUE(same_line(core, {b, 0, a})) << a << ' ' << b;
    }
  }
}

TEST(Engine, MakesLinesOfThreeAxesOfWidth6) {
  Core6 core;
  for (std::int64_t a = -31; a <= 31; a += 2) {
    for (std::int64_t b = 0; b <= 31; b += 3) {
      for (std::int64_t c = 1; c <= 31; c += 2) ASSERT_TRUE(same_line(core, {a, b, -c})) << a << ' ' << b << ' ' << c;
    }
  }
}

/// All arcs of R ≤ 31, which 6 bits hold.
TEST(Engine, MakesEveryArcOfWidth6) {
  Core6 core;
  std::int64_t arcs = 0;
  for (std::int64_t x = -31; x <= 31; ++x) {
    for (std::int64_t y = -31; y <= 31; ++y) {
      const pulse::Point start{x, y};
      if (start == pulse::Point{} || x * x + y * y > 31 * 31) continue;
      for (const pulse::Point end : ends_for(start)) {
        if (end == pulse::Point{}) continue;
        for (const auto direction : {pulse::Direction::clockwise, pulse::Direction::counterclockwise}) {
          const pulse::Arc arc{start, end, direction};
          ASSERT_TRUE(same_arc(core, arc, 0, 1)) << text_of(arc);
          ++arcs;
        }
      }
    }
  }
  EXPECT_GT(arcs, 500'000);
}

pulse::Arc random_arc(std::mt19937_64& random, std::int64_t greatest) {
  std::uniform_int_distribution<std::int64_t> coordinate(-greatest, greatest);
  std::uniform_real_distribution<double> angle(0, 6.283185307179586);
  pulse::Arc arc;
  do {
    arc.start = {coordinate(random), coordinate(random)};
  } while (arc.start == pulse::Point{});
  do {
    const double radius = std::sqrt(static_cast<double>(arc.squared_radius())), at = angle(random);
    arc.end = {std::llround(radius * std::cos(at)), std::llround(radius * std::sin(at))};
  } while (arc.end == pulse::Point{});
  arc.direction = random() % 2 == 0 ? pulse::Direction::clockwise : pulse::Direction::counterclockwise;
  return arc;
}

TEST(Engine, MakesRandomArcsOfWidth24InAnyPlane) {
  Core24 core;
  std::mt19937_64 random(24);
  constexpr std::array<std::pair<std::size_t, std::size_t>, 3> planes{{{0, 1}, {2, 0}, {1, 2}}};
  for (int i = 0; i < 300; ++i) {
    const pulse::Arc arc = random_arc(random, 100);
    const auto [x, y] = planes[random() % 3];
    ASSERT_TRUE(same_arc(core, arc, x, y)) << text_of(arc);
  }
  for (std::int64_t radius = 1; radius <= 100; ++radius) {
    const pulse::Arc circle{{radius, 0}, {radius, 0}, pulse::Direction::counterclockwise};
    ASSERT_TRUE(same_arc(core, circle, 0, 1)) << text_of(circle);
  }
}

TEST(Engine, MakesLongLinesAndArcsOfWidth24) {
  Core24 core;
  std::mt19937_64 random(25);
  // An eighth of a turn and more at R 10⁶, about the diagonal.
  const pulse::Arc arc{{998'244, 59'301}, {-3'000, 999'999}, pulse::Direction::counterclockwise};
  EXPECT_TRUE(same_arc(core, arc, 0, 1));
  std::uniform_int_distribution<std::int64_t> distance(-300'000, 300'000);
  for (int i = 0; i < 3; ++i) {
    const CoreVector delta{distance(random), distance(random), distance(random)};
    EXPECT_TRUE(same_line(core, delta)) << delta[0] << ' ' << delta[1] << ' ' << delta[2];
  }
}

TEST(LongEngine, MakesCirclesOfAMillion) {
  Core24 core;
  std::mt19937_64 random(26);
  for (int i = 0; i < 10; ++i) {
    const pulse::Arc arc = random_arc(random, 1'000'000);
    EXPECT_TRUE(same_arc(core, arc, 0, 1)) << text_of(arc);
  }
  EXPECT_TRUE(same_line(core, {(std::int64_t{1} << 24) - 1, -((std::int64_t{1} << 24) - 2), 5'000'001}));
}

/// Octants are cut the same at any size; without the model, so that large ones do not take long.
TEST(Engine, OctantsAreThoseOfTheSoftware) {
  std::mt19937_64 random(27);
  for (int i = 0; i < 120; ++i) {
    const pulse::Arc arc = random_arc(random, i % 3 == 0 ? 200'000 : 300);
    const Cut cut = i % 2 == 0 ? Cut::octants : Cut::pieces;
    CircleOfPulse circle(arc);
    Octants octants(arc, cut);
    std::int64_t commands = 0;
    for (; !octants.done(); ++commands) {
      Octant octant = octants.next();
      ASSERT_GE(octant.count, 1) << text_of(arc);
      for (auto& [e, s, d, c] = octant.other; octant.count > 0; --octant.count) {
        const bool both = e >= 0;
        e += both ? d : s;
        s += 2 * c;
        d += both ? 4 * c : 2 * c;
        const pulse::Pulse<2> made{{both || octant.x_drives ? octant.sign_x : std::int8_t{0},
                                    both || !octant.x_drives ? octant.sign_y : std::int8_t{0}}};
        ASSERT_EQ(made, circle.step()) << text_of(arc);
      }
    }
    ASSERT_TRUE(circle.done()) << text_of(arc);
    EXPECT_LE(commands, cut == Cut::octants ? 13 : 13 * 14) << text_of(arc);
  }
}

}  // namespace test_engine
}  // namespace leadscrew::hardware
