// `simulate`: errors of slides under simulated loops.

#include <gtest/gtest.h>
#include <leadscrew/servo/contour.hpp>

#include <cmath>
#include <csignal>
#include <map>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_simulate {

Json simulated(const Folder& folder, const std::string& program, std::vector<std::string> more, int status = 0) {
  folder.write("part.ngc", program);
  std::vector<std::string> words = {"simulate", "part.ngc", "--json"};
  words.insert(words.end(), more.begin(), more.end());
  const auto outcome = leadscrew(folder, words);
  EXPECT_EQ(outcome.status, status) << outcome.errors << outcome.output;
  return outcome.json();
}

/// A machine whose loops are K/(s(τs + 1)) under a gain alone, with an encoder of 10 nm.
std::string proportional_machine(double x_gain, double y_gain) {
  std::string text = machine_text();
  for (const auto& [axis, gain] : {std::pair{'X', x_gain}, {'Y', y_gain}, {'Z', 20.0}}) {
    std::ostringstream drive;
    drive << "[axis." << axis << ".drive]\ncontroller = \"pid\"\ngain_mm_s = 10\ntime_constant_ms = 5\n"
          << "proportional_per_mm = " << gain / 10 << "\nvelocity_forward = 0\nacceleration_forward = 0\n"
          << "encoder_counts_per_mm = 100000\n";
    text += drive.str();
  }
  return text;
}

TEST(Simulate, HoldsTheToleranceWithDrivesThatAreNotTold) {
  const Folder folder;
  const Json figures = simulated(folder, square, {});
  EXPECT_EQ(figures["schema"], "leadscrew.simulate/1");
  EXPECT_EQ(figures["machine"], "mill3");
  EXPECT_EQ(figures["tolerance_mm"], 0.01);
  EXPECT_LT(figures["deviation_mm"], 0.01);
  EXPECT_GT(figures["deviation_mm"], 0);
  EXPECT_LT(figures["settling_s"], 0.1);
  EXPECT_NEAR(figures["feed"]["measured_max_mm_s"], 10, 0.3);
  EXPECT_NEAR(figures["feed"]["commanded_max_mm_s"], 10, 1e-9);
  ASSERT_EQ(figures["axes"].size(), 3u);
  EXPECT_EQ(figures["axes"][2]["following_max_mm"], 0);
}

/// Textbook: an axis lags V/Kv, and of a line at 45° what lies across it is (V/2)·(1/Kx − 1/Ky).
TEST(Simulate, FindsTheErrorsOfALineByTheFormulas) {
  const Folder folder;
  folder.write("m.toml", proportional_machine(20, 25));
  const Json figures = simulated(folder, "G21 G90\nG1 X60 Y60 F1200\nM2\n", {"--machine", "m.toml"}, 1);
  const double across = servo::line_contour_error(20, std::atan(1.0), {20, 0.005}, {25, 0.005});
  EXPECT_NEAR(figures["axes"][0]["following_max_mm"], 20 / std::sqrt(2.0) / 20, 1e-4);
  EXPECT_NEAR(figures["axes"][1]["following_max_mm"], 20 / std::sqrt(2.0) / 25, 1e-4);
  EXPECT_NEAR(figures["contour"]["max_mm"], std::fabs(across), 1e-4);
  EXPECT_NEAR(figures["deviation_mm"], std::fabs(across), 1e-3);
}

/// Three turns: what is left when they have settled is a circle of another radius, though each axis is a millimetre
/// off.
TEST(Simulate, FindsTheErrorOfACircleByTheFormula) {
  const Folder folder;
  folder.write("m.toml", proportional_machine(20, 20));
  const Json figures =
      simulated(folder, "G21 G90 G17\nG2 X0 Y0 I20 J0 P3 F1800\nM2\n", {"--machine", "m.toml", "--period", "250us"}, 1);
  const double frequency = 30.0 / 20;
  const servo::SemiAxes circle = servo::circle_semi_axes(20, frequency, {20, 0.005}, {20, 0.005});
  EXPECT_GT(figures["axes"][0]["following_max_mm"], 1);
  EXPECT_NEAR(figures["contour"]["max_mm"], 20 - circle.major, 1e-3);
}

