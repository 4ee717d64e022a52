#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <leadscrew/pipeline/motion_source.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "worst_ratios.hpp"

// Thousands of short lines with A and C in each, as a CAM system writes the blades of an impeller: motion does not stop
// among them, every window comes out inside its limits, and planning takes little.

namespace test_impeller {

using namespace leadscrew;

/// The trunnion of machines/table-table-ac.toml.
machine::Machine trunnion() {
  machine::Machine machine;
  machine.name = "trunnion";
  machine.kinematics = "table-table-ac";
  machine.rotary_chain = machine::preset_chain("table-table-ac");
  machine.rotary_chain->axes[0].point = {0, 0, -50};
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z})
    machine.axes[base::index(axis)] = machine::AxisLimits{-1000, 1000, 400, 3000, 60000, 0.001};
  machine.axes[base::index(base::Axis::A)] = machine::AxisLimits{-120, 120, 180, 1500, 30000, 0.001};
  machine.axes[base::index(base::Axis::C)] = machine::AxisLimits{-36000, 36000, 360, 3000, 60000, 0.001};
  machine.period = {1'000'000};
  return machine;
}

/// Blades in passes to and fro along their length, each pass a little deeper, and from blade to blade round the hub: lines
/// of 0.3 to 1 mm, and up to 2 degrees, with three decimals. Switched on by M428 as LinuxCNC's programs are.
std::string impeller(int lines) {
  constexpr int blades = 7, along = 60;
  const double degree = std::numbers::pi / 180;
  std::string text = "G21 G90 G17 G94 G64 P0.02\nM428\n";
  for (int k = 0; k < lines; ++k) {
    const int pass = k / along;
    const double within = (pass % 2 == 0 ? k % along : along - 1 - k % along) / (along - 1.0);
    const double blade = pass * (360.0 / blades) / (lines / along / blades + 1.0);
    const double u = 0.5 - 0.5 * std::cos(std::numbers::pi * within);  // slower towards the edges
    const double height = 30 - 28 * u, radius = 9 + 22 * u * u + 0.01 * pass;
    const double round = blade + 38 * u + 4 * std::sin(3 * u), tilt = 72 - 30 * u + 3 * std::sin(5 * u);
    char line[120];
    std::snprintf(line, sizeof line, "G1 X%.3f Y%.3f Z%.3f A%.3f C%.3f F%d\n", radius * std::cos(round * degree),
                  radius * std::sin(round * degree), height, -tilt, -round - 60 * u, 3000);
    text += line;
  }
  return text + "M429\nM2\n";
}

TEST(Impeller, IsOneSectionWithoutARefusedWindow) {
  const machine::Machine machine = trunnion();
  const machine::ToolTable tools;
  const std::string text = impeller(4500);
  pipeline::MotionSource source(gcode::text_source(text), machine, tools, {}, [](const base::Diagnostic& problem) {
    ADD_FAILURE() << problem.place.line << ": " << problem.message;
  });
  constraints::LimitRatios ratios{};
  double seconds = 0;
  std::vector<int> rests;  // lines
  while (const std::optional<planner::Chunk> chunk = source.next()) {
    seconds += chunk->duration.value();
    if (chunk->stop_tail.empty()) rests.push_back(static_cast<int>(base::number(chunk->rest_line)));
    planner::raise_limit_ratios(*chunk, machine, ratios);
  }
  // At the last line of all, and M2.
  EXPECT_EQ(rests, (std::vector{4502, 4504}));
  EXPECT_EQ(source.planner().refused_windows(), 0);
  EXPECT_EQ(source.planner().simplified_sections(), 0);
  EXPECT_LE(testing_support::worst_planned(ratios), 1.001);
  // A unit of work is a quarter of a microsecond: at most 3 % of the motion's time.
  EXPECT_LE(source.planner().effort() / seconds, 0.03 / 0.25e-6);
}

}  // namespace test_impeller
