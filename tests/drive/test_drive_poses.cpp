// Five axes on time: where words bring the tool's tip, beside the words and in the state.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "driven.hpp"

namespace leadscrew::cli::testing {
namespace test_drive_poses {

/// Two tools, on and off tool centre point control, with and without rounding.
const std::string five_axes =
    "G21 G90 G94 G17 G61\nT1 M6\nG0 A10 C20\nG43.4 H1\nG0 X20 Y0 Z5\nG1 X0 A25 C40 F2000\nG1 C60 F1200\nG64 P0.02 "
    "E0.1\n"
    "G1 X-10 Y5 C50\nG1 X-12 Y8 C55\nG49\nG0 Z80\nG43 H2\nG1 X10 F1500\nG43.4 H2\nG1 X0 C40 F1000\nM2\n";

const std::vector<std::string> on_the_trunnion = {
    "--machine", (source_folder / "machines/table-table-ac.toml").string(), "--tools", "tools.tbl"};

void write_part(const Folder& folder) {
  folder.write("part.ngc", five_axes);
  folder.write("tools.tbl", "T1 P1 Z30\nT2 P2 X1 Z45.5\n");
}

std::vector<std::string> with_machine(std::vector<std::string> words) {
  words.insert(words.end(), on_the_trunnion.begin(), on_the_trunnion.end());
  return words;
}

std::string run_trace(const Folder& folder) {
  EXPECT_EQ(leadscrew(folder, with_machine({"run", "part.ngc", "--trace", "run.csv"})).status, 0);
  return folder.read("run.csv");
}

TEST(DrivePoses, AreThoseOfRunBitForBit) {
  const Folder folder;
  write_part(folder);
  const std::string expected = run_trace(folder);
  ASSERT_TRUE(expected.starts_with("t,line,s,feed,X,Y,Z,A,C,tx,ty,tz,i,j,k\n"));
  drive_without_a_tail(folder, with_machine({"--trace", "driven.csv", "--state", "state"}));
  EXPECT_EQ(folder.read("driven.csv"), expected);
  drive_without_a_tail(folder, with_machine({"--sink", "sent.csv", "--state", "sent"}));
  EXPECT_EQ(folder.read("sent.csv"), expected);
  const std::vector<double> last = rows_of(expected).back().q;
  for (const char* const name : {"state", "sent"}) {
    const Json tool = Json::parse(folder.read(name))["tool"];
    EXPECT_EQ(tool["offset"], Json({1, 0, 45.5}));
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(tool["tip"][i], last[5 + i]);
      EXPECT_EQ(tool["direction"][i], last[8 + i]);
    }
  }
}

/// While the program holds the tip, rows say so, and behind it the tool's tip is where the axes take it.
TEST(DrivePoses, TellTheTipThatTheProgramAsksFor) {
  const Folder folder;
  write_part(folder);
  std::size_t standing = 0, turned = 0;
  for (const Row& row : rows_of(run_trace(folder))) {
    if (row.line == 7) {  // C alone turns
      for (const auto& [column, place] : {std::pair(5, 0.0), {6, 0.0}, {7, 5.0}})
        EXPECT_NEAR(row.q[static_cast<std::size_t>(column)], place, 1e-9) << row.t;
      ++standing;
    }
    if (row.line == 14) {                // without control, tool 2: one straight line of the axes
      EXPECT_NEAR(row.q[2], 80, 0.021);  // rounded where it begins
      EXPECT_NEAR(row.q[10], std::cos(25 * std::atan(1.0) / 45), 1e-12);
      ++turned;
    }
  }
  EXPECT_GT(standing, 100u);
  EXPECT_GT(turned, 100u);
}

TEST(DrivePoses, GoOnWithTheToolThatWasStoppedWith) {
  const Folder folder;
  write_part(folder);
  const std::vector<Row> path = rows_of(run_trace(folder));
  Running first(folder, with_machine({"drive", "part.ngc", "--trace", "1.csv", "--state", "state", "--json"}));
  ASSERT_TRUE(comes_to(folder, path.back().s / 2));
  first.send(SIGTERM);
  ASSERT_EQ(first.wait().status, 130);
  const Json stopped = Json::parse(folder.read("state"));
  ASSERT_NE(stopped["tool"]["offset"], Json({0, 0, 0}));
  const auto second = leadscrew(
      folder, with_machine({"drive", "part.ngc", "--trace", "2.csv", "--resume", "state", "--state", "state"}));
  ASSERT_EQ(second.status, 0) << second.errors;
  const std::vector<Row> rows = rows_of(folder.read("2.csv"));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(rows.front().q[5 + i], stopped["tool"]["tip"][i], 1e-9) << i;
  for (std::size_t k = 0; k < rows.size(); k += 50) EXPECT_LT(distance_to(path, rows[k].q), 0.02) << rows[k].t;
  EXPECT_EQ(Json::parse(folder.read("state"))["tool"]["offset"], Json({1, 0, 45.5}));
}

TEST(DrivePoses, OfAStateThatWasChangedByHandAreRefused) {
  const Folder folder;
  write_part(folder);
  leadscrew(folder, with_machine({"drive", "part.ngc", "--state", "state", "--quiet"}));
  Json state = Json::parse(folder.read("state"));
  state["state"] = "stopped";
  for (const Json& offset : {Json({1, 2}), Json("long"), Json({0, 0, "long"})}) {
    state["tool"]["offset"] = offset;
    folder.write("state", state.dump());
    const auto outcome = leadscrew(folder, with_machine({"drive", "part.ngc", "--resume", "state", "--json"}));
    EXPECT_EQ(outcome.status, 3);
    EXPECT_EQ(outcome.json()["diagnostics"][0]["code"], "resume-state") << offset;
  }
}

TEST(DrivePoses, AreOfMachinesWithKinematicsOnly) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94\nG1 X2 F3000\nM2\n");
  leadscrew(folder, {"drive", "part.ngc", "--state", "state", "--trace", "words.csv", "--quiet"});
  EXPECT_FALSE(Json::parse(folder.read("state")).contains("tool"));
  EXPECT_TRUE(folder.read("words.csv").starts_with("t,line,s,feed,X,Y,Z\n"));
}

}  // namespace test_drive_poses
}  // namespace leadscrew::cli::testing
