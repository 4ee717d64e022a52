#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <leadscrew/pipeline/program.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "interventions.hpp"
#include "live_program.hpp"
#include "motion_with_events.hpp"
#include "random_programs.hpp"

// Events that motion does not rest for: they cost no time and change no word, and each happens once, in order, no
// earlier than motion is where it was programmed, and no more than a period later.

namespace test_travelling_events {

using namespace leadscrew;
using base::PassedEvent;
using Kind = base::Event::Kind;
using testing_support::any;
using testing_support::Intervention;
using testing_support::LiveProgram;
using testing_support::Motion;
using testing_support::numbered;
using testing_support::run_with_events;
using testing_support::seconds;

/// Never early, no more than a period late, at the place that the event says.
template <class Words>
void expect_in_time(const Words& words, const std::vector<PassedEvent>& events) {
  for (const PassedEvent& event : events) {
    const auto tick = static_cast<std::size_t>(base::count(event.tick));
    ASSERT_LT(tick, words.size());
    ASSERT_GE(words[tick].path_length, event.path_length - 1e-9) << "line " << base::number(event.line);
    if (event.waits || tick == 0) continue;
    // Where motion rested there, it is passed as motion goes on.
    ASSERT_LE(words[tick - 1].path_length, event.path_length + 1e-9) << "line " << base::number(event.line);
  }
}

/// Where motion is at an event, mm.
double distance_from(const base::AxisVector& place, const Motion& motion, const PassedEvent& event) {
  const auto tick = static_cast<std::size_t>(base::count(event.tick));
  const base::Word &behind = motion.words[tick], &before = motion.words[tick == 0 ? 0 : tick - 1];
  const double step = behind.path_length - before.path_length;
  const double share = step > 0 ? (event.path_length - before.path_length) / step : 1;
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double at = before.position[i] + share * (behind.position[i] - before.position[i]);
    sum += (at - place[i]) * (at - place[i]);
  }
  return std::sqrt(sum);
}

TEST(TravellingEvents, HappenWhereBlocksMeet) {
  const std::string blocks = "G1 X10\nS1\nX20\nS2\nX25 Y10\nS3\nG3 X15 Y20 I-10 J0\nM8\nG1 X0\nM9\nX-5 Y17\nM2\n";
  const base::AxisVector joints[] = {{10}, {20}, {25, 10}, {15, 20}, {0, 20}};
  for (const char* mode : {"G61", "G61.1", "G64 P0.1", "G64 P0.1 Q0", "G64 P0.002"}) {
    const Motion motion = run_with_events(std::string("G21 G90 G94 G17 F3000 ") + mode + '\n' + blocks);
    EXPECT_EQ(motion.problems, "");
    ASSERT_EQ(motion.events.size(), 6u) << mode;
    expect_in_time(motion.words, motion.events);
    const bool blends = mode[2] == '4';
    // In a blend the middle stands for the corner.
    for (std::size_t k = 0; k < std::size(joints); ++k)
      EXPECT_LT(distance_from(joints[k], motion, motion.events[k]), blends ? 0.1 : 2e-3) << mode << ' ' << k;
  }
}

/// Short lines about a circle, fitted as a whole.
TEST(TravellingEvents, KeepTheirPlacesOnFits) {
  std::string text = "G21 G90 G94 G17 F3000 G64 P0.02\n";
  std::vector<base::AxisVector> joints;
  for (int k = 0; k < 200; ++k) {
    const double angle = 0.05 * k;
    joints.push_back({20 * std::sin(angle), 20 - 20 * std::cos(angle), 0.01 * k});
    char block[80];
    std::snprintf(block, sizeof block, "G1 X%.6f Y%.6f Z%.6f S%d\n", joints.back()[0], joints.back()[1],
                  joints.back()[2], k);
    text += block;
  }
  const Motion motion = run_with_events(text + "M2\n");
  ASSERT_EQ(motion.events.size(), 201u);
  expect_in_time(motion.words, motion.events);
  for (std::size_t k = 1; k < joints.size(); ++k) {
    EXPECT_EQ(motion.events[k].value, static_cast<double>(k));
    EXPECT_LT(distance_from(joints[k - 1], motion, motion.events[k]), 0.025) << k;
  }
}

