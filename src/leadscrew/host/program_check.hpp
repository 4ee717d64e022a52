#pragma once
// A program read, and not moved: what is wrong with it, and what can be told of it before motion is planned.

#include <leadscrew/base/result.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/host/motion.hpp>
#include <optional>
#include <string>

namespace leadscrew::host {

/// Of a program that was only read.
struct CheckedProgram {
  std::int64_t blocks = 0;                ///< lines that hold at least one word
  std::int64_t moves = 0;                 ///< lines, arcs and curves
  std::optional<base::Diagnostic> error;  ///< the first; what follows is of programs without one
  double bound_s = 0;                     ///< as pipeline::Summary has it
  base::AxisVector least{}, greatest{};   ///< coordinates of the path, its start included, mm or degrees
};

/// As `leadscrew check --json` checks it; `diagnostics` gets what is found, once. The machine is sound. Errors:
/// `interrupted`, those of a subprogram's text.
base::Result<CheckedProgram> check_program(const machine::Machine& machine, std::string text,
                                           const MotionOptions& options, const gcode::DiagnosticSink& diagnostics);

}  // namespace leadscrew::host