/// Gains of the published convention have no feed-forward unless it is asked for.
TEST(Simulate, TakesGainsAndFeedForward) {
  const Folder folder;
  const std::string line = "G21 G90\nG1 X60 F600\nM2\n";
  const auto lag = [&](std::vector<std::string> more, int status) -> double {
    return simulated(folder, line, std::move(more), status)["axes"][0]["following_max_mm"];
  };
  EXPECT_LT(lag({}, 0), 0.01);
  EXPECT_NEAR(lag({"--feed-forward", "off"}, 0), 10.0 / 40, 2e-3);
  EXPECT_NEAR(lag({"--gains", "1,0,0"}, 0), 10.0 / 10, 2e-3);
  EXPECT_LT(lag({"--gains", "1,0,0", "--feed-forward", "on"}, 0), 0.02);
}

/// V/Kv in every axis, within a pulse of the steps and one of the encoder; what lags evenly stays on its line.
TEST(Simulate, SendsStepsThroughPulseDrivenLoops) {
  const Folder folder;
  folder.write("m.toml", with_screw("drive.position_gain_per_s = 25\n"));
  const std::string line = "G21 G90\nG1 X30 Y0 F600\nM2\n", diagonal = "G21 G90\nG1 X30 Y30 F600\nM2\n";
  const Json figures = simulated(folder, line, {"--pulses", "--machine", "m.toml"});
  EXPECT_NEAR(figures["axes"][0]["following_max_mm"], 10.0 / 25, 2e-3);
  EXPECT_LT(figures["contour"]["max_mm"], 2e-3);
  EXPECT_LT(figures["settling_s"], 0.4);
  const Json even = simulated(folder, diagonal, {"--pulses"});
  EXPECT_NEAR(even["axes"][1]["following_max_mm"], 10.0 / std::sqrt(2.0) / 40, 2e-3);
  EXPECT_LT(even["contour"]["max_mm"], 2e-3);
  // Steps of 1 µm: none is lost, and the screw has gone as far as it was sent.
  for (const int axis : {0, 1}) {
    EXPECT_EQ(even["pulses"][axis]["commanded"], 30'000);
    EXPECT_EQ(even["pulses"][axis]["encoder"], 30'000);
    EXPECT_EQ(even["pulses"][axis]["lost"], 0);
  }
}

/// Around a circle of 5 mm each axis goes 20 mm, and back where it was: 20 000 steps, net none.
TEST(Simulate, CountsPulsesOfBothDirections) {
  const Folder folder;
  const Json circle = simulated(folder, "G21 G90\nG2 X0 Y0 I5 J0 F600\nM2\n", {"--pulses"});
  for (const int axis : {0, 1}) {
    const Json& counts = circle["pulses"][axis];
    EXPECT_EQ(counts["commanded"], 0);
    EXPECT_EQ(counts["commanded_gross"], 20'000);
    EXPECT_EQ(counts["encoder"], 0);
    EXPECT_NEAR(counts["encoder_gross"].get<double>(), 20'000, 40);  // slides that lag turn within R
    EXPECT_EQ(counts["overflows"], 0);
  }
}

TEST(Simulate, SaysWhatIsWrongWithItsOptions) {
  const Folder folder;
  folder.write("part.ngc", square);
  const auto errors = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"simulate", "part.ngc"});
    const auto outcome = leadscrew(folder, more);
    EXPECT_EQ(outcome.status, 2);
    return outcome.errors;
  };
  EXPECT_TRUE(contains(errors({"--gains", "2,2"}), "three gains"));
  EXPECT_TRUE(contains(errors({"--gains", "2,x,2"}), "is not a number"));
  EXPECT_TRUE(contains(errors({"--feed-forward", "yes"}), "is none of on, off"));
  EXPECT_TRUE(contains(errors({"--gain", "2,2,2"}), "--gains"));
  EXPECT_TRUE(contains(errors({"--pulses", "--gains", "2,2,2"}), "position_gain_per_s"));
  EXPECT_EQ(leadscrew(folder, {"simulate", "nothing.ngc"}).status, 4);
  EXPECT_EQ(leadscrew(folder, {"simulate", "part.ngc", "--machine", "nothing.toml"}).status, 4);
}

TEST(Simulate, EndsWhereALoopIsNotStable) {
  const Folder folder;
  folder.write("part.ngc", square);
  const auto outcome = leadscrew(folder, {"simulate", "part.ngc", "--gains", "5000,0,0", "--trace", "t.csv"});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_TRUE(contains(outcome.errors, "servo-unstable")) << outcome.errors;
  EXPECT_EQ(folder.names(), (Names{"part.ngc"}));
}

/// Held within a limit cycle by what torque there is, it would look like a small error.
TEST(Simulate, RefusesALoopThatIsNotStableBeforeAnythingMoves) {
  const Folder folder;
  folder.write("part.ngc", square);
  std::ifstream drives(source_folder / "machines/mill3-drives.toml");
  std::string machine{std::istreambuf_iterator<char>(drives), {}};
  const std::string key = "velocity_gain_per_s";
  const std::size_t at = machine.find(key);
  ASSERT_NE(at, std::string::npos);
  machine.replace(at, machine.find('\n', at) - at, key + " = 5000");
  folder.write("mill.toml", machine);
  for (const std::string command : {"simulate", "drive"}) {
    const auto outcome = leadscrew(folder, {command, "part.ngc", "--machine", "mill.toml"});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_TRUE(contains(outcome.errors, "is not stable")) << outcome.errors;
    EXPECT_TRUE(contains(outcome.errors, "[servo-unstable]")) << outcome.errors;
  }
}

/// Words as of `run`, slides beside them, on until they stand.
TEST(Simulate, WritesWordsAndSlides) {
  const Folder folder;
  const Json figures = simulated(folder, square, {"--trace", "t.csv"});
  leadscrew(folder, {"run", "part.ngc", "--trace", "words.csv"});
  std::istringstream rows(folder.read("t.csv")), words(folder.read("words.csv"));
  std::string row, word;
  std::getline(rows, row);
  std::getline(words, word);
  EXPECT_EQ(row, word +
                     ",actual_X,actual_Y,actual_Z,velocity_X,velocity_Y,velocity_Z,control_X,control_Y,control_Z,"
                     "current_X,current_Y,current_Z");
  double greatest = 0;
  int count = 0;
  for (; std::getline(rows, row); ++count) {
    if (std::getline(words, word)) {
      EXPECT_EQ(row.substr(0, word.size()), word);
    }
    std::vector<double> cells;
    std::istringstream stream(row);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(std::stod(cell));
    ASSERT_EQ(cells.size(), 19u);
    greatest = std::max(greatest, std::fabs(cells[4] - cells[7]));
  }
  EXPECT_EQ(greatest, figures["axes"][0]["following_max_mm"]);
  EXPECT_GT(count, figures["words"].get<int>() + 1);
  EXPECT_EQ(leadscrew(folder, {"verify", "t.csv", "part.ngc"}).status, 0);
}

using Row = std::map<std::string, double>;

std::vector<Row> rows_of(const std::string& text) {
  std::istringstream lines(text);
  std::string line, cell;
  std::vector<std::string> names;
  std::getline(lines, line);
  for (std::istringstream cells(line); std::getline(cells, cell, ',');) names.push_back(cell);
  std::vector<Row> rows;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    Row& row = rows.emplace_back();
    for (const std::string& name : names) {
      std::getline(cells, cell, ',');
      row[name] = std::stod(cell);
    }
  }
  return rows;
}

