#include <algorithm>
#include <leadscrew/base/nearest.hpp>
#include <leadscrew/config/machine_keys.hpp>
#include <span>

namespace leadscrew::config {

namespace {

/// Named by the contract, and not yet more than names.
constexpr std::array<std::string_view, 6> later_kinematics = {"table-table-ac", "table-table-bc", "head-head-bc",
                                                              "head-head-ac",   "head-b-table-c", "head-b-table-a"};

void append(std::vector<std::string_view>& texts, std::span<const Key> keys, base::Axis axis) {
  for (const Key& key : keys) texts.push_back(text_of(key, axis));
}

}  // namespace

std::string_view axis_key_of(base::Axis axis, std::string_view field) {
  const auto found = std::ranges::find(axis_keys, field, &Key::field);
  return found == axis_keys.end() ? std::string_view() : text_of(*found, axis);
}

std::vector<std::string_view> all_axis_keys(base::Axis axis) {
  std::vector<std::string_view> texts;
  append(texts, axis_keys, axis);
  texts.push_back(drive_key);
  return texts;
}

std::vector<std::string_view> all_drive_keys(base::Axis axis) {
  std::vector<std::string_view> texts = {controller_key, encoder_key};
  append(texts, drive_keys, axis);
  return texts;
}

std::vector<std::string_view> needed_keys(base::Axis axis) {
  std::vector<std::string_view> texts;
  append(texts, std::span(axis_keys).first(needed_axis_key_count), axis);
  return texts;
}

std::string section_of(base::Axis axis) {
  return std::string("axis.") + base::letter(axis);
}

std::string drive_section_of(base::Axis axis) {
  return section_of(axis) + "." + std::string(drive_key);
}

void explain_kinematics(base::Diagnostic& problem, std::string_view kinematics) {
  if (std::ranges::find(later_kinematics, kinematics) != later_kinematics.end()) {
    problem.message = "kinematics \"" + std::string(kinematics) + "\" is not built yet";
    problem.hint = "built: cartesian";
  } else if (base::nearest(kinematics, std::array<std::string_view, 1>{"cartesian"})) {
    problem.hint = "did you mean cartesian?";
  }
}

}  // namespace leadscrew::config
