#include "called.hpp"

// The modes of a program, block by block.

using namespace leadscrew::capi_tests;

namespace test_modes {

std::vector<leadscrew_modes> modes_of(const std::string& text, const leadscrew_options& options = no_options()) {
  std::vector<leadscrew_modes> all;
  leadscrew_error error = sized_error();
  const auto take = [](const leadscrew_modes* modes, void* to) {
    static_cast<std::vector<leadscrew_modes>*>(to)->push_back(*modes);
  };
  EXPECT_EQ(leadscrew_program_modes(mill().get(), text.data(), text.size(), &options, take, &all, &error), LEADSCREW_OK)
      << error.message;
  return all;
}

std::vector<std::string> codes_of(const leadscrew_modes& modes) {
  return {modes.motion,    modes.plane,     modes.units,   modes.distance,     modes.arc_distance,
          modes.feed_mode, modes.path_mode, modes.retract, modes.compensation, modes.tool_length,
          modes.spindle,   modes.coolant,   modes.system};
}

using Codes = std::vector<std::string>;

TEST(Modes, OfTheFirstBlockAreThoseThatAProgramBeginsWith) {
  const auto all = modes_of("G1 X5 F600\nM2\n");
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(codes_of(all[0]),
            (Codes{"G1", "G17", "G21", "G90", "G91.1", "G94", "G64", "G99", "G40", "G49", "M5", "M9", "G54"}));
  EXPECT_EQ(all[0].line, 1);
  EXPECT_EQ(all[0].block, 0);
  EXPECT_DOUBLE_EQ(all[0].feed, 10);
  EXPECT_EQ(all[0].tolerance, 0.01);  // the machine's
  EXPECT_EQ(all[0].selected_tool, -1);
}

TEST(Modes, AreToldWhereTheyChangeAndNowhereElse) {
  const auto all = modes_of(
      "G21 G90 G64 P0.05 Q0.02 F600\nG1 X1\nX2\nX3\nT3 S8000 M3 M8\nG18 G91 G61\nX1\nX1\nG10 L2 P2 X7\nG55\nG20\n"
      "F1 X0.1\nM2\n");
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[0].tolerance, 0.05);
  EXPECT_EQ(all[0].naive_cam, 0.02);
  EXPECT_EQ(all[1].line, 7);
  EXPECT_EQ(all[1].block, 3);
  EXPECT_EQ(codes_of(all[1]),
            (Codes{"G1", "G18", "G21", "G91", "G91.1", "G94", "G61", "G99", "G40", "G49", "M3", "M8", "G54"}));
  EXPECT_EQ(all[1].tolerance, 0);
  EXPECT_EQ(all[1].spindle_speed, 8000);
  EXPECT_EQ(all[1].selected_tool, 3);
  EXPECT_EQ(all[2].line, 12);
  EXPECT_STREQ(all[2].system, "G55");
  EXPECT_STREQ(all[2].units, "G20");
  EXPECT_EQ(all[2].offset[0], 7);
  EXPECT_DOUBLE_EQ(all[2].feed, 25.4 / 60);
}

TEST(Modes, CountBlocksAsATrajectoryDoes) {
  const std::string text = "G21 G90 F600\nG1 X1\nX1\nM3 S100\nG4 P0.1\nG2 X3 I1\nG0 X0\nM2\n";
  leadscrew_trajectory* planned = nullptr;
  ASSERT_EQ(leadscrew_motion_plan(program(text).get(), &planned, nullptr), LEADSCREW_OK);
  const Trajectory trajectory(planned);
  std::vector<std::int64_t> lines;
  const auto take = [](const leadscrew_block* block, void* to) {
    static_cast<std::vector<std::int64_t>*>(to)->push_back(block->line);
  };
  ASSERT_EQ(leadscrew_trajectory_blocks(trajectory.get(), take, &lines, nullptr), LEADSCREW_OK);
  const auto all = modes_of(text);
  ASSERT_EQ(all.size(), 4U);
  for (const leadscrew_modes& modes : all) EXPECT_EQ(lines.at(static_cast<std::size_t>(modes.block)), modes.line);
}

TEST(Modes, AreThoseThatOptionsStandFor) {
  leadscrew_options options = no_options();
  options.path_mode = LEADSCREW_EXACT_STOP;
  EXPECT_STREQ(modes_of("G64 P0.1 F600\nG1 X1\nM2\n", options).at(0).path_mode, "G61.1");
}

TEST(Modes, RefuseWhatIsNone) {
  const auto nothing = [](const leadscrew_modes*, void*) {};
  const std::string text = "G1 X1Q F600\nM2\n";
  leadscrew_error error = sized_error();
  EXPECT_EQ(leadscrew_program_modes(mill().get(), text.data(), text.size(), nullptr, nothing, nullptr, &error),
            LEADSCREW_REJECTED);
  EXPECT_EQ(error.line, 1);
  EXPECT_EQ(leadscrew_program_modes(nullptr, text.data(), text.size(), nullptr, nothing, nullptr, nullptr),
            LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_program_modes(mill().get(), nullptr, 1, nullptr, nothing, nullptr, nullptr), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_program_modes(mill().get(), text.data(), text.size(), nullptr, nullptr, nullptr, nullptr),
            LEADSCREW_MISUSE);
}

}  // namespace test_modes
