// The command on time: its words, and what becomes of them when it is stopped and taken up again.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "driven.hpp"

namespace leadscrew::cli::testing {
namespace test_drive {

TEST(Drive, MakesTheWordsOfRunBitForBit) {
  const Folder folder;
  folder.write("part.ngc", part);
  const auto driven = drive_without_a_tail(folder, {"--trace", "driven.csv", "--axes", "axes.csv"});
  const auto run = leadscrew(folder, {"run", "part.ngc", "--trace", "run.csv", "--json"});
  EXPECT_EQ(run.status, 0);
  const Json json = driven.json();
  EXPECT_EQ(json["end"], "done");
  EXPECT_EQ(json["words"], json["words_taken"]);
  EXPECT_EQ(folder.read("driven.csv"), folder.read("run.csv"));
  EXPECT_EQ(json["words"], run.json()["words"]);
  EXPECT_EQ(leadscrew(folder, {"verify", "driven.csv", "part.ngc"}).status, 0);
}

TEST(Drive, ComesToRestOnThePathWhenInterruptedAndGoesOn) {
  const Folder folder;
  folder.write("part.ngc", part);
  leadscrew(folder, {"run", "part.ngc", "--trace", "run.csv"});
  Running first(folder, {"drive", "part.ngc", "--trace", "1.csv", "--state", "state", "--json"});
  ASSERT_TRUE(comes_to(folder, 15));
  first.send(SIGTERM);
  const auto stopped = first.wait();
  EXPECT_EQ(stopped.status, 130) << stopped.errors;
  EXPECT_EQ(stopped.json()["end"], "stopped");
  EXPECT_EQ(state_of(folder), "stopped");
  const auto second = leadscrew(folder, {"drive", "part.ngc", "--trace", "2.csv", "--resume", "state", "--lead", "1s"});
  EXPECT_EQ(second.status, 0) << second.errors;
  EXPECT_EQ(state_of(folder), "ended");
  const auto path = rows_of(folder.read("run.csv")), one = rows_of(folder.read("1.csv")),
             two = rows_of(folder.read("2.csv"));
  EXPECT_LE(worst_ratio(one), 1.001);
  EXPECT_LE(worst_ratio(two), 1.001);
  EXPECT_LE(distance(one.back().q, at(path, one.back().s)), 3e-4);
  EXPECT_LE(distance(one.back().q, two.front().q), 1e-9);
  // At the end of the first line motion rests anyhow: there it goes on with the next.
  const double next = distance(one.back().q, {30, 0, 0}) <= 1e-9 ? 1 : 0;
  EXPECT_EQ(one.back().line + next, two.front().line) << one.back().s;
  EXPECT_LE(distance(two.back().q, path.back().q), 1e-9);
  const auto third = leadscrew(folder, {"drive", "part.ngc", "--resume", "state"});
  EXPECT_EQ(third.status, 3);
  EXPECT_TRUE(contains(third.errors, "[resume-ended]")) << third.errors;
}

TEST(Drive, StopsAtOnceAtTheSecondSignal) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94\nG1 X400 F3000\nM2\n");
  Running running(folder, {"drive", "part.ngc", "--axes", "axes.csv", "--state", "state", "--look-ahead", "5s"});
  ASSERT_TRUE(comes_to(folder, 20));
  running.send(SIGINT);
  // Two signals that wait to be delivered would be one.
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  running.send(SIGINT);
  EXPECT_EQ(running.wait().status, 130);
  EXPECT_EQ(state_of(folder), "stopped");
  const auto axes = rows_of(folder.read("axes.csv"));
  EXPECT_LE(worst_ratio(axes), 1.001);
  EXPECT_LT(axes.back().q[0], 200);  // the look-ahead alone would have brought it further
}

TEST(Drive, IsLeftByItsDrivesWhenWordsComeTooLate) {
  const Folder folder;
  folder.write("part.ngc", part);
  Running first(folder, {"drive", "part.ngc", "--axes", "axes.csv", "--state", "state", "--json"});
  ASSERT_TRUE(comes_to(folder, 15));
  ASSERT_TRUE(first.stop());
  EXPECT_TRUE(eventually([&] { return state_of(folder) == "stopped"; }));
  first.resume();
  const auto outcome = first.wait();
  EXPECT_EQ(outcome.status, 1) << outcome.errors;
  EXPECT_TRUE(contains(outcome.errors, "[words-late]")) << outcome.errors;
  EXPECT_EQ(outcome.json()["end"], "tripped");
  EXPECT_LE(worst_ratio(rows_of(folder.read("axes.csv"))), 1.001);
  EXPECT_EQ(leadscrew(folder, {"drive", "part.ngc", "--resume", "state", "--quiet", "--lead", "1s"}).status, 0);
  EXPECT_EQ(state_of(folder), "ended");
}

/// As when all processes of a session are killed: nobody brings the axes to rest, nobody writes down where.
TEST(Drive, TellsThatItsDrivesWereKilled) {
  const Folder folder;
  folder.write("part.ngc", part);
  Running first(folder, {"drive", "part.ngc", "--state", "state", "--trace", "1.csv"});
  ASSERT_TRUE(comes_to(folder, 15));
  first.send_to_child(SIGKILL);
  const auto outcome = first.wait();
  EXPECT_EQ(outcome.status, 4);
  EXPECT_TRUE(contains(outcome.errors, "[io-drives]")) << outcome.errors;
  EXPECT_EQ(state_of(folder), "moving");
  const auto second = leadscrew(folder, {"drive", "part.ngc", "--resume", "state", "--trace", "2.csv", "--lead", "1s"});
  EXPECT_EQ(second.status, 0) << second.errors;
  EXPECT_TRUE(contains(second.errors, "[resume-cut-twice]")) << second.errors;
  EXPECT_EQ(state_of(folder), "ended");
}

TEST(LongDrive, EndsDrivesThatAreSilent) {
  const Folder folder;
  folder.write("part.ngc", part);
  Running running(folder, {"drive", "part.ngc", "--state", "state"});
  ASSERT_TRUE(comes_to(folder, 15));
  running.send_to_child(SIGSTOP);
  const auto outcome = running.wait();
  EXPECT_EQ(outcome.status, 4);
  EXPECT_TRUE(contains(outcome.errors, "did nothing for 10 s, and was ended [io-drives]")) << outcome.errors;
}

/// Slides under the machine's loops: they follow, not quite.
TEST(Drive, TellsHowItsSlidesFollowed) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94 G17\nG1 X20 F3000\nG2 X20 Y0 I10\nM2\n");
  const Json drive = leadscrew(folder, {"drive", "part.ngc", "--json", "--lead", "1s"}).json();
  const Json simulate = leadscrew(folder, {"simulate", "part.ngc", "--json"}).json();
  for (const int axis : {0, 1}) {
    const double error = drive["axes"][axis]["following_max_mm"];
    EXPECT_GT(error, 1e-5);
    // But for how long they are watched at rest, where they hunt between two counts of 1 µm.
    EXPECT_NEAR(error, simulate["axes"][axis]["following_max_mm"].get<double>(), 2e-4);
  }
  EXPECT_NEAR(drive["feed"]["measured_max_mm_s"], simulate["feed"]["measured_max_mm_s"].get<double>(), 0.05);
}

