// Threads that follow a spindle whose speed wanders, on random machines: in step behind a run-in that is told, within limits,
// where the program says.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdio>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <string>
#include <trunnion.hpp>
#include <vector>

#include "judged_run.hpp"
#include "spindle_machines.hpp"

namespace test_threads {

using namespace leadscrew;
using testing_support::between;
using testing_support::SpindleOfEvents;
using Kind = base::Event::Kind;

/// A machine and a program of lines in step, each with a lead and a speed of the spindle of its own. Of every two machines
/// one holds the tip of a tool that points anywhere on a line that is one of no axis.
struct Case {
  machine::Machine machine;
  std::string text;

  static Case any() {
    Case made;
    made.machine = testing_support::machine_with_spindle();
    const machine::Derivatives least = testing_support::least_limits(made.machine);
    char block[160];
    double before = 0;
    made.text = "G21 G90 G94 G17 F600\n";
    const bool by_tip = *rc::gen::arbitrary<bool>();
    if (by_tip) made.text += testing_support::point_tool(made.machine);
    for (int k = *rc::gen::inRange(1, 4); k > 0; --k) {
      const double turns = 100 * between(0.01, 1), fastest = std::max(turns, before);  // revolutions per s
      const double lead = std::min(between(0.2, 6), least.velocity * 0.9 / fastest), v = lead * fastest;
      before = turns;
      const double rise = 2 * std::sqrt(v / least.jerk) + v / least.acceleration;
      const double length = v * (between(0.5, 2) + 12 * rise) + 2;
      if (!by_tip && *rc::gen::arbitrary<bool>())
        made.text += std::string(*rc::gen::element("T1 M6", "M19 R30")) + "\nG4 P0.5\n";
      std::snprintf(block, sizeof block, "S%.3f M%d\nG33 X%.4f Z%.4f K%.4f\nG0 X%.4f\nZ0\nX0\n", 60 * turns,
                    *rc::gen::inRange(3, 5), length * between(0, 0.3), -length, lead, length);
      made.text += block;
    }
    made.text += "M2\n";
    RC_LOG() << made.text << testing_support::limits_with_spindle(made.machine);
    return made;
  }
};

/// Of one line, from the word that passed its event on.
struct Line {
  double lead = 0;
  std::vector<double> s, errors;  ///< along it, and |s − lead · (revolutions since the index)|

  double length() const { return s.back(); }
};

/// Each line's words, matched with the spindle as the test finds it.
class Watcher {
 public:
  explicit Watcher(const machine::Machine& machine) : turns_(machine) {}

  std::vector<Line> lines;

  void pass(const base::PassedEvent& event) {
    turns_.obey(event);
    if (event.kind != Kind::spindle_in_step) return;
    is_on_ = event.value > 0;
    if (!is_on_) return;
    lines.push_back({.lead = event.value});
    begin_ = event.path_length;
    has_index_ = false;
    first_ = base::count(event.tick);
  }

  void see(const base::Word& word) {
    if (!is_on_) return;
    const std::int64_t tick = base::count(word.tick);
    const double turned = turns_.at(tick);
    if (!has_index_ && tick > first_ && turns_.is_at_speed(tick - 1) && turns_.passes_index(tick - 1)) {
      has_index_ = true;
      index_ = std::floor(turned);
    }
    Line& line = lines.back();
    line.s.push_back(word.path_length - begin_);
    if (!has_index_) RC_ASSERT(line.s.back() <= 1e-9);
    line.errors.push_back(has_index_ ? std::abs(line.s.back() - line.lead * (turned - index_)) : 0);
  }

