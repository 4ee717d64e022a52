// The command: the same rows whoever makes them.

#include <gtest/gtest.h>

#include <algorithm>

#include "swept_archive.hpp"

namespace leadscrew::cli::testing {
namespace test_sweep {

TEST(Sweep, MakesTheSameRowsOnOneProcessorTwoAndFour) {
  const SweptArchive archive(6);
  for (const char* const count : {"1", "2", "4"}) {
    const Outcome outcome = archive.run(count, {"--processes", count});
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    const Json summary = outcome.json();
    EXPECT_EQ(summary["done"], archive.tasks);
    EXPECT_EQ(summary["kept"], 12);
    EXPECT_EQ(summary["rejected"], 2);
    EXPECT_EQ(summary["unreadable"], 2);
    EXPECT_EQ(archive.rows(count), archive.rows("1"));
    EXPECT_EQ(archive.folder.read(std::string(count) + "/results.npy"), archive.folder.read("1/results.npy"));
  }
}

TEST(Sweep, DoesOnlyWhatIsNotDone) {
  const SweptArchive archive(3);
  ASSERT_EQ(archive.run("out").status, 0);
  const std::string rows = archive.rows("out");
  const Json again = archive.run("out").json();
  EXPECT_EQ(again["done"], 0);
  EXPECT_EQ(again["done_before"], archive.tasks);
  EXPECT_EQ(archive.rows("out"), rows);
  archive.folder.write("archive/p1.ngc", with_feed(square, "500"));
  EXPECT_EQ(archive.run("out").json()["done"], 2);
  EXPECT_NE(archive.rows("out"), rows);
  const Json merged = leadscrew(archive.folder, {"sweep", "--merge", "--out", "out", "--json"}).json();
  EXPECT_EQ(merged["rows"], archive.tasks);
}

TEST(Sweep, SaysWhichProgramsWereRefusedAndWhy) {
  const SweptArchive archive(1);
  const Outcome outcome =
      leadscrew(archive.folder, {"sweep", "--programs", "archive", "none.ngc", "--jerk", "1,2", "--out", "out"});
  EXPECT_TRUE(contains(outcome.output, "refused     archive/bad.ngc:2: ")) << outcome.output;
  EXPECT_TRUE(contains(outcome.output, "refused     none.ngc: cannot open")) << outcome.output;
  EXPECT_EQ(outcome.output.find("bad.ngc"), outcome.output.rfind("bad.ngc")) << "told once a value";
  for (int k = 0; k < 5; ++k) archive.folder.write("archive/worse" + std::to_string(k) + ".ngc", "G1 X\n");
  const Outcome more = leadscrew(archive.folder, {"sweep", "--programs", "archive", "none.ngc", "--out", "out"});
  EXPECT_TRUE(contains(more.output, "            and 2 more: results.html")) << more.output;
}

/// A build of the same version: of other bytes.
TEST(Sweep, TellsHowManyRowsAnotherBuildMade) {
  const SweptArchive archive(3);
  EXPECT_FALSE(archive.run("out").json().contains("other_builds"));
  const Surroundings other = without_page(archive.folder);
  std::ofstream(other.command, std::ios::app) << "other";
  const auto of_other = [&] { return leadscrew(archive.folder, archive.words("out"), other).json(); };
  Json told = of_other();
  EXPECT_EQ(told["done"], 0);
  ASSERT_EQ(told["other_builds"].size(), 1);
  EXPECT_EQ(told["other_builds"][0]["rows"], archive.tasks);
  EXPECT_TRUE(told["other_builds"][0]["build"].get<std::string>().starts_with("0.")) << told;
  EXPECT_TRUE(contains(archive.folder.read("out/results.html"), "rows by 0."));
  archive.folder.write("archive/p1.ngc", with_feed(square, "500"));
  EXPECT_EQ(of_other()["other_builds"][0]["rows"], archive.tasks - 2);
  const Outcome text = leadscrew(archive.folder, {"sweep", "--merge", "--out", "out"});
  EXPECT_TRUE(contains(text.output, "builds      2 rows by 0.")) << text.output;
  std::filesystem::remove_all(archive.folder.path() / "out/shards");
  told = of_other();
  EXPECT_EQ(told["done"], archive.tasks);
  EXPECT_FALSE(told.contains("other_builds")) << told;
}

TEST(Sweep, SaysWhatIsWrongWithItsWords) {
  const Folder folder;
  EXPECT_EQ(leadscrew(folder, {"sweep", "--out", "out"}).status, 2);
  EXPECT_EQ(leadscrew(folder, {"sweep", "--programs", "a.ngc"}).status, 2);
  EXPECT_EQ(leadscrew(folder, {"sweep", "--programs", "a.ngc", "--out", "o", "--override", "0.5,3"}).status, 2);
  const Outcome nothing = leadscrew(folder, {"sweep", "--merge", "--out", "out"});
  EXPECT_EQ(nothing.status, 3);
  EXPECT_TRUE(contains(nothing.errors, "[sweep-tasks]")) << nothing.errors;
  std::filesystem::create_directory(folder.path() / "empty");
  const Outcome none = leadscrew(folder, {"sweep", "--programs", "empty", "--out", "out"});
  EXPECT_EQ(none.status, 3);
  EXPECT_TRUE(contains(none.errors, "[no-programs]")) << none.errors;
}

TEST(Sweep, SaysThatThereIsNoMpiWhereSeveralProcessesWereStarted) {
  const Folder folder;
  Surroundings alone = without_page(folder);
  alone.environment = {"OMPI_COMM_WORLD_SIZE=2"};
  const Outcome outcome = leadscrew(folder, {"sweep", "--random", "2", "--out", "out"}, alone);
  EXPECT_EQ(outcome.status, 3);
  EXPECT_TRUE(contains(outcome.errors, "[sweep-mpi]")) << outcome.errors;
}

#ifdef LEADSCREW_MPIRUN
TEST(Sweep, MakesTheSameRowsUnderMpi) {
  const SweptArchive archive(6);
  ASSERT_EQ(archive.run("alone").status, 0);
  for (const char* const ranks : {"2", "4"}) {
    const Outcome outcome = archive.ranked(ranks, ranks);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(outcome.json()["done"], archive.tasks);
    EXPECT_EQ(archive.rows(ranks), archive.rows("alone"));
    EXPECT_EQ(archive.lines(ranks), archive.tasks);
  }
}

/// Of the time from the first task of a shard to its last the share that is between two tasks; the largest of all shards.
double longest_waiting(const Folder& folder, const std::string& out) {
  double longest = 0;
  for (const auto& tasks : spent_of(folder, out)) {
    double working = 0;
    for (const SpentTime& task : tasks) working += task.end - task.begin;
    longest = std::max(longest, 1 - working / (tasks.back().end - tasks.front().begin));
  }
  return longest;
}

TEST(Sweep, ClaimsOverANetworkDoNotWaitForTheFirstRanksTasks) {
  const Folder folder;
  std::vector<std::string> words = {"--out", "out", "--quiet"};
  add_long_programs(folder, 12, words);
  const Outcome outcome = ranked_sweep(folder, "2", words, {"--mca", "btl", "tcp,self", "--mca", "osc", "pt2pt"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_LT(longest_waiting(folder, "out"), 0.1);
}
#endif

}  // namespace test_sweep
}  // namespace leadscrew::cli::testing
