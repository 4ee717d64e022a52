// Taps that follow a spindle whose speed wanders, on random machines: in step on the way in and out behind a run-in that is
// told, never deeper than programmed, within limits, and the spindle stands where the tool does.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/kinematics/transformation.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <string>
#include <vector>

#include "judged_run.hpp"
#include "spindle_machines.hpp"

namespace test_taps {

using namespace leadscrew;
using testing_support::between;
using Kind = base::Event::Kind;

const machine::ToolTable no_tools;

/// A machine and a program of taps along Z.
struct Case {
  machine::Machine machine;
  std::string text;

  static Case any() {
    Case made;
    made.machine = testing_support::machine_with_spindle();
    const machine::AxisLimits& z = *made.machine.axes[2];
    const machine::Derivatives limits{z.velocity, z.acceleration, z.jerk};
    char block[200];
    made.text = "G21 G90 G94 G17 F600\n";
    for (int k = *rc::gen::inRange(1, 4); k > 0; --k) {
      const double lead = between(0.2, 4), most = z.velocity / lead / 1.12 / between(1, 2);
      const double acceleration =
          machine::tap_acceleration(*made.machine.spindle, limits, lead, made.machine.tolerance, made.machine.period);
      const double turns =
          std::min({between(0.5, 60), most, std::sqrt(2 * acceleration * between(1, 50) / lead)});  // revolutions per s
      const double v = lead * turns, rise = 2 * std::sqrt(v / z.jerk) + v / z.acceleration;
      const double depth = lead * turns * turns / (2 * acceleration) * 1.01 + v * (12 * rise + between(0.1, 1)) + lead;
      const bool is_left = *rc::gen::arbitrary<bool>();
      switch (*rc::gen::inRange(0, 3)) {
        case 0:
          std::snprintf(block, sizeof block, "S%.4f M%d\nG0 Z5\nG33.1 Z%.4f K%.4f%s\nG0 X%d\n", 60 * turns,
                        is_left ? 4 : 3, 5 - depth, lead, *rc::gen::arbitrary<bool>() ? " I1.05" : "", k);
          break;
        default:
          std::snprintf(block, sizeof block, "S%.4f M%d\nG0 Z6\n%s X%d Z%.4f R5 P%.2f F%.6f\nG80\nG0 Z7\n", 60 * turns,
                        is_left ? 4 : 3, is_left ? "G74" : "G84", k, 5 - depth, between(0, 0.1), 60 * v);
      }
      made.text += block;
    }
    made.text += "M5\nM2\n";
    RC_LOG() << made.text << testing_support::limits_with_spindle(made.machine);
    return made;
  }
};

/// A tap, from the word that passed its event on.
struct Tap {
  double lead = 0, top = 0, depth = 0;
  double turned_back = 0,
         ended = 0;  ///< |lead · (revolutions since the index) − depth| where the spindle turns back, and at the end
  std::vector<double> s, errors;  ///< along the way in and back, and |place − lead · (revolutions since the index)|
};

/// Each tap's words, matched with the spindle as the test finds it.
class Watcher {
 public:
  explicit Watcher(const machine::Machine& machine) : machine_(machine), spindle_(machine) {}

  std::vector<Tap> taps;

  void pass(const base::PassedEvent& event) {
    if (is_on_ && (event.kind == Kind::spindle_clockwise || event.kind == Kind::spindle_counterclockwise))
      (is_out_ ? taps.back().ended : taps.back().turned_back) = place(base::count(event.tick));
    if (is_on_ && base::is_in_step(event.kind)) taps.back().ended = place(base::count(event.tick));
    spindle_.obey(event, is_on_ && !is_out_ ? acceleration_ : 1e9);
    if (is_on_ && (event.kind == Kind::spindle_clockwise || event.kind == Kind::spindle_counterclockwise))
      is_out_ = true;
    if (!base::is_in_step(event.kind)) return;
    is_on_ = event.value > 0;
    if (!is_on_) return;
    is_out_ = has_index_ = false;
    first_ = base::count(event.tick);
    begin_ = event.path_length;
    way_ = spindle_.way();
    taps.push_back({.lead = event.value});
    const machine::AxisLimits& z = *machine_.axes[2];
    acceleration_ = machine::tap_acceleration(*machine_.spindle, {z.velocity, z.acceleration, z.jerk}, event.value,
                                              machine_.tolerance, machine_.period);
  }

