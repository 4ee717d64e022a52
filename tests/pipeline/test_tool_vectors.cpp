#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <leadscrew/kinematics/great_circle.hpp>
#include <leadscrew/referee/pose.hpp>
#include <numbers>
#include <trunnion.hpp>

#include "five_axes.hpp"
#include "random_programs.hpp"
#include "worst_ratios.hpp"

// Tool vectors (G43.5): what a program asks for is kept here as it was written, and what comes of it is judged by the
// referee's own kinematics: at the ends of blocks, between them, and word for word.

namespace test_tool_vectors {

using namespace leadscrew;
using campaign::Programmed;
using kinematics::angle_between;
using kinematics::GreatCircle;
using kinematics::Vector;
using testing_support::any;
using testing_support::direction_at;
using testing_support::five_axes;
using testing_support::judge;
using testing_support::Judged;
using testing_support::limits_of;
using testing_support::tip_of;
using testing_support::two_tools;
using testing_support::VectorProgram;
using testing_support::worst_judged;
using testing_support::worst_planned;

constexpr double radian = std::numbers::pi / 180;

/// Moves of a text, and whether a direction of it is out of reach.
struct Moves {
  std::vector<gcode::Move> moves;
  bool is_out_of_reach = false;
  int errors = 0;
};

Moves moves_of(const std::string& text, const machine::Machine& machine) {
  Moves result;
  const machine::ToolTable tools = two_tools();
  gcode::Reader reader(gcode::text_source(text), machine, tools, {}, [&](const base::Diagnostic& problem) {
    if (problem.severity != base::Severity::error) return;
    ++result.errors;
    result.is_out_of_reach |= problem.code == "pose-out-of-reach";
  });
  gcode::Move move;
  while (reader.next(move)) result.moves.push_back(move);
  return result;
}

/// A place of a line of moves, or of a curve of them; share 0 … 1.
base::AxisVector place_of(const gcode::Move& move, double share) {
  base::AxisVector place{};
  if (move.kind == gcode::Move::Kind::line) {
    for (std::size_t i = 0; i < place.size(); ++i)
      place[i] = share < 1 ? move.start[i] + (move.end[i] - move.start[i]) * share : move.end[i];
    return place;
  }
  // de Boor's algorithm.
  const auto& curve = move.curve;
  const auto p = static_cast<std::size_t>(curve.degree);
  const double u = curve.knots.front() + share * (curve.knots.back() - curve.knots.front());
  std::size_t span = p;
  while (span + 1 < curve.points.size() && curve.knots[span + 1] <= u) ++span;
  std::vector<base::AxisVector> d;
  for (std::size_t j = 0; j <= p; ++j) d.push_back(curve.points[span - p + j].position);
  for (std::size_t r = 1; r <= p; ++r) {
    for (std::size_t j = p; j >= r; --j) {
      const double left = curve.knots[span - p + j], right = curve.knots[span + 1 + j - r];
      const double a = right > left ? (u - left) / (right - left) : 0;
      for (std::size_t i = 0; i < place.size(); ++i) d[j][i] = (1 - a) * d[j - 1][i] + a * d[j][i];
    }
  }
  return d[p];
}

/// How far along the line a tip is; `otherwise` where the tip stands.
double share_of(const Programmed& line, const Vector& tip, double otherwise) {
  const Vector way = numeric::difference(line.to, line.from);
  const double square = numeric::dot(way, way);
  return square > 0 ? numeric::dot(numeric::difference(tip, line.from), way) / square : otherwise;
}

double angle_to(const GreatCircle& circle, const Vector& direction, double share) {
  return angle_between(circle.at(share), direction) / radian;
}

/// The least of a function from 0 to 1.
template <class Function>
double least_of(Function&& f) {
  constexpr int parts = 64;
  double best = f(0.0), low = 0, high = 1;
  for (int k = 0; k <= parts; ++k) {
    const double value = f(static_cast<double>(k) / parts);
    if (value > best) continue;
    best = value;
    low = std::max((k - 1.0) / parts, 0.0);
    high = std::min((k + 1.0) / parts, 1.0);
  }
  for (int k = 0; k < 60; ++k) {
    const double third = (high - low) / 3;
    if (f(low + third) < f(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  return std::min(best, f((low + high) / 2));
}

/// The moves of one line: where the tip goes, and how the tool is held. Degrees, the greatest departure from the great
/// circle, and at the end.
struct Departures {
  double tip = 0, along = 0, end = 0;
};

Departures departures_of(const Programmed& line, const std::vector<gcode::Move>& moves, const referee::Pose& pose) {
  Departures worst;
  const GreatCircle circle(line.direction_from, line.direction_to);
  for (const gcode::Move& move : moves) {
    if (move.line != base::line_at(line.line) || move.kind == gcode::Move::Kind::event) continue;
    const int parts = move.kind == gcode::Move::Kind::line ? 4 : 400;
    for (int k = 0; k <= parts; ++k) {
      const base::AxisVector place = place_of(move, static_cast<double>(k) / parts);
      const Vector tip = tip_of(place), direction = direction_at(pose, place);
      const double share = share_of(line, tip, -1);
      const Vector straight = numeric::sum(line.from, std::max(share, 0.0), numeric::difference(line.to, line.from));
      worst.tip = std::max(worst.tip, numeric::norm(numeric::difference(tip, straight)));
      if (line.is_free) continue;
      worst.along =
          std::max(worst.along, share < 0 ? least_of([&](double at) { return angle_to(circle, direction, at); })
                                          : angle_to(circle, direction, std::clamp(share, 0.0, 1.0)));
    }
  }
  return worst;
}

/// Angles go as 1/s beside a pole: a spline through places ever farther apart would swing about that.
TEST(ToolVectors, FollowGreatCirclesPastAPoleOnTheExactPath) {
  const machine::Machine machine = testing_support::trunnion();
  const Moves read = moves_of(
      "G21 G90 G17 G94 G61\nG43.5 H1\nG1 X0 Y0 Z0 F3000\n"
      "G1 X-0.6 Y-0.6 Z-0.6 I0.000030826 J-0.001471624 K0.099989166\n"
      "G1 X-1.2 Y-1.2 Z-1.2 I-0.000002592 J0.000135475 K0.100009580\n"
      "G1 X-1.8 Y-1.8 Z-1.8 I0.000078476 J-0.001957211 K0.099980814\nM2\n",
      machine);
  EXPECT_EQ(read.errors, 0);
  const Programmed line{5,
                        {-0.6, -0.6, -0.6},
                        {-1.2, -1.2, -1.2},
                        kinematics::unit_vector({0.000030826, -0.001471624, 0.099989166}),
                        kinematics::unit_vector({-0.000002592, 0.000135475, 0.100009580}),
                        false};
  ASSERT_TRUE(std::ranges::any_of(read.moves, [](const auto& move) { return base::number(move.line) == 5; }));
  EXPECT_LE(departures_of(line, read.moves, referee::Pose(machine)).along,
            machine.rotary_chain->orientation_tolerance / 4);
}

/// The last move of each line leads to its end.
const gcode::Move* last_move_of(const Programmed& line, const std::vector<gcode::Move>& moves) {
  const gcode::Move* last = nullptr;
  for (const gcode::Move& move : moves) {
    if (move.line == base::line_at(line.line) && move.kind != gcode::Move::Kind::event) last = &move;
  }
  return last;
}

/// Where tools differ from the coordinates of the axes, the first line begins elsewhere than at 0.
void set_beginning(std::vector<Programmed>& lines, const std::vector<gcode::Move>& moves) {
  if (lines.empty()) return;
  for (const gcode::Move& move : moves) {
    if (move.line != base::line_at(lines.front().line) || move.kind == gcode::Move::Kind::event) continue;
    lines.front().from = tip_of(move.start);
    return;
  }
}

RC_GTEST_PROP(ToolVectors, AreHeldAtTheEndsOfBlocksAndBetween, ()) {
  const machine::Machine machine = five_axes();
  VectorProgram program(machine);
  program.make(any(1, 16));
  RC_LOG() << machine.kinematics << "\n" << program.text;
  const Moves read = moves_of(program.text, machine);
  RC_PRE(!read.is_out_of_reach);
  RC_ASSERT(read.errors == 0);
  const referee::Pose pose(machine);
  const bool blends = program.tolerance > 0;
  const double e = blends ? program.orientation_tolerance : machine.rotary_chain->orientation_tolerance;
  set_beginning(program.lines, read.moves);
  for (std::size_t k = 1; k < read.moves.size(); ++k) {
    if (read.moves[k - 1].is_of_tip) RC_ASSERT(read.moves[k].start == read.moves[k - 1].end);
  }
  for (const Programmed& line : program.lines) {
    const gcode::Move* const last = last_move_of(line, read.moves);
    if (!last) continue;  // to where the tool is
    const double off = angle_between(direction_at(pose, last->end), line.direction_to);
    RC_ASSERT(tip_of(last->end) == line.to);
    RC_ASSERT(off <= (blends ? e * radian : 1e-6));
    const Departures worst = departures_of(line, read.moves, pose);
    RC_LOG() << "line " << line.line << ": tip " << worst.tip << ", direction " << worst.along << " of " << e << "\n";
    RC_ASSERT(worst.tip <= 1e-9);
    RC_ASSERT(worst.along <= (blends ? e : e / 4) * 1.001 + 1e-5);
  }
}

RC_GTEST_PROP(ToolVectors, KeepEveryLimitAndEveryPoint, ()) {
  const machine::Machine machine = five_axes();
  VectorProgram program(machine);
  program.make(any(1, 5));
  RC_LOG() << machine.kinematics << "\n" << program.text << limits_of(machine);
  RC_PRE(!moves_of(program.text, machine).is_out_of_reach);
  const Judged outcome = judge(program.text, machine);
  RC_ASSERT(outcome.errors == 0);
  RC_ASSERT(worst_planned(outcome.summary.plan) <= 1 + 1e-9);
  RC_ASSERT(worst_judged(outcome.verdict) <= 1.001);
  RC_ASSERT(outcome.verdict.feed_max_ratio <= 1.001);
  for (const referee::Violation& each : outcome.verdict.violations)
    RC_LOG() << each.what << " " << each.value << " of " << each.limit << " at " << each.t << " line "
             << base::number(each.line) << "\n";
  RC_ASSERT(outcome.verdict.violation_count == 0);
  RC_ASSERT(outcome.summary.bound_s <= outcome.summary.time_s * (1 + 1e-6));
}

/// How far a word is from a line, in tolerances of the tip and of the direction, whichever is more; of the best place.
double distance_to(const Programmed& line, const GreatCircle& circle, const Vector& tip, const Vector& direction,
                   double p, double e) {
  const auto at = [&](double share) {
    const Vector there = numeric::sum(line.from, share, numeric::difference(line.to, line.from));
    return std::max(numeric::norm(numeric::difference(tip, there)) / p, angle_to(circle, direction, share) / e);
  };
  const double nearest = at(std::clamp(share_of(line, tip, 0), 0.0, 1.0));
  return nearest <= 1 ? nearest : std::min(nearest, least_of(at));
}

/// Every word, by the referee's kinematics, against the program as it was written.
RC_GTEST_PROP(ToolVectors, AreHeldWordForWord, ()) {
  const machine::Machine machine = five_axes();
  VectorProgram program(machine);
  program.make(any(1, 4));
  RC_LOG() << machine.kinematics << "\n" << program.text << limits_of(machine);
  const Moves read = moves_of(program.text, machine);
  RC_PRE(!read.is_out_of_reach);
  set_beginning(program.lines, read.moves);
  const referee::Pose pose(machine);
  const machine::ToolTable tools = two_tools();
  const bool blends = program.tolerance > 0;
  const double p = program.tolerance + 1e-6;
  const double e = (blends ? program.orientation_tolerance : machine.rotary_chain->orientation_tolerance / 4) + 1e-4;
  std::vector<GreatCircle> circles;
  for (const Programmed& line : program.lines) circles.emplace_back(line.direction_from, line.direction_to);
  pipeline::Program motion(gcode::text_source(program.text), machine, tools, {}, nullptr);
  while (motion.prepare()) {
    const base::Word word = motion.cycle();
    const std::int64_t number = base::number(word.line);
    if (base::count(word.tick) % 5 != 0 || number < program.lines.front().line) continue;
    const Vector tip = tip_of(pose.tip_of(word.position, {0, 0, 73.25})), direction = direction_at(pose, word.position);
    // A fit takes many lines together and names one of them.
    double best = 1e9;
    for (std::int64_t apart = 0; apart <= 12 && best > 1; ++apart) {
      for (std::size_t k = 0; k < program.lines.size() && best > 1; ++k) {
        const Programmed& line = program.lines[k];
        if (std::abs(line.line - number) != apart) continue;
        best = std::min(best, line.is_free ? 0 : distance_to(line, circles[k], tip, direction, p, e));
      }
    }
    if (best > 1) RC_LOG() << "line " << number << ": " << best << " at " << base::count(word.tick) << "\n";
    RC_ASSERT(best <= 1);
  }
}

}  // namespace test_tool_vectors
