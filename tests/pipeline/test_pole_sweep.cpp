#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/kinematics/vector_run.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/referee.hpp>
#include <numbers>

#include "worst_ratios.hpp"

// A tool that swings from −20° to 20° over 40 mm, past the pole of a trunnion table at distances down to a millionth of a
// degree. However near it is, motion takes little longer than without a jerk limit, and planning little more work.

namespace test_pole_sweep {

using namespace leadscrew;
using kinematics::RunVertex;
using kinematics::VectorRunSettings;
using testing_support::worst_judged;
using testing_support::worst_planned;

constexpr double degree = std::numbers::pi / 180;
constexpr double programmed_feed = 50, tolerance = 0.01;  // mm/s, mm

machine::Machine trunnion() {
  machine::Machine machine;
  machine.name = "trunnion";
  machine.kinematics = "table-table-ac";
  machine.rotary_chain = machine::preset_chain(machine.kinematics);
  machine.rotary_chain->axes[0].point = {0, 0, -50};
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z})
    machine.axes[base::index(axis)] = machine::AxisLimits{-1e4, 1e4, 400, 3000, 60'000, 0.001};
  machine.axes[base::index(base::Axis::A)] = machine::AxisLimits{-1e4, 1e4, 180, 1500, 30'000, 0.001};
  machine.axes[base::index(base::Axis::C)] = machine::AxisLimits{-1e4, 1e4, 360, 3000, 60'000, 0.001};
  machine.period = {1'000'000};
  return machine;
}

class Swing {
 public:
  Swing(double miss, const VectorRunSettings& settings, int steps = 400) : settings_(settings) {
    const kinematics::Chain chain = kinematics::chain_of(machine_);
    kinematics::VectorRun run(chain, kinematics::limits_of(machine_, chain), settings);
    const auto add = [&](int k) {
      const double angle = (40.0 * k / steps - 20) * degree, m = miss * degree;
      const kinematics::Vector tip = {40.0 * k / steps - 20, 5, 0};
      const kinematics::Vector direction = {std::sin(angle), std::cos(angle) * std::sin(m),
                                            std::cos(angle) * std::cos(m)};
      return k == 0 ? run.begin_free(tip, direction, {0, 0}) : run.add(tip, direction);
    };
    for (int k = 0; k <= steps; ++k) EXPECT_TRUE(add(k));
    EXPECT_TRUE(run.finish());
    base::AxisVector at = place({-20, 5, 0}, run.start_angles());
    start_ = kinematics::machine_of(chain, at, {});
    for (const RunVertex& vertex : run.take()) moves_.push_back(move_to(vertex, at));
  }

  const std::vector<gcode::Move>& moves() const { return moves_; }

  pipeline::MoveInput input() const {
    return [this, next = std::size_t{0}](gcode::Move& move) mutable {
      if (next == moves_.size()) return pipeline::Supply::end;
      move = moves_[next++];
      return pipeline::Supply::move;
    };
  }

  pipeline::Summary travel() const {
    pipeline::Program program(input(), machine_, start_);
    referee::Referee referee(
        [this, next = std::size_t{0}](gcode::Move& move) mutable {
          if (next == moves_.size()) return false;
          move = moves_[next++];
          return true;
        },
        machine_, machine_.period);
    while (program.prepare()) referee.observe(program.cycle().position);
    const referee::Verdict verdict = referee.conclude();
    EXPECT_LE(worst_planned(program.summary().plan), 1 + 1e-9);
    EXPECT_LE(worst_judged(verdict), 1.001);
    EXPECT_LE(verdict.feed_max_ratio, 1.001);
    EXPECT_EQ(verdict.violation_count, 0);
    return program.summary();
  }

  /// Units of planning a second of motion.
  double effort() const {
    pipeline::MotionSource source(input(), machine_, start_);
    double seconds = 0;
    while (const std::optional<planner::Chunk> chunk = source.next()) seconds += chunk->duration.value();
    return source.planner().effort() / seconds;
  }

 private:
  static base::AxisVector place(const kinematics::Vector& tip, const kinematics::Angles<double>& angles) {
    base::AxisVector all{};
    for (std::size_t i = 0; i < 3; ++i) all[i] = tip[i];
    all[base::index(base::Axis::C)] = angles[0];
    all[base::index(base::Axis::A)] = angles[1];
    return all;
  }

  static gcode::Move move_to(const RunVertex& vertex, base::AxisVector& at) {
    gcode::Move move;
    move.start = at;
    move.end = at = place(vertex.tip, vertex.angles);
    move.is_of_tip = true;
    move.tolerance = move.naive_cam_tolerance = tolerance;
    move.orientation_tolerance = vertex.tolerance;
    move.feed = {gcode::Feed::Mode::units_per_second, programmed_feed};
    move.line = base::Line{static_cast<int>(vertex.segment) + 1};
    return move;
  }

  machine::Machine machine_ = trunnion();
  VectorRunSettings settings_;
  base::AxisVector start_{};
  std::vector<gcode::Move> moves_;
};

const std::vector<double> all_misses = {5, 2, 1, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 1e-3, 1e-4, 1e-5, 1e-6, 0};

void expect_quick(const VectorRunSettings& settings, int steps, const std::vector<double>& misses = all_misses) {
  const double effort = Swing(5, settings, steps).effort();
  for (const double miss : misses) {
    SCOPED_TRACE(miss);
    const Swing swing(miss, settings, steps);
    const pipeline::Summary summary = swing.travel();
    EXPECT_LE(summary.time_s, (miss >= 1 ? 1.06 : 1.15) * summary.bound_s);
    EXPECT_LE(swing.effort(), 3 * effort);
  }
}

TEST(PoleSweep, TakesLittleLongerThanWithoutJerkAndLittleWork) {
  expect_quick({0.05, 0.1, true}, 400);
}

/// Without a cone, and about where directions beside the pole begin to be taken for it: 5.7e-5 degrees.
TEST(PoleSweep, GoesRoundAsWell) {
  expect_quick({0.05, 0, true}, 400);
  expect_quick({0.05, 0, true}, 400, {8e-5, 6e-5, 5.73e-5, 5.72e-5, 5e-5, 3e-5, 2e-5, 5e-6, 1e-7, 1e-9, 1e-12});
  expect_quick({0.05, 0, true}, 401, {1e-3, 1e-4, 6e-5, 5e-5, 1e-5, 1e-6, 1e-9});
}

TEST(PoleSweep, TakesCoarseAndFineVectors) {
  expect_quick({0.05, 0.1, true}, 40);
  expect_quick({0.05, 0.1, true}, 2000);
}

/// Going round takes 1.33 s.
TEST(PoleSweep, LeadsStraightThroughAtFeed) {
  const pipeline::Summary summary = Swing(0.2, {0.25, 0.25, true}).travel();
  EXPECT_LE(summary.time_s, 0.95);
  EXPECT_GT(Swing(0.2, {0.25, 0.1, true}).travel().time_s, 1.2);
}

}  // namespace test_pole_sweep
