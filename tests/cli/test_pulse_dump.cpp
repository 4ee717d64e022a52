// `leadscrew pulse --vcd`: every signal at every clock, under the papers' names.

#include <gtest/gtest.h>

#include <algorithm>
#include <leadscrew/nc/pulse_signals.hpp>

#include "quarter.hpp"
#include "value_changes.hpp"

namespace leadscrew::cli::testing {
namespace test_pulse_dump {

using nc::PulseMethod;

constexpr std::int64_t units_per_clock = 10;  // of 100 ns

/// Every signal of a scope at every clock, beside the interpolator itself.
void expect_equal(const Dump& dump, nc::PulseRun run, std::string scope, const nc::PulseCurve& curve) {
  std::replace(scope.begin(), scope.end(), '-', '_');
  while (true) {
    const std::int64_t clock = run.clock();
    const auto value = [&](const std::string& name) {
      EXPECT_TRUE(dump.signals.contains(scope + "." + name)) << scope << ' ' << name;
      return dump.signals.at(scope + "." + name).at(clock * units_per_clock);
    };
    ASSERT_EQ(value("dx"), run.last().step[0]) << scope << clock;
    ASSERT_EQ(value("dy"), run.last().step[1]) << scope << clock;
    if (curve.origin() != pulse::Point{}) {
      ASSERT_EQ(value("X"), run.at().x) << scope << clock;
      ASSERT_EQ(value("Y"), run.at().y) << scope << clock;
    }
    const nc::Registers registers = nc::signals_of(run, curve);
    for (const nc::Register& each : registers.all())
      ASSERT_EQ(value(std::string(each.name)), each.value) << scope << clock << each.name;
    if (run.done()) break;
    run.step();
  }
  EXPECT_EQ(dump.signals.at(scope + ".dx").at((run.clock() + 1) * units_per_clock), 0);
  EXPECT_GT(dump.last, run.clock() * units_per_clock);
}

TEST(PulseDump, HasEveryRegisterAtEveryClock) {
  const Folder folder;
  using Shape = nc::PulseCurve::Shape;
  const nc::PulseCurve around{Shape::arc, {-30, 1}, {-30, 1}, {-17, 1}, pulse::Direction::clockwise};
  ASSERT_EQ(leadscrew(folder, {"pulse", "--arc", "--start", "-30,1", "--end", "-30,1", "--center", "-17,1", "--cw",
                               "--quiet", "--vcd", "arc.vcd"})
                .status,
            0);
  const nc::PulseCurve across{Shape::line, {}, {90, -37}, {}, {}};
  ASSERT_EQ(leadscrew(folder, {"pulse", "--line", "--end", "90,-37", "--quiet", "--vcd", "line.vcd"}).status, 0);
  EXPECT_EQ(folder.names(), (Names{"arc.vcd", "line.vcd"}));
  const Dump arc = read_dump(folder.read("arc.vcd")), line = read_dump(folder.read("line.vcd"));
  for (const Dump* dump : {&arc, &line}) {
    EXPECT_EQ(dump->timescale, "100 ns");
    EXPECT_TRUE(dump->has_initial_values);
    EXPECT_EQ(dump->first, 0);
  }
  for (const PulseMethod method : nc::all_pulse_methods) {
    expect_equal(arc, nc::PulseRun(method, around), std::string(nc::name(method)), around);
    expect_equal(line, nc::PulseRun(method, across), std::string(nc::name(method)), across);
  }
}

/// A register at every clock, the first as loaded; a clock behind the end it is the same.
void expect_values(const Dump& dump, const std::string& name, const std::vector<std::int64_t>& values) {
  ASSERT_TRUE(dump.signals.contains(name)) << name;
  std::int64_t time = 0;
  for (const std::int64_t value : values) {
    EXPECT_EQ(dump.signals.at(name).at(time), value) << name << " at " << time;
    time += units_per_clock;
  }
  EXPECT_EQ(dump.signals.at(name).at(time), values.back()) << name;
}

/// Worked by hand from the equations: F, its candidates −2x + 2y + 2, 2y + 1 and −2x + 1 away from it, and 4(d1 − d2).
TEST(PulseDump, HasTheQuarterOf5UnderTheNamesOfTheFpga) {
  const Folder folder;
  ASSERT_EQ(leadscrew(folder, quarter({"--quiet", "--vcd", "made.vcd"})).status, 0);
  const Dump dump = read_dump(folder.read("made.vcd"));
  expect_values(dump, "point_comparison.Val_f", {0, 1, -8, -5, 0, 7, 0, 9, 4, 1, 0});
  expect_values(dump, "point_comparison.Val_x", {5, 5, 4, 4, 4, 4, 3, 3, 2, 1, 0});
  for (const std::string method : {"min_error", "improved_min_error"}) {
    expect_values(dump, method + ".Val_x", {5, 5, 5, 4, 3, 2, 1, 0});
    expect_values(dump, method + ".Val_y", {0, 1, 2, 3, 4, 5, 5, 5});
    expect_values(dump, method + ".Val_f", {0, 1, 4, 0, 0, 4, 1, 0});
    expect_values(dump, method + ".Val_n1", {-8, -5, 0, 0, 4, 12, 11, -8});
    expect_values(dump, method + ".Val_n2", {1, 4, 9, 7, 9, 15, 12, -9});
    expect_values(dump, method + ".Val_n3", {-9, -8, -5, -7, -5, 1, 0, 1});
  }
  expect_values(dump, "improved_min_error.d", {15, 3, -17, -13, 3, -25, -21, 15});
  // Capacity 5, half a load in X, the lagging axis; no overflow at the fourth clock.
  expect_values(dump, "dda.Sum_X", {2, 2, 3, 0, 3, 1, 0, 0, 0});
  expect_values(dump, "dda.Sum_Y", {0, 0, 0, 0, 4, 3, 1, 1, 1});
  expect_values(dump, "dda.Val_y", {0, 1, 2, 3, 3, 4, 5, 5, 5});
}

TEST(PulseDump, HasTheQuarterOf5UnderTheNamesOfKoren) {
  const Folder folder;
  ASSERT_EQ(leadscrew(folder, quarter({"--method", "koren", "--quiet", "--vcd", "arc.vcd"})).status, 0);
  // Half a load in both; the new x is added for y. Integrator 2 moves X.
  const Dump arc = read_dump(folder.read("arc.vcd"));
  expect_values(arc, "koren.y1", {5, 5, 5, 4, 4, 3, 2, 1, 0});
  expect_values(arc, "koren.y2", {0, 1, 2, 3, 4, 4, 5, 5, 5});
  expect_values(arc, "koren.r1", {2, 2, 2, 1, 0, 3, 0, 0, 0});
  expect_values(arc, "koren.r2", {2, 2, 3, 0, 3, 2, 1, 1, 1});
  expect_values(arc, "koren.dz1", {0, 1, 1, 1, 1, 0, 1, 0});
  expect_values(arc, "koren.dz2", {0, 0, 0, -1, 0, -1, -1, -1});
  const Words line = {"pulse",     "--line", "--end",   "3,-4",  "--method", "koren",
                      "--preload", "zero",   "--quiet", "--vcd", "line.vcd"};
  ASSERT_EQ(leadscrew(folder, line).status, 0);
  // L = 5; integrator 1 moves X.
  const Dump straight = read_dump(folder.read("line.vcd"));
  expect_values(straight, "koren.y1", {3, 3, 3, 3, 3, 3});
  expect_values(straight, "koren.r1", {0, 3, 1, 4, 2, 0});
  expect_values(straight, "koren.r2", {0, 4, 3, 2, 1, 0});
  EXPECT_EQ(straight.signals.at("koren.dz2").at(2 * units_per_clock), -1);
}

int rises_of(const Dump::Signal& signal) {
  int rises = 0;
  for (const auto& [time, value] : signal.changes) rises += value != 0 && time > 0 ? 1 : 0;
  return rises;
}

/// Clocks, steps and the wait for the end can be counted as they are in the paper's waveforms.
TEST(PulseDump, HasTheWaveformsOfTheFpga) {
  const Folder folder;
  ASSERT_EQ(leadscrew(folder, {"pulse", "--arc", "--start", "15,-2", "--end", "10,3", "--center", "10,-2", "--method",
                               "dda,min-error", "--quiet", "--vcd", "made.vcd"})
                .status,
            0);
  const Dump dump = read_dump(folder.read("made.vcd"));
  // The paper turns in X and Z; its reset is what loads here.
  for (const auto& [of_paper, ours] : {std::pair("common.rst", "common.Syn"),
                                       {"common.Start_Z0", "common.Start_Y0"},
                                       {"common.End_Z1", "common.End_Y1"},
                                       {"dda.Z_Pwm_Out", "dda.Y_Pwm_Out"},
                                       {"min_error.Z_Pwm_Out", "min_error.Y_Pwm_Out"},
                                       {"min_error.Val_z", "min_error.y"},
                                       {"dda.Val_z", "dda.y"},
                                       {"dda.Val_z", "dda.Val_y"},
                                       {"dda.Sum_Z", "dda.ry"}}) {
    ASSERT_TRUE(dump.signals.contains(of_paper)) << of_paper;
    EXPECT_EQ(dump.signals.at(of_paper).changes, dump.signals.at(ours).changes) << of_paper;
  }
  EXPECT_EQ(dump.signals.at("common.Start_X0").at(0), 5);
  EXPECT_EQ(dump.signals.at("common.Start_Y0").at(0), 0);
  EXPECT_EQ(dump.signals.at("common.End_X1").at(0), 0);
  EXPECT_EQ(dump.signals.at("common.End_Y1").at(0), 5);
  EXPECT_EQ(rises_of(dump.signals.at("common.clk")), 8 + 1);  // one more, at which all rest
  EXPECT_NE(dump.signals.at("common.Syn").at(0), 0);
  EXPECT_EQ(dump.signals.at("common.Syn").at(units_per_clock), 0);
  EXPECT_EQ(rises_of(dump.signals.at("dda.X_Pwm_Out")), 5);
  EXPECT_EQ(rises_of(dump.signals.at("dda.Y_Pwm_Out")), 5);
  EXPECT_NE(dump.signals.at("dda.Y_Pwm_Out").at(units_per_clock), 0);
  EXPECT_EQ(dump.signals.at("dda.Y_Pwm_Out").at(units_per_clock + 5), 0);
  for (const auto& [method, clocks] : {std::pair("dda", 8), {"min_error", 7}}) {
    const Dump::Signal& busy = dump.signals.at(std::string(method) + ".Busy");
    EXPECT_NE(busy.at(clocks * units_per_clock - 1), 0) << method;
    EXPECT_EQ(busy.at(clocks * units_per_clock), 0) << method;
  }
}

/// Each name of a paper's, in words at the head of the dump.
TEST(PulseDump, SaysWhatStandsForWhat) {
  const Folder folder;
  leadscrew(folder, quarter({"--method", "dda,koren", "--quiet", "--vcd", "made.vcd"}));
  const Dump dump = read_dump(folder.read("made.vcd"));
  const auto said = [&](const std::string& part) {
    return std::any_of(dump.comments.begin(), dump.comments.end(),
                       [&](const auto& each) { return contains(each, part); });
  };
  EXPECT_TRUE(said("rst is high at the one that loads, as is Syn"));
  EXPECT_TRUE(said("common: Syn is rst, Start_Z0 is Start_Y0, End_Z1 is End_Y1"));
  EXPECT_TRUE(
      said("dda: Z_Pwm_Out is Y_Pwm_Out, Val_x is x, Val_y is y, Val_z is y, Sum_X is rx, Sum_Y is ry, Sum_Z is ry"));
  EXPECT_TRUE(said("y1 is x, y2 is y, r2 is rx, r1 is ry"));
}

TEST(PulseDump, ShowsRegistersOfNBitsWithASign) {
  const Folder folder;
  leadscrew(folder, quarter({"--method", "dda", "--bits", "10", "--quiet", "--vcd", "made.vcd"}));
  const Dump dump = read_dump(folder.read("made.vcd"));
  for (const char* name : {"x", "y", "rx", "ry", "nx", "ny"})
    EXPECT_EQ(dump.signals.at(std::string("dda.") + name).width, 11);
  EXPECT_EQ(dump.signals.at("dda.q").width, 12);
  EXPECT_EQ(dump.signals.at("dda.dx").width, 2);
}

TEST(PulseText, IsOfCurvesOfSomeSize) {
  const Folder folder;
  const auto outcome = leadscrew(folder, {"pulse", "--line", "--end", "20000000,1", "--method", "dda", "--table"});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_TRUE(contains(outcome.errors, "[too-many-clocks]")) << outcome.errors;
}

}  // namespace test_pulse_dump
}  // namespace leadscrew::cli::testing
