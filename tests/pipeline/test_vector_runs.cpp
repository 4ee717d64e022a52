#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/kinematics/vector_run.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/referee.hpp>
#include <numbers>
#include <random_numbers.hpp>

#include "random_programs.hpp"
#include "worst_ratios.hpp"

// Tool vectors, blended, about the poles of random machines: every word within P of the tip's path and within E of the
// programmed direction there, by nothing but the vectors; and every axis within its limits.

namespace test_vector_runs {

using namespace leadscrew;
using kinematics::Vector;
using testing_support::any;
using testing_support::logarithmic;
using testing_support::worst_judged;
using testing_support::worst_planned;

constexpr double degree = std::numbers::pi / 180;

double between(double least, double greatest) {
  return least + (greatest - least) * any(0, 1000001) / 1e6;
}

machine::Machine random_five_axes() {
  machine::Machine machine;
  machine.name = "random five axes";
  const auto& presets = machine::kinematics_presets;
  const auto& preset = presets[static_cast<std::size_t>(any(0, static_cast<int>(presets.size())))];
  machine::RotaryChain chain = *machine::preset_chain(preset.name);
  for (machine::RotaryAxis& axis : chain.axes) {
    axis.point = {between(-80, 80), between(-80, 80), between(-80, 80)};
    axis.sign = any(0, 2) == 0 ? 1 : -1;
  }
  machine.kinematics = preset.name;
  machine.rotary_chain = chain;
  const auto give = [&](base::Axis axis) {
    machine.axes[base::index(axis)] =
        machine::AxisLimits{-1e5, 1e5, logarithmic(10, 1e4), logarithmic(100, 1e5), logarithmic(2000, 2e6), 0.001};
  };
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z}) give(axis);
  for (const machine::RotaryAxis& axis : chain.axes) give(axis.axis);
  machine.period = {4'000'000};
  return machine;
}

struct Pose {
  Vector tip{}, direction{};
};

/// Tips and vectors; the tool turns with the tip.
struct VectorProgram {
  double p = 0, e = 0, cone = 0;
  std::vector<Pose> poses;
  std::vector<kinematics::GreatCircle> circles;  ///< from each direction to the next

  Pose at(double place) const {
    const auto k = std::min(static_cast<std::size_t>(std::max(place, 0.0)), poses.size() - 2);
    const double share = std::clamp(place - static_cast<double>(k), 0.0, 1.0);
    return {numeric::sum(poses[k].tip, share, numeric::difference(poses[k + 1].tip, poses[k].tip)),
            circles[k].at(share)};
  }
  /// The greater of what a pose is off by in the tip and in the direction, of P and E.
  double off(const Pose& pose, double place) const {
    const Pose there = at(place);
    return std::max(numeric::distance(pose.tip, there.tip) / p,
                    kinematics::angle_between(pose.direction, there.direction) / degree / e);
  }
};

VectorProgram random_vectors(const Vector& pole) {
  VectorProgram program;
  program.p = logarithmic(3e-3, 0.1);
  program.e = logarithmic(0.01, 0.5);
  program.cone = program.e * between(0, 1.5);
  const Vector u = {pole[1], pole[2], pole[0]}, v = kinematics::cross_product(pole, u);
  const double spacing = logarithmic(0.1, 3), wide = between(0, 8);
  double x = between(-wide, wide), y = between(-wide, wide);
  Vector tip{};
  for (int k = any(3, 20); k > 0; --k) {
    const Vector direction = {pole[0] + (x * u[0] + y * v[0]) * degree, pole[1] + (x * u[1] + y * v[1]) * degree,
                              pole[2] + (x * u[2] + y * v[2]) * degree};
    program.poses.push_back({tip, kinematics::unit_vector(direction)});
    tip = {tip[0] + spacing * between(0.5, 1), tip[1] + spacing * between(-0.5, 0.5),
           tip[2] + spacing * between(-1, 1)};
    const double step = logarithmic(0.02, 4);
    switch (any(0, 4)) {
      case 0:
        x = -x + between(-1, 1) * program.e;
        y = -y;
        break;
      case 1:
        x = between(-1, 1) * program.e;
        y = between(-1, 1) * program.e;
        break;
      default:
        x = 0.9 * x + between(-step, step);
        y = 0.9 * y + between(-step, step);
    }
  }
  for (std::size_t k = 0; k + 1 < program.poses.size(); ++k)
    program.circles.emplace_back(program.poses[k].direction, program.poses[k + 1].direction);
  return program;
}

struct Moves {
  std::vector<gcode::Move> all;
  base::AxisVector start{};
};

