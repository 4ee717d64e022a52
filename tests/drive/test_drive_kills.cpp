// The command on time, killed at any instant and taken up again.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "driven.hpp"

namespace leadscrew::cli::testing {
namespace test_drive_kills {

/// What is killed again and again.
struct Victim {
  std::string program, period;
  double T = 0;              ///< s
  double longest_stop = 0;   ///< mm
  std::string machine = {};  ///< the built-in one where it is empty
};

/// Along a line a stop from 50 mm/s takes 2.5 mm. Some 20 ms of the part have none that begins soon.
const Victim arcs_and_corners = {part, "1ms", 1e-3, 15};

/// Some three seconds of short lines along a wave, as one smooth path.
Victim short_lines() {
  std::ostringstream program;
  program << "G21 G90 G94 F3000\nG64 P0.02\n";
  for (int k = 1; k <= 1200; ++k) program << "G1 X" << 0.1 * k << " Y" << 4 * std::sin(k / 50.0) << "\n";
  program << "M2\n";
  return {program.str(), "250us", 250e-6, 15};
}

/// Moves that the reader makes: beside a contour, in cycles, of a shaft that is roughed, in loops, and up to a probe. A stop from
/// rapids of 200 mm/s takes v (v/a + a/j) / 2 = 25 mm, and 20 ms before it begins 4 mm more.
const Victim generated = {
    "G21 G90 G94 G17 F3000\nG64 P0.02\nG0 X10 Y-12\nG42.1 D4\nG1 X10 Y-8\nX18\nG3 X20 Y-6 J2\nG1 "
    "Y8\nX0\nY-8\nX10\nG40\n"
    "G1 Y-16\nG0 Z5\nG98 G83 X5 Y5 Z-6 R1 Q2.5\nG91 X4 L2\nG90 G82 X-5 Z-2 R1 P0.05\nG80\nO100 sub\nG1 X4 Z0\nZ-6\nX7 "
    "Z-9\n"
    "O100 endsub\nG18\nG0 X9 Z2\nG71 Q100 I3 R0.5\nG70 Q100\nG17\no200 repeat [2]\nG91 G1 X2 Y3\nG2 X3 I1.5\nG90\n"
    "o200 endrepeat\nG0 Z4\nG38.3 Z-7\nG1 X[#5063*2] Y0\nG61\nG1 Z0\nM2\n",
    "1ms", 1e-3, 30};

/// Threads and taps that follow a spindle, and the rapids between them.
const Victim threads = {
    "G21 G90 G18 F3000\nM3 S400\nG0 X5 Z2\nG33 Z-20 K2\nG33 X7 Z-30 K1\nG0 X9\nZ2\nX5\nG76 P2 Z-15 I-1 J0.5 K0.9 R1 "
    "Q29.5 E2 L3\nG33.1 Z-12 K1.5\nG17 G84 X7 Z-10 R2 P0.1 F400\nG80\nG1 X0 Z0\nM2\n",
    "1ms", 1e-3, 30, machine_with_spindle()};

/// Drives a program, killed again and again, until it has come to its end; returns how often it was killed.
int drive_through_kills(const Victim& victim, unsigned seed) {
  const Folder folder;
  folder.write("part.ngc", victim.program);
  std::vector<std::string> run = {"run", "part.ngc", "--trace", "run.csv", "--period", victim.period};
  const std::vector<std::string> on_machine = {"--machine", "machine.toml"};
  if (!victim.machine.empty()) {
    folder.write("machine.toml", victim.machine);
    run.insert(run.end(), on_machine.begin(), on_machine.end());
  }
  leadscrew(folder, run);
  const auto path = rows_of(folder.read("run.csv"));
  std::minstd_rand random(seed);
  Row last = path.front();                    // taken by the drives
  std::vector<double> rest = path.front().q;  // where they came to
  double longest_stop = 0;
  bool has_begun = false;
  std::chrono::microseconds longest_wait{1'200'000};
  for (int kills = 0;; ++kills) {
    std::vector<std::string> arguments = {
        "drive", "part.ngc", "--trace", "words.csv", "--axes",   "axes.csv",   has_begun ? "--resume" : "--state",
        "state", "--quiet",  "--lead",  "300ms",     "--period", victim.period};
    if (!victim.machine.empty()) arguments.insert(arguments.end(), on_machine.begin(), on_machine.end());
    Running running(folder, arguments);
    // At any instant: while the program is read, before there are drives, on the return path, in motion.
    std::this_thread::sleep_for(longest_wait * (random() % 1000) / 1000);
    running.send(SIGKILL);
    const auto outcome = running.wait();
    const bool was_killed = outcome.signal == SIGKILL;
    EXPECT_TRUE(was_killed || outcome.status == 0) << outcome.errors;
    EXPECT_TRUE(eventually([&] { return is_left(folder); }));
    // Killed before there were drives, it has changed nothing: then there are no files.
    const auto words = rows_in(folder, "words.csv"), axes = rows_in(folder, "axes.csv");
    // Where a processor needs long until there is motion, kills come later.
    if (words.empty()) longest_wait += longest_wait / 4;
    if (!has_begun && !exists(folder, "state")) {
      --kills;
      continue;
    }
    has_begun = true;
    EXPECT_TRUE(state_of(folder) == "stopped" || state_of(folder) == "ended") << folder.read("state");
    if (!axes.empty()) {
      EXPECT_LE(worst_ratio(axes, victim.T), 1.001);
      EXPECT_LE(distance(axes.front().q, rest), 1e-9);
    }
    for (std::size_t k = 0; k < words.size(); ++k) {
      EXPECT_EQ(std::llround(words[k].t / victim.T), static_cast<long long>(k));
      EXPECT_LE(distance(words[k].q, at(path, words[k].s)), 3e-4);
    }
    if (!words.empty()) {
      // No gap, and nothing twice: it goes on where the last word was, from rest.
      EXPECT_LE(std::abs(words.front().s - last.s), 1e-9);
      EXPECT_LE(distance(words.front().q, last.q), 1e-9);
      EXPECT_EQ(words.front().feed, 0);
      last = words.back();
    }
    if (!axes.empty()) rest = axes.back().q;
    // Never aside of the path: neither to rest, nor on the return path to where it goes on.
    for (std::size_t k = 0; k < axes.size(); k += 10) EXPECT_LE(distance_to(path, axes[k].q), 3e-4);
    EXPECT_LE(distance_to(path, rest), 3e-4);
    longest_stop = std::max(longest_stop, distance(rest, last.q));
    EXPECT_LE(longest_stop, victim.longest_stop);
    if (state_of(folder) == "ended" || ::testing::Test::HasFailure()) {
      EXPECT_LE(distance(last.q, path.back().q), 1e-9);
      return kills;
    }
    std::filesystem::remove(folder.path() / "words.csv");
    std::filesystem::remove(folder.path() / "axes.csv");
  }
}

TEST(Drive, GoesOnFromWhereItWasKilled) {
  EXPECT_GE(drive_through_kills(arcs_and_corners, 3), 2);
}

TEST(Drive, GoesOnFromWhereItWasKilledInMovesThatTheReaderMakes) {
  EXPECT_GE(drive_through_kills(generated, 11), 2);
}

TEST(Drive, GoesOnFromWhereItWasKilledInThreads) {
  EXPECT_GE(drive_through_kills(threads, 5), 2);
}

TEST(LongDrive, GoesOnFromWhereItWasKilledAHundredTimes) {
  int kills = 0;
  for (unsigned seed = 1; kills < 100 && !::testing::Test::HasFailure(); ++seed) {
    kills += drive_through_kills(arcs_and_corners, seed);
    kills += drive_through_kills(short_lines(), seed);
    kills += drive_through_kills(generated, seed);
    kills += drive_through_kills(threads, seed);
  }
}

}  // namespace test_drive_kills
}  // namespace leadscrew::cli::testing
