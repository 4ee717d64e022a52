#pragma once
// What the command line asks `leadscrew run` for, beside what other commands are asked for too.

#include <array>
#include <cstdint>
#include <leadscrew/cli/options.hpp>
#include <leadscrew/interpolator/parameter_steps.hpp>
#include <leadscrew/nc/pulse_method.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace leadscrew::cli {

struct RunArguments {
  interpolator::StepRule interpolator = interpolator::StepRule::arc_length;  ///< parameter steps along curves
  std::optional<std::string> trace, report, picture, charts, pulses, events, blocks,
      out;                                      ///< pulses: beside out maybe a step format
  std::optional<nc::PulseMethod> pulse_method;  ///< of --pulses; none: steps that follow the words
  bool accelerate = false;                      ///< of a pulse_method: keep the axes' acceleration
  bool hardware_model = false;          ///< of --pulses: by the model of the hardware; pulse_method is bresenham
  std::optional<std::string> waves;     ///< of hardware_model: its signals
  std::int64_t step_clock = 1'000'000;  ///< of --pulses, Hz
  /// Of --pulses, in place of every axis' own; ns, in the order of machine::all_step_times.
  std::array<std::optional<std::int64_t>, 4> step_times;
};

/// In the order of machine::all_step_times.
inline constexpr std::array<const char*, 4> step_time_options = {"--step-length", "--step-space", "--direction-setup",
                                                                 "--direction-hold"};

/// "vcd" or "csv" in any case, as small letters: beside --out it names the format of every program's steps, not a file.
std::optional<std::string> step_format(std::string_view text);

struct Arguments;

/// The options of run, which put their values into the arguments.
void describe_run(Command& command, Arguments& arguments);

}  // namespace leadscrew::cli
