#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <leadscrew/kinematics/pose.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <numbers>

#include "reading.hpp"

// Under tool centre point control the axes may leave their travel between the ends of a block, while the tip goes straight
// or round a circle: as dense samples of every block have it.

namespace leadscrew::gcode {
namespace test_tip_travel {

constexpr double near_limit = 1e-3;  // mm: so far from a limit a program is inside or outside for certain

double between(double least, double greatest) {
  return least + (greatest - least) * *rc::gen::inRange(0, 1000001) / 1e6;
}

machine::Machine any_five_axes() {
  machine::Machine machine = machine::mill3();
  const auto& presets = machine::kinematics_presets;
  const auto& preset = presets[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(presets.size())))];
  machine::RotaryChain chain = *machine::preset_chain(preset.name);
  for (machine::RotaryAxis& axis : chain.axes) {
    axis.point = {between(-80, 80), between(-80, 80), between(-80, 80)};
    machine.axes[base::index(axis.axis)] = {-3600, 3600, 100, 1000, 20000, 0.001};
  }
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z})
    machine.axes[base::index(axis)] = {-1e5, 1e5, 200, 1000, 20000, 0.001};
  machine.kinematics = preset.name;
  machine.rotary_chain = chain;
  return machine;
}

/// A block of a line, of an arc in any plane or of a curve, from anywhere.
std::string any_block(const machine::Machine& machine) {
  std::string text = "G21 G90 F600\nG43.4 H0\nG0";
  const auto word = [&text](char letter, double value) {
    char written[40];
    std::snprintf(written, sizeof written, " %c%.4f", letter, value);
    text += written;
  };
  const auto angles = [&](double most) {
    for (const machine::RotaryAxis& axis : machine.rotary_chain->axes)
      word(base::letter(axis.axis), between(-most, most));
  };
  double at[3];
  for (int i = 0; i < 3; ++i) word("XYZ"[i], at[i] = between(-100, 100));
  angles(120);
  const int kind = *rc::gen::inRange(0, 4);
  if (kind == 3) {  // a curve of three points in the plane XY, the rotary axes as they are
    text += "\nG5.2";
    word('X', at[0] + between(-60, 60));
    word('Y', at[1] + between(-60, 60));
    text += " P1\n";
    word('X', at[0] + between(-60, 60));
    word('Y', at[1] + between(-60, 60));
    text += " P1\n";
    word('X', at[0] + between(-60, 60));
    word('Y', at[1] + between(-60, 60));
    return text + " P1\nG5.3\nM2\n";
  }
  if (kind == 0) {
    text += "\nG1";
    for (int i = 0; i < 3; ++i) word("XYZ"[i], between(-100, 100));
    angles(150);
    return text + "\nM2\n";
  }
  const int plane = *rc::gen::inRange(0, 3), first = plane == 0 ? 0 : plane == 1 ? 2 : 1, second = (first + 1) % 3;
  text += plane == 0 ? "\nG17" : plane == 1 ? "\nG18" : "\nG19";
  text += *rc::gen::inRange(0, 2) == 0 ? " G2" : " G3";
  const double radius = between(1, 60), from = between(0, 2 * std::numbers::pi), to = between(0, 2 * std::numbers::pi);
  word("XYZ"[first], at[first] + radius * (std::cos(to) - std::cos(from)));
  word("XYZ"[second], at[second] + radius * (std::sin(to) - std::sin(from)));
  word("IJK"[first], -radius * std::cos(from));
  word("IJK"[second], -radius * std::sin(from));
  if (*rc::gen::inRange(0, 2) == 0) angles(150);
  return text + "\nM2\n";
}

/// Of a curve by Cox and de Boor's recursion (Piegl and Tiller, eq. 2.5), as slow as it may be.
double weight_of(const NurbsCurve& curve, std::size_t i, int p, double u) {
  const auto& knots = curve.knots;
  if (p == 0) return knots[i] <= u && u < knots[i + 1] ? 1 : 0;
  const std::size_t k = i + static_cast<std::size_t>(p);
  const double rise = knots[k] > knots[i] ? (u - knots[i]) / (knots[k] - knots[i]) : 0;
  const double fall = knots[k + 1] > knots[i + 1] ? (knots[k + 1] - u) / (knots[k + 1] - knots[i + 1]) : 0;
  return (rise > 0 ? rise * weight_of(curve, i, p - 1, u) : 0) +
         (fall > 0 ? fall * weight_of(curve, i + 1, p - 1, u) : 0);
}

base::AxisVector on_curve(const NurbsCurve& curve, double t) {
  base::AxisVector sum{};
  double weights = 0;
  const double u = curve.knots.front() + t * (1 - 1e-12) * (curve.knots.back() - curve.knots.front());
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const double weight = weight_of(curve, i, curve.degree, u) * curve.points[i].weight;
    weights += weight;
    for (std::size_t q = 0; q < sum.size(); ++q) sum[q] += weight * curve.points[i].position[q];
  }
  for (double& coordinate : sum) coordinate /= weights;
  return sum;
}

