// Whole programs as pulses: where they end, and how fast.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <leadscrew/nc/nc_program.hpp>
#include <numbers>

#include "pulses.hpp"

namespace leadscrew::nc {
namespace test_pulse_program {

using testing::Conditions;
using testing::pulse;
using testing::Pulsed;
using testing::TimedPulse;

constexpr std::array methods = {PulseMethod::koren,
                                PulseMethod::dda,
                                PulseMethod::point_comparison,
                                PulseMethod::min_error,
                                PulseMethod::improved_min_error,
                                PulseMethod::bresenham};

/// Of the last move, in steps: read without any of the room.
LatticeVector programmed_end(const std::string& text, const Conditions& conditions) {
  gcode::Reader reader(gcode::text_source(text), conditions.machine, conditions.tools, conditions.reading(),
                       [](const base::Diagnostic& d) { EXPECT_NE(d.severity, base::Severity::error) << d.message; });
  base::AxisVector end = conditions.start;
  gcode::Move move;
  while (reader.next(move)) {
    if (move.kind != gcode::Move::Kind::event && move.kind != gcode::Move::Kind::dwell) end = move.end;
  }
  LatticeVector steps{};
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    steps[i] = std::llround(end[i] / conditions.machine.limits(axis).blu) -
               std::llround(conditions.start[i] / conditions.machine.limits(axis).blu);
  }
  return steps;
}

void expect_to_end(const std::string& example, const Conditions& conditions) {
  const std::string text = testing::text_of(example);
  const Pulsed pulsed = pulse(text, conditions);
  EXPECT_EQ(pulsed.problems, "") << example;
  EXPECT_EQ(pulsed.sum, programmed_end(text, conditions)) << example;
  EXPECT_TRUE(pulsed.is_ordered) << example;
  EXPECT_GT(pulsed.pulses, 3000) << example;
}

class PulsedExamples : public ::testing::TestWithParam<const char*> {};

Conditions for_examples() {
  Conditions conditions;
  conditions.machine = testing::nine_axes(0.01);
  conditions.machine.axes[0]->blu = conditions.machine.axes[1]->blu = conditions.machine.axes[2]->blu = 0.005;
  for (const std::size_t i : {3, 4, 5}) conditions.machine.axes[i]->velocity = 360;  // one turns at 225 degrees/s
  // Not on the lattice, nor where any of them ends.
  conditions.start = {1.2345, -3.21, 10.017};
  conditions.tools = machine::ToolTable({{1}, {2}, {3, 0, {0, 0, 20}}});
  return conditions;
}

TEST_P(PulsedExamples, SumToTheirEnds) {
  Conditions conditions = for_examples();
  for (const PulseMethod method : methods) {
    conditions.options.method = method;
    expect_to_end(GetParam(), conditions);
  }
  conditions.options.method = PulseMethod::koren;
  conditions.options.shape = Shape::accelerate;
  expect_to_end(GetParam(), conditions);
}

INSTANTIATE_TEST_SUITE_P(All, PulsedExamples,
                         ::testing::Values("01-plate.ngc", "02-helical-bore.ngc", "03-arcs-in-three-planes.ngc",
                                           "04-square.ngc", "05-finishing.ngc", "06-drilling.ngc", "07-rotary.ngc",
                                           "08-work-offsets.ngc", "09-butterfly.ngc", "10-cubic.ngc",
                                           "11-splines.ngc"));

constexpr double mm_per_step = 0.001;

std::string word(char letter, double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, " %c%.6f", letter, value);
  return buffer;
}

/// An arc from somewhere on a circle to elsewhere on it.
struct RandomArc {
  Conditions conditions;
  std::string text;
  double radius = 0, sweep = 0;  // mm, radians
  double center_x = 0, center_y = 0;
  double seconds = 0;  // at its feed
};

