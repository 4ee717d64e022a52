#pragma once
// What the command line asks `leadscrew pulse` for.

#include <leadscrew/cli/quantity.hpp>
#include <leadscrew/stepping/pulse_method.hpp>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::cli {

struct PulseArguments {
  stepping::PulseCurve curve;
  std::vector<stepping::PulseMethod> methods;  ///< one or more, none twice
  stepping::PulseOptions options;
  bool path = false;   ///< every place, in JSON
  bool table = false;  ///< every register at every clock, as text
  std::optional<std::string> vcd, svg;
};

/// Options as text, before their values are looked at.
struct PulseTexts {
  bool arc = false, line = false, clockwise = false, counterclockwise = false, path = false, table = false;
  std::optional<std::string> start, end, center, methods, bits, preload, tie, order, vcd, svg;
};

/// Says in whole sentences what is wrong. `json`: that is asked for.
Parsed<PulseArguments> parse_pulse(const PulseTexts& texts, bool json);

/// "point-comparison, dda, …": every method there is.
std::string names_of_pulse_methods();

}  // namespace leadscrew::cli
