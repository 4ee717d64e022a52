// `simulate --adaptive`: the force is held, time is saved, a sensor that fails is not believed.

#include <gtest/gtest.h>

#include <sstream>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_adaptive {

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

/// The feeds of all words of a trace, mm/s.
std::vector<double> feeds_of(const Folder& folder, const std::string& trace) {
  std::istringstream lines(folder.read(trace));
  std::string line, cell;
  std::getline(lines, line);
  EXPECT_TRUE(line.starts_with("t,line,s,feed,")) << line;
  std::vector<double> feeds;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    for (int k = 0; k < 4; ++k) std::getline(cells, cell, ',');
    feeds.push_back(std::stod(cell));
  }
  return feeds;
}

/// 8 mm as programmed, 8 mm at 0.4 of it; it is told by code on standard error, in the summary and in --json.
void expect_safe_feed(const std::string& fault, const std::string& name) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90\nG1 X16 F600\nM2\n");
  const std::vector<std::string> words = {"simulate",      "part.ngc", "--adaptive", "--sensor-fault", fault + "@0.8",
                                          "--safe-factor", "0.4",      "--trace",    "words.csv"};
  const auto outcome = leadscrew(folder, words);
  EXPECT_EQ(outcome.status, 0);
  EXPECT_TRUE(
      contains(outcome.errors, "warning: the sensor of the force failed (" + name + "): not believed from t = 0.8"))
      << outcome.errors;
  EXPECT_TRUE(contains(outcome.errors, "the feed is 0.4 times the programmed one from there [force-sensor]"));
  EXPECT_TRUE(contains(outcome.output, "sensor     " + name + ": not believed from 0.8")) << outcome.output;
  const std::vector<double> feeds = feeds_of(folder, "words.csv");
  for (std::size_t k = 0; k < feeds.size() - 100; ++k) {
    if (k > 300 && k < 800) {
      EXPECT_NEAR(feeds[k], 10, 0.5) << k;
    } else if (k > 950) {
      EXPECT_NEAR(feeds[k], 4, 1e-9) << k;
    }
  }

  const Json figures =
      milled(folder, "G21 G90\nG1 X16 F600\nM2\n", std::vector<std::string>(words.begin() + 3, words.end()));
  const Json& problem = figures["diagnostics"].at(0);
  EXPECT_EQ(figures["diagnostics"].size(), 1u);
  EXPECT_EQ(problem["code"], "force-sensor");
  EXPECT_EQ(problem["severity"], "warning");
  EXPECT_EQ(figures["adaptive"]["sensor_failure"], name);
  EXPECT_EQ(figures["adaptive"]["safe_factor"], 0.4);
  EXPECT_GE(figures["adaptive"]["failed_at_s"], 0.815);
  EXPECT_LE(figures["adaptive"]["failed_at_s"], 0.82 + 0.002);  // slides are a word or two behind
  EXPECT_NEAR(figures["time_s"], 0.8 + 0.8 / 0.4, 0.12);
}

TEST(Adaptive, TakesTheSafeFeedAndSaysSoWhenTheSensorSaysNoNumber) {
  expect_safe_feed("nan", "not a number");
}

TEST(Adaptive, TakesTheSafeFeedAndSaysSoWhenTheSensorIsStuck) {
  expect_safe_feed("stuck", "stuck");
}

TEST(Adaptive, TakesTheSafeFeedAndSaysSoWhenTheSensorIsSilent) {
  expect_safe_feed("silent", "silent");
}

TEST(Adaptive, SaysNothingOfASensorThatIsBelieved) {
  const Folder folder;
  folder.write("part.ngc", slot);
  const auto outcome = leadscrew(folder, {"simulate", "part.ngc", "--adaptive"});
  EXPECT_EQ(outcome.errors, "");
  EXPECT_TRUE(contains(outcome.output, "believed throughout"));
}

/// An ideal sensor is believed in air too, where all it says is 0.
TEST(Adaptive, TakesASensorWithoutNoise) {
  const Folder folder;
  const Json figures = milled(folder, slot, {"--noise", "0", "--depth-steps", "0:2,8:0,16:4"}),
             cut = figures["adaptive"];
  EXPECT_EQ(cut["sensor_failure"], "none");
  EXPECT_EQ(cut["held"], true);
  EXPECT_GT(cut["override"]["max"], 1.5);
  EXPECT_NEAR(cut["override"]["min"], 0.5, 0.03);
  const auto stuck =
      leadscrew(folder, {"simulate", "part.ngc", "--adaptive", "--noise", "0", "--sensor-fault", "stuck@1"});
  EXPECT_EQ(stuck.status, 2);
  EXPECT_TRUE(contains(stuck.errors, "--sensor-fault stuck@1: shows by noise that is missing")) << stuck.errors;
  EXPECT_EQ(milled(folder, slot, {"--noise", "0", "--sensor-fault", "silent@1"})["adaptive"]["sensor_failure"],
            "silent");
}

/// Words of many lines are planned in windows; corners are slow, and after each the force is at its limit again.
TEST(Adaptive, HoldsTheForceFromCornerToCorner) {
  const Folder folder;
  std::string program = "G21 G90 F600\n";
  for (int k = 1; k <= 6; ++k) program += "G1 X" + std::to_string(4 * k) + " Y" + std::to_string(k % 2 * 4) + "\n";
  const Json figures = milled(folder, program + "M2\n", {"--depth-steps", "0:2,12:4,24:1", "--tolerance", "0.05"});
  EXPECT_EQ(figures["adaptive"]["held"], true);
  EXPECT_NEAR(figures["adaptive"]["override"]["min"], 0.5, 0.05);
  EXPECT_NEAR(figures["adaptive"]["override"]["max"], 2, 1e-9);
  EXPECT_LT(figures["time_s"], figures["adaptive"]["safe_time_s"]);
}

/// All that is not kept is named, not the first of it alone.
TEST(Adaptive, NamesAllThatIsNotKept) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90\nG1 X4 F600\nM2\n");
  const auto verdict = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"simulate", "part.ngc", "--adaptive"};
    words.insert(words.end(), more.begin(), more.end());
    const auto outcome = leadscrew(folder, words);
    const std::size_t at = outcome.output.find("kept: ");
    EXPECT_NE(at, std::string::npos) << outcome.output << outcome.errors;
    EXPECT_EQ(outcome.status, at >= 4 && outcome.output.substr(at - 4, 4) == "NOT " ? 1 : 0);
    return outcome.output.substr(at + 6, outcome.output.find('\n', at) - at - 6);
  };
  const std::string force = "the force is beyond its limit for too long";
  EXPECT_EQ(verdict({}), "the slides stay within the tolerance, and come to rest; the force is held");
  EXPECT_EQ(verdict({"--edge-force", "40", "--force-limit", "30"}), force);
  EXPECT_EQ(verdict({"--gains", "20,400,0"}), "the slides leave the tolerance");
  EXPECT_EQ(verdict({"--gains", "20,400,0", "--edge-force", "40", "--force-limit", "30"}),
            "the slides leave the tolerance; " + force);
  EXPECT_EQ(verdict({"--gains", "150,0,0", "--edge-force", "40", "--force-limit", "30"}),
            "the slides do not come to rest; " + force);
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

}  // namespace test_adaptive
}  // namespace leadscrew::cli::testing