RandomArc random_arc(double least_mm, double greatest_mm) {
  RandomArc arc;
  arc.radius = *rc::gen::inRange(static_cast<int>(least_mm * 1e4), static_cast<int>(greatest_mm * 1e4)) / 1e4;
  const double from = *rc::gen::inRange(0, 6283) / 1e3;
  arc.sweep = *rc::gen::inRange(500, 6000) / 1e3;
  const bool ccw = *rc::gen::arbitrary<bool>();
  const double feed = *rc::gen::inRange(10, 9000), to = from + (ccw ? arc.sweep : -arc.sweep);
  arc.center_x = *rc::gen::inRange(-9999, 9999) / 1e4;
  arc.center_y = *rc::gen::inRange(-9999, 9999) / 1e4;
  arc.conditions.start[0] = arc.center_x + arc.radius * std::cos(from);
  arc.conditions.start[1] = arc.center_y + arc.radius * std::sin(from);
  arc.text = std::string("G61 G90.1 ") + (ccw ? "G3" : "G2") + word('X', arc.center_x + arc.radius * std::cos(to)) +
             word('Y', arc.center_y + arc.radius * std::sin(to)) + word('I', arc.center_x) + word('J', arc.center_y) +
             word('F', feed) + "\n";
  arc.seconds = arc.radius * arc.sweep / (feed / 60);
  return arc;
}

double seconds(const Pulsed& pulsed, const Conditions& conditions) {
  return static_cast<double>(pulsed.last) / static_cast<double>(conditions.options.clock_pps);
}

RC_GTEST_PROP(PulseProgram, TravelsArcsAtTheirFeed, ()) {
  RandomArc arc = random_arc(0.02, 12);
  arc.conditions.options.interpolation.places = *rc::gen::element(0, 16);
  arc.conditions.options.method = *rc::gen::elementOf(methods);
  const Pulsed pulsed = pulse(arc.text, arc.conditions);
  RC_ASSERT(pulsed.problems == "");
  const double steps = arc.radius * arc.sweep / mm_per_step;
  const double allowed = steps > 6000 ? 0.001 * arc.seconds : 2 * arc.seconds / steps;
  RC_LOG() << arc.text << seconds(pulsed, arc.conditions) << " s for " << arc.seconds;
  RC_ASSERT(std::abs(seconds(pulsed, arc.conditions) - arc.seconds) <= allowed);
}

