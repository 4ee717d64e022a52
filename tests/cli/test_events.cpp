// What a program asks for on its way, as a file and on the report.

#include <gtest/gtest.h>

#include <cmath>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_events {

const std::string part = "G21 G90 G94 F6000 G61\nS1200 M3\nG1 X10\nM67 E2 Q0.5\nG1 X20 S800\nM8\nX30\nM62 P3\nM2\n";

std::vector<std::vector<std::string>> rows_of(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string>& row = rows.emplace_back();
    std::istringstream cells(line + ',');
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
  }
  return rows;
}

TEST(Events, AreWrittenWithTheirWordsAndPlaces) {
  const Folder folder;
  folder.write("part.ngc", part);
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--events", "e.csv", "--trace", "t.csv"}).status, 0);
  const auto events = rows_of(folder.read("e.csv")), words = rows_of(folder.read("t.csv"));
  ASSERT_EQ(events.size(), 8u);
  EXPECT_EQ(events[0], (std::vector<std::string>{"tick", "t", "s", "line", "code", "output", "value", "q"}));
  const std::vector<std::vector<std::string>> expected = {
      {"2", "S", "", "1200"}, {"2", "M3", "", "1200"}, {"5", "S", "", "800"}, {"4", "M67", "2", "0.5"},
      {"6", "M8", "", ""},    {"8", "M62", "3", ""},   {"9", "M2", "", ""}};
  const double places[] = {0, 0, 10, 10, 20, 30, 30};
  std::set<std::vector<std::string>> found;
  for (std::size_t k = 1; k < events.size(); ++k) {
    const auto& event = events[k];
    found.insert({event[3], event[4], event[5], event[6]});
    const auto tick = static_cast<std::size_t>(std::stoll(event[0]));
    ASSERT_LT(tick + 1, words.size());
    EXPECT_DOUBLE_EQ(std::stod(event[1]), 1e-3 * static_cast<double>(tick));
    EXPECT_NEAR(std::stod(event[2]), places[k - 1], 1e-9);
    EXPECT_GE(std::stod(words[tick + 1][2]), places[k - 1] - 1e-9);
    if (tick == 0) continue;
    EXPECT_LE(std::stod(words[tick][2]), places[k - 1] + 1e-9);
  }
  EXPECT_EQ(found, (std::set<std::vector<std::string>>(expected.begin(), expected.end())));
  EXPECT_EQ(events[4][4] + events[3][4], "SM67");  // in the order of the program
}

/// Of a machine with a laser: a column of the trace, by `run` and by `simulate`, where words come later than events. What
/// no block asks for is no event.
TEST(Events, ReachTheLaserWithTheirWords) {
  const Folder folder;
  const std::string text = "G21 G90 G94 F6000 G61\nM67 E0 Q5\nG1 X20\nM68 E0 Q2\nF3000 X40\nG0 X60\nM2\n";
  folder.write("part.ngc", text);
  std::string machine = "[laser]\n";
  for (const char axis : {'X', 'Y', 'Z'})
    machine += std::string("[axis.") + axis + "]\ntravel_mm = [-500, 500]\nmax_velocity_mm_s = 200\n" +
               "max_acceleration_mm_s2 = 1000\nmax_jerk_mm_s3 = 20000\nblu_mm = 0.001\n";
  folder.write("laser.toml", machine);
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--machine", "laser.toml", "--trace", "t.csv", "--events", "e.csv",
                               "--report", "r.html"})
                .status,
            0);
  ASSERT_EQ(leadscrew(folder, {"simulate", "part.ngc", "--machine", "laser.toml", "--trace", "s.csv"}).status, 0);
  const auto words = rows_of(folder.read("t.csv")), followed = rows_of(folder.read("s.csv"));
  EXPECT_EQ(words[0].back(), "power");
  EXPECT_EQ(followed[0].back(), "power");
  ASSERT_EQ(rows_of(folder.read("e.csv")).size(), 4u);
  EXPECT_FALSE(contains(folder.read("r.html"), "<td class=\"text\">F</td>"));
  for (const auto* rows : {&words, &followed}) {
    for (std::size_t k = 1; k < rows->size(); ++k) {
      const auto& row = (*rows)[k];
      const double x = std::stod(row[4]), feed = std::stod(row[3]);
      const double expected = x < 20 ? 5 * feed / 100 : x < 40 ? 2 * feed / 50 : 0;
      EXPECT_NEAR(std::stod(row.back()), expected, 1e-9) << row[0];
    }
  }
}

TEST(Events, StandOnTheReport) {
  const Folder folder;
  folder.write("part.ngc", part);
  folder.write("plain.ngc", square);
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--report", "r.html"}, without_page(folder)).status, 0);
  const std::string page = folder.read("r.html");
  EXPECT_TRUE(contains(page, "<td>6</td><td class=\"text\">M8</td>")) << page;
  EXPECT_TRUE(contains(page, "<td class=\"text\">M67</td><td>2</td><td>0.5</td>"));
  EXPECT_TRUE(contains(page, "goes on"));
}

TEST(Events, AreRefusedAFileThatIsNoCsvOrAlreadyTaken) {
  const Folder folder;
  folder.write("part.ngc", part);
  for (const Names& wrong :
       {Names{"--events=e.txt"}, Names{"--events=part.ngc"}, Names{"--events=t.csv", "--trace=t.csv"}}) {
    std::vector<std::string> arguments = {"run", "part.ngc"};
    arguments.insert(arguments.end(), wrong.begin(), wrong.end());
    EXPECT_EQ(leadscrew(folder, arguments).status, 2);
  }
  EXPECT_EQ(leadscrew(folder, {"run", "part.ngc", "part.ngc", "--events", "e.csv"}).status, 2);
  EXPECT_EQ(folder.names(), Names{"part.ngc"});
}

}  // namespace test_events
}  // namespace leadscrew::cli::testing
