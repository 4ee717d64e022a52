#pragma once
// What the command line asks `leadscrew pulse` for.

#include <leadscrew/cli/quantity.hpp>
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

/// Options as text, before their values are looked at.
struct PulseTexts {
  bool arc = false, line = false, clockwise = false, counterclockwise = false, path = false, table = false;
  std::optional<std::string> start, end, center, methods, bits, preload, tie, order, vcd, svg;
};

/// Says in whole sentences what is wrong. `json`: that is asked for.
Parsed<PulseArguments> parse_pulse(const PulseTexts& texts, bool json);

inline constexpr std::string_view pulse_examples =
    "Examples:\n"
    "  leadscrew pulse --arc --start 5,0 --end 0,5 --center 0,0 --ccw --method dda\n"
    "  leadscrew pulse --arc --start 25,0 --end 25,0 --cw --svg circle.svg --vcd circle.vcd\n"
    "  leadscrew pulse --line --end 11,-7 --method dda,bresenham --bits 4 --table\n"
    "  leadscrew pulse --line --end 300,40 --method koren --preload zero --path --json\n"
    "\n"
    "Integers are BLU. A full circle ends where it starts. Each method's conventions are by default those with which "
    "it\n"
    "gives its published figures; --json names all that were in force.\n"
    "\n"
    "Columns of --table: x y from the centre or a line's start, F the deviation; n1 n2 n3 what F would be after a "
    "step\n"
    "of both axes, of y, of x; d = 4(d1 - d2) of improved-min-error; Jx Jy integrands, rx ry remainders, nx ny steps\n"
    "left, q the capacity. --vcd has them under the papers' names too, and says which is which: rst Val_z Val_f "
    "Val_n1\n"
    "Sum_Z and, for koren, y1 r1 dz1.\n";

/// One of their names; what is wrong follows "--option TEXT: ".
Parsed<nc::PulseMethod> parse_pulse_method(std::string_view text);

/// "point-comparison, dda, …": every method there is.
std::string names_of_pulse_methods();

}  // namespace leadscrew::cli