/// A full disc, of one file or of the other.
TEST(Drive, ComesToRestWhenAFileCannotBeWritten) {
  for (const bool is_trace : {true, false}) {
    const Folder folder;
    folder.write("part.ngc", "G21 G90 G94\nG1 X400 F3000\nM2\n");
    const std::string other = is_trace ? "axes.csv" : "words.csv";
    const auto outcome =
        leadscrew(folder, {"drive", "part.ngc", is_trace ? "--trace" : "--axes", "/dev/full",
                           is_trace ? "--axes" : "--trace", other, "--state", "state", "--lead", "500ms", "--quiet"});
    EXPECT_EQ(outcome.status, 4);
    // Nothing else but what the system did not permit.
    const std::string expected = "/dev/full: error: cannot write: No space left on device [io-write]\n";
    EXPECT_TRUE(outcome.errors.ends_with(expected)) << outcome.errors;
    EXPECT_EQ(outcome.errors.find("error:"), outcome.errors.rfind("error:")) << outcome.errors;
    EXPECT_EQ(state_of(folder), "stopped");
    const auto rows = rows_of(folder.read(other));
    ASSERT_FALSE(rows.empty());
    const Json state = Json::parse(folder.read("state"));
    EXPECT_LT(state["axes"][0].get<double>(), 300);
    if (!is_trace) continue;
    EXPECT_LE(worst_ratio(rows), 1.001);
    EXPECT_EQ(state["axes"][0].get<double>(), rows.back().q[0]);
  }
}

