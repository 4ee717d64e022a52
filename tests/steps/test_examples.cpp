// Steps of whole programs: from the text to the last step, every example.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <leadscrew/gcode/tool_table.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/steps/step_generator.hpp>
#include <string>

namespace leadscrew::steps::testing {
namespace test_examples {

std::string file_text(const std::string& name) {
  std::ifstream file(std::string(LEADSCREW_SOURCE_DIR) + "/examples/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The built-in mill with rotary axes, as in machines/mill6.toml; screws of 1 µm.
machine::Machine mill_with_rotary_axes(std::int64_t microseconds) {
  machine::Machine machine = machine::mill3();
  for (const base::Axis axis : {base::Axis::A, base::Axis::B, base::Axis::C}) {
    machine.axes[base::index(axis)] = machine::AxisLimits{-36000, 36000, 90, 500, 5000, 0.001};
  }
  machine.period = {microseconds * 1000};
  return machine;
}

/// Where the program's last move ends, by the reader alone.
base::AxisVector programmed_end(const std::string& text, const machine::Machine& machine,
                                const machine::ToolTable& tools) {
  gcode::Reader reader(gcode::text_source(text), machine, tools, {}, [](const base::Diagnostic&) {});
  base::AxisVector end{};
  gcode::Move move;
  while (reader.next(move)) {
    if (move.kind != gcode::Move::Kind::dwell && move.kind != gcode::Move::Kind::event) end = move.end;
  }
  return end;
}

class Examples : public ::testing::TestWithParam<std::tuple<const char*, int, int>> {};

TEST_P(Examples, EndOnTheBluOfTheirLastBlock) {
  const auto& [name, microseconds, clock_khz] = GetParam();
  const machine::Machine machine = mill_with_rotary_axes(microseconds);
  const auto tools = gcode::read_tool_table(file_text("tools.tbl"), "tools.tbl");
  const std::string text = file_text(name);
  pipeline::Program program(gcode::text_source(text), machine, tools.table, {}, nullptr);
  auto generator = StepGenerator::create(machine, clock_khz * 1000).value();
  std::array<std::int64_t, base::axis_count> sum{};
  std::int64_t last = 0;
  bool ordered = true;
  const auto sink = [&](std::span<const StepEvent> events) {
    for (const StepEvent event : events) {
      sum[base::index(event.axis())] += event.direction();
      ordered = ordered && event.tick() >= last;
      last = event.tick();
    }
  };
  while (program.prepare()) generator.follow(program.cycle(), sink);
  generator.finish(sink);

  ASSERT_FALSE(program.failure());
  EXPECT_TRUE(ordered);
  EXPECT_GT(generator.report().steps, 10000);
  EXPECT_LE(generator.report().greatest_error, 0.5 + 2e-6);
  EXPECT_LE(generator.report().greatest_delay, 1);
  EXPECT_FALSE(generator.complaint());
  const base::AxisVector end = programmed_end(text, machine, tools.table);
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const double blu = end[base::index(axis)] / machine.limits(axis).blu;
    const auto steps = static_cast<double>(sum[base::index(axis)]);
    if (std::fabs(blu - std::floor(blu) - 0.5) > 1e-5) {
      EXPECT_EQ(steps, std::round(blu)) << base::letter(axis);
    } else {
      EXPECT_NEAR(steps, blu, 0.5 + 1e-5) << base::letter(axis);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, Examples,
    ::testing::Combine(::testing::Values("01-plate.ngc", "02-helical-bore.ngc", "03-arcs-in-three-planes.ngc",
                                         "04-square.ngc", "05-finishing.ngc", "06-drilling.ngc", "07-rotary.ngc",
                                         "08-work-offsets.ngc", "09-butterfly.ngc", "10-cubic.ngc", "11-splines.ngc"),
                       ::testing::Values(1000), ::testing::Values(10000)));
INSTANTIATE_TEST_SUITE_P(Short, Examples,
                         ::testing::Combine(::testing::Values("04-square.ngc", "11-splines.ngc"),
                                            ::testing::Values(100, 20000), ::testing::Values(500, 1843)));

}  // namespace test_examples
}  // namespace leadscrew::steps::testing