TEST(TravellingEvents, WaitWhereTheyMust) {
  const auto time = [](const std::string& event, bool spindle_waits) {
    machine::Machine machine = machine::mill3();
    machine.spindle_waits = spindle_waits;
    const Motion motion =
        run_with_events("G21 G90 G94 F6000 G64 P0.01\nT1 S100\nG1 X20\n" + event + "\nX40\nM2\n", machine);
    EXPECT_EQ(motion.problems, "");
    return seconds(motion);
  };
  const double plain = time("", true);
  for (const char* event : {"M3", "M4", "M5"}) {
    EXPECT_GT(time(event, true), plain + 0.05) << event;
    EXPECT_EQ(time(event, false), plain) << event;
  }
  for (const char* event : {"M0", "M1", "M60", "M6", "G4 P0.01"}) EXPECT_GT(time(event, false), plain + 0.05) << event;
  for (const char* event :
       {"M7", "M8", "M9", "S5", "T2", "M62 P0", "M63 P1", "M64 P2", "M65 P3", "M67 E0 Q1", "M68 E1 Q-2"})
    EXPECT_EQ(time(event, true), plain) << event;
}

/// M62, M63 and M67 happen as the next motion begins, all others before the dwell.
TEST(TravellingEvents, ComeWithMotionWhereTheySaySo) {
  const Motion motion =
      run_with_events("G21 G90 G94 F6000 G61\nG1 X1\nM67 E0 Q5\nM68 E1 Q6\nM62 P2\nS7\nG4 P0.5\nX2\nM67 E3 Q8\nM2\n");
  ASSERT_EQ(motion.problems, "");
  std::vector<Kind> kinds;
  for (const PassedEvent& event : motion.events) kinds.push_back(event.kind);
  EXPECT_EQ(kinds, (std::vector<Kind>{Kind::analog_output, Kind::spindle_speed, Kind::analog_output_with_motion,
                                      Kind::digital_output_on_with_motion, Kind::analog_output_with_motion,
                                      Kind::program_end}));
  EXPECT_EQ(motion.events[2].tick, motion.events[3].tick);
  EXPECT_GE(base::count(motion.events[2].tick) - base::count(motion.events[1].tick), 500);
  EXPECT_EQ(motion.events[2].output, 0);
  EXPECT_EQ(motion.events[2].value, 5);
  EXPECT_DOUBLE_EQ(motion.events[2].path_length, 1);
  EXPECT_DOUBLE_EQ(motion.events[4].path_length, 2);
}

/// A random program with events, so many before a block.
std::string with_events(const std::string& program) {
  std::string text;
  int count = 0;
  for (std::size_t at = 0; at < program.size();) {
    const std::size_t end = program.find('\n', at) + 1;
    const std::string block = program.substr(at, end - at);
    at = end;
    const bool is_plain = block.starts_with("G1 ") || block.starts_with("G0 ") || block.starts_with("G2 ") ||
                          block.starts_with("G3 ") || block.starts_with("G4 ");
    for (int k = is_plain ? *rc::gen::element(0, 1, 1, 1, 2, 5) : 0; k > 0; --k) {
      const char* const event =
          *rc::gen::element("M7 S", "M9 S", "S", "S", "T", "M62 P3 S", "M64 P1 T", "M67 E1 Q", "M68 E2 Q", "M3 S");
      text += numbered(event, ++count) + '\n';
    }
    text += block;
  }
  return text;
}

/// The same program with a remark in place of each event that travels.
std::string without_events(const std::string& program) {
  std::string text;
  std::istringstream lines(program);
  for (std::string line; std::getline(lines, line);) {
    const bool is_event = line.starts_with("S") || line.starts_with("T") || line.starts_with("M6") ||
                          line.starts_with("M7") || line.starts_with("M9");
    text += (is_event ? "(an event)" : line) + '\n';
  }
  return text;
}

RC_GTEST_PROP(TravellingEvents, ChangeNoWord, ()) {
  machine::Machine machine = testing_support::random_machine();
  machine.period = {2'000'000};
  const std::string text = with_events(testing_support::RandomProgram::make(5));
  RC_LOG() << text << testing_support::limits_of(machine);
  const Motion motion = run_with_events(text, machine), same = run_with_events(without_events(text), machine);
  RC_ASSERT(motion.problems.empty() && same.problems.empty());
  RC_ASSERT(motion.words.size() == same.words.size());
  for (std::size_t k = 0; k < motion.words.size(); ++k) {
    RC_ASSERT(motion.words[k].position == same.words[k].position);
    RC_ASSERT(motion.words[k].path_length == same.words[k].path_length);
    RC_ASSERT(motion.words[k].line == same.words[k].line);
  }
}

