#pragma once
// A mill whose table tilts (A) and turns (C) the part, and programs of short lines under tool centre point control for it.

#include <cmath>
#include <cstdio>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <string>

namespace leadscrew::testing_support {

/// As machines/table-table-ac.toml; its rotary axes `faster` times as fast, and as much faster still as acceleration and jerk
/// must be for that to be reached.
inline machine::Machine trunnion(double faster = 1) {
  machine::Machine machine;
  machine.name = "trunnion";
  machine.kinematics = "table-table-ac";
  machine.rotary_chain = machine::preset_chain(machine.kinematics);
  machine.rotary_chain->axes[0].point = {0, 0, -50};
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z})
    machine.axes[base::index(axis)] = machine::AxisLimits{-600, 600, 400, 3000, 60'000, 0.001};
  const double more = faster * faster, most = more * faster;
  machine.axes[base::index(base::Axis::A)] =
      machine::AxisLimits{-36'000, 36'000, 180 * faster, 1500 * more, 30'000 * most, 0.001};
  machine.axes[base::index(base::Axis::C)] =
      machine::AxisLimits{-36'000, 36'000, 360 * faster, 3000 * more, 60'000 * most, 0.001};
  machine.period = {1'000'000};
  return machine;
}

/// Passes over a twisted blade as a CAM system writes them: `passes` times `moves` lines of 0.3 to 1 mm with A and C.
inline std::string blade_program(const std::string& tolerances, int passes, int moves) {
  std::string text = "G21 G90 G94 G17 G64 " + tolerances + "\nG0 A30 C-30\nG43.4\nG0 X45 Y0 Z10\n";
  for (int pass = 0; pass < passes; ++pass) {
    for (int k = 0; k < moves; ++k) {
      const double along = static_cast<double>(k) / (moves - 1), u = pass % 2 == 0 ? along : 1 - along;
      const double radius = 45 - 25 * u, turn = 0.87 * u * u + 0.007 * pass + 0.17 * std::sin(5 * u);
      char line[160];
      std::snprintf(line, sizeof line, "G1 X%.4f Y%.4f Z%.4f A%.4f C%.4f F3000\n", radius * std::cos(turn),
                    radius * std::sin(turn), 10 - 15 * u - 0.3 * pass, 30 + 20 * std::sin(2.2 * u) + 0.2 * pass,
                    -30 + 55 * u + 8 * std::sin(4 * u) + 0.4 * pass);
      text += line;
    }
  }
  return text + "M2\n";
}

}  // namespace leadscrew::testing_support
