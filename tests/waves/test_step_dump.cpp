// Steps as files, read back.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <leadscrew/steps/step_generator.hpp>
#include <leadscrew/waves/step_dump.hpp>
#include <map>
#include <sstream>

#include "byte_sinks.hpp"

namespace leadscrew::waves {
namespace test_step_dump {

using namespace testing_support;
using steps::StepEvent;

constexpr std::int64_t clock_hz = 3'000'000;
constexpr machine::StepTimes times_of_x{
    .step_length = 1500, .step_space = 600, .direction_setup = 4000, .direction_hold = 2000};
constexpr machine::StepTimes times_of_y{
    .step_length = 700, .step_space = 2500, .direction_setup = 9000, .direction_hold = 0};

/// Of X and Y, each with a drive of its own.
machine::Machine table() {
  machine::Machine machine = machine::mill3();
  machine.axes[base::index(base::Axis::X)]->step_times = times_of_x;
  machine.axes[base::index(base::Axis::Y)]->step_times = times_of_y;
  machine.axes[base::index(base::Axis::Z)].reset();
  return machine;
}

/// Ellipses in X and Y that turn all the time.
std::vector<StepEvent> turning_steps() {
  auto generator = steps::StepGenerator::create(table(), clock_hz).value();
  std::vector<StepEvent> steps;
  const auto sink = [&](std::span<const StepEvent> events) { steps.insert(steps.end(), events.begin(), events.end()); };
  for (int k = 0; k < 300; ++k) {
    base::Word word;
    word.tick = base::Tick{k};
    word.position = {0.3 * std::sin(k / 9.0), 0.2 * std::sin(k / 5.0)};
    generator.follow(word, sink);
  }
  generator.finish(sink);
  return steps;
}

/// In pieces, as a generator gives them.
template <class Writer>
std::string text_of(std::span<const StepEvent> steps, Writer&& make) {
  std::string text;
  auto writer = make(into(text));
  for (std::size_t at = 0; at < steps.size(); at += 7) {
    EXPECT_TRUE(writer.write(steps.subspan(at, std::min<std::size_t>(7, steps.size() - at))));
  }
  EXPECT_TRUE(writer.finish());
  return text;
}

std::string vcd_of(std::span<const StepEvent> steps) {
  return text_of(steps, [](base::ByteSink sink) { return StepVcdWriter(std::move(sink), table(), clock_hz); });
}

TEST(StepDump, WritesARowForEachStep) {
  const std::vector<StepEvent> steps = {{3, base::Axis::X, 1}, {3, base::Axis::Z, -1}, {1500000, base::Axis::X, -1}};
  EXPECT_EQ(text_of(steps, [](base::ByteSink sink) { return StepCsvWriter(std::move(sink), clock_hz); }),
            "tick,t,axis,direction\n3,9.9999999999999995e-07,X,1\n3,9.9999999999999995e-07,Z,-1\n1500000,0.5,X,-1\n");
}

TEST(StepDump, WritesTheSignalsOfADrive) {
  const std::vector<StepEvent> steps = {{30, base::Axis::X, 1}, {60, base::Axis::X, -1}};
  EXPECT_EQ(vcd_of(steps),
            "$comment step and direction, a clock of 3000000 Hz $end\n$version leadscrew $end\n$timescale 1 ns $end\n"
            "$scope module steps $end\n$var wire 1 ! X_step $end\n$var wire 1 \" X_dir $end\n"
            "$var wire 1 # Y_step $end\n$var wire 1 $ Y_dir $end\n$upscope $end\n$enddefinitions $end\n"
            "#0\n$dumpvars\n0!\nx\"\n0#\nx$\n$end\n"
            "#6000\n1\"\n#10000\n1!\n#11667\n0!\n#16000\n0\"\n#20000\n1!\n#21667\n0!\n");
}

struct Drive {
  char step = '0', direction = 'x';
  std::int64_t rose = -1'000'000, fell = -1'000'000, turned = -1'000'000;  // ns
};

/// As a drive counts: at each leading edge, by the direction that stands; with the times that were asked for.
TEST(StepDump, KeepsTheTimesThatADriveAsks) {
  const auto steps = turning_steps();
  std::istringstream dump(vcd_of(steps));
  std::string line;
  while (std::getline(dump, line) && line != "$dumpvars") continue;
  while (std::getline(dump, line) && line != "$end") continue;
  std::map<char, Drive> drives;
  std::vector<StepEvent> counted;
  std::int64_t now = 0;
  const auto turned = [&](Drive& drive, char value, const machine::StepTimes& times) {
    EXPECT_NE(value, drive.direction);
    EXPECT_GE(now - drive.fell, times.direction_hold);
    drive.direction = value;
    drive.turned = now;
  };
  const auto stepped = [&](Drive& drive, char value, base::Axis axis, const machine::StepTimes& times) {
    EXPECT_NE(value, drive.step);
    drive.step = value;
    if (value == '0') {
      EXPECT_GE(now - drive.rose, times.step_length);
      drive.fell = now;
      return;
    }
    EXPECT_GE(now - drive.fell, times.step_space);
    EXPECT_GE(now - drive.turned, times.direction_setup);
    drive.rose = now;
    counted.emplace_back((now * 3 + 500) / 1000, axis, drive.direction == '1' ? 1 : -1);
  };
  while (std::getline(dump, line)) {
    if (line[0] == '#') {
      const std::int64_t time = std::atoll(line.c_str() + 1);
      EXPECT_GT(time, now);
      now = time;
      continue;
    }
    const int signal = line[1] - '!';
    const auto axis = static_cast<base::Axis>(signal / 2);
    Drive& drive = drives[base::letter(axis)];
    const machine::StepTimes& times = axis == base::Axis::X ? times_of_x : times_of_y;
    signal % 2 == 1 ? turned(drive, line[0], times) : stepped(drive, line[0], axis, times);
  }
  EXPECT_GT(counted.size(), 10000u);
  auto expected = steps;
  std::ranges::sort(expected);
  EXPECT_EQ(counted, expected);
}

TEST(StepDump, FailsAsItsSinkDoes) {
  const auto steps = turning_steps();
  StepCsvWriter csv(failing_after(100'000), clock_hz);
  StepVcdWriter vcd(failing_after(100'000), table(), clock_hz);
  for (int round = 0; round < 2; ++round) {
    const auto rows = csv.write(steps);
    ASSERT_FALSE(rows);
    EXPECT_EQ(rows.error().code, "disk-full");
    const auto changes = vcd.write(steps);
    ASSERT_FALSE(changes);
    EXPECT_EQ(changes.error().code, "disk-full");
  }
  EXPECT_FALSE(csv.finish());
  EXPECT_FALSE(vcd.finish());
}

}  // namespace test_step_dump
}  // namespace leadscrew::waves
