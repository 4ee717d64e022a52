// What a program asks for on its way, as drives have it: with the words that they took.

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "driven.hpp"

namespace leadscrew::cli::testing {
namespace test_drive_events {

/// Lines that go on smoothly, an S in each, and M67 behind half of them.
std::string many_events(int lines, int feed) {
  std::string text = "G21 G90 G94 F" + std::to_string(feed) + "\nG64 P0.05\nM3 S0\n";
  for (int k = 1; k <= lines; ++k) {
    text += "G1 X" + std::to_string(k) + " Y" + std::to_string(k % 3) + " S" + std::to_string(k) + '\n';
    if (k % 2 == 0) text += "M67 E1 Q" + std::to_string(k) + '\n';
  }
  return text + "M9\nM2\n";
}

struct EventRow {
  double s = 0, value = 0;
  std::string code;
};

std::vector<EventRow> events_of(const std::string& csv) {
  std::vector<EventRow> rows;
  std::istringstream text(csv);
  std::string line;
  std::getline(text, line);
  while (std::getline(text, line)) {
    std::vector<std::string> cells;
    std::istringstream row(line + ',');
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    rows.push_back({std::stod(cells[2]), std::atof(cells[6].c_str()), cells[4]});
  }
  return rows;
}

/// Slow enough for a planner under sanitizers to be in time.
TEST(DriveEvents, AreThoseOfRunBitForBit) {
  const Folder folder;
  folder.write("part.ngc", many_events(40, 900));
  std::string machine = "[laser]\noutput = 1\n";
  for (const char* axis : {"X", "Y", "Z"})
    machine += "[axis." + std::string(axis) + "]\ntravel_mm = [-500, 500]\nmax_velocity_mm_s = 200\n" +
               "max_acceleration_mm_s2 = 1000\nmax_jerk_mm_s3 = 20000\nblu_mm = 0.001\n";
  folder.write("laser.toml", machine);
  drive_without_a_tail(folder, {"--machine", "laser.toml", "--events", "driven.csv", "--trace", "driven-words.csv"});
  drive_without_a_tail(folder, {"--machine", "laser.toml", "--events", "sent.csv", "--sink", "words.csv"});
  const std::vector<std::string> run = {"run",      "part.ngc", "--machine", "laser.toml",
                                        "--events", "run.csv",  "--trace",   "run-words.csv"};
  EXPECT_EQ(leadscrew(folder, run).status, 0);
  const std::string expected = folder.read("run.csv");
  EXPECT_EQ(std::count(expected.begin(), expected.end(), '\n'), 1 + 2 + 40 + 20 + 2);
  EXPECT_EQ(folder.read("driven.csv"), expected);
  EXPECT_EQ(folder.read("sent.csv"), expected);
  // With the power of a laser.
  const std::string words = folder.read("run-words.csv");
  EXPECT_TRUE(words.starts_with("t,line,s,feed,X,Y,Z,power\n"));
  EXPECT_EQ(folder.read("driven-words.csv"), words);
  EXPECT_EQ(folder.read("words.csv"), words);
}

/// Those in force are told again where motion goes on; all others once.
TEST(DriveEvents, HappenOnceThoughMotionIsStoppedAndGoesOn) {
  const Folder folder;
  folder.write("part.ngc", many_events(80, 3000));
  Running first(folder, {"drive", "part.ngc", "--events", "1.csv", "--state", "state", "--json"});
  ASSERT_TRUE(comes_to(folder, 20));
  first.send(SIGTERM);
  EXPECT_EQ(first.wait().status, 130);
  const auto second =
      leadscrew(folder, {"drive", "part.ngc", "--events", "2.csv", "--resume", "state", "--lead", "1s"});
  EXPECT_EQ(second.status, 0) << second.errors;
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--events", "run.csv"}).status, 0);
  const auto expected = events_of(folder.read("run.csv")), one = events_of(folder.read("1.csv")),
             two = events_of(folder.read("2.csv"));
  ASSERT_FALSE(two.empty());
  std::vector<EventRow> all = one;
  std::copy_if(two.begin(), two.end(), std::back_inserter(all),
               [&](const EventRow& event) { return event.s > two.front().s + 1e-9; });
  ASSERT_EQ(all.size(), expected.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_EQ(all[k].code, expected[k].code) << k;
    EXPECT_EQ(all[k].value, expected[k].value) << k;
    EXPECT_NEAR(all[k].s, expected[k].s, 1e-6) << k;
  }
  // In force where it went on: M3, and the last S and M67.
  const auto again = static_cast<std::size_t>(two.size() + one.size() - all.size());
  ASSERT_EQ(again, 3u);
  const auto last_speed = std::find_if(one.rbegin(), one.rend(), [](const auto& event) { return event.code == "S"; });
  EXPECT_TRUE(std::any_of(two.begin(), two.begin() + 3, [&](const EventRow& event) {
    return event.code == "S" && event.value == last_speed->value;
  }));
}

/// No input is there: motion rests for all of Q. Where it need not, and in `run`, it does not.
TEST(DriveEvents, OfAnInputThatDoesNotComeTakeTheirTime) {
  const Folder folder;
  const std::string begin = "G21 G90 F3000\nG1 X1\nM66 P0 ", end = "\nG1 X2\nM2\n";
  folder.write("part.ngc", begin + "L3 Q0.75" + end);
  const auto driven = leadscrew(folder, {"drive", "part.ngc", "--json", "--events", "e.csv"});
  EXPECT_EQ(driven.status, 0) << driven.errors;
  EXPECT_GE(driven.json()["words"], 750);
  const std::string events = folder.read("e.csv");
  EXPECT_TRUE(contains(events, ",3,M66,0,3,0.75\n")) << events;
  EXPECT_LT(leadscrew(folder, {"run", "part.ngc", "--json"}).json()["words"], 750);
}

}  // namespace test_drive_events
}  // namespace leadscrew::cli::testing
