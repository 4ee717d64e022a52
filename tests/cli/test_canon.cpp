// `leadscrew canon` prints calls on standard output and problems on standard error.

#include <gtest/gtest.h>

#include <algorithm>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_canon {

constexpr const char* head =
    "    1 N..... USE_LENGTH_UNITS(CANON_UNITS_MM)\n"
    "    2 N..... SET_G5X_OFFSET(1, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
    "    3 N..... SET_G92_OFFSET(0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)\n"
    "    4 N..... SET_XY_ROTATION(0.0000)\n"
    "    5 N..... SET_FEED_REFERENCE(CANON_XYZ)\n";

TEST(CanonCommand, PrintsCalls) {
  const Folder folder;
  folder.write("part.ngc", "G21 G61\nG0 X4\nM2\n");
  const auto outcome = leadscrew(folder, {"canon", "part.ngc"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.errors, "");
  EXPECT_EQ(outcome.output, head + std::string("    6 N..... SET_MOTION_CONTROL_MODE(CANON_EXACT_PATH)\n"
                                               "    7 N..... STRAIGHT_TRAVERSE(4.0000, 0.0000, 0.0000, 0.0000, "
                                               "0.0000, 0.0000)\n"
                                               "    8 N..... PROGRAM_END()\n"));
}

TEST(CanonCommand, EndsWithTheFirstErrorAndTellsAll) {
  const Folder folder;
  folder.write("part.ngc", "G21 G61\nG1 X4\nG1 X5 Q1\nM2\n");
  const auto outcome = leadscrew(folder, {"canon", "part.ngc"});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_EQ(outcome.output, head);
  EXPECT_TRUE(contains(outcome.errors, "missing-feed")) << outcome.errors;
  EXPECT_TRUE(contains(outcome.errors, "unused-word")) << outcome.errors;
  EXPECT_EQ(leadscrew(folder, {"canon", "none.ngc"}).status, 4);
  EXPECT_EQ(leadscrew(folder, {"canon", "part.ngc", "--json"}).status, 2);
}

TEST(CanonCommand, StreamsLongPrograms) {
  const Folder folder;
  std::string text = "G21 G61 G91\n";
  constexpr int blocks = 5000;
  for (int i = 0; i < blocks; ++i) text += i % 2 == 0 ? "G0 X1\n" : "G0 X-1\n";
  folder.write("part.ngc", text + "M2\n");
  const auto outcome = leadscrew(folder, {"canon", "part.ngc"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 5 + 1 + blocks + 1);
  EXPECT_TRUE(contains(outcome.output, " 5007 N..... PROGRAM_END()\n"));
}

}  // namespace test_canon
}  // namespace leadscrew::cli::testing
