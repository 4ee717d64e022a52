// Threads that follow a simulated spindle, on time: the words of run, and motion that is stopped or killed inside them.

#include <gtest/gtest.h>

#include <algorithm>

#include "driven.hpp"

namespace leadscrew::cli::testing {
namespace test_drive_threads {

/// The spindle turns on, the other way, faster and not at all between lines, events lie between slices, and a pause behind a thread.
const std::string threads =
    "G21 G90 G94 G18 F3000\nM3 S600\nG0 X5 Z2\nG33 Z-30 K1.5\nM0\nG0 X8\nG0 Z2\nX5.5\nS900\nG33 Z-10 K1\nG33 X6 Z-20 "
    "K1.5\nG0 X9\nZ2\nX5\nM5\nG4 P0.1\nM4 S450\nG76 P2 Z-15 I-1 J0.3 K0.9 R1 Q29.5 E2 L3\nG1 X7 Z0\nS300\nG1 X0\nM2\n";

TEST(DriveThreads, AreThoseOfRunBitForBit) {
  const Folder folder;
  folder.write("part.ngc", threads);
  folder.write("lathe.toml", machine_with_spindle());
  const Outcome driven = drive_without_a_tail(
      folder, {"--machine", "lathe.toml", "--events", "driven.csv", "--trace", "driven-words.csv"});
  const Outcome run = leadscrew(folder, {"run", "part.ngc", "--machine", "lathe.toml", "--events", "run.csv", "--trace",
                                         "run-words.csv", "--json"});
  EXPECT_EQ(run.status, 0) << run.errors;
  const Json figures = run.json()["threads"];
  EXPECT_GT(figures["lines"], 3);
  EXPECT_GT(figures["run_in_mm"], 0);
  EXPECT_LT(figures["run_in_mm"], 10);
  EXPECT_EQ(driven.json()["threads"], figures);
  EXPECT_EQ(folder.read("driven.csv"), folder.read("run.csv"));
  EXPECT_EQ(folder.read("driven-words.csv"), folder.read("run-words.csv"));
  EXPECT_EQ(leadscrew(folder, {"verify", "run-words.csv", "part.ngc", "--machine", "lathe.toml"}).status, 0);
  // Another spindle is followed otherwise.
  std::string other = machine_with_spindle();
  other.replace(other.find("seed = 7"), 8, "seed = 8");
  folder.write("other.toml", other);
  leadscrew(folder, {"run", "part.ngc", "--machine", "other.toml", "--trace", "other-words.csv"});
  EXPECT_NE(folder.read("other-words.csv"), folder.read("run-words.csv"));
}

/// Feed per revolution, along lines and curves, while S changes, beside feed per minute and a thread: by the spindle's speed as
/// the words come, so that they are not those of run where it changes, but keep every limit as these do.
TEST(DriveThreads, FeedPerRevolutionGoesWithTheSpindle) {
  const Folder folder;
  folder.write(
      "part.ngc",
      "G21 G90 G94 G17 F1200\nM3 S600\nG95 F2\nG1 X8\nG64 P0.05\nG1 X12 Y4\nX8 Y8 S900\nG2 X0 Y8 I-4 J0\nG0 X5\n"
      "G94 G1 X10 F3000\nG18 G33 Z-10 K1\nG0 X15\nG0 Z0\nG95 F2\nM4 S300\nG1 X10\nM5\nM2\n");
  folder.write("lathe.toml", machine_with_spindle());
  const Outcome driven = leadscrew(folder, {"drive", "part.ngc", "--machine", "lathe.toml", "--events", "driven.csv",
                                            "--trace", "driven-words.csv"});
  EXPECT_EQ(driven.status, 0) << driven.errors;
  EXPECT_FALSE(contains(folder.read("driven.csv"), "G95"));
  EXPECT_EQ(leadscrew(folder, {"verify", "driven-words.csv", "part.ngc", "--machine", "lathe.toml"}).status, 0);
}

/// Words are made half a second ahead, and the wait for an input begins behind the last of the thread: motion stands there for all
/// of Q, and nothing of the path is lost.
TEST(DriveThreads, AreCutWholeBeforeAnInputIsWaitedFor) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94 F3000\nM3 S600\nG0 Z2\nG33 Z-40 K1\nM66 P0 L3 Q1.5\nG1 X6\nM2\n");
  folder.write("lathe.toml", machine_with_spindle());
  drive_without_a_tail(folder, {"--machine", "lathe.toml", "--trace", "driven.csv"}, "500ms");
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--machine", "lathe.toml", "--trace", "run.csv"}).status, 0);
  const Stand stand = longest_stand(rows_in(folder, "driven.csv"));
  EXPECT_EQ(stand.z, -40);
  EXPECT_GE(stand.seconds, 1.5);
  EXPECT_TRUE(untimed(folder.read("driven.csv")) == untimed(folder.read("run.csv")));
}

/// Motion leaves the thread within limits, and goes on there.
TEST(DriveThreads, ComeToRestWhereTheyAreStoppedAndGoOn) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 F3000\nM3 S300\nG0 Z2\nG33 Z-60 K2\nG0 X8\nZ2\nM2\n");
  folder.write("lathe.toml", machine_with_spindle());
  Running first(folder,
                {"drive", "part.ngc", "--machine", "lathe.toml", "--trace", "1.csv", "--state", "state", "--json"});
  ASSERT_TRUE(comes_to(folder, 20));
  first.send(SIGTERM);
  EXPECT_EQ(first.wait().status, 130);
  const auto one = rows_in(folder, "1.csv");
  ASSERT_FALSE(one.empty());
  EXPECT_LT(one.back().s, 50);
  EXPECT_LE(worst_ratio(one), 1.001);
  const auto second = leadscrew(folder, {"drive", "part.ngc", "--machine", "lathe.toml", "--trace", "2.csv", "--resume",
                                         "state", "--lead", "1s"});
  EXPECT_EQ(second.status, 0) << second.errors;
  const auto two = rows_in(folder, "2.csv");
  ASSERT_FALSE(two.empty());
  EXPECT_LE(distance(one.back().q, two.front().q), 1e-9);
  EXPECT_LE(worst_ratio(two), 1.001);
  EXPECT_EQ(two.back().q, (std::vector<double>{8, 0, 2}));
}