std::optional<Moves> moves_of(const VectorProgram& program, const machine::Machine& machine) {
  const kinematics::Chain chain = kinematics::chain_of(machine);
  kinematics::VectorRun run(chain, kinematics::limits_of(machine, chain), {program.e, program.cone, true});
  bool is_done = run.begin_free(program.poses[0].tip, program.poses[0].direction, {0, 0});
  for (std::size_t k = 1; k < program.poses.size() && is_done; ++k)
    is_done = run.add(program.poses[k].tip, program.poses[k].direction);
  if (!run.finish() || !is_done) return std::nullopt;
  const auto place = [&](const Vector& tip, const kinematics::Angles<double>& angles) {
    base::AxisVector all{};
    for (std::size_t i = 0; i < 3; ++i) all[i] = tip[i];
    for (std::size_t i = 0; i < 2; ++i) all[base::index(chain.turns()[i].axis)] = angles[i];
    return all;
  };
  Moves moves;
  base::AxisVector at = place(program.poses[0].tip, run.start_angles());
  moves.start = kinematics::machine_of(chain, at, {});
  const double feed = logarithmic(20, 100);
  for (const kinematics::RunVertex& vertex : run.take()) {
    gcode::Move move;
    move.start = at;
    move.end = at = place(vertex.tip, vertex.angles);
    move.is_of_tip = true;
    move.tolerance = move.naive_cam_tolerance = program.p;
    move.orientation_tolerance = vertex.tolerance;
    move.feed = {gcode::Feed::Mode::units_per_second, feed};
    move.line = base::Line{static_cast<int>(vertex.segment) + 1};
    moves.all.push_back(move);
  }
  return moves;
}

/// From the place where the last word was on: the worst of all words.
class PoseMatcher {
 public:
  explicit PoseMatcher(const VectorProgram& program) : program_(program) {}

  void observe(const Pose& pose) {
    double best = 1e9;
    const double leg = std::floor(place_), last = static_cast<double>(program_.poses.size()) - 2;
    for (double k = std::max(leg - 1, 0.0); k <= std::min(leg + 2, last); ++k) search(pose, k, best);
    worst = std::max(worst, best);
  }

  double worst = 0;

 private:
  /// Along one line both are the farther off the farther from their least.
  void search(const Pose& pose, double leg, double& best) {
    const double golden = (std::sqrt(5.0) - 1) / 2;  // of the width is kept each time, and one of the two places in it
    double from = leg, to = leg + 1, left = to - golden, right = from + golden;
    double off_left = program_.off(pose, left), off_right = program_.off(pose, right);
    while (to - from > 1e-5) {
      if (off_left < off_right) {
        to = right, right = left, off_right = off_left;
        off_left = program_.off(pose, left = to - golden * (to - from));
      } else {
        from = left, left = right, off_left = off_right;
        off_right = program_.off(pose, right = from + golden * (to - from));
      }
    }
    const double off = std::min(off_left, off_right);
    if (off >= best) return;
    best = off;
    place_ = from;
  }

  const VectorProgram& program_;
  double place_ = 0;
};

RC_GTEST_PROP(BlendedVectors, KeepTheTipWithinPAndTheToolWithinE, ()) {
  const machine::Machine machine = random_five_axes();
  const kinematics::Chain chain = kinematics::chain_of(machine);
  const VectorProgram program = random_vectors(chain.turns()[0].direction);
  const std::optional<Moves> moves = moves_of(program, machine);
  RC_LOG() << machine.kinematics << " P " << program.p << " E " << program.e << " cone " << program.cone << "\n"
           << testing_support::limits_of(machine);
  for (const Pose& pose : program.poses)
    RC_LOG() << pose.tip[0] << " " << pose.tip[1] << " " << pose.tip[2] << "  " << pose.direction[0] << " "
             << pose.direction[1] << " " << pose.direction[2] << "\n";
  RC_ASSERT(moves.has_value());
  std::size_t next = 0, judged = 0;
  pipeline::Program motion(
      [&](gcode::Move& move) {
        if (next == moves->all.size()) return pipeline::Supply::end;
        move = moves->all[next++];
        return pipeline::Supply::move;
      },
      machine, moves->start);
  referee::Referee referee(
      [&](gcode::Move& move) {
        if (judged == moves->all.size()) return false;
        move = moves->all[judged++];
        return true;
      },
      machine, machine.period);
  PoseMatcher matcher(program);
  while (motion.prepare()) {
    const base::AxisVector position = motion.cycle().position;
    referee.observe(position);
    const auto pose = kinematics::pose_of(chain, position, {});
    matcher.observe(
        {{pose[0], pose[1], pose[2]},
         kinematics::direction_of(chain, kinematics::angles_of(chain, kinematics::Coordinates<double>(position)))});
  }
  const referee::Verdict verdict = referee.conclude();
  for (const referee::Violation& each : verdict.violations)
    RC_LOG() << each.what << " " << each.value << " of " << each.limit << " at " << each.t << "\n";
  RC_ASSERT(worst_planned(motion.summary().plan) <= 1 + 1e-9);
  RC_ASSERT(worst_judged(verdict) <= 1.001);
  RC_ASSERT(verdict.feed_max_ratio <= 1.001);
  RC_ASSERT(verdict.violation_count == 0);
  RC_ASSERT(matcher.worst <= 1.002);
}

}  // namespace test_vector_runs
