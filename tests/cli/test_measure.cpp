// `measure`: what the tool of a trace leaves of the surfaces that its program machines.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_measure {

using Words = std::vector<std::string>;

const std::string balls = "T1 P1 D10 R5\nT2 P2 D10 R5 Z42\nT3 P3 D8 R1 L30\nT4 P4 D6\n";
const std::string plane = "G6.4 D1 P2 Q2 I2 J2\nX0 Y0 Z0\nX20\nX0 Y12\nX20\n";
const std::string patch_a =
    "G6.4 D1 P4 Q4 I4 J4\n"
    "X0 Y0 Z0\nX20 Z6\nX40\nX60 Z0\n"
    "X0 Y20 Z6\nX20 Z14\nX40 Z2\nX60 Z-4\n"
    "X0 Y40 Z6\nX20 Z2\nX40 Z14\nX60 Z6\n"
    "X0 Y60 Z0\nX20 Z-4\nX40 Z6\nX60 Z8\n";

/// The program's words, measured with few places.
struct Measured {
  Outcome outcome;
  nlohmann::json surface;
};
Measured measured(const Folder& folder, const std::string& program, const Words& more = {}, const Words& of_both = {},
                  const std::string& places = "8192") {
  folder.write("part.ngc", program);
  folder.write("tools.tbl", balls);
  Words run = {"run", "part.ngc", "--tools", "tools.tbl", "--start", "Z50", "--trace", "t.csv", "--quiet"};
  run.insert(run.end(), of_both.begin(), of_both.end());
  const Outcome ran = leadscrew(folder, run);
  EXPECT_EQ(ran.status, 0) << ran.errors;
  Words words = {"measure", "t.csv", "part.ngc", "--tools",  "tools.tbl",
                 "--start", "Z50",   "--json",   "--places", places};
  words.insert(words.end(), of_both.begin(), of_both.end());
  words.insert(words.end(), more.begin(), more.end());
  Measured result{leadscrew(folder, words), {}};
  const auto json = nlohmann::json::parse(result.outcome.output, nullptr, false);
  if (json.is_object() && json.contains("surfaces")) result.surface = json["surfaces"][0];
  return result;
}

TEST(Measure, FindsTheScallopsThatWereAskedFor) {
  const Folder folder;
  const Measured found = measured(folder, "G21 G90 G61 T1 M6\n" + patch_a + "G6.5 D1 H0.01 L1 S2 Z30 F12000\nM2\n",
                                  {"--ridge", "0.01001"}, {}, "30000");
  ASSERT_EQ(found.outcome.status, 0) << found.outcome.errors;
  EXPECT_EQ(found.surface["passes"], 100);
  EXPECT_NEAR(found.surface["ridge"]["mm"].get<double>(), 0.01, 1e-5);
  EXPECT_GT(found.surface["mean_ridge_mm"].get<double>(), 0.009);
  EXPECT_LT(found.surface["cut"]["mm"].get<double>(), 2e-5) << "words on chords";
  EXPECT_EQ(found.surface["not_reached_mm2"], 0);
  EXPECT_NEAR(found.surface["area_mm2"].get<double>(), 3673.206807, 0.1);
  EXPECT_EQ(found.surface["ridge"]["line"], 19);
}

TEST(Measure, TellsACutAndItsBlockAndFailsWhereItIsDeeperThanAllowed) {
  const Folder folder;
  const std::string program =
      "G21 G90 G61 T1 M6\n" + plane + "G6.5 D1 Q1 Z5 F6000\nG0 X7.3 Y4.1\nG1 Z-0.05\nG0 Z5\nM2\n";
  const Measured found = measured(folder, program, {"--allow", "0.04"});
  EXPECT_EQ(found.outcome.status, 1);
  EXPECT_NEAR(found.surface["cut"]["mm"].get<double>(), 0.05, 1e-6);
  EXPECT_NEAR(found.surface["cut"]["x"].get<double>(), 7.3, 1e-3);
  EXPECT_NEAR(found.surface["cut"]["y"].get<double>(), 4.1, 1e-3);
  EXPECT_EQ(found.surface["cut"]["line"], 9);
  EXPECT_NEAR(found.surface["ridge"]["mm"].get<double>(), 5 - std::sqrt(25 - 0.25), 1e-6);
  EXPECT_EQ(measured(folder, program, {"--allow", "0.06"}).outcome.status, 0);
  EXPECT_EQ(measured(folder, program, {"--allow", "0.06", "--ridge", "0.02"}).outcome.status, 1);
}