base::AxisVector on_move(const Move& move, double t) {
  if (move.kind == Move::Kind::nurbs) return on_curve(move.curve, t);
  base::AxisVector place = move.start;
  for (std::size_t i = 0; i < place.size(); ++i) place[i] += t * (move.end[i] - move.start[i]);
  if (move.kind != Move::Kind::arc) return place;
  const std::size_t first = base::index(first_axis(move.plane)), second = base::index(second_axis(move.plane));
  const double a = move.start[first] - move.center_first, b = move.start[second] - move.center_second;
  const double c = move.end[first] - move.center_first, d = move.end[second] - move.center_second;
  double turned = std::atan2(a * d - b * c, a * c + b * d);
  if (move.turns > 0 && turned <= 0) turned += 2 * std::numbers::pi;
  if (move.turns < 0 && turned >= 0) turned -= 2 * std::numbers::pi;
  place[first] = move.center_first + a * std::cos(t * turned) - b * std::sin(t * turned);
  place[second] = move.center_second + a * std::sin(t * turned) + b * std::cos(t * turned);
  return place;
}

RC_GTEST_PROP(TipTravel, IsLeftWhereDenseSamplesLeaveIt, ()) {
  constexpr int samples = 6000;
  Conditions conditions;
  conditions.machine = any_five_axes();
  const std::string text = any_block(conditions.machine);
  RC_LOG() << conditions.machine.kinematics << "\n" << text;
  const Reading whole = read(text, conditions);
  RC_ASSERT(whole.problems() == "");
  const auto chain = kinematics::chain_of(conditions.machine);
  std::array<double, 3> least{}, greatest{};
  for (const Move& move : whole.moves) {
    if (move.kind == Move::Kind::event || move.kind == Move::Kind::dwell) continue;
    for (int k = 0; k <= samples; ++k) {
      const base::AxisVector axes =
          kinematics::machine_of(chain, on_move(move, static_cast<double>(k) / samples), move.tool);
      for (std::size_t i = 0; i < 3; ++i) {
        least[i] = std::min(least[i], axes[i]);
        greatest[i] = std::max(greatest[i], axes[i]);
      }
    }
  }
  const int axis = *rc::gen::inRange(0, 3), side = *rc::gen::inRange(0, 2);
  const auto i = static_cast<std::size_t>(axis);
  for (const double room : {near_limit, -near_limit}) {
    machine::AxisLimits limits = *conditions.machine.axes[i];
    if (side == 0) {
      limits.travel_max = greatest[i] + room;
    } else {
      limits.travel_min = least[i] - room;
    }
    if (!(limits.travel_min < -near_limit && limits.travel_max > near_limit)) continue;  // the start would be outside
    Conditions tight = conditions;
    tight.machine.axes[i] = limits;
    const std::string problems = read(text, tight).problems();
    RC_LOG() << "XYZ"[i] << " " << limits.travel_min << " " << limits.travel_max << ": " << problems << "\n";
    RC_ASSERT((problems.find("travel") != std::string::npos) == (room < 0));
  }
}

/// The tip stands at X 100 while the table turns by 90°: half way X is no farther, and Y goes there and back.
TEST(TipTravel, TellsHowFarABlockLeadsAnAxis) {
  Conditions conditions;
  conditions.machine = machine::mill3();
  conditions.machine.rotary_chain = machine::preset_chain("table-table-ac");
  for (const base::Axis axis : {base::Axis::A, base::Axis::C})
    conditions.machine.axes[base::index(axis)] = {-360, 360, 100, 1000, 20000, 0.001};
  const std::string text = "G21 G90 F600\nG0 X100 Y100\nG43.4 H0\nG1 C90\nM2\n";
  EXPECT_EQ(read(text, conditions).problems(), "");
  conditions.machine.axes[1]->travel_max = 141;
  const Reading reading = read(text, conditions);
  EXPECT_EQ(reading.problems(), "4:1 travel; ");
  EXPECT_EQ(reading.diagnostics.at(0).message.substr(0, 23), "axis Y would be at 141.");
  conditions.machine.axes[1]->travel_max = 141.422;
  EXPECT_EQ(read(text, conditions).problems(), "");
}

/// A circle of the tip whose chord would be inside and which is not, and one whose chord would not be.
TEST(TipTravel, FollowsACircleOfTheTip) {
  Conditions conditions;
  conditions.machine = machine::mill3();
  conditions.machine.rotary_chain = machine::preset_chain("table-table-ac");
  for (const base::Axis axis : {base::Axis::A, base::Axis::C})
    conditions.machine.axes[base::index(axis)] = {-360, 360, 100, 1000, 20000, 0.001};
  conditions.machine.axes[0]->travel_max = 45;
  const std::string begin = "G21 G90 F600\nG43.4 H0\nG0 X40 Y-20\n";
  EXPECT_EQ(read(begin + "G3 X40 Y20 I0 J20\nM2\n", conditions).problems(), "4:1 travel; ");
  EXPECT_EQ(read(begin + "G2 X40 Y20 I0 J20\nM2\n", conditions).problems(), "");
}

}  // namespace test_tip_travel
}  // namespace leadscrew::gcode
