#pragma once
// The keys of machine files that say where rotary axes lie and what they carry. For machine_file.cpp alone.

#include <functional>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/config/toml_values.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace leadscrew::config {

/// What is told while they are read.
struct RotaryTold {
  /// A problem: code, place, what was found, what would be right.
  std::function<void(std::string_view, toml::source_position, std::string, std::string)> problem;
  /// Where a value stands, or what stands for it.
  std::function<void(const base::Subject&, toml::source_position)> place;
};

/// The chain of that kinematics with what the file gives in place of the preset's values; empty where the kinematics has
/// none. Codes: `machine-type`; `machine-carries`; `machine-kinematics`, of keys that have no meaning without a chain.
std::optional<machine::RotaryChain> read_rotary_chain(const toml::table& root, std::string_view kinematics,
                                                      const RotaryTold& told);

}  // namespace leadscrew::config
