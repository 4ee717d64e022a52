#include <fmt/format.h>

#include <leadscrew/cli/drive_keys.hpp>
#include <leadscrew/cli/machine_keys.hpp>

namespace leadscrew::cli {

namespace {

using Keys = std::array<std::string_view, machine::drive_numbers.size()>;

constexpr Keys linear_keys = {"position_gain_per_s",    "velocity_gain_per_s", "velocity_integral_per_s2",
                              "max_acceleration_mm_s2", "damping_per_s",       "gain_mm_s",
                              "time_constant_ms",       "proportional_per_mm", "integral_per_mm_s",
                              "derivative_per_mm",      "command_limit",       "velocity_forward",
                              "acceleration_forward",   "friction_mm_s2",      "breakaway_mm_s2",
                              "encoder_counts_per_mm"};
constexpr Keys rotary_keys = {"position_gain_per_s",     "velocity_gain_per_s",  "velocity_integral_per_s2",
                              "max_acceleration_deg_s2", "damping_per_s",        "gain_deg_s",
                              "time_constant_ms",        "proportional_per_deg", "integral_per_deg_s",
                              "derivative_per_deg",      "command_limit",        "velocity_forward",
                              "acceleration_forward",    "friction_deg_s2",      "breakaway_deg_s2",
                              "encoder_counts_per_deg"};

}  // namespace

const Keys& drive_keys_of(base::Axis axis) {
  return base::is_rotary(axis) ? rotary_keys : linear_keys;
}

std::vector<std::string_view> all_drive_keys(base::Axis axis) {
  std::vector<std::string_view> keys = {controller_key, encoder_key};
  keys.insert(keys.end(), drive_keys_of(axis).begin(), drive_keys_of(axis).end());
  return keys;
}

std::string drive_section_of(base::Axis axis) {
  return section_of(axis) + ".drive";
}

std::string drive_slot_of(base::Axis axis, std::string_view message) {
  for (std::size_t k = 0; k < machine::drive_numbers.size(); ++k) {
    const std::string told = fmt::format("drive: {} is ", machine::drive_numbers[k].name);
    if (message.find(told) != std::string_view::npos)
      return fmt::format("{}.{}", drive_section_of(axis), drive_keys_of(axis)[k]);
  }
  return {};
}

}  // namespace leadscrew::cli