/// A drive with a velocity loop of its own obeys v′ = (K·u − v)/τ, and its motor's current gives v′: for a millisecond under
/// a constant u the velocity goes the share 1 − e^(−T/τ) of the way to K·u. On until it stands.
TEST(Simulate, TracesTachometersControlSignalsAndCurrents) {
  const Folder folder;
  folder.write("m.toml", proportional_machine(20, 25));
  simulated(folder, "G21 G90\nG1 X6 Y3 F1200\nM2\n", {"--machine", "m.toml", "--trace", "t.csv"}, 1);
  const std::vector<Row> rows = rows_of(folder.read("t.csv"));
  const double gain = 10, time_constant = 0.005, share = 1 - std::exp(-0.001 / time_constant);
  double greatest = 0;
  for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
    Row row = rows[k], next = rows[k + 1];
    for (const std::string axis : {"X", "Y"}) {
      const double v = row["velocity_" + axis], u = row["control_" + axis];
      EXPECT_NEAR(next["velocity_" + axis], v + share * (gain * u - v), 1e-9);
      EXPECT_NEAR(row["current_" + axis], (gain * u - v) / time_constant, 1e-6);
    }
    const double wanted = 20.0 / gain * (row["X"] - row["actual_X"]);
    EXPECT_NEAR(row["control_X"], wanted, 2.0 * 1e-5);  // an encoder of 10 nm
    greatest = std::max(greatest, row["velocity_X"]);
  }
  EXPECT_GT(greatest, 15);
  EXPECT_LT(std::fabs(Row(rows.back())["velocity_X"]), 0.05);
}

