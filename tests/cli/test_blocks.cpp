// Where the time of a run goes: by block as a file, by cause in the summary and as JSON.

#include <gtest/gtest.h>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_blocks {

constexpr std::string_view slow_mill = R"(name = "slow"
kinematics = "cartesian"
[axis.X]
travel_mm = [-500, 500]
max_velocity_mm_s = 2
max_acceleration_mm_s2 = 1000000
max_jerk_mm_s3 = 1000000000
blu_mm = 0.001
)";

/// The last cells of a row, behind its quoted text.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream rest(line.substr(line.rfind('"') + 2) + ',');
  for (std::string cell; std::getline(rest, cell, ',');) cells.push_back(cell);
  return cells;
}

/// To know rapids from feed moves, events go along the path: they change no bit of a word, and are in no list.
TEST(Blocks, AndRapidsAreDrawnFromTheSameWords) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G64 P0.1\nG0 X5 Z5\nG1 X10 Y3 F900\nM8\nX30 F600\nG0 X40 Y9\nG1 X0\nM2\n");
  leadscrew(folder, {"run", "part.ngc", "--trace", "t.csv", "--events", "e.csv"});
  const Outcome drawn = leadscrew(
      folder, {"run", "part.ngc", "--trace", "d.csv", "--events", "f.csv", "--report", "r.html", "--picture", "p.svg"},
      without_page(folder));
  ASSERT_EQ(drawn.status, 0) << drawn.errors;
  EXPECT_EQ(folder.read("t.csv"), folder.read("d.csv"));
  EXPECT_EQ(folder.read("e.csv"), folder.read("f.csv"));
  EXPECT_TRUE(contains(folder.read("p.svg"), ">900 mm/min</text>"));
  EXPECT_TRUE(contains(folder.read("p.svg"), ">rapids</text>"));
  const std::string page = folder.read("r.html");
  EXPECT_TRUE(contains(page, "Where time is lost"));
  EXPECT_TRUE(contains(page, "X30 F600</td><td>600</td>"));
  EXPECT_TRUE(contains(page, "G0 X40 Y9</td><td>rapid</td>"));
}

// A line of a subprogram, or in a loop, is another block each time.
TEST(Blocks, AreToldByFileLineAndVisit) {
  const Folder folder;
  folder.write("sub.ngc", "o<sub> sub\nG1 X[#1] (of a file)\no<sub> endsub\nM2\n");
  folder.write("part.ngc", "G61.1 F600\no1 repeat [2]\nG1 X1 (own)\no<sub> call [5]\no1 endrepeat\nM2\n");
  const Outcome run =
      leadscrew(folder, {"run", "part.ngc", "--blocks", "b.csv", "--report", "r.html", "--trace", "t.csv", "--json"},
                without_page(folder));
  ASSERT_EQ(run.status, 0) << run.errors;
  std::istringstream rows(folder.read("b.csv"));
  std::string told, row;
  while (std::getline(rows, row)) {
    const std::size_t text = row.find('"'), behind = row.find(",jerk X");
    if (behind != std::string::npos) told += row.substr(0, row.find('"', text + 1)) + row.substr(behind + 7) + "\n";
  }
  EXPECT_EQ(told,
            "3,\"G1 X1 (own),,0\n2,\"G1 X[#1] (of a file),\"sub.ngc\",1\n"
            "3,\"G1 X1 (own),,3\n2,\"G1 X[#1] (of a file),\"sub.ngc\",4\n");
  const std::string page = folder.read("r.html");
  for (const char* cells : {">3</td><td class=\"source\" title=\"G1 X1 (own)\">", ">3, visit 3</td>",
                            ">sub.ngc:2, visit 4</td><td class=\"source\" title=\"G1 X[#1] (of a file)\">"}) {
    EXPECT_TRUE(contains(page, cells)) << cells;
  }
  // Of a motion that is judged by limits it has not been planned for.
  folder.write("slow.toml", std::string(slow_mill));
  const Outcome verify = leadscrew(folder, {"verify", "t.csv", "part.ngc", "--machine", "slow.toml", "--json"});
  ASSERT_EQ(verify.status, 1) << verify.errors;
  const Json object = verify.json(), violations = object["violations"];
  EXPECT_FALSE(violations[0].contains("file"));
  EXPECT_FALSE(violations[0].contains("visit"));
  EXPECT_EQ(violations.back()["line"], 2);
  EXPECT_EQ(violations.back()["file"], 1);
  EXPECT_EQ(violations.back()["visit"], 4);
  const Outcome words = leadscrew(folder, {"verify", "t.csv", "part.ngc", "--machine", "slow.toml"});
  EXPECT_TRUE(contains(words.output, ", line 3: X velocity is")) << words.output;
}

TEST(Blocks, AreWrittenWithWhatTheyTookAndLost) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G61 F6000\nG0 Z5\nG1 X10 (a \"quoted\" word)\n\nG4 P0.25\nG1 X30 F600\nM2\n");
  const Outcome run = leadscrew(folder, {"run", "part.ngc", "--blocks", "b.csv", "--json"});
  ASSERT_EQ(run.status, 0) << run.errors;
  std::istringstream lines(folder.read("b.csv"));
  std::string header, line;
  std::getline(lines, header);
  EXPECT_EQ(
      header,
      "line,text,from X,from Y,from Z,to X,to Y,to Z,length,feed_asked,feed_reached,time,least_time,time_lost,cause,"
      "file,visit");
  const std::vector<std::string> begins = {"2,\"G0 Z5\",", "3,\"G1 X10 (a \"\"quoted\"\" word)\",", "5,\"G4 P0.25\",",
                                           "6,\"G1 X30 F600\","};
  double seconds = 0, lost = 0;
  for (const std::string& begin : begins) {
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_EQ(line.substr(0, begin.size()), begin);
    const auto cells = cells_of(line);
    ASSERT_EQ(cells.size(), 15u) << line;
    seconds += std::stod(cells[9]);
    lost += std::stod(cells[11]);
    EXPECT_NEAR(std::stod(cells[9]) - std::stod(cells[10]), std::stod(cells[11]), 1e-12);
  }
  EXPECT_FALSE(std::getline(lines, line));
  const Json object = run.json();
  EXPECT_NEAR(object["time_s"].get<double>(), seconds, 1e-9);
  double by_cause = 0, before = 1e300;
  for (const Json& loss : object["losses"]) {
    const double cost = loss["s"].get<double>();
    EXPECT_LE(cost, before);
    by_cause += before = cost;
  }
  EXPECT_NEAR(by_cause, lost, 1e-9);
  EXPECT_NEAR(object["extents"][0]["greatest"].get<double>(), 30, 1e-9);
  EXPECT_EQ(object["extents"][2]["name"], "Z");
}

TEST(Blocks, AreOfOneProgram) {
  const Folder folder;
  folder.write("a.ngc", "G0 X1\nM2\n");
  EXPECT_EQ(leadscrew(folder, {"run", "a.ngc", "a.ngc", "--blocks", "b.csv"}).status, 2);
  EXPECT_EQ(leadscrew(folder, {"run", "a.ngc", "--blocks", "b.txt"}).status, 2);
}

}  // namespace test_blocks
}  // namespace leadscrew::cli::testing
