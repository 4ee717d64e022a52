// What a program asks for on its way, as a file and on the report.

#include <gtest/gtest.h>

#include <cmath>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace {

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
  EXPECT_EQ(events[0], (std::vector<std::string>{"tick", "t", "s", "line", "code", "output", "value"}));
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

TEST(Events, StandOnTheReport) {
  const Folder folder;
  folder.write("part.ngc", part);
  folder.write("plain.ngc", square);
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--report", "r.html"}).status, 0);
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

}  // namespace
}  // namespace leadscrew::cli::testing