/// Pulses: the counter drives the motor, v′ = (Kv·UDC − v)/τ with τ = 1/(4·Kv), of steps of 1 µm. In an array as well, which
/// the referee reads.
TEST(Simulate, TracesTheCountersOfPulseDrivenLoops) {
  const Folder folder;
  folder.write("m.toml", with_screw("drive.position_gain_per_s = 25\n"));
  simulated(folder, "G21 G90\nG1 X5 F600\nM2\n", {"--pulses", "--machine", "m.toml", "--trace", "t.csv"});
  double greatest = 0;
  for (Row row : rows_of(folder.read("t.csv"))) {
    const double count = row["control_X"];
    EXPECT_EQ(count, std::round(count));
    EXPECT_NEAR(row["current_X"], 4 * 25 * (25 * count * 1e-3 - row["velocity_X"]), 1e-9);
    greatest = std::max(greatest, count);
  }
  EXPECT_NEAR(greatest, 10e3 / 25, 2);
  simulated(folder, "G21 G90\nG1 X5 F600\nM2\n", {"--trace", "t.npy"});
  EXPECT_EQ(leadscrew(folder, {"verify", "t.npy", "part.ngc"}).status, 0);
}

TEST(Simulate, ReportsSlides) {
  const Folder folder;
  simulated(folder, square, {"--report", "r.html"});
  const std::string page = folder.read("r.html");
  EXPECT_TRUE(contains(page, "The part as it is made"));
  EXPECT_TRUE(contains(page, "<b>contour error</b>"));
  EXPECT_TRUE(contains(page, "<b>tachometer</b>"));
  EXPECT_TRUE(contains(page, "<b>control signal</b>"));
  EXPECT_TRUE(contains(page, "<b>motor current</b>"));
  EXPECT_TRUE(contains(page, "class=\"actual by2\""));
  EXPECT_TRUE(contains(page, "Keeps every limit"));
}

TEST(Simulate, ShowsThePlayOfAScrew) {
  const Folder folder;
  folder.write("m.toml", with_screw("backlash_mm = 0.03\n"));
  const Json figures = simulated(folder, square, {"--machine", "m.toml"}, 1);
  EXPECT_NEAR(figures["axes"][0]["following_max_mm"], 0.015, 0.005);
  EXPECT_LT(figures["axes"][1]["following_max_mm"], 0.01);
}

/// Its encoder's counts lie where they lie: ends between them are ends all the same.
TEST(Simulate, RestsAtEndsBetweenTwoCounts) {
  const Folder folder;
  for (const char* end : {"31.12345", "31.1234", "31.12349", "7.00005"}) {
    folder.write("part.ngc", std::string("G21 G90 F3000\nG1 X") + end + " Y" + end + "\nM2\n");
    const auto outcome = leadscrew(folder, {"simulate", "part.ngc", "--json"});
    EXPECT_EQ(outcome.status, 0) << end << outcome.errors;
    EXPECT_FALSE(outcome.json()["settling_s"].is_null()) << end;
  }
}

