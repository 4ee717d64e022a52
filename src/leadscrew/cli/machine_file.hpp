#pragma once
// A machine as a TOML file: the keys of the command-line contract, every problem in one pass, each with its line.

#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/machine/machine.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::cli {

struct MachineFile {
  machine::Machine machine;
  std::vector<base::Diagnostic> diagnostics;  ///< in the order of the file; any error makes the machine unusable
};

/// Codes: `machine-syntax`, `machine-key` (not known), `machine-type`, `machine-missing`, and those of
/// machine::validate(). Of the keys outside [axis.…] each has a default; an axis must give its limits,
/// not the errors of its screw.
MachineFile read_machine(std::string_view text, const std::string& file);

}  // namespace leadscrew::cli