TEST(Measure, TakesAToolsLengthFromItsPlace) {
  const Folder folder;
  const std::string passes = plane + "G6.5 D1 Q1 Z5 F6000\nM2\n";
  const Measured found = measured(folder, "G21 G90 G61 T2 M6 G43 H2\n" + passes);
  ASSERT_EQ(found.outcome.status, 0) << found.outcome.errors;
  EXPECT_NEAR(found.surface["ridge"]["mm"].get<double>(), 5 - std::sqrt(25 - 0.25), 1e-6);
  EXPECT_NEAR(found.surface["ridge"]["z"].get<double>(), 0, 1e-9) << "without the length of 42 mm";
}

/// Two tools of different lengths over one surface, the second in the middle between the passes of the first: half the step.
TEST(Measure, PutsSeveralToolsOverOneSurfaceTogether) {
  const Folder folder;
  const std::string program = "G21 G90 G61 T1 M6 G43 H1\n" + plane +
                              "G6.5 D1 Q1 Z5 F6000\nG0 Z95\nG49\nT2 M6 G43 H2\nG6.5 D1 Q0.5 Z5 F6000\nM2\n";
  const Measured found = measured(folder, program);
  ASSERT_EQ(found.outcome.status, 0) << found.outcome.errors;
  EXPECT_EQ(found.surface["line"], 11);
  EXPECT_NEAR(found.surface["ridge"]["mm"].get<double>(), 5 - std::sqrt(25 - 0.0625), 1e-6);

  // Another controller's trace does not tell lines: then nobody knows which tool cuts.
  std::string trace = folder.read("t.csv");
  folder.write("bare.csv", trace.replace(trace.find("line"), 4, "what"));
  const Outcome bare = leadscrew(folder, {"measure", "bare.csv", "part.ngc", "--tools", "tools.tbl", "--start", "Z50"});
  EXPECT_EQ(bare.status, 3);
  EXPECT_TRUE(contains(bare.errors, "[measure-line]")) << bare.errors;
}

TEST(Measure, JudgesALeaningToolByThePosesOfItsAxes) {
  const Folder folder;
  const std::string program = "G21 G90 G61 T3 M6\nG43.4 H3\n" + plane + "G6.5 D1 Q1 S1 A10 Z15 F3000\nG49\nM2\n";
  const Measured found =
      measured(folder, program, {}, {"--machine", std::string(LEADSCREW_SOURCE_DIR) + "/machines/table-table-ac.toml"});
  ASSERT_EQ(found.outcome.status, 0) << found.outcome.errors;
  EXPECT_LT(found.surface["cut"].is_null() ? 0 : found.surface["cut"]["mm"].get<double>(), 2e-5);
  EXPECT_EQ(found.surface["corner_radius_mm"], 1);
  // R_e = (R − r)/sin θ + r = 18.28 mm, and a step of 1 mm; before the first and behind the last place of a pass more.
  EXPECT_GT(found.surface["mean_ridge_mm"].get<double>(), 0.0068);
  EXPECT_LT(found.surface["mean_ridge_mm"].get<double>(), 0.0075);
}

TEST(Measure, SaysWhatWasNotReached) {
  const Folder folder;
  const Measured found =
      measured(folder, "G21 G90 G61 T1 M6\n" + plane + "G6.5 D1 Q1 Z5 U0 V1 I0 J1 F6000\nM2\n", {"--reach", "0.01"});
  ASSERT_EQ(found.outcome.status, 0) << found.outcome.errors;
  // Of a step of 1 mm what is left is below 0.01 over 2 √(2·5·0.01 − 0.0001) mm.
  EXPECT_NEAR(found.surface["not_reached_mm2"].get<double>(), 240 * (1 - 2 * std::sqrt(0.1 - 0.0001)), 8);
}

