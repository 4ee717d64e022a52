#pragma once
// The keys of machine files, and the values of machine::Machine that they give.

#include <array>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/machine/drive.hpp>
#include <leadscrew/machine/fields.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/step_times.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::config {

/// true: motion rests for M3, M4 and M5, as without it; false: it goes on.
inline constexpr std::string_view spindle_waits_key = "spindle_waits";

/// How paths are smoothed within their tolerance: machine::Smoothing, in its order.
inline constexpr std::string_view smoothing_key = "smoothing";
inline constexpr std::array<std::string_view, 2> smoothings = {"splines", "least-time"};

/// What its programs are written in: a name of machine::Dialect.
inline constexpr std::string_view dialect_key = "dialect";

/// Of machines with two rotary axes that turn the tool against the workpiece: machine::RotaryChain. The third is a table.
inline constexpr std::string_view orientation_tolerance_key = "orientation_tolerance_deg",
                                  pole_cone_key = "pole_cone_deg", geometry_key = "kinematics_geometry",
                                  tool_zero_key = "tool_zero_mm";
inline constexpr std::array<std::string_view, 1> geometry_keys = {tool_zero_key};
/// Of [axis.A], beside those of every axis.
inline constexpr std::string_view carries_key = "carries", point_key = "point_mm", direction_key = "direction",
                                  order_key = "order", sign_key = "sign";
inline constexpr std::array<std::string_view, 5> chain_axis_keys = {carries_key, point_key, direction_key, order_key,
                                                                    sign_key};

/// A number of the machine itself, in the unit that it has there.
struct MachineNumber {
  std::string_view field, key;
  double machine::Machine::* value;
};
inline constexpr std::array machine_numbers = {
    MachineNumber{machine::field::tolerance, "tolerance_mm", &machine::Machine::tolerance},
    MachineNumber{machine::field::chord_error, "chord_error_mm", &machine::Machine::chord_error}};

/// Outside tables.
inline constexpr auto machine_keys = [] {
  std::array<std::string_view, 13 + machine_numbers.size()> keys = {"name", "kinematics", "period_us"};
  for (std::size_t k = 0; k < machine_numbers.size(); ++k) keys[3 + k] = machine_numbers[k].key;
  keys[keys.size() - 10] = orientation_tolerance_key;
  keys[keys.size() - 9] = pole_cone_key;
  keys[keys.size() - 8] = geometry_key;
  keys[keys.size() - 7] = dialect_key;
  keys[keys.size() - 6] = smoothing_key;
  keys[keys.size() - 5] = spindle_waits_key;
  keys[keys.size() - 4] = "laser";
  keys[keys.size() - 3] = "probe";
  keys[keys.size() - 2] = "spindle";
  keys.back() = "axis";
  return keys;
}();

inline constexpr std::array<std::string_view, base::axis_count> axis_names = {"X", "Y", "Z", "A", "B",
                                                                              "C", "U", "V", "W"};

/// A key by the field of base::Subject that it gives: of a linear axis, in mm, and of a rotary one, in degrees.
struct Key {
  std::string_view field, linear, rotary;
};

/// Of [axis.X]. Without the first five there is no axis.
inline constexpr std::array<Key, 13> axis_keys = {
    {{machine::field::travel, "travel_mm", "travel_deg"},
     {machine::field::velocity, "max_velocity_mm_s", "max_velocity_deg_s"},
     {machine::field::acceleration, "max_acceleration_mm_s2", "max_acceleration_deg_s2"},
     {machine::field::jerk, "max_jerk_mm_s3", "max_jerk_deg_s3"},
     {machine::field::blu, "blu_mm", "blu_deg"},
     {machine::field::pitch_errors, "pitch_errors_mm", "pitch_errors_deg"},
     {machine::field::backward_pitch_errors, "pitch_errors_backward_mm", "pitch_errors_backward_deg"},
     {machine::field::backlash, "backlash_mm", "backlash_deg"},
     {machine::field::takeup_velocity, "backlash_takeup_mm_s", "backlash_takeup_deg_s"},
     {machine::all_step_times[0].name, "step_length_us", "step_length_us"},
     {machine::all_step_times[1].name, "step_space_us", "step_space_us"},
     {machine::all_step_times[2].name, "direction_setup_us", "direction_setup_us"},
     {machine::all_step_times[3].name, "direction_hold_us", "direction_hold_us"}}};
