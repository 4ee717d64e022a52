// The command: the same rows whoever makes them, and nothing lost and nothing twice whatever is killed.

#include <gtest/gtest.h>

#include <random>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_sweep {

/// Programs of some milliseconds each, one that has an error, and one that is not there.
class Archive {
 public:
  explicit Archive(int programs) {
    std::filesystem::create_directory(folder.path() / "archive");
    for (int k = 0; k < programs; ++k)
      folder.write("archive/p" + std::to_string(k) + ".ngc", with_feed(square, std::to_string(600 + 60 * k)));
    folder.write("archive/bad.ngc", "G21\nG1 X\nM2\n");
    tasks = 2 * (programs + 2);
  }

  std::vector<std::string> words(const std::string& out, std::vector<std::string> more = {}) const {
    std::vector<std::string> all = {"sweep",      "--programs", "archive", "none.ngc", "--tolerance",
                                    "0.001,0.01", "--out",      out,       "--json"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  Outcome run(const std::string& out, std::vector<std::string> more = {}) const {
    return leadscrew(folder, words(out, std::move(more)));
  }
  std::string rows(const std::string& out) const { return folder.read(out + "/results.jsonl"); }
  /// Whole lines of all shards.
  int lines(const std::string& out) const {
    int lines = 0;
    for (const auto& shard : std::filesystem::directory_iterator(folder.path() / out / "shards")) {
      std::ifstream file(shard.path());
      for (std::string line; std::getline(file, line);) lines += line.ends_with("}}") ? 1 : 0;
    }
    return lines;
  }

  Folder folder;
  int tasks = 0;
};

TEST(Sweep, MakesTheSameRowsOnOneProcessorTwoAndFour) {
  const Archive archive(6);
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
  const Archive archive(3);
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

/// Kills the command, or one of its processes, at random instants, and starts it again until it is done.
void kill_and_start_again(const Archive& archive, const std::string& out, int kills, unsigned seed) {
  std::mt19937 random(seed);
  for (int k = 0; k < kills; ++k) {
    Running running(archive.folder, archive.words(out, {"--processes", "2"}));
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 60'000));
    if (k % 2 == 0) {
      running.send(SIGKILL);
    } else {
      try {
        running.send_to_child(SIGKILL);
      } catch (const std::runtime_error&) {  // has none, or has ended
      }
    }
    running.wait();
  }
  const Outcome last = archive.run(out);
  EXPECT_EQ(last.status, 0) << last.errors;
  EXPECT_EQ(last.json()["rows"], archive.tasks);
  EXPECT_EQ(archive.lines(out), archive.tasks) << "a task was lost or done twice";
}

TEST(Sweep, LosesNothingAndDoesNothingTwiceWhenKilled) {
  const Archive archive(12);
  ASSERT_EQ(archive.run("whole").status, 0);
  kill_and_start_again(archive, "killed", 4, 1980);
  EXPECT_EQ(archive.rows("killed"), archive.rows("whole"));
}

TEST(LongKilledSweep, LosesNothingAndDoesNothingTwice) {
  const Archive archive(60);
  ASSERT_EQ(archive.run("whole").status, 0);
  for (unsigned round = 0; round < 5; ++round) {
    const std::string out = "killed" + std::to_string(round);
    kill_and_start_again(archive, out, 10, round);
    EXPECT_EQ(archive.rows(out), archive.rows("whole"));
  }
}

TEST(Sweep, SaysThatAProcessWasKilledAndEnds) {
  const Archive archive(40);
  Running running(archive.folder, archive.words("out", {"--processes", "2"}));
  ASSERT_TRUE(eventually([&] {
    try {
      running.send_to_child(SIGKILL);
      return true;
    } catch (const std::runtime_error&) {
      return running.has_ended();
    }
  }));
  const Outcome outcome = running.wait();
  EXPECT_EQ(outcome.status, 4);
  EXPECT_TRUE(contains(outcome.errors, "[sweep-process]")) << outcome.errors;
}

TEST(Sweep, TellsOfAFullDiskAndGoesOnWhenThereIsRoom) {
  const Archive archive(12);
  ASSERT_EQ(archive.run("whole").status, 0);
  const auto tasks = std::filesystem::file_size(archive.folder.path() / "whole/tasks.jsonl");
  const Outcome full = leadscrew(archive.folder, archive.words("full", {"--processes", "1"}), {.largest_file = tasks});
  EXPECT_EQ(full.status, 4);
  EXPECT_TRUE(contains(full.errors, "[io-write]")) << full.errors;
  const Outcome after = archive.run("full");
  EXPECT_EQ(after.status, 0) << after.errors;
  EXPECT_GT(after.json()["done_before"], 0);
  EXPECT_EQ(archive.rows("full"), archive.rows("whole"));
  EXPECT_EQ(archive.lines("full"), archive.tasks);
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
  const std::filesystem::path copy = folder.path() / "leadscrew";
  std::filesystem::copy(LEADSCREW_COMMAND, copy);
  const Outcome outcome = leadscrew(folder, {"sweep", "--random", "2", "--out", "out"},
                                    {.command = copy, .environment = {"OMPI_COMM_WORLD_SIZE=2"}});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_TRUE(contains(outcome.errors, "[sweep-mpi]")) << outcome.errors;
}

#ifdef LEADSCREW_MPIRUN
Outcome ranked(const Archive& archive, const std::string& out, const std::string& ranks) {
  std::vector<std::string> words = {"-n", ranks, "--oversubscribe", "--allow-run-as-root", LEADSCREW_COMMAND};
  const auto own = archive.words(out);
  words.insert(words.end(), own.begin(), own.end());
  return leadscrew(archive.folder, words, {.command = LEADSCREW_MPIRUN});
}

TEST(Sweep, MakesTheSameRowsUnderMpi) {
  const Archive archive(6);
  ASSERT_EQ(archive.run("alone").status, 0);
  for (const char* const ranks : {"2", "4"}) {
    const Outcome outcome = ranked(archive, ranks, ranks);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(outcome.json()["done"], archive.tasks);
    EXPECT_EQ(archive.rows(ranks), archive.rows("alone"));
    EXPECT_EQ(archive.lines(ranks), archive.tasks);
  }
}
#endif

}  // namespace test_sweep
}  // namespace leadscrew::cli::testing
