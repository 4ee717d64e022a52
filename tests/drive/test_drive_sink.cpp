// A file or a pipe in the place of drives.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "driven.hpp"

namespace leadscrew::cli::testing {
namespace test_drive_sink {

TEST(DriveSink, GetsTheWordsOfRunBitForBit) {
  const Folder folder;
  folder.write("part.ngc", part);
  const auto driven = drive_without_a_tail(folder, {"--sink", "words.csv", "--state", "state"});
  const Json json = driven.json();
  EXPECT_FALSE(json.contains("drives"));
  EXPECT_EQ(json["words"], json["words_taken"]);
  EXPECT_EQ(state_of(folder), "ended");
  const auto run = leadscrew(folder, {"run", "part.ngc", "--trace", "run.csv", "--json"});
  EXPECT_EQ(folder.read("words.csv"), folder.read("run.csv"));
  EXPECT_EQ(leadscrew(folder, {"verify", "words.csv", "part.ngc"}).status, 0);
  std::uint64_t late = 0;
  for (const Json& octave : json["latency_ns"]["histogram"]) late += octave["count"].get<std::uint64_t>();
  EXPECT_GT(late, 0U);
  EXPECT_LE(late, json["words"].get<std::uint64_t>() + 1);
}

/// What has reached the file is the last word that counts.
TEST(DriveSink, KeepsWhatReachedItWhenTheCommandIsKilledAndGoesOn) {
  const Folder folder;
  folder.write("part.ngc", part);
  leadscrew(folder, {"run", "part.ngc", "--trace", "run.csv"});
  Running first(folder, {"drive", "part.ngc", "--sink", "1.csv", "--state", "state", "--quiet"});
  ASSERT_TRUE(comes_to(folder, 15));
  first.send(SIGKILL);
  first.wait();
  const auto second = leadscrew(folder, {"drive", "part.ngc", "--sink", "2.csv", "--resume", "state", "--quiet"});
  EXPECT_EQ(second.status, 0) << second.errors;
  EXPECT_EQ(state_of(folder), "ended");
  const auto path = rows_of(folder.read("run.csv")), one = rows_of(folder.read("1.csv")),
             two = rows_of(folder.read("2.csv"));
  ASSERT_FALSE(one.empty());
  EXPECT_GE(one.back().s, 15);
  EXPECT_EQ(two.front().s, one.back().s);
  EXPECT_LE(distance(two.front().q, one.back().q), 1e-9);
  EXPECT_LE(worst_ratio(two), 1.001);
  EXPECT_LE(distance(two.back().q, path.back().q), 1e-9);
}

/// A word is accepted when its row is in the file: not before, not after a row that was begun.
TEST(DriveSink, EndsMotionWhereNothingCanBeWritten) {
  const Folder folder;
  folder.write("part.ngc", part);
  const auto none = leadscrew(folder, {"drive", "part.ngc", "--sink", "/dev/full", "--state", "none", "--quiet"});
  EXPECT_EQ(none.status, 4);
  EXPECT_TRUE(contains(none.errors, "[io-write]")) << none.errors;
  EXPECT_EQ(Json::parse(folder.read("none"))["path_length"], 0);
  const auto some = leadscrew(folder, {"drive", "part.ngc", "--sink", "1.csv", "--state", "state", "--quiet"},
                              {.largest_file = 60'000});
  EXPECT_EQ(some.status, 4);
  EXPECT_EQ(state_of(folder), "stopped");
  const std::string text = folder.read("1.csv");
  EXPECT_EQ(text.back(), '\n');
  const auto one = rows_of(text);
  ASSERT_GT(one.size(), 100U);
  EXPECT_EQ(one.back().s, Json::parse(folder.read("state"))["path_length"].get<double>());
  const auto again = leadscrew(folder, {"drive", "part.ngc", "--sink", "1.csv", "--resume", "state", "--quiet"});
  EXPECT_EQ(again.status, 2);
  EXPECT_TRUE(contains(again.errors, "holds words already")) << again.errors;
  EXPECT_EQ(folder.read("1.csv"), text);
  EXPECT_EQ(leadscrew(folder, {"drive", "part.ngc", "--sink", "2.csv", "--resume", "state", "--quiet"}).status, 0);
  const auto two = rows_of(folder.read("2.csv"));
  EXPECT_EQ(two.front().s, one.back().s);
  EXPECT_LE(distance(two.front().q, one.back().q), 1e-9);
}

TEST(DriveSink, KeepsWhatReachedItWhenItIsKilledItself) {
  const Folder folder;
  folder.write("part.ngc", part);
  Running first(folder, {"drive", "part.ngc", "--sink", "1.csv", "--state", "state", "--quiet"});
  ASSERT_TRUE(comes_to(folder, 15));
  first.send_to_child(SIGKILL);
  EXPECT_EQ(first.wait().status, 4);
  const double known = Json::parse(folder.read("state"))["path_length"].get<double>();
  EXPECT_GE(rows_of(folder.read("1.csv")).back().s, known);
  EXPECT_GE(known, 15);
  EXPECT_EQ(folder.names(), (Names{"part.ngc", "1.csv", "state"}));
}

/// A pipe holds motion back while it is full; a signal is obeyed whether or not somebody reads.
TEST(DriveSink, WaitsForTheReaderOfAPipe) {
  const Folder folder;
  folder.write("part.ngc", part);
  const std::string pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  Running unread(folder, {"drive", "part.ngc", "--sink", "pipe", "--quiet"});
  ASSERT_TRUE(eventually([&] { return unread.handles(SIGINT); }));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  unread.send(SIGINT);
  EXPECT_EQ(unread.wait().status, 130);
  {
    // Somebody has opened it, and reads nothing.
    folder.write("long.ngc", "G21 G90 G94\nG1 X400 F600\nM2\n");
    Running stalled(folder, {"drive", "long.ngc", "--sink", "pipe", "--state", "state", "--quiet"});
    const std::ifstream idle(pipe);
    ASSERT_TRUE(comes_to(folder, 5));
    stalled.send(SIGTERM);
    EXPECT_EQ(stalled.wait().status, 130);
    EXPECT_EQ(state_of(folder), "stopped");
  }

  leadscrew(folder, {"run", "part.ngc", "--trace", "run.csv"});
  Running read(folder, {"drive", "part.ngc", "--sink", "pipe", "--json", "--look-ahead", "60s"});
  std::ifstream words(pipe);
  std::this_thread::sleep_for(std::chrono::seconds(3));
  const std::string text{std::istreambuf_iterator<char>(words), {}};
  const auto outcome = read.wait();
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(text, folder.read("run.csv"));
}

TEST(DriveSink, LeavesStandardOutputToTheWords) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94\nG1 X1 F3000\nM2\n");
  const auto words = leadscrew(folder, {"drive", "part.ngc", "--sink", "/dev/stdout", "--quiet"});
  EXPECT_EQ(words.status, 0) << words.errors;
  EXPECT_TRUE(words.output.starts_with("t,line,s,feed,X,Y,Z\n0,")) << words.output;
  EXPECT_EQ(rows_of(words.output).back().q[0], 1);
  EXPECT_EQ(leadscrew(folder, {"drive", "part.ngc", "--sink", "/dev/stdout"}).status, 2);
  EXPECT_EQ(leadscrew(folder, {"drive", "part.ngc", "--sink", "/dev/stdout", "--json", "--quiet"}).status, 2);
}

TEST(DriveSink, HasNoDrivesWhoseTraceCouldBeWritten) {
  const Folder folder;
  folder.write("part.ngc", part);
  const auto outcome = leadscrew(folder, {"drive", "part.ngc", "--sink", "words.csv", "--axes", "axes.csv"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_TRUE(contains(outcome.errors, "--axes is of simulated drives")) << outcome.errors;
  for (const std::string name : {"words.txt", "words", "-"})
    EXPECT_EQ(leadscrew(folder, {"drive", "part.ngc", "--sink", name}).status, 2) << name;
  EXPECT_EQ(folder.names(), Names{"part.ngc"});
}

}  // namespace test_drive_sink
}  // namespace leadscrew::cli::testing