/// Feed per revolution rests where it begins and ends, and so the path that is gone on along does.
TEST(DriveThreads, GoOnBehindFeedPerRevolution) {
  const Folder folder;
  folder.write("part.ngc", "G18 G21 G90\nS600 M3\nG64 P0.05\nG0 X10\nG95 F0.3\nG1 Z-4\nX20\nM2\n");
  folder.write("lathe.toml", machine_with_spindle());
  Running first(folder, {"drive", "part.ngc", "--machine", "lathe.toml", "--state", "state", "--quiet"});
  ASSERT_TRUE(comes_to(folder, 12));
  first.send(SIGTERM);
  EXPECT_EQ(first.wait().status, 130);
  const auto second = leadscrew(folder, {"drive", "part.ngc", "--machine", "lathe.toml", "--resume", "state"});
  EXPECT_EQ(second.status, 0) << second.errors;
}

/// A tap that was left is not followed any more: the tool does not stand at its bottom while the spindle turns.
TEST(DriveThreads, TellThatATapIsNotGoneOnWith) {
  const Folder folder;
  folder.write("part.ngc", "G17 G21 G90\nS600 M3\nG0 X5 Y5 Z5\nG84 X10 Y5 Z-20 R2 F600\nX20\nG80\nM2\n");
  folder.write("mill.toml", machine_with_spindle());
  Running first(folder, {"drive", "part.ngc", "--machine", "mill.toml", "--state", "state", "--quiet"});
  ASSERT_TRUE(comes_to(folder, 30));
  first.send(SIGTERM);
  EXPECT_EQ(first.wait().status, 130);
  const auto second = leadscrew(folder, {"drive", "part.ngc", "--machine", "mill.toml", "--resume", "state", "--trace",
                                         "words.csv", "--lead", "1s", "--json"});
  EXPECT_EQ(second.status, 0) << second.errors;
  EXPECT_TRUE(contains(second.errors, "[resume-out-of-step]")) << second.errors;
  EXPECT_EQ(second.json()["threads"]["lines"], 2);  // of the second hole
  EXPECT_EQ(second.json()["threads"]["out_of_step"], 0);
}

}  // namespace test_drive_threads
}  // namespace leadscrew::cli::testing
