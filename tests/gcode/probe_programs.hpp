#pragma once
// What a program says of the simulated probe.

#include <leadscrew/machine/probe.hpp>
#include <string>

#include "reading.hpp"

namespace leadscrew::gcode {

/// A block that says #5061 … #5063 and #5070.
inline const std::string tell = "\n(PRINT,%.3f#5061 #5062 #5063 %d#5070)\n";

/// What a program prints, and its problems.
inline std::string told(const std::string& program, const machine::Probe& probe) {
  Conditions conditions;
  conditions.machine.probe = probe;
  std::string text;
  conditions.options.remarks = [&](const Remark& remark) {
    if (remark.kind == Remark::Kind::print) text += remark.text + ";";
  };
  const Reading reading = read("G21 F600\n" + program + "M2\n", conditions);
  return text + reading.problems();
}

}  // namespace leadscrew::gcode