  void see(const base::Word& word) {
    if (!is_on_) return;
    const std::int64_t tick = base::count(word.tick);
    Tap& tap = taps.back();
    if (tick == first_) tap.top = word.position[2];
    if (!has_index_ && tick > first_ && spindle_.is_at_speed(tick - 1) && spindle_.passes_index(tick - 1)) {
      has_index_ = true;
      index_ = std::floor(spindle_.at(tick));
    }
    const double deep = tap.top - word.position[2];
    tap.depth = std::max(tap.depth, deep);
    tap.s.push_back(word.path_length - begin_);
    if (!has_index_) RC_ASSERT(deep <= 1e-9);
    tap.errors.push_back(has_index_ ? std::abs(deep - place(tick)) : 0);
  }
  /// Behind the word, the spindle is braked as the programmed depth asks for.
  void brake(const base::Word& word, double depth) {
    if (!is_on_ || !has_index_) return;
    const double end = way_ * (index_ + (is_out_ ? 0 : depth / taps.back().lead));
    spindle_.stand_at(end, base::count(word.tick), acceleration_);
  }

 private:
  double place(std::int64_t tick) const { return taps.back().lead * (way_ * spindle_.clockwise_at(tick) - index_); }

  const machine::Machine& machine_;
  testing_support::SpindleOfEvents spindle_;
  bool is_on_ = false, is_out_ = false, has_index_ = false;
  double begin_ = 0, index_ = 0, way_ = 1, acceleration_ = 0;
  std::int64_t first_ = 0;
};

/// Depths of the program's taps, in order.
std::vector<double> depths_of(const Case& made) {
  std::vector<double> depths;
  gcode::Reader reader(gcode::text_source(made.text), made.machine, no_tools, {}, [](const base::Diagnostic&) {});
  double from = 0;
  bool begins = false;
  for (gcode::Move move; reader.next(move);) {
    if (move.kind == gcode::Move::Kind::event) {
      if (base::is_in_step(move.event.kind)) begins = move.event.value > 0;
      continue;
    }
    if (move.kind == gcode::Move::Kind::dwell) continue;
    if (begins) depths.push_back(from - move.end[2]);
    begins = false;
    from = move.end[2];
  }
  return depths;
}

RC_GTEST_PROP(Taps, AreInStepOnTheWayInAndOut, ()) {
  const Case made = Case::any();
  const std::vector<double> depths = depths_of(made);
  Watcher watcher(made.machine);
  const pipeline::Summary summary = testing_support::judged_run(
      made.text, made.machine, [&](const base::PassedEvent& event) { watcher.pass(event); },
      [&](const base::Word& word) {
        watcher.see(word);
        if (!watcher.taps.empty()) watcher.brake(word, depths[watcher.taps.size() - 1]);
      });
  RC_ASSERT(summary.bound_s <= summary.time_s * (1 + 1e-6));
  RC_ASSERT(watcher.taps.size() == depths.size());
  RC_ASSERT(summary.threads.lines == 2 * static_cast<std::int64_t>(depths.size()));
  double longest = 0;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const Tap& tap = watcher.taps[i];
    RC_ASSERT(std::abs(tap.depth - depths[i]) <= 1e-9);
    double run_in = 0;
    for (std::size_t k = 0; k < tap.s.size(); ++k)
      if (tap.errors[k] > made.machine.tolerance * (1 + 1e-9)) run_in = std::max(run_in, tap.s[k]);
    RC_LOG() << "run-in " << run_in << " of " << depths[i] << '\n';
    RC_ASSERT(run_in < depths[i]);
    RC_ASSERT(std::abs(tap.turned_back - depths[i]) <= made.machine.tolerance);
    RC_ASSERT(std::abs(tap.ended) <= made.machine.tolerance);
    longest = std::max(longest, run_in);
  }
  RC_LOG() << "told " << summary.threads.run_in << '\n';
  RC_ASSERT(std::abs(summary.threads.run_in - longest) <= 1e-9);
}

