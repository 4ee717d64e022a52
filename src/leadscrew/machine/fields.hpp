#pragma once
// What problems of machines are about: the values of a machine by name, as base::Subject has them. Those of step times
// and drives are the names in machine::all_step_times and machine::drive_numbers; no two are alike.

#include <string_view>

namespace leadscrew::machine::field {

// Of the machine.
inline constexpr std::string_view kinematics = "kinematics";
inline constexpr std::string_view period = "period";
inline constexpr std::string_view tolerance = "tolerance";
inline constexpr std::string_view chord_error = "chord error";
inline constexpr std::string_view axes = "axes";
inline constexpr std::string_view laser_output = "laser output";
inline constexpr std::string_view spindle_acceleration = "spindle acceleration";
inline constexpr std::string_view spindle_noise = "spindle noise";
inline constexpr std::string_view spindle_noise_period = "spindle noise period";
inline constexpr std::string_view spindle_seed = "spindle seed";
inline constexpr std::string_view tool_zero = "tool zero";
inline constexpr std::string_view orientation_tolerance = "orientation tolerance";
inline constexpr std::string_view pole_cone = "pole cone";
inline constexpr std::string_view probe_plane = "probe plane";  // of an axis

// Of an axis.
inline constexpr std::string_view travel = "travel";
inline constexpr std::string_view velocity = "velocity";
inline constexpr std::string_view acceleration = "acceleration";
inline constexpr std::string_view jerk = "jerk";
inline constexpr std::string_view blu = "basic length unit";

// Of a rotary axis in a chain.
inline constexpr std::string_view carries = "carries";
inline constexpr std::string_view direction = "direction";
inline constexpr std::string_view point = "point";
inline constexpr std::string_view order = "order";
inline constexpr std::string_view sign = "sign";

// Of its screw; tables have entries.
inline constexpr std::string_view pitch_errors = "pitch errors";
inline constexpr std::string_view backward_pitch_errors = "backward pitch errors";
inline constexpr std::string_view backlash = "backlash";
inline constexpr std::string_view takeup_velocity = "takeup velocity";

}  // namespace leadscrew::machine::field
