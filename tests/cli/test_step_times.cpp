// Times of step and direction signals: from machine files and options to the edges of what is written.

#include <gtest/gtest.h>

#include <array>
#include <ostream>

#include "command.hpp"
#include "value_changes.hpp"

namespace leadscrew::cli::testing {
namespace test_step_times {

using Words = std::vector<std::string>;

/// Back and forth, in lines and a circle.
const std::string turning = "G21 G90 G61.1 F900\nG1 X3 Y1\nX-1 Y2\nX0 Y0\nG3 X0 Y0 I2\nG1 X0.5\nM2\n";

/// A machine file whose axis X has these lines.
std::string with_lines(const std::string& lines) {
  return with_screw(lines);
}

/// ns
struct Times {
  std::int64_t length, space, setup, hold;
};

/// What the signals of an axis keep at least, read from the dump alone; its steps, summed, are `end`.
struct Kept {
  Times least{1 << 30, 1 << 30, 1 << 30, 1 << 30};
  std::int64_t end = 0;
  int turns = 0;
};

Kept kept_by(const Dump& dump, const std::string& axis) {
  const Dump::Signal &step = dump.signals.at("steps." + axis + "_step"),
                     &direction = dump.signals.at("steps." + axis + "_dir");
  Kept kept;
  const auto take = [](std::int64_t& least, std::int64_t value) { least = std::min(least, value); };
  std::int64_t rose = -1, fell = -1;
  for (const auto& [time, value] : step.changes) {
    if (value != 0) {
      if (fell >= 0) take(kept.least.space, time - fell);
      // Directions are 1 and 0; before the first change the dump has an x, which the reader does not take for either.
      const auto after = direction.changes.upper_bound(time);
      const auto turned = std::prev(after);
      take(kept.least.setup, time - turned->first);
      kept.end += turned->second != 0 ? 1 : -1;
      rose = time;
    } else if (rose >= 0) {
      take(kept.least.length, time - rose);
      fell = time;
    }
  }
  for (const auto& [time, value] : direction.changes) {
    const auto next = step.changes.lower_bound(time);
    if (next == step.changes.begin() || std::prev(next)->first == 0) continue;
    EXPECT_EQ(std::prev(next)->second, 0) << "direction changes within a step";
    take(kept.least.hold, time - std::prev(next)->first);
    ++kept.turns;
  }
  return kept;
}

void expect_kept(const Kept& kept, const Times& asked, const std::string& what) {
  EXPECT_GE(kept.least.length, asked.length) << what;
  EXPECT_GE(kept.least.space, asked.space) << what;
  EXPECT_GE(kept.least.setup, asked.setup) << what;
  EXPECT_GE(kept.least.hold, asked.hold) << what;
  EXPECT_GT(kept.turns, 2) << what;
}

class StepTimes : public ::testing::TestWithParam<const char*> {};

TEST_P(StepTimes, OfTheMachineFileAreKeptForEachAxis) {
  const Folder folder;
  folder.write("part.ngc", turning);
  folder.write("m.toml", with_lines("step_length_us = 1.5\nstep_space_us = 2.25\ndirection_setup_us = 40\n"
                                    "direction_hold_us = 9\n"));
  Words words = {"run", "part.ngc", "--machine", "m.toml", "--pulses", "s.vcd", "--quiet", "--step-clock", "4MHz"};
  if (*GetParam() != '\0') words.insert(words.end(), {"--pulse-method", GetParam()});
  const Outcome outcome = leadscrew(folder, words);
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const Dump dump = read_dump(folder.read("s.vcd"));
  const Kept x = kept_by(dump, "X"), y = kept_by(dump, "Y");
  expect_kept(x, {1500, 2250, 40000, 9000}, "X");
  expect_kept(y, {1000, 1000, 1000, 1000}, "Y");
  EXPECT_EQ(x.end, 500);
  EXPECT_EQ(y.end, 0);
  // No more of each than is asked for, in whole ticks: 250 ns.
  EXPECT_EQ(x.least.length, 1500);
  EXPECT_EQ(x.least.setup, 40000);
  EXPECT_EQ(y.least.length, 1000);
  EXPECT_EQ(y.least.setup, 1000);
}

TEST_P(StepTimes, OfTheCommandLineStandForThoseOfEveryAxis) {
  const Folder folder;
  folder.write("part.ngc", turning);
  folder.write("m.toml", with_lines("step_length_us = 100\nstep_space_us = 100\n"));
  Words words = {"run",     "part.ngc",         "--machine", "m.toml",       "--pulses", "s.vcd",
                 "--quiet", "--step-length",    "2.2us",     "--step-space", "800ns",    "--direction-setup",
                 "0.03ms",  "--direction-hold", "12us"};
  if (*GetParam() != '\0') words.insert(words.end(), {"--pulse-method", GetParam()});
  const Outcome outcome = leadscrew(folder, words);
  ASSERT_EQ(outcome.status, 0) << outcome.errors;
  const Dump dump = read_dump(folder.read("s.vcd"));
  for (const char* axis : {"X", "Y"}) {
    const Kept kept = kept_by(dump, axis);
    expect_kept(kept, {2200, 800, 30000, 12000}, axis);
    EXPECT_EQ(kept.least.length, 3000) << "in whole ticks of 1 us";
  }
}

INSTANTIATE_TEST_SUITE_P(Every, StepTimes, ::testing::Values("", "koren", "min-error"), [](const auto& method) {
  const std::string name = *method.param == '\0' ? "words" : method.param;
  return name.substr(0, name.find('-'));
});

/// A step that would be due at once waits for its direction.
TEST(StepTimesOfRun, HoldFromTheFirstStepOn) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G1 X-1 F6000\nM2\n");
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--pulses", "s.csv", "--quiet", "--direction-setup", "900us"}).status,
            0);
  std::istringstream rows(folder.read("s.csv"));
  std::string row;
  std::getline(rows, row);
  std::getline(rows, row);
  EXPECT_GE(std::stoll(row), 900);
}

