#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <leadscrew/cli/drive_keys.hpp>
#include <leadscrew/cli/machine_keys.hpp>
#include <leadscrew/machine/step_times.hpp>
#include <optional>

namespace leadscrew::cli {

namespace {

constexpr std::array<std::string_view, 4> step_time_keys = {"step_length_us", "step_space_us", "direction_setup_us",
                                                            "direction_hold_us"};
constexpr AxisKeys linear_keys = {"travel_mm",
                                  "max_velocity_mm_s",
                                  "max_acceleration_mm_s2",
                                  "max_jerk_mm_s3",
                                  "blu_mm",
                                  "pitch_errors_mm",
                                  "pitch_errors_backward_mm",
                                  "backlash_mm",
                                  "backlash_takeup_mm_s",
                                  step_time_keys};
constexpr AxisKeys rotary_keys = {"travel_deg",
                                  "max_velocity_deg_s",
                                  "max_acceleration_deg_s2",
                                  "max_jerk_deg_s3",
                                  "blu_deg",
                                  "pitch_errors_deg",
                                  "pitch_errors_backward_deg",
                                  "backlash_deg",
                                  "backlash_takeup_deg_s",
                                  step_time_keys};

/// Messages begin with their axis.
std::optional<base::Axis> axis_in(std::string_view message) {
  constexpr std::string_view opening = "axis ";
  if (!message.starts_with(opening) || message.size() <= opening.size()) return std::nullopt;
  const auto name = std::find(axis_names.begin(), axis_names.end(), message.substr(opening.size(), 1));
  if (name == axis_names.end()) return std::nullopt;
  return base::all_axes[static_cast<std::size_t>(name - axis_names.begin())];
}

std::string_view limit_key(std::string_view message, const AxisKeys& keys) {
  const auto says = [&](std::string_view word) { return message.find(word) != std::string_view::npos; };
  if (says("velocity")) return keys.velocity;
  if (says("acceleration")) return keys.acceleration;
  return says("jerk") ? keys.jerk : keys.blu;
}

/// "axis X: backward pitch entry 3 …": they count from 1.
std::string pitch_slot(std::string_view message, const AxisKeys& keys) {
  constexpr std::string_view opening = "pitch entry ";
  const std::size_t found = message.find(opening);
  if (found == std::string_view::npos) return {};
  const std::string_view rest = message.substr(found + opening.size());
  std::size_t entry = 0;
  std::from_chars(rest.data(), rest.data() + rest.size(), entry);
  const bool is_backward = message.substr(0, found).ends_with("backward ");
  return fmt::format("{}[{}]", is_backward ? keys.pitch_errors_backward : keys.pitch_errors, entry - 1);
}

std::string_view step_time_key(std::string_view message) {
  for (std::size_t k = 0; k < machine::all_step_times.size(); ++k) {
    if (message.find(machine::all_step_times[k].name) != std::string_view::npos) return step_time_keys[k];
  }
  return {};
}

std::string axis_slot(const base::Diagnostic& problem, const AxisKeys& keys) {
  if (problem.code == "machine-travel") return std::string(keys.travel);
  if (problem.code == "backlash") return std::string(keys.backlash);
  if (problem.code == "backlash-takeup") return std::string(keys.takeup);
  if (problem.code == "step-time") return std::string(step_time_key(problem.message));
  if (problem.code.starts_with("pitch-")) return pitch_slot(problem.message, keys);
  return std::string(limit_key(problem.message, keys));
}

}  // namespace

const AxisKeys& keys_of(base::Axis axis) {
  return base::is_rotary(axis) ? rotary_keys : linear_keys;
}

std::string section_of(base::Axis axis) {
  return fmt::format("axis.{}", base::letter(axis));
}

std::string slot_of(const base::Diagnostic& problem) {
  if (problem.code == "machine-kinematics") return "kinematics";
  if (problem.code == "machine-period") return "period_us";
  if (problem.code == "machine-tolerance") return "tolerance_mm";
  if (problem.code == "machine-chord-error") return "chord_error_mm";
  const auto axis = axis_in(problem.message);
  if (axis && problem.code == "machine-drive") return drive_slot_of(*axis, problem.message);
  return axis ? fmt::format("{}.{}", section_of(*axis), axis_slot(problem, keys_of(*axis))) : std::string();
}

}  // namespace leadscrew::cli
