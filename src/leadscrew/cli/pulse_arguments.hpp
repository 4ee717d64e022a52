#pragma once
// What the command line asks `leadscrew pulse` for.

#include <leadscrew/cli/options.hpp>
#include <leadscrew/nc/pulse_method.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::cli {

struct PulseArguments {
  nc::PulseCurve curve;
  std::vector<base::Diagnostic> overflows;  ///< coordinates that no register holds; the curve has what 64 bits do
  std::vector<nc::PulseMethod> methods;     ///< one or more, none twice
  nc::MethodOptions options;
  bool path = false;   ///< every place, in JSON
  bool table = false;  ///< every register at every clock, as text
  std::optional<std::string> vcd, svg;
};

struct Arguments;

/// The options of pulse, which put their values into the arguments.
void describe_pulse(Command& command, Arguments& arguments);

/// One of their names; what is wrong follows "--option TEXT: ".
Parsed<nc::PulseMethod> parse_pulse_method(std::string_view text);

/// Every method there is, and "point-comparison, dda, …".
std::vector<std::string> pulse_method_names();
std::string names_of_pulse_methods();

}  // namespace leadscrew::cli
