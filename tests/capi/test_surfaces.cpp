#include <cmath>
#include <string>
#include <vector>

#include "called.hpp"

// Poses of the tool, the table of tools, surfaces that a program machines, and where it gouges them.

using namespace leadscrew;
using namespace leadscrew::capi_tests;

namespace test_surfaces {

/// A plane of 20 mm by 20 mm at Z 0, machined by a flat end mill of 10 mm, which then cuts half a millimetre into it.
constexpr const char* plane_program =
    "G6.4 D3 P2 Q2 I2 J2\nX0 Y0 Z0\nX20\nX0 Y20\nX20\nT2 M6\nG43 H2\nG0 Z25\nG6.5 D3 Q5 Z10 F3000\n"
    "G0 X7 Y9 Z5\nG1 Z-0.5 F500\nG1 Z5\nM2\n";
constexpr const char* table = "T1 P1 D6 Z10\nT2 P2 D10 R0 Z30 L40 H50 K60\n";

leadscrew_options with_tools() {
  leadscrew_options options = no_options();
  options.tools = table;
  options.tools_length = std::string(table).size();
  return options;
}

Machine trunnion() {
  const std::string text = read(LEADSCREW_SOURCE_DIR "/machines/table-table-ac.toml");
  leadscrew_machine* machine = nullptr;
  EXPECT_EQ(leadscrew_machine_of_text(text.data(), text.size(), &machine, nullptr), LEADSCREW_OK);
  return Machine(machine);
}

Trajectory planned(const leadscrew_machine* machine, const std::string& text) {
  const leadscrew_options options = with_tools();
  leadscrew_motion* motion = nullptr;
  leadscrew_error error{};
  error.size = sizeof error;
  EXPECT_EQ(leadscrew_motion_of_program(machine, text.data(), text.size(), &options, &motion, &error), LEADSCREW_OK)
      << error.message;
  const Motion owner(motion);
  leadscrew_trajectory* trajectory = nullptr;
  EXPECT_EQ(leadscrew_motion_plan(motion, &trajectory, nullptr), LEADSCREW_OK);
  return Trajectory(trajectory);
}

leadscrew_pose pose_at(const leadscrew_trajectory* trajectory, double time) {
  leadscrew_pose pose{};
  pose.size = sizeof pose;
  EXPECT_EQ(leadscrew_trajectory_pose(trajectory, time, &pose, nullptr), LEADSCREW_OK);
  return pose;
}

TEST(CapiSurfaces, ThePoseOfAMillIsItsPlaceLessTheOffset) {
  const Machine machine = mill();
  const Trajectory trajectory = planned(machine.get(), "T2 M6\nG0 X5\nG43 H2\nG1 X10 Y4 Z-3 F3000\nM2\n");
  const leadscrew_pose first = pose_at(trajectory.get(), 0);
  EXPECT_EQ(first.tip[2], 0);
  const leadscrew_pose last = pose_at(trajectory.get(), leadscrew_trajectory_duration(trajectory.get()));
  EXPECT_NEAR(last.tip[0], 10, 1e-12);
  EXPECT_NEAR(last.tip[1], 4, 1e-12);
  EXPECT_NEAR(last.tip[2], -3, 1e-12);
  EXPECT_EQ(last.offset[2], 30);
  EXPECT_EQ(last.direction[2], 1);
  EXPECT_EQ(last.tool, 2);
  EXPECT_TRUE(std::isinf(last.pole_angle));
}

/// The tip is where the program has it, and the table tilted by A holds the tool as far from the pole.
TEST(CapiSurfaces, ThePoseOfFiveAxesIsTheProgrammedTip) {
  const Machine machine = trunnion();
  const Trajectory trajectory = planned(machine.get(), "T2 M6\nG43.4 H2\nG1 X10 Y4 Z3 A-30 C40 F3000\nG49\nM2\n");
  const leadscrew_pose last = pose_at(trajectory.get(), leadscrew_trajectory_duration(trajectory.get()));
  EXPECT_NEAR(last.tip[0], 10, 1e-9);
  EXPECT_NEAR(last.tip[1], 4, 1e-9);
  EXPECT_NEAR(last.tip[2], 3, 1e-9);
  EXPECT_NEAR(last.direction[2], std::cos(30 * M_PI / 180), 1e-12);
  EXPECT_NEAR(std::hypot(last.direction[0], last.direction[1]), 0.5, 1e-12);
  EXPECT_NEAR(last.pole_angle, 30, 1e-10);
}

TEST(CapiSurfaces, ToldToolsAreThoseOfTheTable) {
  std::vector<leadscrew_tool> tools;
  const auto take = [](const leadscrew_tool* tool, void* user) {
    static_cast<std::vector<leadscrew_tool>*>(user)->push_back(*tool);
  };
  const leadscrew_options options = with_tools();
  ASSERT_EQ(leadscrew_tools(&options, take, &tools, nullptr), LEADSCREW_OK);
  ASSERT_EQ(tools.size(), 2U);
  EXPECT_EQ(tools[0].corner_radius, -1);
  EXPECT_EQ(tools[1].number, 2);
  EXPECT_EQ(tools[1].diameter, 10);
  EXPECT_EQ(tools[1].corner_radius, 0);
  EXPECT_EQ(tools[1].length, 40);
  EXPECT_EQ(tools[1].holder_diameter, 50);
  EXPECT_EQ(tools[1].holder_length, 60);
  EXPECT_EQ(leadscrew_tools(&options, nullptr, nullptr, nullptr), LEADSCREW_MISUSE);
}

TEST(CapiSurfaces, BlocksSayWhichPassTheyAre) {
  const Machine machine = mill();
  const Trajectory trajectory = planned(machine.get(), plane_program);
  std::vector<leadscrew_block> blocks;
  const auto take = [](const leadscrew_block* block, void* user) {
    static_cast<std::vector<leadscrew_block>*>(user)->push_back(*block);
  };
  ASSERT_EQ(leadscrew_trajectory_blocks(trajectory.get(), take, &blocks, nullptr), LEADSCREW_OK);
  ASSERT_FALSE(blocks.empty());
  EXPECT_EQ(blocks.front().part, LEADSCREW_NO_SURFACE);
  EXPECT_EQ(blocks.back().part, LEADSCREW_NO_SURFACE);
  std::int32_t passes = 0, links = 0;
  for (const leadscrew_block& block : blocks) {
    if (block.line != 9) continue;
    EXPECT_NE(block.part, LEADSCREW_NO_SURFACE);
    if (block.part == LEADSCREW_PASS) passes = block.pass + 1;
    if (block.part == LEADSCREW_LINK) links = block.pass + 1;
  }
  EXPECT_GE(passes, 4);
  EXPECT_EQ(links, passes - 1);
}

TEST(CapiSurfaces, TheSurfaceLiesWhereItIsProgrammed) {
  struct Seen {
    int number = 0;
    double area = 0, farthest = 0;
  } seen;
  const auto take = [](const leadscrew_surface* surface, void* user) {
    Seen& to = *static_cast<Seen*>(user);
    to.number = surface->number;
    for (std::size_t i = 0; i < surface->cells; ++i) {
      const double* at = surface->corners + 12 * i;
      to.area += (at[6] - at[0]) * (at[7] - at[1]);
      for (std::size_t k = 0; k < 4; ++k) {
        to.farthest = std::max(to.farthest, std::abs(at[3 * k + 2]));
        EXPECT_NEAR(std::abs(surface->normals[12 * i + 3 * k + 2]), 1, 1e-12);
      }
    }
  };
  const Machine machine = mill();
  const leadscrew_options options = with_tools();
  const std::string text = plane_program;
  ASSERT_EQ(leadscrew_program_surfaces(machine.get(), text.data(), text.size(), &options, 0.01, take, &seen, nullptr),
            LEADSCREW_OK);
  EXPECT_EQ(seen.number, 3);
  EXPECT_NEAR(seen.area, 400, 1e-9);
  EXPECT_LT(seen.farthest, 1e-9);
  EXPECT_EQ(leadscrew_program_surfaces(machine.get(), "G1 X1\n", 6, &options, 0.01, take, &seen, nullptr),
            LEADSCREW_REJECTED);
  EXPECT_EQ(leadscrew_program_surfaces(machine.get(), text.data(), text.size(), &options, 0, take, &seen, nullptr),
            LEADSCREW_MISUSE);
}

TEST(CapiSurfaces, AGougeIsToldWithItsDepthAndPlace) {
  std::vector<leadscrew_gouge> gouges;
  const auto take = [](const leadscrew_gouge* gouge, void* user) {
    static_cast<std::vector<leadscrew_gouge>*>(user)->push_back(*gouge);
  };
  const Machine machine = mill();
  const leadscrew_options options = with_tools();
  const std::string text = plane_program;
  ASSERT_EQ(leadscrew_program_gouges(machine.get(), text.data(), text.size(), &options, 0.01, take, &gouges, nullptr),
            LEADSCREW_OK);
  ASSERT_EQ(gouges.size(), 1U);
  EXPECT_EQ(gouges[0].line, 11);
  EXPECT_EQ(gouges[0].part, LEADSCREW_NO_SURFACE);
  EXPECT_EQ(gouges[0].tool_part, LEADSCREW_CUTTER);
  EXPECT_EQ(gouges[0].surface, 3);
  EXPECT_NEAR(gouges[0].depth, 0.5, 1e-6);
  EXPECT_NEAR(gouges[0].tip[0], 7, 1e-9);
  EXPECT_NEAR(gouges[0].tip[2], -0.5, 1e-9);
  EXPECT_LE(std::hypot(gouges[0].place[0] - 7, gouges[0].place[1] - 9), 5.0 + 1e-6);
}

struct Contour {
  std::int64_t line = 0;
  bool is_rapid = false;
  std::vector<double> places;
};

std::vector<Contour> contours_of(const std::string& text, double sag) {
  std::vector<Contour> told;
  const auto take = [](const leadscrew_contour* from, void* user) {
    static_cast<std::vector<Contour>*>(user)->push_back(
        {from->line, from->is_rapid == 1, {from->places, from->places + 3 * from->count}});
  };
  const Machine machine = mill();
  const leadscrew_options options = with_tools();
  EXPECT_EQ(leadscrew_program_contours(machine.get(), text.data(), text.size(), &options, sag, take, &told, nullptr),
            LEADSCREW_OK);
  return told;
}

/// The contour is where it is programmed, and the tool's middle 3 mm, its radius, beside it.
TEST(CapiSurfaces, AContourIsToldAsItIsProgrammed) {
  const std::string text =
      "T1 M6\nG43 H1\nG0 X-20 Y-10 Z0\nG41 D1 G1 X0 Y0 F1000\nY20\nG2 X20 Y20 R10\nG1 Y0\nG40 G0 X40 Y-10\nX50\nM2\n";
  constexpr double sag = 0.01;
  const std::vector<Contour> contours = contours_of(text, sag);
  ASSERT_EQ(contours.size(), 5U);
  const std::vector<double> way_in{-20, -10, 0, 0, 0, 0}, side{0, 0, 0, 0, 20, 0}, way_out{20, 0, 0, 40, -10, 0};
  EXPECT_EQ(contours[0].places, way_in);
  EXPECT_EQ(contours[1].places, side);
  EXPECT_EQ(contours[1].line, 5);
  EXPECT_FALSE(contours[1].is_rapid);
  EXPECT_EQ(contours[4].places, way_out);
  EXPECT_TRUE(contours[4].is_rapid);
  const std::vector<double>& arc = contours[2].places;
  EXPECT_LT(arc.size(), 3 * 70U);
  for (std::size_t i = 0; i + 3 < arc.size(); i += 3) {
    EXPECT_NEAR(std::hypot(arc[i] - 10, arc[i + 1] - 20), 10, 1e-9);
    EXPECT_NEAR(std::hypot((arc[i] + arc[i + 3]) / 2 - 10, (arc[i + 1] + arc[i + 4]) / 2 - 20), 10 - sag / 2, sag / 2);
  }
  const Machine machine = mill();
  const Trajectory trajectory = planned(machine.get(), text);
  double highest = 0;
  for (double t = 0; t < leadscrew_trajectory_duration(trajectory.get()); t += 0.001)
    highest = std::max(highest, pose_at(trajectory.get(), t).tip[1]);
  EXPECT_NEAR(highest, 33, 0.02);
}

TEST(CapiSurfaces, NoContourIsToldWithoutCompensation) {
  EXPECT_TRUE(contours_of("T1 M6\nG43 H1\nG1 X10 F1000\nG2 X20 R5\nM2\n", 0.01).empty());
  const Machine machine = mill();
  const leadscrew_options options = with_tools();
  const auto none = [](const leadscrew_contour*, void*) {};
  const std::string gouges = "T1 M6\nG41 D1\nG1 X10 F1000\nX20\nG3 Y2 R1\nM2\n";
  leadscrew_error error{};
  error.size = sizeof error;
  EXPECT_EQ(
      leadscrew_program_contours(machine.get(), gouges.data(), gouges.size(), &options, 0.01, none, nullptr, &error),
      LEADSCREW_REJECTED);
  EXPECT_STREQ(error.code, "cutter-gouge");
  EXPECT_EQ(leadscrew_program_contours(machine.get(), "G1 X1\n", 6, &options, 0, none, nullptr, nullptr),
            LEADSCREW_MISUSE);
}

}  // namespace test_surfaces
