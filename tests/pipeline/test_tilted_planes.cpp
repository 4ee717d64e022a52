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

#include "random_program.hpp"
#include "worst_ratios.hpp"

// Programs in a tilted working plane, on every kind of machine: the tip is where the program says, by the referee's own
// kinematics, and every limit is kept.

namespace test_tilted_planes {

using namespace leadscrew;
using testing_support::any;
using testing_support::limits_of;
using testing_support::logarithmic;
using testing_support::worst_judged;
using testing_support::worst_planned;

using Vector = std::array<double, 3>;

double between(double least, double greatest) {
  return least + (greatest - least) * any(0, 1000001) / 1e6;
}
/// With three decimals, as it is written.
double written(double least, double greatest) {
  return std::round(between(least, greatest) * 1000) / 1000;
}
Vector place() {
  return {between(-80, 80), between(-80, 80), between(-80, 80)};
}

/// A preset with its axes anywhere, or nutating; limits over two decades.
machine::Machine tilting_machine() {
  machine::Machine machine;
  machine.name = "random five axes";
  const auto& presets = machine::kinematics_presets;
  const auto& preset = presets[static_cast<std::size_t>(any(0, static_cast<int>(presets.size())))];
  machine::RotaryChain chain = *machine::preset_chain(preset.name);
  for (machine::RotaryAxis& axis : chain.axes) {
    axis.point = place();
    axis.sign = any(0, 2) == 0 ? 1 : -1;
  }
  const bool nutates = preset.name == "head-head-bc" || preset.name == "table-table-bc";
  if (nutates && any(0, 2) == 0) {
    chain.axes[preset.name == "head-head-bc" ? 1 : 0].direction = {0, std::sqrt(0.5), std::sqrt(0.5)};
  }
  chain.tool_zero = place();
  machine.kinematics = preset.name;
  machine.rotary_chain = chain;
  const auto give = [&](base::Axis axis) {
    machine.axes[base::index(axis)] =
        machine::AxisLimits{-1e5, 1e5, logarithmic(50, 500), logarithmic(400, 1e4), logarithmic(2000, 1e6), 0.001};
  };
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z}) give(axis);
  for (const machine::RotaryAxis& axis : chain.axes) give(axis.axis);
  machine.period = {1'000'000};
  return machine;
}

machine::ToolTable two_tools() {
  machine::Tool first, second;
  first.number = 1;
  first.offset[2] = 73.25;
  second.number = 2;
  second.offset = {1.5, -2, 41};
  return machine::ToolTable({first, second});
}

Vector about(std::size_t axis, double degrees, Vector v) {
  const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Vector before = v;
  v[i] = c * before[i] - s * before[j];
  v[j] = s * before[i] + c * before[j];
  return v;
}

/// Where a move ends, and what it is told of, in the workpiece.
struct Target {
  Vector end{}, tool{};
  bool is_arc = false;
  Vector center{}, normal{};
  double radius = 0;
};

/// A program, and where it leads, in the workpiece.
class TiltedProgram {
 public:
  std::string make(int blocks) {
    text_ = "G21 G90 G94 G17 F1200\n";
    if (any(0, 3) == 0) text_ += "G61\n";
    offsets();
    if (any(0, 2) == 0) tool();
    plane();
    if (any(0, 3) == 0) line("G0", 30);  // before the tool is along the normal
    text_ += any(0, 2) == 0 ? "G53.1\n" : "G53.1 P1\n";
    if (any(0, 3) == 0) tool();
    line("G0", 30);
    for (int k = 0; k < blocks; ++k) block();
    return text_ + "M2\n";
  }

  /// Of the moves that move the tip against the machine.
  const std::vector<Target>& targets() const { return targets_; }

