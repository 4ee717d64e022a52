#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "command.hpp"
#include "value_changes.hpp"

// run --pulses: steps as files, summed by readers that know nothing of what wrote them.

namespace leadscrew::cli::testing {
namespace test_steps {

/// Where the steps of a CSV lead, BLU, by axis; ticks must not fall.
std::map<std::string, std::int64_t> ends_of_rows(const std::string& text) {
  std::map<std::string, std::int64_t> ends;
  std::istringstream rows(text);
  std::string row;
  std::getline(rows, row);
  EXPECT_EQ(row, "tick,t,axis,direction");
  std::int64_t last = -1;
  while (std::getline(rows, row)) {
    std::istringstream cells(row);
    std::string tick, time, axis, direction;
    std::getline(cells, tick, ',');
    std::getline(cells, time, ',');
    std::getline(cells, axis, ',');
    std::getline(cells, direction, ',');
    const std::int64_t now = std::stoll(tick);
    EXPECT_GE(now, last);
    last = now;
    ends[axis] += std::stoll(direction);
  }
  return ends;
}

const std::string bracket =
    "G21 G90 G94 G17 F1200\nG1 X10\nG3 X15 Y5 J5\nG1 X15.0004 Y20.2506 Z-1.5\nG2 X10.0004 Y20.2506 I-2.5\nM2\n";

class Stepped : public ::testing::TestWithParam<const char*> {};

TEST_P(Stepped, LeadToTheProgrammedEnd) {
  Folder folder;
  folder.write("part.ngc", bracket);
  std::vector<std::string> words = {"run", "part.ngc", "--pulses", "steps.csv", "--json"};
  if (*GetParam() != '\0') words.insert(words.end(), {"--pulse-method", GetParam()});
  const Outcome outcome = leadscrew(folder, words);
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const auto ends = ends_of_rows(folder.read("steps.csv"));
  EXPECT_EQ(ends.at("X"), 10000);
  EXPECT_EQ(ends.at("Y"), 20251);
  EXPECT_EQ(ends.at("Z"), -1500);
  const Json pulses = outcome.json()["pulses"];
  EXPECT_EQ(pulses["method"], *GetParam() != '\0' ? GetParam() : "words");
  EXPECT_EQ(pulses["clock_hz"], 1'000'000);
  if (pulses["method"] == "words") {
    EXPECT_LT(pulses["error_blu"], 1);
  }
}

INSTANTIATE_TEST_SUITE_P(Every, Stepped,
                         ::testing::Values("", "koren", "dda", "point-comparison", "min-error", "improved-min-error",
                                           "bresenham"));

/// Steps of a signal pair: rising edges, each in the direction that the other signal then shows.
std::int64_t end_of_signals(Dump& dump, const std::string& axis) {
  Dump::Signal &steps = dump.signals.at("steps." + axis + "_step"),
               &direction = dump.signals.at("steps." + axis + "_dir");
  std::int64_t end = 0;
  for (const auto& [time, value] : steps.changes) {
    if (value != 0) end += direction.at(time) != 0 ? 1 : -1;
  }
  return end;
}

TEST(StepsOfRun, AreRowsWhateverTheCaseOfTheEnding) {
  Folder folder;
  folder.write("part.ngc", bracket);
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--pulses", "steps.CSV"}).status, 0);
  EXPECT_EQ(ends_of_rows(folder.read("steps.CSV")).at("X"), 10000);
}

/// A drive asks for a time to hold the direction after a step, and one to set it up before the next.
TEST(StepsOfRun, LeaveTheTimeToTurnWhateverTheMethod) {
  Folder folder;
  folder.write("part.ngc", "G21 G90 G61 G0 X1\nX0\nX1\nX0\nM2\n");
  const Outcome outcome = leadscrew(
      folder, {"run", "part.ngc", "--pulses", "steps.csv", "--pulse-method", "koren", "--step-clock", "1MHz"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  std::istringstream rows(folder.read("steps.csv"));
  std::string row;
  std::getline(rows, row);
  std::int64_t last = -1000, closest = 1000;
  while (std::getline(rows, row)) {
    const std::int64_t now = std::stoll(row);
    closest = std::min(closest, now - last);
    last = now;
  }
  EXPECT_GE(closest, 3);  // µs: step length, hold and setup
}

TEST(StepsOfRun, SayWhoseTimeAndLimitsAreTold) {
  Folder folder;
  folder.write("part.ngc", bracket);
  const Outcome outcome = leadscrew(folder, {"run", "part.ngc", "--pulses", "steps.csv", "--pulse-method", "koren"});
  EXPECT_NE(outcome.output.find("those of the words"), std::string::npos) << outcome.output;
}

TEST(StepsOfRun, AreSignalsOfDrives) {
  Folder folder;
  folder.write("part.ngc", bracket);
  for (const std::vector<std::string>& more : {std::vector<std::string>{}, {"--pulse-method", "dda", "--accelerate"}}) {
    std::vector<std::string> words = {"run", "part.ngc", "--quiet", "--pulses", "steps.vcd", "--step-clock", "2MHz"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = leadscrew(folder, words);
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    Dump dump = read_dump(folder.read("steps.vcd"));
    EXPECT_EQ(dump.timescale, "1 ns");
    EXPECT_EQ(end_of_signals(dump, "X"), 10000);
    EXPECT_EQ(end_of_signals(dump, "Y"), 20251);
    EXPECT_EQ(end_of_signals(dump, "Z"), -1500);
  }
}

/// As traces, reports and pictures are.
TEST(StepsOfRun, AreWrittenOfEachOfSeveralPrograms) {
  Folder folder;
  folder.write("a.ngc", bracket);
  folder.write("b.ngc", "G21 G90 G1 X-2 Y1 F600\nM2\n");
  Outcome outcome = leadscrew(folder, {"run", "a.ngc", "b.ngc", "--out", "made", "--pulses", "csv", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(ends_of_rows(folder.read("made/a.steps.csv")).at("Y"), 20251);
  EXPECT_EQ(ends_of_rows(folder.read("made/b.steps.csv")).at("X"), -2000);
  EXPECT_EQ(folder.names(), (Names{"a.ngc", "b.ngc", "made", "made/a.csv", "made/a.html", "made/a.steps.csv",
                                   "made/a.svg", "made/b.csv", "made/b.html", "made/b.steps.csv", "made/b.svg"}));
  outcome = leadscrew(
      folder, {"run", "a.ngc", "b.ngc", "--out", "other", "--pulses", "vcd", "--pulse-method", "dda", "--quiet"});
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  Dump dump = read_dump(folder.read("other/b.steps.vcd"));
  EXPECT_EQ(end_of_signals(dump, "X"), -2000);
  EXPECT_EQ(end_of_signals(dump, "Y"), 1000);
}

TEST(StepsOfRun, AreOfAFormatInAnyCase) {
  Folder folder;
  folder.write("a.ngc", "G21 G90 G1 X-2 Y1 F600\nM2\n");
  folder.write("b.ngc", "G21 G90 G1 X1 F600\nM2\n");
  for (const char* format : {"VCD", "Csv"}) {
    const Outcome outcome =
        leadscrew(folder, {"run", "a.ngc", "b.ngc", "--out", "made", "--pulses", format, "--quiet"});
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
  }
  Dump dump = read_dump(folder.read("made/a.steps.vcd"));
  EXPECT_EQ(end_of_signals(dump, "X"), -2000);
  EXPECT_EQ(ends_of_rows(folder.read("made/b.steps.csv")).at("X"), 1000);
  EXPECT_EQ(leadscrew(folder, {"run", "a.ngc", "--out", "made", "--pulses", "VCDs"}).status, 2);
}

/// What cannot be stepped has no files; the others have theirs.
TEST(StepsOfRun, OfSeveralProgramsAreRefusedForEach) {
  Folder folder;
  folder.write("slow.ngc", "G21 G90 G1 X1 F60\nM2\n");
  folder.write("fast.ngc", "G21 G90 G1 X1 F6000\nM2\n");
  const Outcome outcome = leadscrew(folder, {"run", "fast.ngc", "slow.ngc", "--out", "made", "--pulses", "vcd",
                                             "--pulse-method", "koren", "--step-clock", "10kHz"});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.errors.find("fast.ngc:1:1: error: pulses:"), std::string::npos) << outcome.errors;
  EXPECT_EQ(folder.names(), (Names{"fast.ngc", "slow.ngc", "made", "made/slow.csv", "made/slow.html", "made/slow.svg",
                                   "made/slow.steps.vcd"}));
}

const std::vector<std::string> by_koren = {"run", "part.ngc", "--pulses", "steps.vcd", "--pulse-method", "koren"};

TEST(StepsOfRun, AreRefusedWithTheLineAndACaretUnderTheBlock) {
  Folder folder;
  folder.write("part.ngc", "G21 G90 G61\n  G1 X10 F13000\nM2\n");
  const Outcome outcome = leadscrew(folder, by_koren);
  EXPECT_EQ(outcome.status, 3);
  EXPECT_TRUE(contains(outcome.errors, "part.ngc:2:3: error: pulses: the feed asks for ")) << outcome.errors;
  EXPECT_TRUE(contains(outcome.errors, "\n      G1 X10 F13000\n      ^\n    hint: ")) << outcome.errors;
}

/// Line 8 turns A five times as fast as it can.
TEST(StepsOfRun, ThatAnAxisCannotMakeAreRefusedOrShaped) {
  Folder folder;
  std::filesystem::copy(source_folder / "examples" / "07-rotary.ngc", folder.path() / "part.ngc");
  std::vector<std::string> words = by_koren;
  words.insert(words.end(), {"--quiet", "--machine", source_folder / "machines" / "mill6.toml"});
  const Outcome outcome = leadscrew(folder, words);
  EXPECT_EQ(outcome.status, 3);
  EXPECT_TRUE(contains(outcome.errors,
                       "part.ngc:8:1: error: pulses: the feed asks for 226385 a second, axis A allows "
                       "90554 a second [pulse-velocity]\n    X40 A540 F1500\n"))
      << outcome.errors;
  EXPECT_TRUE(contains(outcome.errors, "hint: program a lower feed, or give --accelerate: "));
  words.push_back("--accelerate");
  EXPECT_EQ(leadscrew(folder, words).status, 0);
}

/// Both kinds in one run, in either form.
TEST(StepsOfRun, AreRefusedBesideWhatElseIsWrongWithTheProgram) {
  Folder folder;
  folder.write("part.ngc", "G21 G90 G61 F13000\nG1 X10\nG1 X[1/0]\n G1 Y10\nX900\nM2\n");
  std::vector<std::string> words = by_koren;
  words.push_back("--json");
  const Outcome outcome = leadscrew(folder, words);
  EXPECT_EQ(outcome.status, 3);
  const Json diagnostics = outcome.json()["diagnostics"];
  EXPECT_EQ(places_of(diagnostics),
            (Names{"2:1 pulse-velocity", "3:7 division-by-zero", "4:2 pulse-velocity", "5:1 travel"}));
  for (const Json& problem : diagnostics) EXPECT_EQ(problem["file"], "part.ngc");
  EXPECT_EQ(folder.names(), Names{"part.ngc"});
}

/// As many as the reader tells, and once that there are more.
TEST(StepsOfRun, AreRefusedAHundredTimesAtMost) {
  Folder folder;
  std::string fast = "G21 G90 G61 F13000\n", worse = fast;
  for (int i = 0; i < 150; ++i) fast += i % 2 == 0 ? "G1 X1\n" : "G1 X0\n";
  for (int i = 0; i < 150; ++i) worse += "G1 X[1/0]\n";
  std::vector<std::string> words = by_koren;
  words.push_back("--json");
  folder.write("part.ngc", fast + "M2\n");
  Json diagnostics = leadscrew(folder, words).json()["diagnostics"];
  ASSERT_EQ(diagnostics.size(), 101u);
  EXPECT_EQ(diagnostics[99]["code"], "pulse-velocity");
  EXPECT_EQ(diagnostics[100]["code"], "too-many-problems");
  folder.write("part.ngc", worse + "G1 X1\nM2\n");
  diagnostics = leadscrew(folder, words).json()["diagnostics"];
  ASSERT_EQ(diagnostics.size(), 101u);
  EXPECT_EQ(diagnostics[100]["code"], "too-many-problems");
}

struct Refused {
  std::vector<std::string> words;
  int status;
  std::string says;
};

class RefusedSteps : public ::testing::TestWithParam<Refused> {};

TEST_P(RefusedSteps, LeaveNoFile) {
  Folder folder;
  folder.write("part.ngc", bracket);
  std::vector<std::string> words = {"run", "part.ngc"};
  words.insert(words.end(), GetParam().words.begin(), GetParam().words.end());
  const Outcome outcome = leadscrew(folder, words);
  EXPECT_EQ(outcome.status, GetParam().status);
  EXPECT_NE(outcome.errors.find(GetParam().says), std::string::npos) << outcome.errors;
  EXPECT_EQ(folder.names(), Names{"part.ngc"});
}

INSTANTIATE_TEST_SUITE_P(
    Every, RefusedSteps,
    ::testing::Values(
        Refused{{"--pulses", "steps.txt"}, 2, "ends in neither .vcd nor .csv"},
        Refused{{"--pulse-method", "dda"}, 2, "--pulses FILE"},
        Refused{{"--pulses", "--quiet"}, 2, "--pulses --quiet: is no file's name"},
        Refused{{"--pulses", "part.ngc/steps.vcd"}, 4, "part.ngc: error: cannot make the folder"},
        Refused{{"--report", "--json"}, 2, "--report --json: is no file's name"},
        Refused{{"--pulses", "vcd"}, 2, "--pulses vcd: names a format beside --out DIR"},
        Refused{{"other.ngc", "--pulses", "steps.vcd"}, 2, "--out DIR --pulses vcd, or csv, writes"},
        Refused{{"other.ngc", "--pulses", "steps.vcd", "--out", "made"}, 2, "is for one program"},
        Refused{
            {"part.steps.ngc", "--pulses", "csv", "--out", "made"}, 2, "two programs would write made/part.steps.csv"},
        Refused{{"--pulses", "steps.csv", "--accelerate"}, 2, "--pulse-method"},
        Refused{{"--pulses", "steps.csv", "--pulse-method", "dad"}, 2, "did you mean dda?"},
        Refused{{"--pulses", "steps.csv", "--step-clock", "5kHz"}, 2, "outside 10kHz to 10MHz"},
        Refused{{"--pulses", "steps.csv", "--step-clock", "10kHz"}, 3, "step-rate"},
        Refused{{"--pulses", "steps.csv", "--step-clock", "10kHz", "--pulse-method", "koren"}, 3, "pulse-"}));

/// Some 10⁸ turns: to plan them would take minutes, before the first of them is travelled.
TEST(StepsInterrupt, EndsPlanning) {
  const Folder folder;
  std::string text = "G21 G61 F1200\n";
  for (int i = 0; i < 2000; ++i) text += "G3 X0 Y0 I10 P100000\n";
  folder.write("part.ngc", text + "M2\n");
  Running running(folder, {"run", "part.ngc", "--pulses", "steps.csv", "--pulse-method", "koren"});
  ASSERT_TRUE(eventually([&] { return running.handles(SIGINT); }));
  running.send(SIGINT);
  const Outcome outcome = running.wait();
  EXPECT_EQ(outcome.status, 130);
  EXPECT_EQ(folder.names(), Names{"part.ngc"});
}

}  // namespace test_steps
}  // namespace leadscrew::cli::testing