/// With ends and centre on the lattice, a quarter of a turn or three.
RC_GTEST_PROP(PulseProgram, TravelsArcsOfTheLatticeAtTheirFeed, ()) {
  const int a = *rc::gen::inRange(-9000, 9000), b = *rc::gen::inRange(20, 9000);
  const bool ccw = *rc::gen::arbitrary<bool>();
  Conditions conditions;
  conditions.start = {a * mm_per_step, b * mm_per_step};
  conditions.options.interpolation.places = *rc::gen::element(0, 16);
  conditions.options.method = *rc::gen::elementOf(methods);
  const std::string text = std::string("G61 F600 G90.1 ") + (ccw ? "G3" : "G2") + word('X', -b * mm_per_step) +
                           word('Y', a * mm_per_step) + " I0 J0\n";
  const Pulsed pulsed = pulse(text, conditions);
  const double steps = std::hypot(a, b) * std::numbers::pi / 2 * (ccw ? 1 : 3);
  const double allowed = steps > 6000 ? 0.001 * steps : 2;
  RC_ASSERT(pulsed.problems == "");
  RC_LOG() << text << steps << " steps";
  RC_ASSERT(std::abs(seconds(pulsed, conditions) * 10'000 - steps) <= allowed);
  RC_ASSERT(pulsed.sum == (LatticeVector{-b - a, a - b}));
}

RC_GTEST_PROP(PulseProgram, StaysByTheProgrammedCircle, ()) {
  RandomArc arc = random_arc(0.01, 3);
  arc.conditions.options.method = *rc::gen::elementOf(methods);
  double x = std::round(arc.conditions.start[0] / mm_per_step), y = std::round(arc.conditions.start[1] / mm_per_step);
  double worst = 0;
  const Pulsed pulsed = pulse(arc.text, arc.conditions, [&](const TimedPulse& made) {
    x += made.pulse.step[0];
    y += made.pulse.step[1];
    const double at = std::hypot(x - arc.center_x / mm_per_step, y - arc.center_y / mm_per_step);
    worst = std::max(worst, std::abs(at - arc.radius / mm_per_step));
  });
  RC_ASSERT(pulsed.problems == "");
  RC_LOG() << arc.text << worst;
  RC_ASSERT(worst < 3.5);  // the methods' 1.43, its ends and centre rounded
}

TEST(PulseProgram, GoesAlongHelicesEvenly) {
  Conditions conditions;
  for (const PulseMethod method : methods) {
    conditions.options.method = method;
    double x = 5000, y = 0, z = 0, turned = 0, worst = 0;
    conditions.start = {5, 0, 0};
    const Pulsed pulsed = pulse("G61 F1000 G3 X0 Y5 Z-7 I-5 P4\n", conditions, [&](const TimedPulse& made) {
      const double before = std::atan2(y, x);
      x += made.pulse.step[0];
      y += made.pulse.step[1];
      z += made.pulse.step[2];
      turned += std::remainder(std::atan2(y, x) - before, 2 * std::numbers::pi);
      worst = std::max(worst, std::abs(z + 7000 * turned / (3.25 * 2 * std::numbers::pi)));
    });
    EXPECT_EQ(pulsed.sum, (LatticeVector{-5000, 5000, -7000}));
    // Where an axis steps at every command the angle goes up to a seventh of an octant ahead of the commands.
    EXPECT_LT(worst, method == PulseMethod::koren || method == PulseMethod::dda ? 2 : 15);
    const double length = std::hypot(3.25 * 2 * std::numbers::pi * 5, 7);
    EXPECT_NEAR(seconds(pulsed, conditions), length / (1000.0 / 60), 0.001 * length / (1000.0 / 60));
  }
}

TEST(PulseProgram, ClimbsHelicesThatAreSteeperThanTheirCircles) {
  Conditions conditions;
  conditions.start = {0.5, 0, 0};
  const Pulsed pulsed = pulse("G61 F1000 G2 X0.5 Y0 Z40 I-0.5\n", conditions);
  EXPECT_EQ(pulsed.sum, (LatticeVector{0, 0, 40000}));
  const double length = std::hypot(std::numbers::pi, 40);
  EXPECT_NEAR(seconds(pulsed, conditions), length / (1000.0 / 60), 0.001 * length / (1000.0 / 60));
}

TEST(PulseProgram, GivesKorensRatesOnKorensMachine) {
  Conditions conditions;
  conditions.machine = testing::nine_axes(0.00254);  // a BLU of 0.0001 in
  conditions.options.clock_pps = 5000;
  conditions.options.feed_capacity = 3000;
  const auto at = [&](const std::string& feed) { return pulse("G20\nG61 G1 X1 F" + feed + "\n", conditions); };
  EXPECT_EQ(at("30").last, 10'000);
  EXPECT_EQ(at("12.34").last, std::ceil(10'000 * 3000 / 1234.0));
  EXPECT_EQ(at("30.01").problems, "2 pulse-rate; ");
}

TEST(PulseProgram, MakesThePulsesOfTheNcProgram) {
  const std::string text = "G61 F600 G1 X3.1 Y-2 Z0.5\nG3 X1.1 Y0 R2 F300\nG4 P0.01\nG2 X0 Y0 I-0.55 Z0\nM2\n";
  Conditions conditions;
  conditions.options.clock_pps = 20'000;
  BlockMaker maker(conditions.machine, conditions.options, conditions.start);
  std::vector<Block> blocks;
  gcode::Reader reader(gcode::text_source(text), conditions.machine, conditions.tools, {},
                       [](const base::Diagnostic& d) { ADD_FAILURE() << d.message; });
  gcode::Move move;
  while (reader.next(move)) {
    maker.load(move);
    while (auto planned = maker.next()) blocks.push_back((**planned).block);
  }
  ASSERT_GE(blocks.size(), 4u);
  NcProgram program(
      {conditions.options.clock_pps, conditions.options.feed_capacity, {}},
      [&, i = std::size_t{0}]() mutable { return i < blocks.size() ? std::optional(blocks[i++]) : std::nullopt; });
  pulse(text, conditions, [&](const TimedPulse& made) {
    while (program.interrupts() + 1 < made.tick) ASSERT_EQ(program.interrupt(), AxisPulse{});
    ASSERT_EQ(program.interrupt(), made.pulse) << made.tick;
  });
  EXPECT_TRUE(program.done());
}

/// One clock at a time, or as many as find room.
RC_GTEST_PROP(PulseProgram, MakesTheSameStepsWhateverTheRoom, ()) {
  Conditions conditions;
  conditions.options.method = *rc::gen::elementOf(methods);
  conditions.options.shape = *rc::gen::element(Shape::constant, Shape::accelerate);
  const std::string feed = "G61 F" + std::to_string(*rc::gen::inRange(300, 5000)) + "\n";
  const std::string text = feed +
                           "G1 X1.1 Y-0.7\nX1 Y0.4 Z0.3\nA2 B-1 U1.1\nA0 B0 U0 V1 W2 C3\nG3 X0 Y0.5 R0.6\nG4 P0.001\n" +
                           "G18 G2 X0.5 Z0.2 R0.4\nG17 G3 I0.4 J0.1 Z1 P2\nG2 X-1 Y0 R3 Z0 A1\nG0 X0 Z2\nM2\n";
  const auto steps_with = [&](std::size_t room_for) {
    PulseProgram program(gcode::text_source(text), conditions.machine, conditions.tools, {}, conditions.options,
                         [](const base::Diagnostic& d) { RC_FAIL(d.message); });
    std::vector<steps::StepEvent> all, room(room_for);
    base::Line line{};
    for (auto steps = program.next(room); !steps.empty(); steps = program.next(room)) {
      if (room_for == base::axis_count) RC_ASSERT(steps.front().tick() == steps.back().tick());
      RC_ASSERT(program.ticks() == steps.back().tick());
      RC_ASSERT(program.line() >= line);
      line = program.line();
      all.insert(all.end(), steps.begin(), steps.end());
    }
    return all;
  };
  const std::vector<steps::StepEvent> one_by_one = steps_with(base::axis_count);
  RC_ASSERT(one_by_one.size() > 9000u);
  RC_ASSERT(steps_with(*rc::gen::inRange<std::size_t>(base::axis_count + 1, 3000)) == one_by_one);
}

TEST(PulseProgram, TakesInverseTimeAndDwells) {
  const Conditions conditions;
  // Four seconds, one and a half, and as fast as the machine can: 0.2 s.
  const Pulsed pulsed = pulse("G61 G93 G1 X10 Y3 A40 F15\nG4 P1.5\nG0 X50 Y3 A40\n", conditions);
  EXPECT_NEAR(seconds(pulsed, conditions), 5.7, 0.001);
  EXPECT_EQ(pulsed.sum, (LatticeVector{50000, 3000, 0, 40000}));
}

TEST(PulseProgram, TakesAnOverrideWhileItRuns) {
  const Conditions conditions;
  const std::string text = "G61 G1 X10 F600\nM2\n";
  PulseProgram program(gcode::text_source(text), conditions.machine, conditions.tools, {}, conditions.options,
                       [](const base::Diagnostic& d) { ADD_FAILURE() << d.message; });
  std::array<steps::StepEvent, base::axis_count> room;  // for one step of one axis and no more
  for (int i = 0; i < 5000; ++i) ASSERT_EQ(program.next(room).size(), 1u);
  EXPECT_NEAR(static_cast<double>(program.ticks()), 500'000, 100);
  program.override_feed(500);
  while (!program.next(room).empty()) continue;
  EXPECT_NEAR(static_cast<double>(program.ticks()), 1'500'000, 300);
}

TEST(PulseProgram, KeepsTheLengthOfSteps) {
  Conditions conditions;
  conditions.options.step_clocks = 7;
  std::int64_t before = -100, least = 100;
  pulse("G61 G0 X3 Y3 Z3\nG3 X0 Y0 R4 F5000\n", conditions, [&](const TimedPulse& made) {
    least = std::min(least, made.tick - before);
    before = made.tick;
  });
  EXPECT_EQ(least, 7);
}

/// A half-loaded DDA comes to the end of some sooner than after its capacity's commands.
TEST(PulseProgram, TravelsShortLinesAtTheirFeed) {
  for (const PulseMethod method : methods) {
    for (const LatticeVector& delta : {LatticeVector{1, 1}, {1, 1, 1}, {2, 2}, {2, 2, 2}, {1, 2}, {5, 4}, {1}}) {
      Conditions conditions;
      conditions.options.method = method;
      std::string text = "G61 G91 F600\n";
      double length = 0;
      for (const std::int64_t of_axis : delta) length += static_cast<double>(of_axis * of_axis);
      for (int lines = 0; lines < 500; ++lines) {
        text += "G1";
        for (std::size_t i = 0; i < 3; ++i) text += word("XYZ"[i], static_cast<double>(delta[i]) * mm_per_step);
        text += "\n";
      }
      const Pulsed pulsed = pulse(text, conditions);
      EXPECT_EQ(pulsed.problems, "");
      const double expected = 500 * std::sqrt(length) * mm_per_step / 10;
      EXPECT_NEAR(seconds(pulsed, conditions), expected, 0.002 * expected) << static_cast<int>(method) << delta[1];
    }
  }
}

/// None for a circle below a step; its axes beside it travel all the same.
TEST(PulseProgram, EndsHelicesOfManySmallTurnsWhereTheyEnd) {
  for (const PulseMethod method : methods) {
    for (const double radius : {0.0004, 0.0009, 0.0012, 0.0019, 0.0026, 0.1}) {
      Conditions conditions;
      conditions.options.method = method;
      const Pulsed pulsed = pulse("G61 F60\nG2 X0 Y0" + word('I', radius) + " Z0.4 P4\n", conditions);
      EXPECT_EQ(pulsed.problems, "");
      EXPECT_EQ(pulsed.sum, (LatticeVector{0, 0, 400})) << static_cast<int>(method) << " R " << radius;
    }
  }
}

TEST(PulseProgram, DrawsFullCirclesFromAStepOn) {
  for (const PulseMethod method : methods) {
    for (const double radius : {0.001, 0.0014, 0.0019, 0.0024}) {
      Conditions conditions;
      conditions.options.method = method;
      double x = 0, farthest = 0;
      pulse("G61 F60\nG3 X0 Y0" + word('I', radius) + "\n", conditions, [&](const TimedPulse& made) {
        x += made.pulse.step[0];
        farthest = std::max(farthest, x);
      });
      EXPECT_NEAR(farthest, 2 * radius / mm_per_step, 1.01) << static_cast<int>(method) << " R " << radius;
    }
  }
}

TEST(PulseProgram, TakesItsTimeForLinesWithoutAStepInInverseTime) {
  EXPECT_NEAR(seconds(pulse("G61 G93\nG1 X0.0001 F60\nX0.0002 F60\nX1 F60\n"), {}), 3, 0.002);
  EXPECT_NEAR(seconds(pulse("G61 F60\nG1 X0.0001\nX0.0002\nX1\n"), {}), 1, 0.002);
}

/// Of every axis over spans of one step to thousands.
TEST(PulseProgram, KeepsTheVelocityOfEveryAxis) {
  for (const PulseMethod method : methods) {
    Conditions conditions;
    conditions.options.method = method;
    conditions.machine.axes[0]->velocity = 60;
    conditions.machine.axes[1]->velocity = 50;
    std::array<std::vector<std::int64_t>, 3> ticks;
    // Rapids, lines at the limit of Y, and circles that are a fifth slower: point comparison makes 4/π as many steps.
    const Pulsed pulsed = pulse("G61 G0 X7 Y20 Z3\nX0 Y0 Z10\nG1 Y30 X1 F2900\nG3 I5 F2300\nG2 I-5 Z4 P2\n", conditions,
                                [&](const TimedPulse& made) {
                                  for (std::size_t i = 0; i < 3; ++i) {
                                    if (made.pulse.step[i] != 0) ticks[i].push_back(made.tick);
                                  }
                                });
    ASSERT_EQ(pulsed.problems, "");
    constexpr std::array clocks_a_step = {1e6 / 60'000, 1e6 / 50'000, 1e6 / 200'000};
    for (std::size_t i = 0; i < 3; ++i) {
      for (const std::size_t span : {1u, 2u, 5u, 20u, 100u, 1000u, 5000u}) {
        for (std::size_t k = span; k < ticks[i].size(); ++k) {
          const auto least = (static_cast<double>(span) - 2) * clocks_a_step[i];
          ASSERT_GE(static_cast<double>(ticks[i][k] - ticks[i][k - span]), least) << i << " " << span;
        }
      }
    }
  }
}

}  // namespace test_pulse_program
}  // namespace leadscrew::nc
