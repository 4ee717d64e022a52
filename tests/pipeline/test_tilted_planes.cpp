#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/pose.hpp>
#include <leadscrew/referee/referee.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "five_axes.hpp"
#include "random_programs.hpp"
#include "worst_ratios.hpp"

// Programs in a tilted working plane, on every kind of machine: the tip is where the program says, by the referee's own
// kinematics, and every limit is kept.

namespace test_tilted_planes {

using namespace leadscrew;
using campaign::Target;
using machine::Vector;
using testing_support::any;
using testing_support::limits_of;
using testing_support::TiltedProgram;
using testing_support::tilting_machine;
using testing_support::two_tools;
using testing_support::worst_judged;
using testing_support::worst_planned;

double distance(const base::AxisVector& a, const Vector& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double from_axis(const base::AxisVector& tip, const Target& arc) {
  Vector across = {tip[0] - arc.center[0], tip[1] - arc.center[1], tip[2] - arc.center[2]};
  double along = 0;
  for (std::size_t i = 0; i < 3; ++i) along += across[i] * arc.normal[i];
  for (std::size_t i = 0; i < 3; ++i) across[i] -= along * arc.normal[i];
  return std::hypot(across[0], across[1], across[2]);
}

std::vector<gcode::Move> moves_of(const std::string& text, const machine::Machine& machine, std::string& problems) {
  const machine::ToolTable tools = two_tools();
  gcode::Reader reader(gcode::text_source(text), machine, tools, {}, [&](const base::Diagnostic& problem) {
    if (problem.severity == base::Severity::error) problems += problem.message + "\n";
  });
  std::vector<gcode::Move> moves;
  gcode::Move move;
  while (reader.next(move)) moves.push_back(move);
  return moves;
}

bool moves_linear_axes(const gcode::Move& move) {
  return move.kind == gcode::Move::Kind::arc || move.kind == gcode::Move::Kind::nurbs ||
         (move.kind == gcode::Move::Kind::line &&
          (move.end[0] != move.start[0] || move.end[1] != move.start[1] || move.end[2] != move.start[2]));
}

/// Points of an arc or of a curve of circles, in the axes.
std::vector<base::AxisVector> points_of(const gcode::Move& move) {
  std::vector<base::AxisVector> points;
  if (move.kind == gcode::Move::Kind::arc) {
    const auto first = base::index(first_axis(move.plane)), second = base::index(second_axis(move.plane));
    const double x = move.start[first] - move.center_first, y = move.start[second] - move.center_second;
    for (const double angle : {0.3, 1.1, 2.9}) {
      const double turned = move.turns > 0 ? angle : -angle;
      base::AxisVector point = move.start;
      point[first] = move.center_first + x * std::cos(turned) - y * std::sin(turned);
      point[second] = move.center_second + x * std::sin(turned) + y * std::cos(turned);
      points.push_back(point);
    }
  }
  for (std::size_t k = 0; move.kind == gcode::Move::Kind::nurbs && k + 2 < move.curve.points.size(); k += 2) {
    const double b[] = {0.49, 0.42, 0.09};
    base::AxisVector point{};
    double weight = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const gcode::ControlPoint& control = move.curve.points[k + i];
      weight += b[i] * control.weight;
      for (std::size_t a = 0; a < point.size(); ++a) point[a] += b[i] * control.weight * control.position[a];
    }
    for (double& each : point) each /= weight;
    points.push_back(point);
  }
  return points;
}

RC_GTEST_PROP(TiltedPlanes, LeadTheTipWhereTheProgramSays, ()) {
  const machine::Machine machine = tilting_machine();
  TiltedProgram program;
  const std::string text = program.make(any(1, 12));
  RC_LOG() << machine.kinematics << "\n" << text;
  std::string problems;
  const auto moves = moves_of(text, machine, problems);
  RC_ASSERT(problems == "");
  const referee::Pose pose(machine);
  std::size_t next = 0;
  for (const gcode::Move& move : moves) {
    if (!moves_linear_axes(move)) continue;
    RC_ASSERT(next < program.targets().size());
    const Target& target = program.targets()[next++];
    RC_LOG() << "line " << base::number(move.line) << " off by "
             << distance(pose.tip_of(move.end, target.tool), target.end) << "\n";
    RC_ASSERT(distance(pose.tip_of(move.end, target.tool), target.end) < 1e-9);
    RC_ASSERT((move.kind != gcode::Move::Kind::line) == target.is_arc);
    for (const base::AxisVector& each : points_of(move))
      RC_ASSERT(std::fabs(from_axis(pose.tip_of(each, target.tool), target) - target.radius) < 1e-9);
  }
  RC_ASSERT(next == program.targets().size());
}

RC_GTEST_PROP(TiltedPlanes, KeepEveryLimit, ()) {
  const machine::Machine machine = tilting_machine();
  const std::string text = TiltedProgram().make(any(1, 5));
  RC_LOG() << machine.kinematics << "\n" << text << limits_of(machine);
  const machine::ToolTable tools = two_tools();
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, [](const base::Diagnostic& problem) {
    if (problem.severity == base::Severity::error) RC_LOG() << problem.place.line << ": " << problem.message << "\n";
  });
  gcode::Reader judged(gcode::text_source(text), machine, tools, {}, [](const base::Diagnostic&) {});
  referee::Referee referee([&](gcode::Move& move) { return judged.next(move); }, machine, machine.period);
  while (program.prepare()) referee.observe(program.cycle().position);
  const referee::Verdict verdict = referee.conclude();
  RC_ASSERT(worst_planned(program.summary().plan) <= 1 + 1e-9);
  RC_ASSERT(worst_judged(verdict) <= 1.001);
  RC_ASSERT(verdict.feed_max_ratio <= 1.001);
  for (const referee::Violation& each : verdict.violations)
    RC_LOG() << each.what << " " << each.value << " of " << each.limit << " at " << each.t << " line "
             << base::number(each.line) << "\n";
  RC_ASSERT(verdict.violation_count == 0);
}

}  // namespace test_tilted_planes
