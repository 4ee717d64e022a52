// Nothing is lost and nothing done twice whatever is killed; what disturbs a sweep is told, and the rest done.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "swept_archive.hpp"

namespace leadscrew::cli::testing {
namespace test_disturbed_sweep {

void expect_whole(const SweptArchive& archive, const Outcome& last, const std::string& out) {
  EXPECT_EQ(last.status, 0) << last.errors;
  EXPECT_EQ(last.json()["rows"], archive.tasks);
  EXPECT_EQ(archive.lines(out), archive.tasks) << "a task was lost or done twice";
}

/// Waits for the instant of a kill: any of what the rest takes where `is_any`, if all takes `whole`; else when a random number of
/// the tasks that are left have been done, and up to a task's time more. So many kills are to come, this one among them.
void await_instant(const SweptArchive& archive, const std::string& out, Running& running, bool is_any,
                   std::chrono::microseconds whole, int kills, std::mt19937& random) {
  const int before = archive.lines(out), left = archive.tasks - before;
  if (is_any) {
    const auto rest = static_cast<unsigned>(whole.count() * std::max(1, left) / archive.tasks);
    std::this_thread::sleep_for(std::chrono::microseconds(random() % rest));
    return;
  }
  const auto most = static_cast<unsigned>(std::max(1, left / (kills + 1)));
  const int awaited = before + 1 + static_cast<int>(random() % most);
  ASSERT_TRUE(eventually([&] { return archive.lines(out) >= awaited || running.has_ended(); }));
  std::this_thread::sleep_for(std::chrono::microseconds(random() % 5'000));
}

/// What one start that nothing disturbs takes.
template <typename Start>
std::chrono::microseconds time_of(Start start) {
  const auto begun = std::chrono::steady_clock::now();
  EXPECT_EQ(start().status, 0);
  return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begun);
}

/// Is the work half done after a kill?
bool is_half_done(const SweptArchive& archive, const std::string& out) {
  const int lines = archive.lines(out);
  return 0 < lines && lines < archive.tasks;
}

/// Kills the command, or one of its processes, at random instants, and starts it again until it is done: every other instant
/// falls between two tasks' ends. Returns how many kills struck half-done work.
int kill_and_start_again(const SweptArchive& archive, const std::string& out, std::chrono::microseconds whole,
                         int kills, unsigned seed) {
  std::mt19937 random(seed);
  int struck = 0;
  for (int k = 0; k < kills; ++k) {
    Running running(archive.folder, archive.words(out, {"--processes", "2"}));
    await_instant(archive, out, running, k % 2 == 1, whole, kills - k, random);
    bool is_sent = !running.has_ended();
    if (k / 2 % 2 == 0) {
      running.send(SIGKILL);
    } else {
      try {
        running.send_to_child(SIGKILL);
      } catch (const std::runtime_error&) {  // has none, or has ended
        is_sent = false;
      }
    }
    running.wait();
    struck += is_sent && is_half_done(archive, out) ? 1 : 0;
  }
  expect_whole(archive, archive.run(out), out);
  return struck;
}

TEST(DisturbedSweep, LosesNothingAndDoesNothingTwiceWhenKilled) {
  const SweptArchive archive(20);
  const auto whole = time_of([&] { return archive.run("whole"); });
  EXPECT_GT(kill_and_start_again(archive, "killed", whole, 4, 1980), 0);
  EXPECT_EQ(archive.rows("killed"), archive.rows("whole"));
}

TEST(LongKilledSweep, LosesNothingAndDoesNothingTwice) {
  const SweptArchive archive(600);
  const auto whole = time_of([&] { return archive.run("whole"); });
  int struck = 0;
  for (unsigned round = 0; round < 5; ++round) {
    const std::string out = "killed" + std::to_string(round);
    struck += kill_and_start_again(archive, out, whole, 10, round);
    EXPECT_EQ(archive.rows(out), archive.rows("whole"));
  }
  EXPECT_GE(struck, 12) << "of 50 kills";
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

/// Open MPI's mpirun 4.1 may stay for ever when a rank was killed while it started, though no rank is left: it is ended then, as
/// who had started it would.
void await_launcher(Running& running, pid_t launcher) {
  eventually([&] { return running.has_ended() || children_of(launcher).empty(); });
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (!running.has_ended() && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  running.send(SIGKILL);
  running.wait();
}

/// Starts ranks, and kills mpirun with all of them, or alone, when they do what they can, or one rank. Returns whether that struck half-done work.
bool start_and_kill_ranks(const SweptArchive& archive, const std::string& ranks, const std::string& out, int kills,
                          std::chrono::microseconds whole, std::mt19937& random) {
  std::vector<std::string> words = {"-c", "echo $$ > launcher; exec \"$0\" \"$@\"", LEADSCREW_MPIRUN};
  const auto ranked = archive.ranked_words(out, ranks);
  words.insert(words.end(), ranked.begin(), ranked.end());
  archive.folder.write("launcher", "");
  Running running(archive.folder, words, {.command = "/bin/sh"});
  EXPECT_TRUE(eventually([&] { return archive.folder.read("launcher").ends_with('\n'); }));
  const auto launcher = static_cast<pid_t>(std::stol(archive.folder.read("launcher")));
  await_instant(archive, out, running, kills % 2 == 1, whole, kills, random);
  const auto children = children_of(launcher);
  bool is_sent = !running.has_ended() && !children.empty();
  if (kills % 3 == 1) {
    is_sent = is_sent && ::kill(children[random() % children.size()], SIGKILL) == 0;
  } else {
    running.send(SIGKILL);
    if (kills % 3 == 2) {
      for (const pid_t child : children) ::kill(child, SIGKILL);
    }
  }
  await_launcher(running, launcher);
  return is_sent && is_half_done(archive, out);
}

/// Kills mpirun, all ranks, or one of them, at random instants, and starts them again until all is done: every other instant falls
/// between two tasks' ends. Returns how many kills struck half-done work.
int kill_ranks_and_start_again(const SweptArchive& archive, const std::string& ranks, const std::string& out,
                               std::chrono::microseconds whole, int kills, unsigned seed) {
  std::mt19937 random(seed);
  int struck = 0;
  for (int left = kills; left > 0; --left)
    struck += start_and_kill_ranks(archive, ranks, out, left, whole, random) ? 1 : 0;
  expect_whole(archive, archive.ranked(out, ranks), out);
  return struck;
}

TEST(DisturbedSweep, TellsOfAProgramThatChangesMeanwhileAndDoesTheRestOnRanks) {
  const SweptArchive archive(60);
  Running running(archive.folder, archive.ranked_words("out", "2"), {.command = LEADSCREW_MPIRUN});
  change_the_last(archive, running);
}

TEST(DisturbedSweep, LosesNothingAndDoesNothingTwiceWhenRanksAreKilled) {
  const SweptArchive archive(40);
  const auto whole = time_of([&] { return archive.ranked("whole", "2"); });
  EXPECT_GT(kill_ranks_and_start_again(archive, "2", "killed", whole, 4, 1980), 0);
  EXPECT_EQ(archive.rows("killed"), archive.rows("whole"));
}

/// The second rank may write no file of more than a few lines; the first has room. They talk over the network, as those of two
/// computers do: memory that they share would be a file as well.
TEST(DisturbedSweep, TellsOfAFullDiskOfARankAndDoesTheRest) {
  const SweptArchive archive(40);
  ASSERT_EQ(archive.run("whole").status, 0);
  const auto own = archive.ranked_words("full", "1");
  std::vector<std::string> words = {"--mca", "btl", "tcp,self", "--mca", "osc", "pt2pt"};
  words.insert(words.end(), own.begin(), own.end());
  words.insert(words.end(), {":", "-n", "1", "/bin/sh", "-c", "ulimit -f 4; exec \"$0\" \"$@\""});
  words.insert(words.end(), std::ranges::find(own, Surroundings().command), own.end());
  const Outcome full = leadscrew(archive.folder, words, {.command = LEADSCREW_MPIRUN});
  EXPECT_EQ(full.status, 4) << full.errors;
  EXPECT_TRUE(contains(full.errors, "[io-write]")) << full.errors;
  EXPECT_EQ(full.json()["failed"], 1);
  EXPECT_EQ(full.json()["done"], archive.tasks - 1);
  const Outcome after = archive.ranked("full", "2");
  EXPECT_EQ(after.json()["done"], 1);
  expect_whole(archive, after, "full");
  EXPECT_EQ(archive.rows("full"), archive.rows("whole"));
}

/// A file system of so many bytes that only part of the lines fit, then a larger one, in a name space of its own.
TEST(DisturbedSweep, GoesOnUnderMpiWhenAFullDiskHasRoomAgain) {
  const SweptArchive archive(40);
  const auto in_own_space = [&](const std::string& script, const std::vector<std::string>& more) {
    std::vector<std::string> words = {"-rm", "/bin/sh", "-c", script};
    words.insert(words.end(), more.begin(), more.end());
    return leadscrew(archive.folder, words, {.command = "/usr/bin/unshare"});
  };
  std::filesystem::create_directory(archive.folder.path() / "small");
  if (in_own_space("mount -t tmpfs -o size=64k none small", {}).status != 0)
    GTEST_SKIP() << "this computer's users may not mount";
  ASSERT_EQ(archive.run("whole").status, 0);
  std::vector<std::string> words = archive.ranked_words("small/out", "2");
  words.insert(words.begin(), LEADSCREW_MPIRUN);
  const Outcome both = in_own_space(
      "mount -t tmpfs -o size=64k none small; \"$0\" \"$@\" > full.json; echo $? > full.status; "
      "mount -o remount,size=16m small; \"$0\" \"$@\"; status=$?; cp -r small/out kept; exit $status",
      words);
  EXPECT_EQ(archive.folder.read("full.status"), "4\n");
  EXPECT_TRUE(contains(both.errors, "[io-write]")) << both.errors;
  EXPECT_GT(both.json()["done_before"], 0);
  EXPECT_GT(both.json()["done"], 0);
  expect_whole(archive, both, "kept");
  EXPECT_EQ(archive.rows("kept"), archive.rows("whole"));
}

TEST(LongKilledRanks, LoseNothingAndDoNothingTwice) {
  const SweptArchive archive(600);
  const auto whole = time_of([&] { return archive.ranked("whole", "2"); });
  int struck = 0;
  for (unsigned round = 0; round < 10; ++round) {
    const std::string out = "killed" + std::to_string(round);
    struck += kill_ranks_and_start_again(archive, round % 2 == 0 ? "2" : "4", out, whole, 5, round);
    EXPECT_EQ(archive.rows(out), archive.rows("whole"));
  }
  EXPECT_GE(struck, 12) << "of 50 kills";
}
#endif

}  // namespace test_disturbed_sweep
}  // namespace leadscrew::cli::testing