 private:
  SpindleOfEvents turns_;
  bool is_on_ = false, has_index_ = false;
  double begin_ = 0, index_ = 0;
  std::int64_t first_ = 0;
};

/// What a stop from the spindle's greatest speed takes, and what motion may be ahead.
double way_to_the_end(const Line& line, const machine::Machine& machine) {
  double v = 0;
  for (std::size_t i = 1; i < line.s.size(); ++i)
    v = std::max(v, (line.s[i] - line.s[i - 1]) / machine.period.seconds());
  double a = 1e12, j = 1e12;
  for (std::size_t i = 0; i < 3; ++i) {
    a = std::min(a, machine.axes[i]->acceleration);
    j = std::min(j, machine.axes[i]->jerk);
  }
  return v * (2 * std::sqrt(v / j) + v / a) + 0.02 * line.length();
}

/// Where it goes at 0.8 of its greatest speed for the last time: a spindle that wanders is never so slow.
double where_braking(const Line& line) {
  double fastest = 0;
  for (std::size_t i = 1; i < line.s.size(); ++i) fastest = std::max(fastest, line.s[i] - line.s[i - 1]);
  std::size_t i = line.s.size() - 1;
  while (i > 1 && line.s[i] - line.s[i - 1] < 0.8 * fastest) --i;
  return line.s[i];
}

RC_GTEST_PROP(Threads, FollowASpindleThatWandersBehindTheRunInThatIsTold, ()) {
  const Case made = Case::any();
  Watcher watcher(made.machine);
  const pipeline::Summary summary = testing_support::judged_run(
      made.text, made.machine, [&](const base::PassedEvent& event) { watcher.pass(event); },
      [&](const base::Word& word) { watcher.see(word); });
  RC_ASSERT(summary.threads.lines == static_cast<std::int64_t>(watcher.lines.size()));
  RC_ASSERT(summary.bound_s <= summary.time_s * (1 + 1e-6));
  double longest = 0;
  double furthest = 0;
  bool is_told = false;
  for (const Line& line : watcher.lines) {
    const double end = line.length() - way_to_the_end(line, made.machine);
    furthest = std::max(furthest, where_braking(line));
    double run_in = 0;
    for (std::size_t k = 0; k < line.s.size(); ++k) {
      if (line.errors[k] <= made.machine.tolerance * (1 + 1e-9)) continue;
      if (line.s[k] < end) run_in = std::max(run_in, line.s[k]);
      is_told |= std::abs(line.s[k] - summary.threads.run_in) <= 1e-9;
    }
    RC_LOG() << "run-in " << run_in << " of " << line.length() << '\n';
    RC_ASSERT(run_in < end);
    longest = std::max(longest, run_in);
  }
  RC_LOG() << "told " << summary.threads.run_in << '\n';
  // A place where the test finds it late as well: the last, but that where motion brakes is the cycle's to say.
  RC_ASSERT(is_told || summary.threads.run_in == 0);
  RC_ASSERT(summary.threads.run_in >= longest - 1e-9);
  if (summary.threads.run_in > longest + 1e-9) RC_ASSERT(summary.threads.run_in <= furthest);
}

// What is never within the tolerance of the spindle's place is none of the lines in step, and its way is no run-in.
TEST(Threads, ThatEndBeforeTheyAreInStepAreTold) {
  machine::Machine machine = machine::mill3();
  machine.spindle = machine::Spindle{.acceleration = 500, .wander = 0};
  int late = 0;
  for (const double length : {1.0, 4.0, 8.0, 12.0, 30.0}) {
    Watcher watcher(machine);
    const std::string text = "G21 G90 F600\nS1000 M3\nG33 Z" + std::to_string(length) + " K2\nM2\n";
    const pipeline::Summary summary = testing_support::judged_run(
        text, machine, [&](const base::PassedEvent& event) { watcher.pass(event); },
        [&](const base::Word& word) { watcher.see(word); });
    ASSERT_EQ(watcher.lines.size(), 1u);
    const Line& line = watcher.lines.front();
    bool is_late = true;
    for (std::size_t k = 0; k < line.s.size(); ++k) {
      const bool is_on_the_way = line.s[k] > 0.1 * length && line.s[k] < 0.9 * length;
      is_late &= !(is_on_the_way && line.errors[k] <= machine.tolerance);
    }
    EXPECT_EQ(summary.threads.out_of_step, is_late) << length;
    EXPECT_EQ(summary.threads.lines, !is_late) << length;
    late += is_late;
  }
  EXPECT_EQ(late, 3);
}

/// Under tool centre point control a line of the tip is one of the axes only while no rotary axis turns.
TEST(Threads, ThatTurnTheToolAreRefused) {
  machine::Machine machine = testing_support::trunnion();
  const auto problems = [&](const std::string& text) { return testing_support::problems_of(text, machine); };
  const std::string in_step = "G33 Z-10 C20 K1\nM2\n", by_tip = "S100 M3\nG0 A30\nG43.4\n" + in_step;
  EXPECT_EQ(problems(by_tip), "");
  machine.spindle = machine::Spindle{.acceleration = 1000};
  EXPECT_EQ(problems(by_tip), "thread-turns-tool ");
  EXPECT_EQ(problems("S100 M3\nG0 A30\n" + in_step), "");
}

/// The four lines of a pass of G76 go on with the thread before, in phase; passes are congruent.
TEST(Threads, OfAPassGoOnInPhaseAndPassesAreCongruent) {
  machine::Machine machine = machine::mill3();
  machine.spindle = machine::Spindle{.acceleration = 2000, .wander = 0.05, .wander_period = 3, .seed = 7};
  const std::string text = "G21 G90 G18 F3000\nM3 S600\nG0 X5.5 Z2\nG76 P2 Z-40 I-2 J0.3 K1.2 R1 Q0 H1 E4 L3\nM2\n";
  const machine::ToolTable tools;
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, [](const base::Diagnostic&) { FAIL(); });
  SpindleOfEvents turns(machine);
  std::vector<double> phases;  // of Z against the spindle, at Z = -20 of each pass
  bool is_on = false;
  double before = 0;
  program.on_event([&](const base::PassedEvent& event) {
    turns.obey(event);
    if (event.kind == Kind::spindle_in_step) is_on = event.value > 0;
  });
  while (program.prepare()) {
    const base::Word word = program.cycle();
    const double z = word.position[2];
    if (is_on && before > -20 && z <= -20) {
      const double phase = turns.at(base::count(word.tick)) + z / 2;
      phases.push_back(phase - std::floor(phase));
    }
    before = z;
  }
  ASSERT_GE(phases.size(), 4u);
  for (const double phase : phases) EXPECT_NEAR(phase, phases.front(), 0.02 / 2);
  EXPECT_EQ(program.summary().threads.lines + program.summary().threads.out_of_step,
            4 * static_cast<std::int64_t>(phases.size()));
}

