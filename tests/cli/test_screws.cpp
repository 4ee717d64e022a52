// Steps that make good the errors of lead screws, judged on screws of the tests' own.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_screws {

/// Errors over commands, straight between entries; mm.
using Table = std::vector<std::pair<double, double>>;

std::string text_of(const Table& table) {
  std::ostringstream text;
  text.precision(17);
  for (const auto& [position, error] : table) text << "[" << position << ", " << error << "], ";
  return "[" + text.str() + "]\n";
}

double real(const Table& table, double command) {
  if (table.empty()) return command;
  if (command <= table.front().first) return command + table.front().second;
  for (std::size_t k = 1; k < table.size(); ++k) {
    const auto [from, error] = table[k - 1];
    const auto [to, next_error] = table[k];
    if (command <= to) return command + error + (next_error - error) * (command - from) / (to - from);
  }
  return command + table.back().second;
}

/// By bisection.
double command_for(const Table& table, double position) {
  double low = position - 10, high = position + 10;
  for (int halvings = 0; halvings < 80; ++halvings) {
    const double middle = (low + high) / 2;
    (real(table, middle) < position ? low : high) = middle;
  }
  return low;
}

/// A row of a trace, or a step.
struct At {
  double t;
  double x;  ///< mm; of a step its displacement
};

std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  std::istringstream stream(row);
  for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
  return cells;
}

std::vector<At> words_of(const std::string& csv) {
  std::istringstream rows(csv);
  std::string row;
  std::getline(rows, row);
  const auto names = cells_of(row);
  const auto x = static_cast<std::size_t>(std::find(names.begin(), names.end(), "X") - names.begin());
  std::vector<At> words;
  while (std::getline(rows, row)) words.push_back({std::stod(cells_of(row)[0]), std::stod(cells_of(row)[x])});
  return words;
}

std::vector<At> steps_of(const std::string& csv) {
  std::istringstream rows(csv);
  std::string row;
  std::getline(rows, row);
  std::vector<At> steps;
  while (std::getline(rows, row)) {
    const auto cells = cells_of(row);
    if (cells[2] == "X") steps.push_back({std::stod(cells[1]), 0.001 * std::stod(cells[3])});
  }
  return steps;
}

/// Where straight lines between words are.
double position_at(const std::vector<At>& words, double t) {
  const auto after = std::upper_bound(words.begin(), words.end(), t, [](double now, At word) { return now < word.t; });
  if (after == words.end()) return words.back().x;
  const At before = *std::prev(after);
  return before.x + (after->x - before.x) * (t - before.t) / (after->t - before.t);
}

struct Travelled {
  Outcome outcome;
  std::vector<At> words, steps;

  /// Of all steps together, BLU.
  std::int64_t displacement() const {
    double displacement = 0;
    for (const At step : steps) displacement += step.x / 0.001;
    return std::llround(displacement);
  }
};

Travelled travel(const Folder& folder, const std::string& program, const std::string& screw,
                 const std::vector<std::string>& more = {}) {
  folder.write("part.ngc", program);
  folder.write("m.toml", with_screw(screw));
  std::vector<std::string> words = {"run",   "part.ngc", "--machine", "m.toml", "--pulses",
                                    "p.csv", "--trace",  "t.csv",     "--json"};
  words.insert(words.end(), more.begin(), more.end());
  Travelled travelled{leadscrew(folder, words), {}, {}};
  EXPECT_EQ(travelled.outcome.status, 0) << travelled.outcome.errors;
  travelled.words = words_of(folder.read("t.csv"));
  travelled.steps = steps_of(folder.read("p.csv"));
  return travelled;
}

const Table bent = {{-20, 0.05}, {-5, -0.04}, {0, 0.02}, {4, 0.06}, {12, 0.02}, {40, -0.1}};

