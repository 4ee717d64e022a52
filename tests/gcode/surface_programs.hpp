#pragma once
// Programs of surfaces, and which surfaces their moves machine.

#include <leadscrew/gcode/machined.hpp>
#include <leadscrew/machine/rotary_chain.hpp>

#include "reading.hpp"

namespace leadscrew::gcode {

/// A move with what it machines.
struct OnSurface {
  Move move;
  MachinedMove machined;
};

/// A ball of 10 mm, a bull nose, a flat tool, one without a shape.
inline machine::ToolTable shaped_tools() {
  std::vector<machine::Tool> tools(4);
  for (std::size_t k = 0; k < tools.size(); ++k) {
    tools[k].number = static_cast<int>(k) + 1;
    tools[k].diameter = 10;
    tools[k].length = 40;
    tools[k].offset[2] = 30;
  }
  tools[0].corner_radius = 5;
  tools[1].corner_radius = 1;
  tools[2].corner_radius = 0;
  return machine::ToolTable(tools);
}

/// A machine of nine axes with those tools; a table of A and C where `kinematics` names it, or another.
inline Conditions with_shapes(std::string_view kinematics = {}) {
  Conditions conditions;
  conditions.tools = shaped_tools();
  if (!kinematics.empty()) conditions.machine.rotary_chain = machine::preset_chain(kinematics);
  return conditions;
}

inline std::vector<OnSurface> read_surfaces(std::string_view text, const Conditions& conditions = with_shapes()) {
  std::vector<OnSurface> all;
  std::string problems;
  Reader reader(text_source(text), conditions.machine, conditions.tools, conditions.options,
                [&](const base::Diagnostic& d) { problems += std::string(d.code) + ": " + d.message + "; "; });
  Move move;
  while (reader.next(move)) {
    if (move.kind != Move::Kind::event) all.push_back({move, reader.machined()});
  }
  EXPECT_EQ(problems, "") << text;
  return all;
}

/// z = 0 over 0 … 20 by 0 … 10.
inline const std::string flat_patch = "G6.4 D1 P2 Q2 I2 J2\nX0 Y0 Z0\nX20\nX0 Y10\nX20\n";

/// The patch of the study "surface", which is bicubic, over 60 by 60 mm.
inline std::string patch_a() {
  constexpr int heights[4][4] = {{0, 6, 6, 0}, {6, 14, 2, -4}, {6, 2, 14, 6}, {0, -4, 6, 8}};  // by u, then v
  std::string text = "G6.4 D1 P4 Q4 I4 J4\n";
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      text +=
          "X" + std::to_string(20 * i) + " Y" + std::to_string(20 * j) + " Z" + std::to_string(heights[i][j]) + "\n";
    }
  }
  return text;
}

/// A place of a curve, by de Boor's algorithm; weights are 1.
inline base::AxisVector place_on(const NurbsCurve& curve, double u) {
  const auto p = static_cast<std::size_t>(curve.degree);
  std::size_t span = p;
  while (span + 1 < curve.points.size() && curve.knots[span + 1] <= u) ++span;
  std::vector<base::AxisVector> row;
  for (std::size_t k = 0; k <= p; ++k) row.push_back(curve.points[span - p + k].position);
  for (std::size_t r = 1; r <= p; ++r) {
    for (std::size_t k = p; k >= r; --k) {
      const std::size_t i = span - p + k;
      const double alpha = (u - curve.knots[i]) / (curve.knots[i + p - r + 1] - curve.knots[i]);
      for (std::size_t q = 0; q < row[k].size(); ++q) row[k][q] = (1 - alpha) * row[k - 1][q] + alpha * row[k][q];
    }
  }
  return row[p];
}

/// So many places all along a curve, both ends among them.
inline std::vector<base::AxisVector> places_on(const NurbsCurve& curve, int count) {
  std::vector<base::AxisVector> places;
  const double from = curve.knots.front(), to = curve.knots.back();
  for (int k = 0; k < count; ++k) places.push_back(place_on(curve, from + (to - from) * k / (count - 1)));
  return places;
}

}  // namespace leadscrew::gcode