TEST(Simulate, StopsWhenInterrupted) {
  const Folder folder;
  folder.write("part.ngc", long_program(200000));
  Running running(folder, {"simulate", "part.ngc", "--trace", "t.csv"});
  ASSERT_TRUE(eventually([&] { return running.handles(SIGINT); }));
  ASSERT_TRUE(eventually([&] { return folder.names().size() > 1; }));  // its trace is being written
  running.send(SIGINT);
  EXPECT_EQ(running.wait().status, 130);
  EXPECT_EQ(folder.names(), (Names{"part.ngc"}));
}

struct BadDrive {
  const char* name;
  std::string lines;
  Names problems;  ///< "line:column code"

  friend void PrintTo(const BadDrive& bad, std::ostream* stream) { *stream << bad.name; }
};

class RejectedDrive : public ::testing::TestWithParam<BadDrive> {};

TEST_P(RejectedDrive, IsNamedWithItsPlace) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("m.toml", with_screw("[axis.X.drive]\n" + GetParam().lines));
  const Json object = leadscrew(folder, {"simulate", "part.ngc", "--machine", "m.toml", "--json"}).json();
  const Names found = places_of(object["diagnostics"]);
  EXPECT_EQ(found, GetParam().problems);
}

INSTANTIATE_TEST_SUITE_P(Every, RejectedDrive,
                         ::testing::Values(BadDrive{"Zero", "gain_mm_s = 0\n", {"13:13 machine-drive"}},
                                           BadDrive{"NotFinite", "time_constant_ms = nan\n", {"13:20 machine-drive"}},
                                           BadDrive{"Share", "velocity_forward = 1.5\n", {"13:20 machine-drive"}},
                                           BadDrive{"Negative",
                                                    "friction_mm_s2 = -1\ncommand_limit = -1\n",
                                                    {"13:18 machine-drive", "14:17 machine-drive"}},
                                           BadDrive{"Controller", "controller = \"pdi\"\n", {"13:14 machine-drive"}},
                                           BadDrive{"NoWord", "encoder = 3\n", {"13:11 machine-drive"}},
                                           BadDrive{"NoNumber", "damping_per_s = \"1\"\n", {"13:17 machine-type"}},
                                           BadDrive{"KeyOfRotaryAxis", "gain_deg_s = 1\n", {"13:1 machine-key"}}),
                         [](const auto& bad) { return std::string(bad.param.name); });

TEST(DriveKeys, AreSuggested) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("m.toml", with_screw("drive.time_constant = 20\n"));
  EXPECT_TRUE(contains(leadscrew(folder, {"check", "part.ngc", "--machine", "m.toml"}).errors,
                       "did you mean time_constant_ms?"));
  folder.write("m.toml", with_screw("drive = 20\n"));
  EXPECT_TRUE(contains(leadscrew(folder, {"check", "part.ngc", "--machine", "m.toml"}).errors, "[axis.X.drive]"));
}

/// Both feeds are the tip's, though slides go twice as fast to lead it round with the table.
TEST(Simulate, MeasuresTheFeedThatWordsTell) {
  const Folder folder;
  const std::string machine = (source_folder / "machines/table-table-ac.toml").string();
  const std::string leading = "G21 G90 G61\nG43.4\nG1 X40 F1200\nG93 G1 X35 C90 F40\nM2\n";
  const Json fed = simulated(folder, leading, {"--machine", machine});
  EXPECT_NEAR(fed["feed"]["commanded_max_mm_s"], 20, 1e-6);
  EXPECT_NEAR(fed["feed"]["measured_max_mm_s"], 20, 0.4);
  // C alone: no feed of the tip.
  const Json standing = simulated(folder, "G21 G90 G61\nG43.4\nG1 C90 F3000\nM2\n", {"--machine", machine});
  EXPECT_LT(standing["feed"]["commanded_max_mm_s"], 1e-6);
  EXPECT_LT(standing["feed"]["measured_max_mm_s"], 0.1);
}

}  // namespace test_simulate
}  // namespace leadscrew::cli::testing
