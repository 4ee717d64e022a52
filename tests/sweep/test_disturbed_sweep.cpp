// Nothing is lost and nothing done twice whatever is killed; what disturbs a sweep is told, and the rest done.

#include <gtest/gtest.h>

#include <random>

#include "swept_archive.hpp"

namespace leadscrew::cli::testing {
namespace test_disturbed_sweep {

void expect_whole(const SweptArchive& archive, const Outcome& last, const std::string& out) {
  EXPECT_EQ(last.status, 0) << last.errors;
  EXPECT_EQ(last.json()["rows"], archive.tasks);
  EXPECT_EQ(archive.lines(out), archive.tasks) << "a task was lost or done twice";
}

/// Kills the command, or one of its processes, at random instants, and starts it again until it is done.
void kill_and_start_again(const SweptArchive& archive, const std::string& out, int kills, unsigned seed) {
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
  expect_whole(archive, archive.run(out), out);
}

TEST(DisturbedSweep, LosesNothingAndDoesNothingTwiceWhenKilled) {
  const SweptArchive archive(12);
  ASSERT_EQ(archive.run("whole").status, 0);
  kill_and_start_again(archive, "killed", 4, 1980);
  EXPECT_EQ(archive.rows("killed"), archive.rows("whole"));
}

TEST(LongKilledSweep, LosesNothingAndDoesNothingTwice) {
  const SweptArchive archive(60);
  ASSERT_EQ(archive.run("whole").status, 0);
  for (unsigned round = 0; round < 5; ++round) {
    const std::string out = "killed" + std::to_string(round);
    kill_and_start_again(archive, out, 10, round);
    EXPECT_EQ(archive.rows(out), archive.rows("whole"));
  }
}

TEST(DisturbedSweep, SaysThatAProcessWasKilledAndEnds) {
  const SweptArchive archive(40);
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

TEST(DisturbedSweep, TellsOfAFullDiskAndGoesOnWhenThereIsRoom) {
  const SweptArchive archive(12);
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

/// The fastest program is the last, and changes while the others are done.
void change_the_last(const SweptArchive& archive, Running& running) {
  ASSERT_TRUE(eventually([&] { return archive.lines("out") > 0; }));
  archive.folder.write("archive/p59.ngc", with_feed(square, "4000"));
  const Outcome changed = running.wait();
  EXPECT_EQ(changed.status, 4);
  EXPECT_TRUE(contains(changed.errors, "[program-changed]")) << changed.errors;
  EXPECT_EQ(changed.json()["failed"], 2);
  EXPECT_EQ(changed.json()["done"], archive.tasks - 2);
  const Outcome after = archive.run("out");
  EXPECT_EQ(after.json()["done"], 2);
  expect_whole(archive, after, "out");
}

TEST(DisturbedSweep, TellsOfAProgramThatChangesMeanwhileAndDoesTheRest) {
  const SweptArchive archive(60);
  Running running(archive.folder, archive.words("out", {"--processes", "1"}));
  change_the_last(archive, running);
}

#ifdef LEADSCREW_MPIRUN
/// The processes that one has started.
std::vector<pid_t> children_of(pid_t process) {
  const std::string number = std::to_string(process);
  std::ifstream file("/proc/" + number + "/task/" + number + "/children");
  std::vector<pid_t> children;
  for (pid_t child = 0; file >> child;) children.push_back(child);
  return children;
}

/// Kills mpirun, or one of its ranks, at random instants of their time, and starts them again until all is done.
void kill_ranks_and_start_again(const SweptArchive& archive, const std::string& ranks, const std::string& out,
                                int kills, unsigned seed) {
  std::mt19937 random(seed);
  for (int k = 0; k < kills; ++k) {
    std::vector<std::string> words = {"-c", "echo $$ > launcher; exec \"$0\" \"$@\"", LEADSCREW_MPIRUN};
    const auto ranked = archive.ranked_words(out, ranks);
    words.insert(words.end(), ranked.begin(), ranked.end());
    Running running(archive.folder, words, {.command = "/bin/sh"});
    std::this_thread::sleep_for(std::chrono::milliseconds(200 + random() % 800));
    if (k % 2 == 0) {
      running.send(SIGKILL);
    } else {
      const auto children = children_of(static_cast<pid_t>(std::stol("0" + archive.folder.read("launcher"))));
      if (!children.empty()) ::kill(children[random() % children.size()], SIGKILL);
    }
    running.wait();
  }
  expect_whole(archive, archive.ranked(out, ranks), out);
}

TEST(DisturbedSweep, TellsOfAProgramThatChangesMeanwhileAndDoesTheRestOnRanks) {
  const SweptArchive archive(60);
  Running running(archive.folder, archive.ranked_words("out", "2"), {.command = LEADSCREW_MPIRUN});
  change_the_last(archive, running);
}

TEST(DisturbedSweep, LosesNothingAndDoesNothingTwiceWhenRanksAreKilled) {
  const SweptArchive archive(40);
  ASSERT_EQ(archive.run("whole").status, 0);
  kill_ranks_and_start_again(archive, "2", "killed", 3, 1980);
  EXPECT_EQ(archive.rows("killed"), archive.rows("whole"));
}

TEST(LongKilledRanks, LoseNothingAndDoNothingTwice) {
  const SweptArchive archive(200);
  ASSERT_EQ(archive.run("whole").status, 0);
  for (unsigned round = 0; round < 10; ++round) {
    const std::string out = "killed" + std::to_string(round);
    kill_ranks_and_start_again(archive, round % 2 == 0 ? "2" : "4", out, 5, round);
    EXPECT_EQ(archive.rows(out), archive.rows("whole"));
  }
}
#endif

}  // namespace test_disturbed_sweep
}  // namespace leadscrew::cli::testing
