// `simulate --adaptive`: the force is held, time is saved, a sensor that fails is not believed.

#include <gtest/gtest.h>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace {

Json milled(const Folder& folder, const std::string& program, std::vector<std::string> more, int status = 0) {
  folder.write("part.ngc", program);
  std::vector<std::string> words = {"simulate", "part.ngc", "--json", "--adaptive"};
  words.insert(words.end(), more.begin(), more.end());
  const auto outcome = leadscrew(folder, words);
  EXPECT_EQ(outcome.status, status) << outcome.errors << outcome.output;
  return outcome.json();
}

const std::string slot = "G21 G90\nG1 X24 F600\nM2\n";

/// Mean of 4 teeth of 10 mm at 3000/min, 2 mm deep and 4 mm wide in steel: z·ap/2π·Kt·fz·(1 − cos φe).
TEST(Adaptive, HoldsTheForceOfTheFirstDepthWhenItDoubles) {
  const Folder folder;
  const Json figures = milled(folder, slot, {"--depth-steps", "0:2,8:4"}), cut = figures["adaptive"];
  EXPECT_NEAR(cut["force_limit_n"], 4 * 2 / 6.283185307179586 * 2000 * 0.05 * 0.8, 1e-9);
  EXPECT_EQ(cut["held"], true);
  EXPECT_GT(cut["longest_excess_s"], 0);
  EXPECT_LE(cut["longest_excess_s"], 0.15);
  EXPECT_NEAR(cut["longest_excess_turns"], cut["longest_excess_s"].get<double>() / 0.02, 1e-9);
  EXPECT_NEAR(cut["override"]["min"], 0.5, 0.1);
  EXPECT_EQ(cut["sensor_failure"], "none");
  EXPECT_TRUE(cut["failed_at_s"].is_null());
  EXPECT_NEAR(cut["safe_time_s"], 2 * 2.4, 0.15);
  EXPECT_LT(figures["time_s"], cut["safe_time_s"]);
  EXPECT_NEAR(cut["time_saved_s"], cut["safe_time_s"].get<double>() - figures["time_s"].get<double>(), 1e-9);
  EXPECT_NEAR(figures["feed"]["measured_max_mm_s"], 10, 1);
}

/// In half the depth the feed doubles, and no more.
TEST(Adaptive, GoesFasterWhereThereIsLessToCut) {
  const Folder folder;
  const Json figures = milled(folder, slot, {"--depth", "0.5", "--force-limit", "100"});
  EXPECT_NEAR(figures["adaptive"]["override"]["max"], 2, 1e-9);
  EXPECT_LT(figures["feed"]["measured_max_mm_s"], 20.5);
}

TEST(Adaptive, WarnsOfAForceThatNoOverrideKeeps) {
  const Folder folder;
  const Json far = milled(folder, slot, {"--edge-force", "40", "--force-limit", "30"}, 1);
  EXPECT_EQ(far["diagnostics"][0]["code"], "force-limit");
  EXPECT_GT(far["adaptive"]["unreachable_s"], 1);
  EXPECT_EQ(far["adaptive"]["held"], false);
  EXPECT_EQ(milled(folder, slot, {})["diagnostics"], Json::array());
}

/// A rapid does not cut, and the feed after it begins as programmed.
TEST(Adaptive, LeavesRapidsAlone) {
  const Folder folder;
  const Json figures = milled(folder, "G21 G90\nG0 X60\nG1 X66 F600\nG0 X0\nM2\n", {});
  EXPECT_NEAR(figures["feed"]["commanded_max_mm_s"], 200, 1);
  EXPECT_EQ(figures["adaptive"]["sensor_failure"], "none");
  EXPECT_LT(figures["adaptive"]["mean_force_max_n"], 1.3 * figures["adaptive"]["force_limit_n"].get<double>());
}

TEST(Adaptive, FallsBackToTheSafeFeedWhenTheSensorFails) {
  const Folder folder;
  for (const auto& [fault, name] :
       {std::pair("nan@0.8", "not a number"), {"silent@0.8", "silent"}, {"stuck@0.8", "stuck"}}) {
    const Json figures =
        milled(folder, "G21 G90\nG1 X16 F600\nM2\n", {"--sensor-fault", fault, "--safe-factor", "0.4"});
    EXPECT_EQ(figures["adaptive"]["sensor_failure"], name);
    EXPECT_NEAR(figures["adaptive"]["failed_at_s"], 0.82, 0.0025);
    // 8 mm as programmed, 8 mm at 0.4 of it.
    EXPECT_NEAR(figures["time_s"], 0.8 + 0.8 / 0.4, 0.12);
    EXPECT_EQ(leadscrew(folder, {"simulate", "part.ngc", "--adaptive", "--sensor-fault", fault})
                  .output.find("believed throughout"),
              std::string::npos);
  }
}

/// The same seed gives the same cut.
TEST(Adaptive, RepeatsItself) {
  const Folder folder;
  const std::string program = "G21 G90\nG1 X6 F600\nM2\n";
  const auto cut = [&](const std::string& seed) { return milled(folder, program, {"--seed", seed})["adaptive"]; };
  EXPECT_EQ(cut("7"), cut("7"));
  EXPECT_NE(cut("7"), cut("8"));
}

TEST(Adaptive, SaysWhatIsWrongWithItsOptions) {
  const Folder folder;
  folder.write("part.ngc", slot);
  folder.write("rapid.ngc", "G21 G90\nG0 X4\nM2\n");
  const auto errors = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"simulate", "part.ngc"});
    const auto outcome = leadscrew(folder, more);
    EXPECT_EQ(outcome.status, 2);
    return outcome.errors;
  };
  EXPECT_TRUE(contains(errors({"--depth", "2"}), "--depth is of --adaptive"));
  EXPECT_TRUE(contains(errors({"--adaptive", "--material", "wood"}), "none of aluminium"));
  EXPECT_TRUE(contains(errors({"--adaptive", "--depth-steps", "0:2,0:3"}), "places rise"));
  EXPECT_TRUE(contains(errors({"--adaptive", "--depth-steps", "4"}), "PLACE:DEPTH"));
  EXPECT_TRUE(contains(errors({"--adaptive", "--width", "11"}), "give 0 to 10"));
  EXPECT_TRUE(contains(errors({"--adaptive", "--sensor-fault", "dead"}), "none of nan, stuck, silent"));
  EXPECT_TRUE(contains(errors({"--adaptive", "--safe-factor", "2"}), "give 0.01 to 1"));
  EXPECT_TRUE(contains(errors({"--adaptive", "--depht", "2"}), "did you mean --depth"));
  EXPECT_EQ(leadscrew(folder, {"simulate", "rapid.ngc", "--adaptive"}).status, 2);
}

}  // namespace
}  // namespace leadscrew::cli::testing