std::vector<base::Event> programmed_events(const std::string& text, const machine::Machine& machine) {
  const machine::ToolTable tools;
  gcode::Reader reader(gcode::text_source(text), machine, tools, {}, nullptr);
  std::vector<base::Event> events;
  for (gcode::Move move; reader.next(move);) {
    if (move.kind == gcode::Move::Kind::event) events.push_back(move.event);
  }
  return events;
}

/// Those that take effect with the next motion, or all others.
std::vector<base::Event> of_sort(const auto& events, bool with_motion) {
  std::vector<base::Event> found;
  std::copy_if(events.begin(), events.end(), std::back_inserter(found),
               [&](const base::Event& event) { return base::is_with_motion(event.kind) == with_motion; });
  return found;
}

void expect_once_and_in_order(const std::vector<PassedEvent>& events, const std::vector<base::Event>& programmed) {
  for (const bool with_motion : {false, true})
    RC_ASSERT(of_sort(events, with_motion) == of_sort(programmed, with_motion));
  for (std::size_t k = 1; k < events.size(); ++k) {
    RC_ASSERT(events[k - 1].tick <= events[k].tick);
    RC_ASSERT(events[k - 1].path_length <= events[k].path_length + 1e-9);
  }
}

void expect_in_their_periods(const std::vector<base::Word>& words, const std::vector<PassedEvent>& events) {
  for (const PassedEvent& event : events) {
    const auto tick = static_cast<std::size_t>(base::count(event.tick));
    RC_ASSERT(tick < words.size());
    RC_ASSERT(words[tick].path_length >= event.path_length - 1e-9);
    if (tick > 0) RC_ASSERT(words[tick - 1].path_length <= event.path_length + 1e-9);
  }
}

machine::Machine random_machine_that_waits() {
  machine::Machine machine = testing_support::random_machine();
  machine.period = {1'000'000};
  machine.spindle_waits = any(0, 2) == 0;
  return machine;
}

void keep_events(int blocks) {
  const machine::Machine machine = random_machine_that_waits();
  const std::string text = with_events(testing_support::RandomProgram::make(blocks));
  RC_LOG() << text << testing_support::limits_of(machine);
  const double slice = *rc::gen::element(0.0, 0.0, 0.02);
  const Motion motion = run_with_events(text, machine, slice);
  RC_ASSERT(motion.problems.empty());
  expect_once_and_in_order(motion.events, programmed_events(text, machine));
  expect_in_their_periods(motion.words, motion.events);
}

RC_GTEST_PROP(TravellingEvents, HappenOnceAndInOrder, ()) {
  keep_events(6);
}
RC_GTEST_PROP(LongTravellingEvents, HappenOnceAndInOrder, ()) {
  for (int program = 0; program < 5; ++program) keep_events(24);
}

/// Whatever is asked of the feed, and however late the planner is.
void keep_events_under_interventions(int blocks) {
  const machine::Machine machine = random_machine_that_waits();
  const std::string text = with_events(testing_support::RandomProgram::make(blocks));
  RC_LOG() << text << testing_support::limits_of(machine);
  LiveProgram whole(text, machine);
  if (!whole.run({}, 8'000)) return;
  const std::vector<Intervention> interventions = testing_support::random_interventions(whole.words.size());
  LiveProgram live(text, machine);
  RC_ASSERT(live.run(interventions, 800'000));
  RC_ASSERT(live.diagnostics == 0);
  RC_CLASSIFY(live.late > 0, "chunks are late");
  expect_once_and_in_order(live.events, programmed_events(text, machine));
  expect_in_their_periods(live.words, live.events);
  RC_ASSERT(live.events.size() == whole.events.size());
  for (std::size_t k = 0; k < live.events.size(); ++k)
    RC_ASSERT(std::abs(live.events[k].path_length - whole.events[k].path_length) <= 1e-6);
}

RC_GTEST_PROP(TravellingEvents, HappenOnceAndInOrderUnderInterventions, ()) {
  keep_events_under_interventions(10);
}
RC_GTEST_PROP(LongTravellingEvents, HappenOnceAndInOrderUnderInterventions, ()) {
  for (int program = 0; program < 5; ++program) keep_events_under_interventions(24);
}

}  // namespace test_travelling_events
