// A program that is written while it moves.

#include <gtest/gtest.h>

#include "driven.hpp"

namespace leadscrew::cli::testing {
namespace test_drive_live {

/// The rows that have been written whole.
std::vector<Row> rows_by_now(const Folder& folder) {
  if (!folder.names().contains("words.csv")) return {};
  const std::string text = folder.read("words.csv");
  const std::size_t end = text.rfind('\n');
  return end == std::string::npos ? std::vector<Row>() : rows_of(text.substr(0, end + 1));
}

bool has_come_to(const Folder& folder, double s) {
  return eventually([&] {
    const auto rows = rows_by_now(folder);
    return !rows.empty() && rows.back().s >= s - 1e-9;
  });
}

const Surroundings open_input = {.input_stays_open = true};

TEST(DriveLive, MovesWhatHasBeenWrittenAndRestsWhereItEnds) {
  const std::string begin = "G21 G90 G94 G17 F3000 G64 P0.05\nG1 X10\nG1 Y10\n", more = "M8\nG2 X30 Y10 I10 J0\n",
                    end = "G1 X0 Y0\nM9\nM2\n";
  const Folder folder;
  folder.write("part.ngc", begin + more + end);
  Running drive(folder, {"drive", "-", "--live", "--sink", "words.csv", "--events", "events.csv"}, open_input);
  drive.write(begin);
  EXPECT_TRUE(has_come_to(folder, 19.9));  // the corner is cut
  drive.write(more.substr(0, 10));         // half a block
  drive.write(more.substr(10));
  EXPECT_TRUE(eventually([&] {
    const auto rows = rows_by_now(folder);
    return !rows.empty() && distance({rows.back().q[0], rows.back().q[1]}, {30, 10}) < 1e-6;
  }));
  drive.write(end);
  drive.close_input();
  const Outcome outcome = drive.wait();
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(leadscrew(folder, {"verify", "words.csv", "part.ngc"}).status, 0);
  EXPECT_TRUE(contains(folder.read("events.csv"), "M8") && contains(folder.read("events.csv"), "M9"));
}

/// A program whose first part is written, and its end once the tip has come to a place: columns 5 to 7 of the words. Verified.
void expect_tip_to_wait_at(const std::string& begin, const std::string& end, const std::vector<double>& place) {
  const std::string machine = (source_folder / "machines/table-table-ac.toml").string();
  const Folder folder;
  folder.write("part.ngc", begin + end);
  Running drive(folder, {"drive", "-", "--live", "--sink", "words.csv", "--machine", machine}, open_input);
  drive.write(begin);
  EXPECT_TRUE(eventually([&] {
    const auto rows = rows_by_now(folder);
    return !rows.empty() && distance({rows.back().q[5], rows.back().q[6], rows.back().q[7]}, place) < 1e-6;
  }));
  drive.write(end);
  drive.close_input();
  const Outcome outcome = drive.wait();
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(leadscrew(folder, {"verify", "words.csv", "part.ngc", "--machine", machine}).status, 0);
}

/// At rest, too, places are the tip's.
TEST(DriveLive, HoldsTheTipWhereTheProgramWaits) {
  expect_tip_to_wait_at("G21 G90 G94 G17 F3000 G61\nG43.4\nG1 X10 A10 C20\n", "G1 X20 A20\nG49\nM2\n", {10, 0, 0});
}

/// Whoever waits for motion before more is written does not wait for ever: tool vectors, whose angles are decided together,
/// are decided by what there is.
TEST(DriveLive, MovesByToolVectorsThatHaveBeenWritten) {
  expect_tip_to_wait_at(
      "G21 G90 G94 G17 F3000 G64 P0.05 E0.5\nG43.5\nG0 X0 Y0 Z0 I0.1 K1\nG1 X10 I0.15 K1\nG1 X20 I0.2 K1\n",
      "G1 X30 I0.25 K1\nG49\nM2\n", {20, 0, 0});
}

TEST(DriveLive, RestsBeforeTheFirstError) {
  const Folder folder;
  Running drive(folder, {"drive", "-", "--live", "--sink", "words.csv", "--json"}, open_input);
  drive.write("G21 G90 F3000\nG1 X10\n");
  EXPECT_TRUE(has_come_to(folder, 10));
  drive.write("G1 X20\nG77\nG1 X40\n");
  const Outcome outcome = drive.wait();
  EXPECT_EQ(outcome.status, 3) << outcome.errors;
  EXPECT_EQ(places_of(outcome.json()["diagnostics"]), (Names{"4:1 unknown-code"}));
  const auto rows = rows_of(folder.read("words.csv"));
  EXPECT_LE(distance({rows.back().q[0]}, {20}), 1e-9);
}

TEST(DriveLive, ExecutesNoHalfLine) {
  const Folder folder;
  Running drive(folder, {"drive", "-", "--live", "--sink", "words.csv", "--json"}, open_input);
  drive.write("G21 G90 F3000\nG1 X10\nG1 X2");  // of X20
  drive.close_input();
  const Outcome outcome = drive.wait();
  EXPECT_EQ(outcome.status, 3) << outcome.errors;
  EXPECT_TRUE(contains(outcome.errors + outcome.output, "unfinished-line")) << outcome.errors;
  const auto rows = rows_of(folder.read("words.csv"));
  EXPECT_LE(distance({rows.back().q[0]}, {10}), 1e-9);
}

TEST(DriveLive, EndsWhenItIsInterruptedWhileItWaits) {
  const Folder folder;
  Running drive(folder, {"drive", "-", "--live", "--sink", "words.csv"}, open_input);
  drive.write("G21 G90 F3000\nG1 X10\n");
  EXPECT_TRUE(has_come_to(folder, 10));
  drive.send(SIGINT);
  EXPECT_EQ(drive.wait().status, 130);
}

TEST(DriveLive, OfAProgramThatCannotBeReadMovesNothing) {
  const Folder folder;
  const auto none = leadscrew(folder, {"drive", "none.ngc", "--live", "--sink", "words.csv"});
  EXPECT_EQ(none.status, 4) << none.errors;
  EXPECT_TRUE(contains(none.errors, "[io-open]")) << none.errors;
  const auto kept = leadscrew(folder, {"drive", "-", "--live", "--state", "state"});
  EXPECT_EQ(kept.status, 2) << kept.errors;
}

}  // namespace test_drive_live
}  // namespace leadscrew::cli::testing