// ---------------------------------------------------------------------------------------------------------------------

struct BadTimes {
  const char* name;
  std::string lines;
  Names problems;  ///< "line:column code"

  friend void PrintTo(const BadTimes& bad, std::ostream* stream) { *stream << bad.name; }
};

class RejectedTimes : public ::testing::TestWithParam<BadTimes> {};

TEST_P(RejectedTimes, AreNamedWithTheirPlace) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("m.toml", with_lines(GetParam().lines));
  const Outcome run = leadscrew(folder, {"run", "part.ngc", "--machine", "m.toml", "--pulses", "p.csv", "--json"});
  EXPECT_EQ(run.status, 3);
  const Names found = places_of(run.json()["diagnostics"]);
  EXPECT_EQ(found, GetParam().problems) << run.errors;
  EXPECT_EQ(folder.names(), (Names{"m.toml", "part.ngc"}));
}

INSTANTIATE_TEST_SUITE_P(
    Every, RejectedTimes,
    ::testing::Values(BadTimes{"Zero", "step_length_us = 0\n", {"12:18 step-time"}},
                      BadTimes{"Below0", "step_space_us = -1\n", {"12:17 step-time"}},
                      BadTimes{"NotFinite", "direction_setup_us = nan\n", {"12:22 step-time"}},
                      BadTimes{"TooLong", "direction_hold_us = 1000000.001\n", {"12:21 step-time"}},
                      BadTimes{"NoNumber", "step_length_us = \"2\"\n", {"12:18 machine-type"}},
                      BadTimes{"Misspelt", "step_lenght_us = 2\n", {"12:1 machine-key"}},
                      BadTimes{"Several",
                               "step_length_us = 0\nstep_space_us = 0\ndirection_setup_us = -1\n"
                               "direction_hold_us = inf\n",
                               {"12:18 step-time", "13:17 step-time", "14:22 step-time", "15:21 step-time"}}),
    [](const auto& bad) { return std::string(bad.param.name); });

TEST(StepTimesOfRun, AreSuggested) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("m.toml", with_lines("step_length = 2\ndirection_hold_ns = 2\n"));
  const Outcome check = leadscrew(folder, {"check", "part.ngc", "--machine", "m.toml"});
  EXPECT_TRUE(contains(check.errors, "did you mean step_length_us?")) << check.errors;
  EXPECT_TRUE(contains(check.errors, "did you mean direction_hold_us?")) << check.errors;
}

/// Of all axes, before a file is opened: a step every 5 ticks is 200 000 a second, and an axis that turns with
/// 1000 mm/s² is 1 BLU from its steps after 1 ms.
TEST(StepTimesOfRun, ThatCannotBeKeptAreRefused) {
  const Folder folder;
  folder.write("part.ngc", square);
  struct Refused {
    Words words;
    int problems;
    const char* says;
  };
  for (const auto& [words, problems, says] :
       {Refused{{"--step-length", "4001ns"}, 3, "axis Z makes 2e+05 steps/s at its greatest velocity"},
        Refused{{"--step-space", "10us"}, 3, "[step-rate]"}, Refused{{"--direction-setup", "998us"}, 3, "[step-turn]"},
        Refused{{"--direction-hold", "1ms", "--step-clock", "10MHz"}, 3, "may step back 1.002 ms after a step"},
        Refused{{"--pulse-method", "koren", "--step-space", "150us"}, 1, "[pulse-step-length]"}}) {
    Words all = {"run", "part.ngc", "--pulses", "s.vcd"};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome outcome = leadscrew(folder, all);
    EXPECT_EQ(outcome.status, 3) << says;
    EXPECT_TRUE(contains(outcome.errors, says)) << outcome.errors;
    all.push_back("--json");
    EXPECT_GE(leadscrew(folder, all).json()["diagnostics"].size(), static_cast<std::size_t>(problems)) << says;
    EXPECT_EQ(folder.names(), Names{"part.ngc"});
  }
  EXPECT_EQ(leadscrew(folder, {"run", "part.ngc", "--pulses", "s.vcd", "--quiet", "--step-length", "4us"}).status, 0);
  EXPECT_EQ(leadscrew(folder, {"run", "part.ngc", "--pulses", "s.vcd", "--quiet", "--direction-setup", "996us"}).status,
            0);
}