TEST(Measure, WritesAMapAndAPictureAndSaysSo) {
  const Folder folder;
  measured(folder, "G21 G90 G61 T1 M6\n" + plane + "G6.5 D1 Q1 Z5 F6000\nM2\n");
  const Outcome told = leadscrew(folder, {"measure", "t.csv", "part.ngc", "--tools", "tools.tbl", "--start", "Z50",
                                          "--places", "5000", "--map", "left.csv", "--picture", "left.svg"});
  ASSERT_EQ(told.status, 0) << told.errors;
  for (const char* text :
       {"surface 1, line 7: 13 passes of a ball of 10 mm, 1 mm apart", "deep at u", "tall at u", "all of it reached",
        "kept: no cut deeper than 0.01 mm", "wrote      left.csv", "wrote      left.svg"})
    EXPECT_TRUE(contains(told.output, text)) << text << "\n" << told.output;
  EXPECT_TRUE(folder.read("left.csv").starts_with("line,u,v,x,y,z,height\n7,0,0,0,0,0,"));
  for (const char* text :
       {"<svg", "part.ngc: what t.csv leaves", "Across the passes", "prefers-color-scheme:dark", "</svg>"})
    EXPECT_TRUE(contains(folder.read("left.svg"), text)) << text;
}

TEST(Measure, RefusesWhatCannotBeMeasured) {
  const Folder folder;
  folder.write("part.ngc", "G0 X1\nM2\n");
  folder.write("t.csv", "t,X\n0,0\n0.001,1\n");
  folder.write("empty.csv", "t,X\n");
  const Outcome none = leadscrew(folder, {"measure", "t.csv", "part.ngc"});
  EXPECT_EQ(none.status, 3);
  EXPECT_TRUE(contains(none.errors, "[measure-nothing]")) << none.errors;
  EXPECT_EQ(leadscrew(folder, {"measure", "none.csv", "part.ngc"}).status, 4);
  EXPECT_EQ(leadscrew(folder, {"measure", "t.csv", "part.ngc", "--reach", "0"}).status, 2);
  EXPECT_EQ(leadscrew(folder, {"measure", "t.csv", "part.ngc", "--places", "1e9"}).status, 2);
  EXPECT_EQ(leadscrew(folder, {"measure", "t.csv", "part.ngc", "--map", "t.csv"}).status, 2);
  folder.write("tools.tbl", balls);
  folder.write("plane.ngc", "T1 M6\n" + plane + "G6.5 D1 Q1 Z5 F6000\nM2\n");
  const Outcome empty = leadscrew(folder, {"measure", "empty.csv", "plane.ngc", "--tools", "tools.tbl"});
  EXPECT_EQ(empty.status, 3);
  EXPECT_TRUE(contains(empty.errors, "[trace-empty]")) << empty.errors;
}

TEST(Measure, LeavesOutSurfacesBeyondThoseItHoldsAndSaysSo) {
  const Folder folder;
  std::string program = "G21 G90 G61 T1 M6\n";
  for (int k = 0; k < 17; ++k) {
    const std::string x = std::to_string(10 * k), to = std::to_string(10 * k + 4);
    program += "G6.4 D1 P2 Q2 I2 J2\nX" + x + " Y0 Z0\nX" + to + "\nX" + x + " Y4\nX" + to + "\nG6.5 D1 Q4 Z5 F12000\n";
  }
  const Measured found = measured(folder, program + "M2\n");
  EXPECT_EQ(found.outcome.status, 0);
  EXPECT_EQ(nlohmann::json::parse(found.outcome.output)["surfaces"].size(), 16);
  EXPECT_TRUE(contains(found.outcome.errors, "[measure-surfaces]")) << found.outcome.errors;
}

}  // namespace test_measure
}  // namespace leadscrew::cli::testing
