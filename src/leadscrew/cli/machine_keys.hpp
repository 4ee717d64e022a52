#pragma once
// The keys of machine files.

#include <array>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/diagnostic.hpp>
#include <string>
#include <string_view>

namespace leadscrew::cli {

inline constexpr std::array<std::string_view, 6> machine_keys = {"name",         "kinematics",     "period_us",
                                                                 "tolerance_mm", "chord_error_mm", "axis"};

inline constexpr std::array<std::string_view, base::axis_count> axis_names = {"X", "Y", "Z", "A", "B",
                                                                              "C", "U", "V", "W"};

struct AxisKeys {
  std::string_view travel, velocity, acceleration, jerk, blu;
  std::string_view pitch_errors, pitch_errors_backward, backlash, takeup;
  std::array<std::string_view, 4> step_times;  ///< in the order of machine::all_step_times, µs
  std::string_view drive = "drive";            ///< a table: drive_keys.hpp

  /// Without these there is no axis.
  std::array<std::string_view, 5> needed() const { return {travel, velocity, acceleration, jerk, blu}; }
  std::array<std::string_view, 14> all() const {
    return {travel,   velocity, acceleration,  jerk,          blu,           pitch_errors,  pitch_errors_backward,
            backlash, takeup,   step_times[0], step_times[1], step_times[2], step_times[3], drive};
  }
};

/// In mm or in degrees.
const AxisKeys& keys_of(base::Axis axis);

/// "axis.X"
std::string section_of(base::Axis axis);

/// What a problem of machine::validate() is about: "period_us", "axis.X.blu_mm" or, of a list,
/// "axis.X.pitch_errors_mm[0]".
std::string slot_of(const base::Diagnostic& problem);

}  // namespace leadscrew::cli