/// No play: at every instant the command is that of the words, but for half a BLU, a tick of the clock (0.05 BLU), what
/// straight lines between words leave of the motion (1000 mm/s²·T²/8, 0.125 BLU) and of the table's bends (0.22 BLU).
TEST(StepsOnBentScrews, LeadWhereWordsAre) {
  const Folder folder;
  const auto [outcome, words, steps] = travel(folder, "G21 G90 F3000\nG1 X30\nX-15 Y4\nX7.3\nM2\n",
                                              "pitch_errors_mm = " + text_of(bent), {"--start", "X-2"});
  const double start = std::round(command_for(bent, -2) / 0.001) * 0.001;
  double command = start, largest = 0;
  for (const At step : steps) {
    const double wanted = command_for(bent, position_at(words, step.t));
    for (const double x : {command, command + step.x}) largest = std::max(largest, std::fabs(x - wanted));
    command += step.x;
  }
  EXPECT_LT(largest, 0.001);
  EXPECT_NEAR(command, command_for(bent, 7.3), 0.0005 + 1e-9);
  EXPECT_NEAR(real(bent, command), 7.3, 0.0006);
  const Json compensation = outcome.json()["pulses"]["compensation"];
  ASSERT_EQ(compensation.size(), 1u);
  EXPECT_EQ(compensation[0]["name"], "X");
  double greatest = 0;
  for (const At word : words) greatest = std::max(greatest, std::fabs(command_for(bent, word.x) - word.x));
  EXPECT_NEAR(compensation[0]["greatest_correction_mm"].get<double>(), greatest, 1e-9);
}

/// Both directions have their own table: where axes end depends on from where they came.
TEST(StepsOnBentScrews, KnowTheWayTheAxisRuns) {
  Table back = bent;
  for (auto& [position, error] : back) error += 0.07;
  const std::string screw = "pitch_errors_mm = " + text_of(bent) + "pitch_errors_backward_mm = " + text_of(back);
  const Folder folder;
  const double start = std::round(command_for(bent, 0) / 0.001);
  const auto forward = travel(folder, "G21 G90 F3000\nG1 X7.3\nM2\n", screw);
  EXPECT_EQ(start + static_cast<double>(forward.displacement()), std::round(command_for(bent, 7.3) / 0.001));
  const auto backward = travel(folder, "G21 G90 F3000\nG1 X11\nX7.3\nM2\n", screw);
  EXPECT_EQ(start + static_cast<double>(backward.displacement()), std::round(command_for(back, 7.3) / 0.001));
}

/// The nut of a screw with play, moved step by step.
class Nut {
 public:
  explicit Nut(double play) : play_(play) {}
  void move(double displacement) {
    screw_ += displacement;
    at_ = std::clamp(at_, screw_, screw_ + play_);
  }
  double at() const { return at_; }

 private:
  double play_, screw_ = 0, at_ = 0;
};

/// 0.1 mm at 5 mm/s and 1000 mm/s²: 20 ms and twice 5 ms of speeding up, and the turn itself.
TEST(Backlash, IsTakenUpAfterATurn) {
  const Folder folder;
  const auto [outcome, words, steps] =
      travel(folder, "G21 G90 F1200\nG1 X10\nX4\nX6\nM2\n", "backlash_mm = 0.1\nbacklash_takeup_mm_s = 5\n");
  std::vector<double> turns;
  for (std::size_t k = 2; k < words.size(); ++k) {
    if ((words[k].x - words[k - 1].x) * (turns.size() % 2 == 0 ? 1 : -1) < -1e-6) turns.push_back(words[k].t);
  }
  ASSERT_EQ(turns.size(), 2u);
  Nut nut(0.1);
  double largest = 0, largest_lag = 0;
  for (const At step : steps) {
    const double lag = std::fabs(nut.at() - position_at(words, step.t));
    const bool is_taken_up =
        std::none_of(turns.begin(), turns.end(), [&](double turn) { return turn <= step.t && step.t < turn + 0.05; });
    (is_taken_up ? largest : largest_lag) = std::max(is_taken_up ? largest : largest_lag, lag);
    nut.move(step.x);
  }
  EXPECT_LT(largest, 0.001);
  EXPECT_LT(largest_lag, 0.1);
  EXPECT_GT(largest_lag, 0.01);
  EXPECT_NEAR(nut.at(), 6, 0.0005 + 1e-9);
  const Json report = outcome.json();
  EXPECT_NEAR(report["pulses"]["compensation"][0]["greatest_correction_mm"].get<double>(), 0.1, 1e-12);
}

