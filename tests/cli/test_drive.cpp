// The command on time: its words, and what becomes of them when it is stopped, killed and taken up again.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace {

/// Some four seconds with corners to stop at, an arc and a smooth join.
const std::string part =
    "G21 G90 G94 G17 F3000\nG61\nG1 X30\nG2 X50 Y-20 I0 J-20\nG1 Y-40\nG64 P0.05\nG1 X20 Y-50\nG1 X0 Y-20\nG61\nG1 X0 "
    "Y0\nG3 X0 Y0 I10 J0\nM2\n";

struct Row {
  double t = 0, line = 0, s = 0, feed = 0;
  std::vector<double> q;
};

std::vector<Row> rows_of(const std::string& csv) {
  std::vector<Row> rows;
  std::istringstream text(csv);
  std::string line;
  std::getline(text, line);
  while (std::getline(text, line)) {
    std::vector<double> values;
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) values.push_back(std::strtod(field.c_str(), nullptr));
    rows.push_back({values[0], values[1], values[2], values[3], {values.begin() + 4, values.end()}});
  }
  return rows;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

/// Where the path is at a length, between two of the words that run made.
std::vector<double> at(const std::vector<Row>& path, double s) {
  const auto after = std::find_if(path.begin(), path.end(), [&](const Row& row) { return row.s >= s; });
  if (after == path.end()) return path.back().q;
  if (after == path.begin() || after->s == std::prev(after)->s) return after->q;
  const Row& before = *std::prev(after);
  const double share = (s - before.s) / (after->s - before.s);
  std::vector<double> q = before.q;
  for (std::size_t i = 0; i < q.size(); ++i) q[i] += share * (after->q[i] - before.q[i]);
  return q;
}

/// To the nearest place of the path, between two of its words.
double distance_to(const std::vector<Row>& path, const std::vector<double>& q) {
  double nearest = distance(path.front().q, q);
  for (std::size_t k = 1; k < path.size(); ++k) {
    const std::vector<double>&a = path[k - 1].q, &b = path[k].q;
    double along = 0, square = 0;
    for (std::size_t i = 0; i < q.size(); ++i) {
      along += (q[i] - a[i]) * (b[i] - a[i]);
      square += (b[i] - a[i]) * (b[i] - a[i]);
    }
    const double share = square > 0 ? std::clamp(along / square, 0.0, 1.0) : 0;
    std::vector<double> foot = a;
    for (std::size_t i = 0; i < q.size(); ++i) foot[i] += share * (b[i] - a[i]);
    nearest = std::min(nearest, distance(foot, q));
  }
  return nearest;
}

/// The largest first, second or third difference over a limit of the built-in mill, as if it stood before and after.
double worst_ratio(std::vector<Row> rows, double T = 1e-3) {
  rows.insert(rows.begin(), 3, rows.front());
  rows.insert(rows.end(), 3, rows.back());
  double worst = 0;
  for (std::size_t k = 3; k < rows.size(); ++k) {
    for (std::size_t i = 0; i < rows[k].q.size(); ++i) {
      const double a = rows[k].q[i], b = rows[k - 1].q[i], c = rows[k - 2].q[i], d = rows[k - 3].q[i];
      worst = std::max({worst, std::abs(a - b) / T / 200, std::abs(a - 2 * b + c) / T / T / 1000,
                        std::abs(a - 3 * b + 3 * c - d) / T / T / T / 20000});
    }
  }
  return worst;
}

bool exists(const Folder& folder, const std::string& name) {
  return std::filesystem::exists(folder.path() / name);
}

/// None where there is no such file.
std::vector<Row> rows_in(const Folder& folder, const std::string& name) {
  return exists(folder, name) ? rows_of(folder.read(name)) : std::vector<Row>();
}

std::string state_of(const Folder& folder) {
  const Json state = Json::parse(folder.read("state"), nullptr, false);
  return state.is_object() ? state["state"].get<std::string>() : "";
}

/// Waits until the state on disk says that the drives have come so far along the path, mm.
bool comes_to(const Folder& folder, double way) {
  return eventually([&] {
    if (!std::filesystem::exists(folder.path() / "state")) return false;
    const Json state = Json::parse(folder.read("state"), nullptr, false);
    return state.is_object() && state["path_length"].get<double>() >= way;
  });
}

/// Drives until the planner was never late, which is seldom more than once: only then words are those of run.
Outcome drive_without_a_tail(const Folder& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"drive", "part.ngc", "--json", "--look-ahead", "2s", "--lead", "1s"});
  Outcome driven;
  for (int attempt = 0; attempt < 5; ++attempt) {
    driven = leadscrew(folder, arguments);
    EXPECT_EQ(driven.status, 0) << driven.errors;
    if (driven.json()["starvations"] == 0) return driven;
  }
  ADD_FAILURE() << "the planner was always late";
  return driven;
}

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
  EXPECT_EQ(one.back().line, two.front().line);
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

/// What is killed again and again.
struct Victim {
  std::string program, period;
  double T = 0;             ///< s
  double longest_stop = 0;  ///< mm
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

/// Drives a program, killed again and again, until it has come to its end; returns how often it was killed.
int drive_through_kills(const Victim& victim, unsigned seed) {
  const Folder folder;
  folder.write("part.ngc", victim.program);
  leadscrew(folder, {"run", "part.ngc", "--trace", "run.csv", "--period", victim.period});
  const auto path = rows_of(folder.read("run.csv"));
  std::minstd_rand random(seed);
  Row last = path.front();                    // taken by the drives
  std::vector<double> rest = path.front().q;  // where they came to
  double longest_stop = 0;
  bool has_begun = false;
  for (int kills = 0;; ++kills) {
    std::vector<std::string> arguments = {
        "drive", "part.ngc", "--trace", "words.csv", "--axes",   "axes.csv",   has_begun ? "--resume" : "--state",
        "state", "--quiet",  "--lead",  "300ms",     "--period", victim.period};
    Running running(folder, arguments);
    // At any instant: while the program is read, before there are drives, on the way back, in motion.
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 1'200'000));
    running.send(SIGKILL);
    const auto outcome = running.wait();
    const bool was_killed = outcome.signal == SIGKILL;
    EXPECT_TRUE(was_killed || outcome.status == 0) << outcome.errors;
    EXPECT_TRUE(eventually([&] { return is_left(folder); }));
    // Killed before there were drives, it has changed nothing: then there are no files.
    const auto words = rows_in(folder, "words.csv"), axes = rows_in(folder, "axes.csv");
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
    // Never aside of the path: neither on the way to rest, nor on the way back to where it goes on.
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

TEST(LongDrive, GoesOnFromWhereItWasKilledAHundredTimes) {
  int kills = 0;
  for (unsigned seed = 1; kills < 100 && !::testing::Test::HasFailure(); ++seed) {
    kills += drive_through_kills(arcs_and_corners, seed);
    kills += drive_through_kills(short_lines(), seed);
  }
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
  Running read(folder, {"drive", "part.ngc", "--sink", "pipe", "--json", "--look-ahead", "2s"});
  std::ifstream words(pipe);
  std::this_thread::sleep_for(std::chrono::seconds(3));
  const std::string text{std::istreambuf_iterator<char>(words), {}};
  const auto outcome = read.wait();
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  if (outcome.json()["starvations"] == 0) {
    EXPECT_EQ(text, folder.read("run.csv"));
  }
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

}  // namespace
}  // namespace leadscrew::cli::testing
