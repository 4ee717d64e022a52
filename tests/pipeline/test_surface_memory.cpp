// What is held while a surface is read and machined in five axes: no more for many passes than for few.

#include <gtest/gtest.h>

#include <allocations.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <string>

namespace test_surface_memory {

using namespace leadscrew;

machine::Machine table_of_a_and_c() {
  machine::Machine machine;
  machine.name = machine.kinematics = "table-table-ac";
  machine.rotary_chain = *machine::preset_chain(machine.kinematics);
  machine.period = {1'000'000};
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z, base::Axis::A, base::Axis::C})
    machine.axes[base::index(axis)] = machine::AxisLimits{-1e4, 1e4, 500, 5000, 200'000, 0.001};
  return machine;
}

machine::ToolTable bull_nose() {
  machine::Tool tool;
  tool.number = 1;
  tool.diameter = 8;
  tool.corner_radius = 1;
  tool.offset[2] = 60;
  return machine::ToolTable({tool});
}

/// By words of G6.5: how it is machined of a wavy sheet of 10 by 100 mm.
std::string sheet(const std::string& words) {
  std::string text = "G21 G90 G94 F12000\nG6.4 D1 P4 Q4 I4 J7\n";
  for (int j = 0; j < 7; ++j) {
    for (int i = 0; i < 4; ++i)
      text += "X" + std::to_string(10.0 * i / 3) + " Y" + std::to_string(100.0 * j / 6) + " Z" +
              std::to_string(0.5 * ((i + j) % 2)) + "\n";
  }
  return text + "T1 M6\nG43.4 H1\nG0 Z30\nG6.5 D1 T1 " + words + "\nM2\n";
}

struct Held {
  std::size_t passes = 0;
  std::int64_t reading = 0, moving = 0;  ///< the most, bytes
};

Held held_by(const std::string& words) {
  const std::string text = sheet(words);
  const machine::Machine machine = table_of_a_and_c();
  const machine::ToolTable tools = bull_nose();
  Held held;
  const auto most_of = [](const auto& work) {
    const std::int64_t before = testing_support::memory_held();
    testing_support::watch_memory();
    work();
    return testing_support::most_memory_held() - before;
  };
  held.reading = most_of([&] {
    gcode::Reader reader(gcode::text_source(text), machine, tools, {}, nullptr);
    for (gcode::Move move; reader.next(move);)
      held.passes += reader.machined().surface && reader.machined().part == gcode::MachinedMove::Part::pass;
    EXPECT_EQ(reader.errors(), 0);
  });
  held.moving = most_of([&] {
    pipeline::Program program(gcode::text_source(text), machine, tools, {}, nullptr);
    while (program.prepare()) program.cycle();
    EXPECT_FALSE(program.failure());
  });
  return held;
}

TEST(SurfaceMemory, OfTwoHundredPassesInFiveAxesIsThatOfSixty) {
  const Held few = held_by("A8 Q0.5 I0 J0.25"), many = held_by("A8 Q0.5 I0 J1");
  EXPECT_GT(few.passes, 50U);
  EXPECT_LT(few.passes, 70U);
  EXPECT_GT(many.passes, 195U);
  EXPECT_LT(many.reading, few.reading * 1.05);
  EXPECT_LT(many.moving, few.moving * 1.15);
  RecordProperty("reading", std::to_string(many.reading));
  RecordProperty("moving", std::to_string(many.moving));
}

void expect_same(const std::string& words_for_few, const std::string& words_for_many) {
  const Held few = held_by(words_for_few), many = held_by(words_for_many);
  EXPECT_GT(few.passes, 20U);
  EXPECT_GT(many.passes, 2 * few.passes);
  EXPECT_LT(many.reading, few.reading * 1.1);  // with the lines that a draft finds, which are kept up to a mebibyte
  EXPECT_LT(many.moving, few.moving * 1.15);
  testing::Test::RecordProperty("passes", std::to_string(few.passes) + ", " + std::to_string(many.passes));
  testing::Test::RecordProperty("reading", std::to_string(few.reading) + ", " + std::to_string(many.reading));
  testing::Test::RecordProperty("moving", std::to_string(few.moving) + ", " + std::to_string(many.moving));
}

TEST(SurfaceMemory, OfManyLegsOfASpiralIsThatOfFew) {
  expect_same("S3 A30 Q1 I0 J1", "S3 A30 Q0.3 I0 J1");
}
TEST(SurfaceMemory, OfManyIsoScallopPassesIsThatOfFew) {
  expect_same("S4 A8 Q0.5 I0 J0.2", "S4 A8 Q0.5 I0 J0.7");
}
TEST(SurfaceMemory, OfManyPassesInPlanesIsThatOfFew) {
  expect_same("S5 A8 Q0.5 I0 J0.2", "S5 A8 Q0.5 I0 J0.7");
}

}  // namespace test_surface_memory