/// A turret of a Fanuc lathe does not stop it.
TEST(Threads, FollowASpindleThatTurnsOnBehindATurret) {
  machine::Machine machine = machine::mill3();
  machine.dialect = machine::Dialect::fanuc_lathe;
  machine.spindle = machine::Spindle{.acceleration = 2000, .wander = 0.05, .wander_period = 3, .seed = 7};
  gcode::ReaderOptions options;
  options.dialect = machine.dialect;
  const machine::ToolTable tools;
  const std::string text = "G97 S600 M3\nT0200\nG0 X20. Z2.\nG32 Z-10. F1.5\nT0300\nG0 Z2.\nG32 Z-10. F1.5\nM30\n";
  const auto fail = [](const base::Diagnostic& problem) { ADD_FAILURE() << problem.message; };
  pipeline::Program program(gcode::text_source(text), machine, tools, options, fail);
  int turned = 0;
  program.on_event([&](const base::PassedEvent& event) { turned += event.kind == Kind::turret_indexing ? 1 : 0; });
  while (program.prepare()) program.cycle();
  EXPECT_EQ(turned, 2);
  EXPECT_EQ(program.summary().threads.lines, 2);
}

/// A word that stands for the index, and abort there and on the way: motion rests at once, and within limits.
RC_GTEST_PROP(Threads, ComeToRestWhereTheyAreAborted, ()) {
  const Case made = Case::any();
  const machine::ToolTable tools;
  const auto none = [](const base::Diagnostic&) {};
  std::size_t whole = 0;
  {
    pipeline::Program program(gcode::text_source(made.text), made.machine, tools, {}, none);
    for (; program.prepare(); ++whole) program.cycle();
  }
  const auto abort_at = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(whole)));
  RC_LOG() << "aborted at word " << abort_at << " of " << whole << '\n';
  pipeline::Program program(gcode::text_source(made.text), made.machine, tools, {}, none);
  program.slice(0.02);
  std::vector<base::Word> words;
  while (program.prepare()) {
    if (words.size() == abort_at) program.abort();
    words.push_back(program.cycle());
  }
  RC_ASSERT(words.back().state == base::MotionState::rest);
  RC_ASSERT(std::abs(program.summary().length_mm - words.back().path_length) <= 1e-6);
  words.insert(words.begin(), 3, words.front());
  words.insert(words.end(), 3, words.back());
  const double t = made.machine.period.seconds();
  for (std::size_t k = 3; k < words.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const machine::AxisLimits& limits = *made.machine.axes[i];
      const double a = words[k].position[i], b = words[k - 1].position[i], c = words[k - 2].position[i],
                   d = words[k - 3].position[i];
      RC_ASSERT(std::abs(a - b) / t <= 1.001 * limits.velocity);
      RC_ASSERT(std::abs(a - 2 * b + c) / (t * t) <= 1.001 * limits.acceleration + 1e-9 / (t * t));
      RC_ASSERT(std::abs(a - 3 * b + 3 * c - d) / (t * t * t) <= 1.001 * limits.jerk + 1e-9 / (t * t * t));
    }
  }
}

}  // namespace test_threads
