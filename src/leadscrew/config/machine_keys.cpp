#include <algorithm>
#include <leadscrew/base/nearest.hpp>
#include <leadscrew/config/machine_keys.hpp>
#include <span>

namespace leadscrew::config {

namespace {

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
  if (base::is_rotary(axis)) texts.insert(texts.end(), chain_axis_keys.begin(), chain_axis_keys.end());
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
  std::vector<std::string_view> known = {machine::cartesian};
  for (const machine::KinematicsPreset& preset : machine::kinematics_presets) known.push_back(preset.name);
  if (std::ranges::find(known, kinematics) != known.end()) return;
  if (const auto meant = base::nearest(kinematics, known)) problem.hint = "did you mean " + std::string(*meant) + "?";
}

}  // namespace leadscrew::config
