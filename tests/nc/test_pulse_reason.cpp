// What is told of a clock is what happened at it.

#include <gtest/gtest.h>

#include <leadscrew/nc/pulse_reason.hpp>
#include <map>
#include <string>

namespace leadscrew::nc {
namespace test_pulse_reason {

using pulse::Direction;
using pulse::Point;

constexpr auto line = PulseCurve::Shape::line;
constexpr auto arc = PulseCurve::Shape::arc;

std::map<std::string, std::int64_t> values_of(const Registers& registers) {
  std::map<std::string, std::int64_t> values;
  for (const Register& each : registers.all()) values[std::string(each.name)] = each.value;
  return values;
}

/// What is told of the clock with this number.
std::string told(PulseMethod method, const PulseCurve& curve, std::int64_t clock, const MethodOptions& options = {}) {
  PulseRun run(method, curve, options), before = run;
  while (run.clock() < clock) {
    before = run;
    run.step();
  }
  return reason_of(before, run, curve);
}

TEST(PulseReason, SaysWhichSumOverflowed) {
  const PulseCurve teaching{line, {}, {11, 7}, {}, {}};
  const MethodOptions empty{.bits = 4, .preload = pulse::Preload::none};
  EXPECT_EQ(told(PulseMethod::dda, teaching, 0, empty), "");
  EXPECT_EQ(told(PulseMethod::dda, teaching, 1, empty),
            "Jx 11 + rx 0 = 11 < 16: no overflow, rx 11\n"
            "Jy 7 + ry 0 = 7 < 16: no overflow, ry 7");
  EXPECT_EQ(told(PulseMethod::dda, teaching, 2, empty),
            "Jx 11 + rx 11 = 22 ≥ 16: overflow, X +1, rx 6\n"
            "Jy 7 + ry 7 = 14 < 16: no overflow, ry 14");
}

TEST(PulseReason, SaysThatAnAxisHasArrived) {
  const PulseCurve level{line, {}, {-7, 0}, {}, {}};
  EXPECT_EQ(told(PulseMethod::koren, level, 7),
            "Jx 7 + rx 3 = 10 ≥ 7: overflow, X −1, rx 3\n"
            "Y has arrived: its integrator is not clocked");
}

TEST(PulseReason, SaysWhatSearchesCompared) {
  const PulseCurve quarter{arc, {5, 0}, {0, 5}, {}, Direction::counterclockwise};
  EXPECT_EQ(told(PulseMethod::point_comparison, quarter, 1), "F = 0, on the circle: outward, Y +1");
  EXPECT_EQ(told(PulseMethod::point_comparison, quarter, 2), "F = 1 > 0, outside the circle: inward, X −1");
  EXPECT_EQ(told(PulseMethod::min_error, quarter, 1), "|n1| 8, |n2| 1, |n3| 9: the least is |n2|, Y +1");
  EXPECT_EQ(
      told(PulseMethod::improved_min_error, quarter, 1),
      "Y is the faster axis here and steps; 4(d1 − d2) = 15 > 0: the circle is nearer to the step of it alone, Y +1");
  const PulseCurve teaching{line, {}, {11, 7}, {}, {}};
  EXPECT_EQ(told(PulseMethod::bresenham, teaching, 1),
            "F −11 + 2 · 7 = 3 > 0: the line is nearer to the step of both axes, X +1 and Y +1, F −19");
  EXPECT_EQ(told(PulseMethod::point_comparison, teaching, 1), "F = 0, on the line: x first, X +1");
  EXPECT_EQ(told(PulseMethod::point_comparison, teaching, 2), "F = −7 < 0, x is ahead: Y +1");
}

/// Counts clocks, and those at which an axis drains.
struct Seen {
  std::int64_t clocks = 0, drained = 0;
};

/// Each sum that is told overflows just where there is a step, unless it drains, and what remains of it is in the register.
void expect_sums(const PulseCurve& curve, const MethodOptions& options, Seen& seen) {
  PulseRun run(PulseMethod::koren, curve, options);
  while (!run.done()) {
    const PulseRun before = run;
    const auto made = next_additions(before);
    const auto steps = run.step().step;
    const auto flow = values_of(flow_of(before, run, curve)), after = values_of(run.registers());
    const std::string told = reason_of(before, run, curve);
    const bool is_loaded_anew = told.find("loaded anew") != std::string::npos;
    ++seen.clocks;
    seen.drained += made[0].drains || made[1].drains;
    for (const std::size_t axis : {0U, 1U}) {
      const std::string letter(1, axis == 0 ? 'x' : 'y');
      ASSERT_EQ(made[axis].overflows() || made[axis].drains, steps[axis] != 0) << told;
      ASSERT_EQ(flow.at("o" + letter) == 1, made[axis].overflows());
      if (is_loaded_anew || made[axis].drains || !made[axis].is_clocked()) continue;
      ASSERT_EQ(after.at("r" + letter), flow.at("S" + letter) - flow.at("o" + letter) * made[axis].capacity) << told;
    }
  }
}

/// Of every order and preload, both ways.
TEST(PulseReason, AddsUpToTheStepsThatFollow) {
  Seen seen;
  for (std::int64_t x = -9; x <= 9; x += 3) {
    for (std::int64_t y = -10; y <= 10; ++y) {
      if (x == 0 && y == 0) continue;
      for (const Point end : {Point{x, y}, Point{-y, x}, Point{y, x}}) {
        for (const pulse::Order order : all_orders) {
          for (const pulse::Preload preload : all_preloads) {
            const MethodOptions options{.preload = preload, .order = order};
            expect_sums({arc, {x, y}, end, {}, Direction::clockwise}, options, seen);
            expect_sums({arc, {x, y}, end, {}, Direction::counterclockwise}, options, seen);
          }
        }
      }
    }
  }
  EXPECT_GT(seen.clocks, 100000);
  EXPECT_GT(seen.drained, 0);
}

/// Of ellipses and of arcs that run freely as well.
TEST(PulseReason, AddsUpOnEllipsesAndFreeArcs) {
  Seen seen;
  for (const Direction direction : {Direction::clockwise, Direction::counterclockwise}) {
    for (const pulse::Order order : all_orders) {
      for (const pulse::Preload preload : all_preloads) {
        for (const pulse::SemiAxes axes : {pulse::SemiAxes{12, 7}, {5, 20}, {9, 1}}) {
          const PulseCurve ellipse{arc, {axes.x, 0}, {axes.x, 0}, {}, direction, axes};
          expect_sums(ellipse, {.preload = preload, .tie = {}, .order = order}, seen);
        }
        const PulseCurve circle{arc, {3, 25}, {3, 25}, {}, direction};
        expect_sums(circle, {.preload = preload, .tie = {}, .order = order, .free = true}, seen);
      }
    }
  }
  EXPECT_GT(seen.clocks, 10000);
  EXPECT_GT(seen.drained, 0);
}

TEST(PulseReason, SaysWhatAnEllipseAdds) {
  const PulseCurve ellipse{arc, {12, 0}, {0, 7}, {}, Direction::counterclockwise, pulse::SemiAxes{12, 7}};
  EXPECT_EQ(told(PulseMethod::koren, ellipse, 1),
            "Jx 0 + rx 504 = 504 < 1008: no overflow, rx 504\n"
            "Jy 588 + ry 504 = 1092 ≥ 1008: overflow, Y +1, ry 84");
}

/// No sentence claims a least error that was not taken, or leaves a clock without one.
TEST(PulseReason, HasASentenceForEveryClock) {
  for (const PulseMethod method : all_pulse_methods) {
    for (std::int64_t y = -12; y <= 12; ++y) {
      for (const PulseCurve& curve :
           {PulseCurve{arc, {9, y}, {9, y}, {}, Direction::clockwise},
            PulseCurve{arc, {9, y}, {-y, 9}, {}, Direction::counterclockwise}, PulseCurve{line, {}, {9, y}, {}, {}}}) {
        PulseRun run(method, curve), before = run;
        while (!run.done()) {
          before = run;
          run.step();
          ASSERT_NE(reason_of(before, run, curve), "") << name(method) << ' ' << y << ' ' << run.clock();
        }
      }
    }
  }
}

/// Where a curve ends beside where the search comes out, that is said, and nowhere else.
TEST(PulseReason, SaysWhereASearchMakesUpForTheEnd) {
  const PulseCurve whole{arc, {5, 0}, {5, 0}, {}, Direction::counterclockwise};
  for (const PulseMethod method :
       {PulseMethod::point_comparison, PulseMethod::min_error, PulseMethod::improved_min_error}) {
    PulseRun run(method, whole), before = run;
    while (!run.done()) {
      before = run;
      run.step();
      EXPECT_EQ(reason_of(before, run, whole).find("beside the end"), std::string::npos) << name(method) << run.clock();
    }
  }
}

TEST(PulseProblems, SayOfWhichFieldTheyAre) {
  const auto field = [](const PulseCurve& curve, std::optional<int> bits) {
    const auto problems = problems_of(curve, bits);
    return problems.empty() ? std::string() : std::string(problems.front().subject.field);
  };
  EXPECT_EQ(field({line, {3, 4}, {3, 4}, {}, {}}, {}), "end");
  EXPECT_EQ(field({line, {std::int64_t{1} << 31, 0}, {}, {}, {}}, {}), "start");
  EXPECT_EQ(field({arc, {2, 1}, {5, 5}, {2, 1}, {}}, {}), "center");
  EXPECT_EQ(field({arc, {8, 0}, {0, 8}, {}, Direction::counterclockwise}, 3), "start");
  EXPECT_EQ(field({arc, {10, 7}, {10, -7}, {4, 0}, Direction::clockwise}, 3), "bits");
  const PulseCurve level{line, {}, {30, 0}, {}, {}};
  EXPECT_EQ(capacity_problem(PulseMethod::dda, level, {.capacity = 20})->subject.field, "capacity");
}

/// What would be right is beside the ellipse: its diagnostics name such a place.
TEST(PulseProblems, NameAPlaceBesideTheEllipse) {
  for (const Point wrong : {Point{10, -3}, Point{10, 8}, Point{4, 4}, Point{18, 4}, Point{10, 13}, Point{-2, -9}}) {
    const PulseCurve curve{arc, wrong, {22, -3}, {10, -3}, Direction::counterclockwise, pulse::SemiAxes{12, 7}};
    const auto problems = problems_of(curve, std::nullopt);
    ASSERT_EQ(problems.size(), 1u) << point_text(wrong);
    const std::string& hint = problems.front().hint;
    const std::size_t comma = hint.find(", ", hint.find('('));
    const Point right{std::stoll(hint.substr(hint.find('(') + 1)), std::stoll(hint.substr(comma + 2))};
    PulseCurve mended = curve;
    mended.start = right;
    EXPECT_TRUE(problems_of(mended, std::nullopt).empty()) << hint;
  }
}

TEST(ClocksPerBlu, IsTheCapacityOverTheLengthOrTheRadius) {
  const PulseCurve level{line, {}, {3, 4}, {}, {}}, circle{arc, {10, 0}, {10, 0}, {}, {}};
  const auto clocks = [](PulseMethod method, const PulseCurve& curve, const MethodOptions& options) {
    return clocks_per_blu(method, curve, conventions_of(method, curve, options));
  };
  EXPECT_DOUBLE_EQ(*clocks(PulseMethod::dda, level, {.bits = 4}), 16.0 / 5);
  EXPECT_DOUBLE_EQ(*clocks(PulseMethod::dda, circle, {.bits = 4}), 1.6);
  EXPECT_DOUBLE_EQ(*clocks(PulseMethod::koren, circle, {}), 1);
  EXPECT_EQ(clocks(PulseMethod::bresenham, level, {}), std::nullopt);
}

}  // namespace test_pulse_reason
}  // namespace leadscrew::nc