inline constexpr std::size_t needed_axis_key_count = 5;

/// A table in [axis.X].
inline constexpr std::string_view drive_key = "drive";

/// Of [axis.X.drive], beside two that are words. In the order of machine::drive_numbers, whose names are the fields.
inline constexpr std::array<Key, machine::drive_numbers.size()> drive_keys = {
    {{machine::drive_numbers[0].name, "position_gain_per_s", "position_gain_per_s"},
     {machine::drive_numbers[1].name, "velocity_gain_per_s", "velocity_gain_per_s"},
     {machine::drive_numbers[2].name, "velocity_integral_per_s2", "velocity_integral_per_s2"},
     {machine::drive_numbers[3].name, "max_acceleration_mm_s2", "max_acceleration_deg_s2"},
     {machine::drive_numbers[4].name, "damping_per_s", "damping_per_s"},
     {machine::drive_numbers[5].name, "gain_mm_s", "gain_deg_s"},
     {machine::drive_numbers[6].name, "time_constant_ms", "time_constant_ms"},
     {machine::drive_numbers[7].name, "proportional_per_mm", "proportional_per_deg"},
     {machine::drive_numbers[8].name, "integral_per_mm_s", "integral_per_deg_s"},
     {machine::drive_numbers[9].name, "derivative_per_mm", "derivative_per_deg"},
     {machine::drive_numbers[10].name, "command_limit", "command_limit"},
     {machine::drive_numbers[11].name, "velocity_forward", "velocity_forward"},
     {machine::drive_numbers[12].name, "acceleration_forward", "acceleration_forward"},
     {machine::drive_numbers[13].name, "friction_mm_s2", "friction_deg_s2"},
     {machine::drive_numbers[14].name, "breakaway_mm_s2", "breakaway_deg_s2"},
     {machine::drive_numbers[15].name, "encoder_counts_per_mm", "encoder_counts_per_deg"}}};
inline constexpr std::string_view controller_key = "controller", encoder_key = "encoder";

/// Of the axis' kind.
constexpr std::string_view text_of(const Key& key, base::Axis axis) {
  return base::is_rotary(axis) ? key.rotary : key.linear;
}

/// The key of [axis.X] that gives this field; empty where none does.
std::string_view axis_key_of(base::Axis axis, std::string_view field);

/// Of [laser], and what its power may be.
inline constexpr std::array<std::string_view, 3> laser_keys = {"power", "output", "follow_feed"};
inline constexpr std::array<std::string_view, 2> laser_powers = {"M67", "S"};

/// Of [probe]: planes, the axes that they may be of, a surface and where it lies, and bodies in the order of
/// machine::ProbeBody::Kind.
inline constexpr std::string_view probe_planes_key = "plane_mm";
inline constexpr std::string_view probe_surface_key = "surface";
inline constexpr std::string_view probe_surface_at_key = "surface_at_mm";
inline constexpr std::array<std::string_view, 5> probe_body_keys = {"box_mm", "pocket_mm", "sphere_mm", "cylinder_mm",
                                                                    "bore_mm"};
inline constexpr auto probe_keys = [] {
  std::array<std::string_view, 3 + probe_body_keys.size()> keys = {probe_planes_key, probe_surface_key,
                                                                   probe_surface_at_key};
  for (std::size_t k = 0; k < probe_body_keys.size(); ++k) keys[3 + k] = probe_body_keys[k];
  return keys;
}();
inline constexpr std::array<std::string_view, 6> linear_axis_names = {"X", "Y", "Z", "U", "V", "W"};

/// Of [spindle].
inline constexpr std::array<std::string_view, 4> spindle_keys = {"acceleration_rpm_s", "noise", "noise_period_s",
                                                                 "seed"};

/// Every key of [axis.X], of [axis.X.drive], and those without which there is no axis.
std::vector<std::string_view> all_axis_keys(base::Axis axis);
std::vector<std::string_view> all_drive_keys(base::Axis axis);
std::vector<std::string_view> needed_keys(base::Axis axis);

/// "axis.X"
std::string section_of(base::Axis axis);

/// "axis.X.drive"
std::string drive_section_of(base::Axis axis);

/// Of a kinematics that is not known: says which was probably meant.
void explain_kinematics(base::Diagnostic& problem, std::string_view kinematics);

}  // namespace leadscrew::config
