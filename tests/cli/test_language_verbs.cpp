// explain, format, check --lint and --dialect, as they are called.

#include <gtest/gtest.h>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_language_verbs {

TEST(Explain, SaysWhatABlockMeans) {
  const Folder folder;
  const auto told = leadscrew(folder, {"explain", "G1 X5 F100"});
  EXPECT_EQ(told.status, 0);
  EXPECT_TRUE(contains(told.output, "line at feed"));
  EXPECT_TRUE(contains(told.output, "5 mm or inches"));
}

TEST(Explain, KnowsDialectsAndSaysWhatItDoesNotKnow) {
  const Folder folder;
  EXPECT_TRUE(contains(leadscrew(folder, {"explain", "G76", "--dialect", "haas"}).output, "fine boring"));
  const auto unknown = leadscrew(folder, {"explain", "G123"});
  EXPECT_EQ(unknown.status, 3);
  EXPECT_TRUE(contains(unknown.errors, "[unknown-code]"));
  EXPECT_TRUE(contains(leadscrew(folder, {"explain", "cutter-gouge"}).output, "What to do: Use a smaller tool"));
  EXPECT_EQ(leadscrew(folder, {"explain", "cutter-goug"}).status, 3);
  EXPECT_EQ(leadscrew(folder, {"explain"}).status, 2);
}

TEST(Format, WritesAProgramInOneWay) {
  const Folder folder;
  folder.write("part.ngc", "n010g01x1.50f0600(there)\nm2");
  const auto told = leadscrew(folder, {"format", "part.ngc"});
  EXPECT_EQ(told.status, 0);
  EXPECT_EQ(told.output, "N10 G1 X1.5 F600 (there)\nM2\n");
  EXPECT_EQ(leadscrew(folder, {"format", "none.ngc"}).status, 4);
}

TEST(Lint, WarnsAndEndsWell) {
  const Folder folder;
  folder.write("part.ngc", "G0 Z5\nG1 Z-1 F100\nX50 F600\nM2\n");
  EXPECT_FALSE(contains(leadscrew(folder, {"check", "part.ngc"}).errors, "lint-"));
  const auto told = leadscrew(folder, {"check", "part.ngc", "--lint"});
  EXPECT_EQ(told.status, 0);
  EXPECT_TRUE(contains(told.errors, "[lint-spindle-off]"));
  EXPECT_FALSE(
      contains(leadscrew(folder, {"check", "part.ngc", "--lint", "--stock-top", "-2"}).errors, "lint-spindle"));
  EXPECT_EQ(leadscrew(folder, {"check", "part.ngc", "--stock-top", "1"}).status, 2);
}

TEST(Dialects, AreChosenByOptionOrMachineFile) {
  const Folder folder;
  folder.write("part.nc", "M97 P5\nM30\nN5 G4 P250\nM99\n");
  folder.write("haas.toml",
               "dialect = \"haas\"\n[axis.X]\ntravel_mm = [-1, 1]\nmax_velocity_mm_s = 1\n"
               "max_acceleration_mm_s2 = 1\nmax_jerk_mm_s3 = 1\nblu_mm = 0.001\n");
  EXPECT_EQ(leadscrew(folder, {"check", "part.nc", "--dialect", "haas"}).status, 0);
  EXPECT_EQ(leadscrew(folder, {"check", "part.nc", "--machine", "haas.toml"}).status, 0);
  const auto refused = leadscrew(folder, {"check", "part.nc", "--machine", "haas.toml", "--dialect", "linuxcnc"});
  EXPECT_EQ(refused.status, 3);
  EXPECT_TRUE(contains(refused.errors, "known by --dialect haas"));
  EXPECT_EQ(leadscrew(folder, {"check", "part.nc", "--dialect", "okuma"}).status, 2);
}

}  // namespace test_language_verbs
}  // namespace leadscrew::cli::testing