/// A tool that points anywhere, held by its tip: where Z of the part asks other axes than Z of the machine.
RC_GTEST_PROP(Taps, ReachTheirDepthWhereverTheToolPoints, ()) {
  machine::Machine machine = testing_support::machine_with_spindle();
  const std::string pointing = testing_support::point_tool(machine);
  const machine::Derivatives least = testing_support::least_limits(machine);
  const double lead = between(0.2, 4);
  // Along any direction an axis allows no more than √3 of the greatest; the bound falls with acceleration, and rises.
  machine::Derivatives greatest = least;
  for (std::size_t i = 0; i < 3; ++i)
    greatest.acceleration = std::max(greatest.acceleration, std::sqrt(3.0) * machine.axes[i]->acceleration);
  const auto brake_by = [&](const machine::Derivatives& limits) {
    return machine::tap_acceleration(*machine.spindle, limits, lead, machine.tolerance, machine.period);
  };
  const double brake = std::min(brake_by(least), brake_by(greatest));
  const double turns =
      std::min({between(0.5, 60), least.velocity / lead / 1.12, std::sqrt(2 * brake * between(1, 50) / lead)});
  const double v = lead * turns, rise = 2 * std::sqrt(v / least.jerk) + v / least.acceleration;
  const double depth = lead * turns * turns / (2 * brake) * 1.01 + v * (12 * rise + between(0.1, 1)) + lead;
  char tap[120];
  std::snprintf(tap, sizeof tap, "S%.4f M3\nG33.1 Z%.4f K%.4f\nM2\n", 60 * turns, -depth, lead);
  const std::string text = "G21 G90 G94 G17 F600\n" + pointing + tap;
  RC_LOG() << text << testing_support::limits_with_spindle(machine);
  const kinematics::Transformation tip{kinematics::Chain::of(*machine.rotary_chain).value()};
  bool has_begun = false;
  double deepest = 0, last = 0;
  const pipeline::Summary summary = testing_support::judged_run(
      text, machine, [&](const base::PassedEvent& event) { has_begun |= base::is_in_step(event.kind); },
      [&](const base::Word& word) {
        last = tip.tip_of(word.position)[2];
        if (has_begun) deepest = std::min(deepest, last);
      });
  RC_ASSERT(std::abs(deepest + std::round(depth * 1e4) / 1e4) <= 1e-9);
  RC_ASSERT(std::abs(last) <= 1e-9);
  RC_ASSERT(summary.threads.lines == 2);
  RC_ASSERT(summary.threads.run_in < depth);
}

/// A spindle that needs more than the depth to stand, and one whose axis cannot go along, are refused.
TEST(Taps, ThatCannotBeCutAreRefused) {
  machine::Machine machine = machine::mill3();
  machine.spindle = machine::Spindle{.acceleration = 1000};
  const auto problems = [&](const std::string& block) {
    return testing_support::problems_of("G21 G90 G94 F600\nG0 Z2\n" + block + "M2\n", machine);
  };
  // (600/60)² / 2 / (1000/60) = 3 turns; (2000/60)² / 2 / (1000/60) = 33.3.
  EXPECT_EQ(problems("S600 M3\nG33.1 Z-1.1 K1\n"), "");
  EXPECT_EQ(problems("S600 M3\nG33.1 Z-0.9 K1\n"), "tap-too-short ");
  EXPECT_EQ(problems("S600 M3\nG84 Z-1.1 R2 F600\n"), "");
  EXPECT_EQ(problems("S600 M3\nG84 Z-0.9 R2 F600\n"), "tap-too-short ");
  EXPECT_EQ(problems("S2000 M4\nG74 Z-30 R2 F2000\n"), "tap-too-short ");
  EXPECT_EQ(problems("S9000 M3\nG84 Z-30 R2 F36000\n"), "thread-too-fast ");
  machine.spindle.reset();
  EXPECT_EQ(problems("S600 M3\nG84 Z-0.9 R2 F600\nG33.1 Z-0.9 K1\n"), "");
}

}  // namespace test_taps
