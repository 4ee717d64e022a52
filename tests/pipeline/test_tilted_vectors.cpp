#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/referee.hpp>
#include <numbers>
#include <string>

#include "five_axes.hpp"
#include "random_programs.hpp"

// Tool vectors in a tilted working plane (G68.2, G53.1, G43.5) are the plane's, as X Y Z are. The same program is told in the
// workpiece here, places and vectors turned by hand, and the referee judges the words of the one by the other.

namespace test_tilted_vectors {

using namespace leadscrew;
using testing_support::any;
using testing_support::between;
using testing_support::five_axes;
using testing_support::limits_of;
using testing_support::two_tools;

using Vector = std::array<double, 3>;

constexpr double radian = std::numbers::pi / 180;

Vector about_z(double degrees, const Vector& v) {
  const double c = std::cos(degrees * radian), s = std::sin(degrees * radian);
  return {c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
}
Vector about_x(double degrees, const Vector& v) {
  const double c = std::cos(degrees * radian), s = std::sin(degrees * radian);
  return {v[0], c * v[1] - s * v[2], s * v[1] + c * v[2]};
}

std::string words(const char* letters, const Vector& v) {
  char text[120];
  std::snprintf(text, sizeof text, " %c%.14f %c%.14f %c%.14f", letters[0], v[0], letters[1], v[1], letters[2], v[2]);
  return text;
}

struct TwoTellings {
  std::string in_the_plane, in_the_workpiece;
};

/// `turned`: words of the rotary axes where G53.1 has turned them.
TwoTellings tellings(const std::string& head, const std::string& plane, const Vector& origin, const Vector& euler,
                     const std::string& turned, int lines) {
  TwoTellings both{head + plane + "G53.1\nG43.5 H1\n", head + "\nG0" + turned + "\nG43.5 H1\n"};
  Vector place = {0, 0, 10};
  double round = between(0, 360);
  for (int k = 0; k < lines; ++k) {
    for (double& each : place) each += between(-6, 6);
    round += between(-30, 30);
    const double lean = between(3, 15) * radian;
    const Vector vector = {std::sin(lean) * std::cos(round * radian), std::sin(lean) * std::sin(round * radian),
                           std::cos(lean)};
    const auto in_workpiece = [&](const Vector& v) {
      return about_z(euler[0], about_x(euler[1], about_z(euler[2], v)));
    };
    Vector there = in_workpiece(place);
    for (std::size_t i = 0; i < 3; ++i) there[i] += origin[i];
    both.in_the_plane += "G1" + words("XYZ", place) + words("IJK", vector) + "\n";
    both.in_the_workpiece += "G1" + words("XYZ", there) + words("IJK", in_workpiece(vector)) + "\n";
  }
  both.in_the_plane += "G49\nG69\nM2\n";
  both.in_the_workpiece += "G49\nM2\n";
  return both;
}

/// Words of the rotary axes where the program has turned them.
std::string rotary_words(const std::string& text, const machine::Machine& machine) {
  const machine::ToolTable tools = two_tools();
  gcode::Reader reader(gcode::text_source(text), machine, tools, {}, nullptr);
  base::AxisVector end{};
  for (gcode::Move move; reader.next(move);) {
    if (move.kind == gcode::Move::Kind::line) end = move.end;
  }
  std::string words;
  for (const machine::RotaryAxis& axis : machine.rotary_chain->axes) {
    char word[40];
    std::snprintf(word, sizeof word, " %c%.14f", base::letter(axis.axis), end[base::index(axis.axis)]);
    words += word;
  }
  return words;
}

RC_GTEST_PROP(TiltedVectors, AreThoseOfThePlane, ()) {
  const machine::Machine machine = five_axes();
  const Vector origin = {between(-20, 20), between(-20, 20), between(-20, 20)},
               euler = {between(-90, 90), between(1, 25), between(-40, 40)};
  const bool rounds = any(0, 2) == 0;
  const std::string head = "G21 G90 G94 G17 F1500 " + std::string(rounds ? "G64 P0.02 E0.2" : "G61") +
                           "\nG10 L2 P1 X12.5 Y-3 Z4 R" + std::to_string(any(-60, 60)) + "\n";
  const std::string plane = "G68.2" + words("XYZ", origin) + words("IJK", euler) + "\n";
  const std::string turned = rotary_words(head + plane + "G53.1\nM2\n", machine);
  const TwoTellings both = tellings(head, plane, origin, euler, turned, any(1, 4));
  RC_LOG() << machine.kinematics << "\n" << both.in_the_plane << both.in_the_workpiece << limits_of(machine);
  const machine::ToolTable tools = two_tools();
  int errors = 0;
  bool is_in_reach = true;
  for (const std::string& text : {both.in_the_plane, both.in_the_workpiece}) {
    gcode::Reader reader(gcode::text_source(text), machine, tools, {}, [&](const base::Diagnostic& told) {
      errors += told.severity == base::Severity::error ? 1 : 0;
      if (told.code == "pose-out-of-reach") is_in_reach = false;
    });
    for (gcode::Move move; reader.next(move);) continue;
  }
  RC_PRE(is_in_reach);  // of a table that nutates
  RC_ASSERT(errors == 0);
  pipeline::Program program(gcode::text_source(both.in_the_plane), machine, tools, {}, nullptr);
  gcode::Reader judge(gcode::text_source(both.in_the_workpiece), machine, tools, {}, nullptr);
  referee::Referee referee([&](gcode::Move& move) { return judge.next(move); }, machine, machine.period);
  while (program.prepare()) referee.observe(program.cycle().position);
  const referee::Verdict verdict = referee.conclude();
  // mm or degrees: of the numbers of the programs; and of exact lines, of which both readings make parts of their own.
  const double written = rounds ? 1e-8 : 1e-5;
  RC_ASSERT(verdict.tip_deviation_mm.has_value());
  RC_ASSERT(*verdict.tip_deviation_mm <= verdict.tolerance_mm + written);
  RC_ASSERT(*verdict.orientation_deviation_deg <= verdict.orientation_tolerance_deg + written);
  RC_ASSERT(verdict.end_error_mm <= written);
  RC_ASSERT(verdict.deviation_mm <= verdict.tolerance_mm + written);
}

}  // namespace test_tilted_vectors