/// Where the axes stand behind the last word, they go back along the path, no faster than its feed; after a signal they
/// stay where they next rest on it, and nothing else has changed.
TEST(Drive, GoesBackAlongThePathToWhereItGoesOn) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94 G17\nG2 X0 Y0 I20 F1200\nM2\n");
  Running first(folder, {"drive", "part.ngc", "--state", "state"});
  ASSERT_TRUE(comes_to(folder, 1));
  first.send(SIGINT);
  EXPECT_EQ(first.wait().status, 130);
  Json before = Json::parse(folder.read("state"));
  const double behind = before["path_length"].get<double>() + 30;
  before["axes"] = {20 - 20 * std::cos(behind / 20), 20 * std::sin(behind / 20), 0, 0, 0, 0, 0, 0, 0};
  before["axes_path_length"] = behind;
  folder.write("state", before.dump());
  Running second(folder, {"drive", "part.ngc", "--resume", "state", "--axes", "axes.csv", "--trace", "words.csv"});
  const auto state = [&] { return Json::parse(folder.read("state"), nullptr, false); };
  ASSERT_TRUE(
      eventually([&] { return state().is_object() && state()["axes_path_length"].get<double>() < behind - 5; }));
  second.send(SIGTERM);
  const auto outcome = second.wait();
  EXPECT_EQ(outcome.status, 130);
  EXPECT_EQ(outcome.errors.find("error"), std::string::npos) << outcome.errors;
  const auto axes = rows_of(folder.read("axes.csv"));
  EXPECT_LE(worst_ratio(axes), 1.001);
  double fastest = 0;
  for (std::size_t k = 1; k < axes.size(); ++k) {
    fastest = std::max(fastest, distance(axes[k].q, axes[k - 1].q) / 1e-3);
    ASSERT_NEAR(std::hypot(axes[k].q[0] - 20, axes[k].q[1]), 20, 1e-9);
  }
  EXPECT_LE(fastest, 20 * (1 + 1e-6));
  EXPECT_GE(fastest, 19);
  EXPECT_TRUE(rows_of(folder.read("words.csv")).empty());
  Json after = state();
  EXPECT_GT(after["axes_path_length"].get<double>(), behind - 25);
  EXPECT_LT(after["axes_path_length"].get<double>(), behind - 5);
  EXPECT_EQ(after["axes"][0].get<double>(), axes.back().q[0]);
  EXPECT_EQ(after["state"], "stopped");
  for (Json* each : {&before, &after}) {
    each->erase("axes");
    each->erase("axes_path_length");
  }
  EXPECT_EQ(after, before);
}

/// The drives of the command that was killed are still at work.
TEST(Drive, WaitsForTheDrivesOfOneThatWasKilled) {
  const Folder folder;
  folder.write("part.ngc", part);
  Running first(folder, {"drive", "part.ngc", "--trace", "1.csv", "--state", "state", "--quiet", "--lead", "1s"});
  ASSERT_TRUE(comes_to(folder, 15));
  first.send(SIGKILL);
  first.wait();
  const auto second =
      leadscrew(folder, {"drive", "part.ngc", "--trace", "2.csv", "--resume", "state", "--quiet", "--lead", "1s"});
  EXPECT_EQ(second.status, 0) << second.errors;
  const auto one = rows_of(folder.read("1.csv")), two = rows_of(folder.read("2.csv"));
  EXPECT_EQ(two.front().s, one.back().s);
  EXPECT_LE(distance(one.back().q, two.front().q), 1e-9);
  EXPECT_EQ(state_of(folder), "ended");
}