/// The last turn leaves 0.02 mm of motion for 0.3 mm of play at 1 mm/s.
TEST(Backlash, IsTakenUpAfterTheLastWord) {
  const Folder folder;
  const auto [outcome, words, steps] =
      travel(folder, "G21 G90 F1200\nG1 X5\nX4.98\nM2\n", "backlash_mm = 0.3\nbacklash_takeup_mm_s = 1\n");
  Nut nut(0.3);
  for (const At step : steps) nut.move(step.x);
  EXPECT_NEAR(nut.at(), 4.98, 0.0005 + 1e-9);
  const Json report = outcome.json();
  EXPECT_GT(report["pulses"]["time_s"].get<double>(), report["time_s"].get<double>() + 0.15);
}

const std::string worn = "pitch_errors_mm = [[-100, 0], [0, -10]]\nbacklash_mm = 0.02\n";

/// Words are real positions, and what judges them sees no screw.
TEST(ScrewErrors, DoNotChangeWords) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("m.toml", machine_text());
  const auto ideal = leadscrew(folder, {"run", "part.ngc", "--machine", "m.toml", "--trace", "ideal.csv", "--json"});
  ASSERT_EQ(ideal.status, 0);
  const auto travelled = travel(folder, square, worn);
  EXPECT_TRUE(folder.read("t.csv") == folder.read("ideal.csv"));
  EXPECT_EQ(travelled.outcome.json()["axes"], ideal.json()["axes"]);
  EXPECT_EQ(travelled.outcome.json()["deviation_mm"], ideal.json()["deviation_mm"]);
}

TEST(ScrewErrors, StandInTheSummary) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("m.toml",
               with_screw("backlash_mm = 0.02\n") +
                   "[axis.B]\ntravel_deg = [-90, 90]\nmax_velocity_deg_s = 90\nmax_acceleration_deg_s2 = 500\n"
                   "max_jerk_deg_s3 = 5000\nblu_deg = 0.001\npitch_errors_deg = [[-90, 0.5]]\n");
  const auto run = leadscrew(folder, {"run", "part.ngc", "--machine", "m.toml", "--pulses", "p.csv"});
  EXPECT_EQ(run.status, 0) << run.errors;
  const std::string text = run.output + run.errors;
  EXPECT_TRUE(contains(text, "screws     made good by up to 0.02 mm in X, 0.5 degrees in B\n")) << text;
  EXPECT_TRUE(contains(text, "BLU of the compensated words")) << text;
}

/// Commands are up to 1/0.9 as fast as words: too fast for a clock that just gives 200 mm/s.
TEST(ScrewErrors, CountWhereTheClockIsJudged) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("ideal.toml", machine_text());
  folder.write("worn.toml", with_screw(worn));
  const auto at_400_khz = [&](const char* machine) {
    return leadscrew(folder, {"run", "part.ngc", "--machine", machine, "--pulses", "p.csv", "--step-clock", "400kHz"});
  };
  EXPECT_EQ(at_400_khz("ideal.toml").status, 0);
  const auto run = at_400_khz("worn.toml");
  EXPECT_EQ(run.status, 3);
  EXPECT_TRUE(contains(run.errors, "[step-rate]")) << run.errors;
}

TEST(ScrewErrors, AreRefusedForInterpolatorsOfBlocks) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("m.toml", with_screw(worn));
  for (const char* method : {"koren", "dda", "bresenham"}) {
    const auto run = leadscrew(
        folder, {"run", "part.ngc", "--machine", "m.toml", "--pulses", "p.csv", "--pulse-method", method, "--json"});
    EXPECT_EQ(run.status, 3);
    const Json diagnostics = run.json()["diagnostics"];
    ASSERT_EQ(diagnostics.size(), 1u) << run.errors;
    EXPECT_EQ(diagnostics[0]["code"], "pulse-compensation");
    EXPECT_TRUE(contains(diagnostics[0]["message"].get<std::string>(), method));
  }
  EXPECT_EQ(folder.names(), (Names{"m.toml", "part.ngc"}));
  EXPECT_EQ(leadscrew(folder, {"run", "part.ngc", "--machine", "m.toml"}).status, 0);
}

}  // namespace test_screws
}  // namespace leadscrew::cli::testing
