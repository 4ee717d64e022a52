#pragma once
// What a program says of the simulated probe.

#include <leadscrew/machine/probe.hpp>
#include <string>

#include "reading.hpp"

namespace leadscrew::gcode {

/// A block that says #5061 … #5063 and #5070.
inline const std::string tell = "\n(PRINT,%.3f#5061 #5062 #5063 %d#5070)\n";

/// A program's reading, and what it prints.
struct Printed {
  Reading reading;
  std::string text;  ///< each with a semicolon behind it
};

inline Printed printed(const std::string& program, Conditions conditions) {
  Printed printed;
  conditions.options.remarks = [&](const Remark& remark) {
    if (remark.kind == Remark::Kind::print) printed.text += remark.text + ";";
  };
  printed.reading = read(program + "\nM2\n", conditions);
  return printed;
}

/// What a program prints, and its problems.
inline std::string told(const std::string& program, const machine::Probe& probe) {
  Conditions conditions;
  conditions.machine.probe = probe;
  const Printed found = printed("G21 F600\n" + program, conditions);
  return found.text + found.reading.problems();
}

}  // namespace leadscrew::gcode