 private:
  void word(char letter, double value) {
    char word[40];
    std::snprintf(word, sizeof word, " %c%.3f", letter, value);
    text_ += word;
  }
  void offsets() {
    text_ += "G10 L2 P1";
    for (std::size_t i = 0; i < 3; ++i) word("XYZ"[i], origin_[i] = written(-50, 50));
    word('R', rotation_ = any(0, 2) == 0 ? 0 : written(-180, 180));
    text_ += "\n";
    if (any(0, 3) > 0) return;
    text_ += "G52";
    for (std::size_t i = 0; i < 3; ++i) word("XYZ"[i], shift_[i] = written(-20, 20));
    text_ += "\n";
  }
  void tool() {
    const bool second = any(0, 2) == 0;
    text_ += second ? "G43 H2\n" : "G43 H1\n";
    tool_ = second ? Vector{1.5, -2, 41} : Vector{0, 0, 73.25};
  }
  void plane() {
    text_ += "G68.2";
    for (std::size_t i = 0; i < 3; ++i) word("XYZ"[i], plane_[i] = written(-50, 50));
    by_euler_ = any(0, 2) == 0;
    if (by_euler_) {
      degrees_ = {written(-180, 180), written(-80, 80), written(-180, 180)};
    } else {
      degrees_ = {written(-40, 40), written(-40, 40), written(-40, 40)};
      const char* const orders[] = {"123", "132", "213", "231", "312", "321"};
      order_ = orders[any(0, 6)];
      text_ += std::string(" P1 Q") + order_;
    }
    for (std::size_t i = 0; i < 3; ++i) word("IJK"[i], degrees_[i]);
    text_ += "\n";
  }
  Vector in_workpiece(Vector v) const {
    if (by_euler_) {
      v = about(2, degrees_[2], v);
      v = about(0, degrees_[1], v);
      v = about(2, degrees_[0], v);
    } else {
      for (const char each : order_) {
        const auto axis = static_cast<std::size_t>(each - '1');
        v = about(axis, degrees_[axis], v);
      }
    }
    for (std::size_t i = 0; i < 3; ++i) v[i] += plane_[i] + shift_[i];
    v = about(2, rotation_, v);
    for (std::size_t i = 0; i < 3; ++i) v[i] += origin_[i];
    return v;
  }
  void ends_at(const Vector& program, const Vector* center = nullptr, double radius = 0) {
    Target target{in_workpiece(program), tool_};
    if (center) {
      const Vector above = in_workpiece({(*center)[0], (*center)[1], (*center)[2] + 1});
      target.is_arc = true;
      target.center = in_workpiece(*center);
      for (std::size_t i = 0; i < 3; ++i) target.normal[i] = above[i] - target.center[i];
      target.radius = radius;
    }
    if (center || !stands_ || program != at_) targets_.push_back(target);
    at_ = program;
    stands_ = true;
  }
  void line(const char* code, double most) {
    text_ += code;
    Vector to = at_;
    for (std::size_t i = 0; i < 3; ++i) word("XYZ"[i], to[i] = written(-most, most));
    text_ += "\n";
    ends_at(to);
  }
  void arc() {
    const double radius = written(0.5, 8);
    const bool whole = any(0, 3) == 0;
    text_ += any(0, 2) == 0 ? "G2" : "G3";
    const Vector center = {at_[0] + radius, at_[1], at_[2]};
    Vector to = at_;
    if (!whole) word('X', to[0] += 2 * radius);
    if (any(0, 2) == 0) word('Z', to[2] += written(-3, 3));
    word('I', radius);
    text_ += "\n";
    ends_at(to, &center, radius);
  }
  void drill() {
    const double x = written(-20, 20), y = written(-20, 20), top = written(1, 3), bottom = written(-9, 0);
    text_ += "G0 Z9\nG99 G81";
    ends_at({at_[0], at_[1], 9});
    word('X', x), word('Y', y), word('Z', bottom), word('R', top);
    text_ += "\nG80\n";
    for (const double z : {9.0, top, bottom, top}) ends_at({x, y, z});
  }
  void block() {
    switch (any(0, 8)) {
      case 0:
        return line("G0", 30);
      case 1:
      case 2:
        return arc();
      case 3:
        return drill();
      default:
        return line("G1", 20);
    }
  }

  std::string text_;
  std::string order_;
  Vector origin_{}, shift_{}, plane_{}, degrees_{}, tool_{};
  double rotation_ = 0;
  bool by_euler_ = true;
  Vector at_{};
  bool stands_ = false;  // at at_
  std::vector<Target> targets_;
};

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