TEST(Drive, KeepsNoStateThatAnotherKeeps) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94\nG1 X400 F1000\nM2\n");
  Running first(folder, {"drive", "part.ngc", "--state", "state", "--quiet"});
  EXPECT_TRUE(eventually([&] { return std::filesystem::exists(folder.path() / "state"); }));
  const auto second = leadscrew(folder, {"drive", "part.ngc", "--state", "state", "--json"});
  EXPECT_EQ(second.status, 3);
  EXPECT_EQ(second.json()["diagnostics"][0]["code"], "state-busy");
  first.send(SIGKILL);
  first.wait();
}

TEST(Drive, RefusesAPeriodThatNobodyCanKeep) {
  const Folder folder;
  folder.write("part.ngc", part);
  const auto outcome = leadscrew(folder, {"drive", "part.ngc", "--period", "20us", "--state", "state"});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_TRUE(contains(outcome.errors, "[period-too-short]")) << outcome.errors;
  EXPECT_EQ(folder.names(), Names{"part.ngc"});
}

TEST(Drive, RefusesStopsOfMorePeriodsThanDrivesHold) {
  const Folder folder;
  folder.write(
      "slow.toml",
      "name = \"slow\"\n[axis.X]\ntravel_mm = [-500, 500]\nmax_velocity_mm_s = 200\nmax_acceleration_mm_s2 = 0.5\n"
      "max_jerk_mm_s3 = 20000\nblu_mm = 0.001\n");
  folder.write("part.ngc", "G1 X1 F100\nM2\n");
  const auto outcome = leadscrew(folder, {"drive", "part.ngc", "--machine", "slow.toml", "--period", "50us"});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_TRUE(contains(outcome.errors, "[stop-too-long]")) << outcome.errors;
}

/// Nothing depends on a word where nothing moves.
TEST(Drive, EndsWhereNothingMoves) {
  const Folder folder;
  for (const std::string program : {"M2\n", "G21 G90 G94\nG1 X0 F100\nM2\n", "G4 P0.2\nM2\n"}) {
    folder.write("part.ngc", program);
    const auto outcome = leadscrew(folder, {"drive", "part.ngc", "--state", "state", "--json"});
    EXPECT_EQ(outcome.status, 0) << program << outcome.errors;
    EXPECT_EQ(outcome.json()["end"], "done");
    EXPECT_EQ(state_of(folder), "ended");
  }
}

TEST(Drive, RefusesToResumeAnythingElse) {
  const Folder folder;
  folder.write("part.ngc", part);
  folder.write("mill.toml", machine_text());
  folder.write("tools.tbl", "T1 P1 D6 Z10\n");
  Running first(folder, {"drive", "part.ngc", "--machine", "mill.toml", "--tools", "tools.tbl", "--state", "state"});
  ASSERT_TRUE(comes_to(folder, 5));
  first.send(SIGINT);
  EXPECT_EQ(first.wait().status, 130);
  const auto refused = [&](std::vector<std::string> arguments, const std::string& code) {
    arguments.insert(arguments.begin(), "drive");
    arguments.insert(arguments.end(), {"--resume", "state", "--json"});
    const auto outcome = leadscrew(folder, arguments);
    EXPECT_EQ(outcome.status, 3) << outcome.errors;
    EXPECT_EQ(outcome.json()["diagnostics"][0]["code"], code);
  };
  const std::vector<std::string> same = {"part.ngc", "--machine", "mill.toml", "--tools", "tools.tbl"};
  const auto with = [&](std::vector<std::string> arguments, std::vector<std::string> more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  refused({"part.ngc", "--machine", "mill.toml"}, "resume-machine");
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--start", "X1"},
                                               {"--period", "2ms"},
                                               {"--mode", "exact-stop"},
                                               {"--tolerance", "0.02"}}) {
    refused(with(same, more), "resume-machine");
  }
  folder.write("mill.toml", machine_text(1001));
  refused(same, "resume-machine");
  folder.write("mill.toml", machine_text());
  folder.write("tools.tbl", "T1 P1 D6 Z11\n");
  refused(same, "resume-machine");
  folder.write("tools.tbl", "T1 P1 D6 Z10\n");
  folder.write("part.ngc", part + "\n");
  refused(same, "resume-program");
  folder.write("state", "{}");
  refused(same, "resume-state");
}

}  // namespace test_drive
}  // namespace leadscrew::cli::testing