/// At 1 MHz: whose times they are, and which of them.
TEST(StepTimesOfRun, AreNamedWhereAPulseMethodNeedsMore) {
  const Folder folder;
  folder.write("part.ngc", with_feed(square, "6000"));  // 100 000 steps a second
  folder.write("turn.toml", with_lines("step_length_us = 5\ndirection_setup_us = 6.5\n"));
  folder.write("space.toml", with_lines("step_space_us = 15\n"));
  folder.write("both.toml", with_lines("step_space_us = 15\ndirection_hold_us = 14\n"));
  struct Named {
    Words words;
    const char *limit, *times;
  };
  for (const auto& [words, limit, times] :
       {Named{{"--machine", "turn.toml"},
              "axis X allows 76923.0769 a second: 13 clocks from a step to its next",
              "shorten what sets it: step_length_us (5 us), direction_setup_us (6.5 us)\n"},
        Named{{"--machine", "turn.toml", "--direction-setup", "4us", "--direction-hold", "3us"},
              "axis X allows 83333.3333 a second: 12 clocks from a step to its next",
              "shorten what sets it: step_length_us (5 us), --direction-hold (3 us), --direction-setup (4 us)\n"},
        Named{{"--machine", "space.toml"},
              "axis X allows 62500 a second: 16 clocks from a step to its next",
              "shorten what sets it: step_space_us (15 us)\n"},
        Named{{"--machine", "both.toml"},
              "16 clocks from a step to its next",
              "step_space_us (15 us), direction_hold_us (14 us)\n"},
        Named{{"--step-clock", "100kHz"},
              "axis X allows 33333.3333 a second: 3 clocks from a step to its next",
              "hint: program a lower feed, or give a faster --step-clock, up to 10MHz\n"},
        Named{{"--step-length", "9us"},
              "axis X allows 90909.0909 a second: 11 clocks from a step to its next",
              "--step-length (9 us)\n"}}) {
    Words all = {"run", "part.ngc", "--pulses", "s.vcd", "--pulse-method", "koren"};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome outcome = leadscrew(folder, all);
    EXPECT_EQ(outcome.status, 3) << limit;
    EXPECT_TRUE(contains(outcome.errors, "part.ngc:2:1: error: pulses: the feed asks for 100000 a second, "))
        << outcome.errors;
    EXPECT_TRUE(contains(outcome.errors, limit)) << outcome.errors;
    EXPECT_TRUE(contains(outcome.errors, times)) << outcome.errors;
    EXPECT_FALSE(contains(outcome.errors, "step length allows")) << outcome.errors;
  }
}

TEST(StepTimesOfRun, AreTimes) {
  const Folder folder;
  folder.write("part.ngc", square);
  struct Misuse {
    Words words;
    const char* says;
  };
  for (const auto& [words, says] :
       {Misuse{{"--pulses", "s.vcd", "--step-length", "2"}, "--step-length 2: needs a number and a unit"},
        Misuse{{"--pulses", "s.vcd", "--step-length", "0us"}, "--step-length 0us: must be above 0"},
        Misuse{{"--pulses", "s.vcd", "--step-space", "-1us"}, "--step-space -1us: lies outside 0 to 1000ms"},
        Misuse{{"--pulses", "s.vcd", "--direction-hold", "0.5ns"}, "is not a whole number of nanoseconds"},
        Misuse{{"--pulses", "s.vcd", "--direction-setupp", "1us"}, "did you mean --direction-setup?"},
        Misuse{{"--direction-setup", "5us"}, "--direction-setup is of --pulses FILE, which is missing"},
        Misuse{{"--step-clock", "2MHz"}, "--step-clock is of --pulses FILE, which is missing"}}) {
    Words all = {"run", "part.ngc"};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome outcome = leadscrew(folder, all);
    EXPECT_EQ(outcome.status, 2) << says;
    EXPECT_TRUE(contains(outcome.errors, says)) << outcome.errors;
    EXPECT_EQ(folder.names(), Names{"part.ngc"});
  }
}

}  // namespace test_step_times
}  // namespace leadscrew::cli::testing
