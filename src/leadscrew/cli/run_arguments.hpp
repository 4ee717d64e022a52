#pragma once
// What the command line asks `leadscrew run` for, beside what other commands are asked for too.

#include <array>
#include <cstdint>
#include <leadscrew/cli/quantity.hpp>
#include <leadscrew/interpolator/parameter_steps.hpp>
#include <leadscrew/nc/pulse_method.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace leadscrew::cli {

struct RunArguments {
  interpolator::StepRule interpolator = interpolator::StepRule::arc_length;  ///< parameter steps along curves
  std::optional<std::string> trace, report, picture, pulses, out;            ///< pulses: beside out maybe a step format
  std::optional<nc::PulseMethod> pulse_method;  ///< of --pulses; none: steps that follow the words
  bool accelerate = false;                      ///< of a pulse_method: keep the axes' acceleration
  std::int64_t step_clock = 1'000'000;          ///< of --pulses, Hz
  /// Of --pulses, in place of every axis' own; ns, in the order of machine::all_step_times.
  std::array<std::optional<std::int64_t>, 4> step_times;
};

/// Options as text, before their values are looked at.
struct RunTexts {
  std::optional<std::string> trace, report, picture, pulses, out;
  std::optional<std::string> interpolator, pulse_method, step_clock;
  std::array<std::optional<std::string>, 4> step_times;  ///< of step_time_options
  bool accelerate = false;
};

/// In the order of machine::all_step_times.
inline constexpr std::array<const char*, 4> step_time_options = {"--step-length", "--step-space", "--direction-setup",
                                                                 "--direction-hold"};

/// "vcd" or "csv" in any case, as small letters: beside --out it names the format of every program's steps, not a file.
std::optional<std::string> step_format(std::string_view text);

/// Says in whole sentences what is wrong. `programs`: so many are named.
Parsed<RunArguments> parse_run(const RunTexts& texts, std::size_t programs);

inline constexpr std::string_view run_examples =
    "Examples:\n"
    "  leadscrew run part.ngc\n"
    "  leadscrew run part.ngc --machine machines/heavy3.toml --trace part.csv --report part.html\n"
    "  leadscrew run part.ngc --pulses part.vcd   steps and directions that follow the motion\n"
    "  leadscrew run part.ngc --pulses part.csv --machine machines/mill3-worn.toml   its screws' errors made good\n"
    "  leadscrew run *.ngc --out results          results/NAME.csv, .html and .svg of each\n"
    "  leadscrew run *.ngc --out results --pulses vcd   and its steps, results/NAME.steps.vcd\n"
    "  generator | leadscrew run - --json         a program from standard input, figures as JSON\n"
    "\n"
    "Times of step signals may be given for each axis in the machine file, [axis.X], in microseconds, 1 by default:\n"
    "step_length_us, step_space_us, direction_setup_us, direction_hold_us. What clock and times cannot give at an "
    "axis'\n"
    "greatest velocity and acceleration is refused before anything moves.\n"
    "\n"
    "Files appear whole or not at all. A program with an error is not moved. cycle_ns of --json is the time of\n"
    "a call that makes a word, of every 61st from the first on, the two looks at the clock included.\n";

}  // namespace leadscrew::cli
