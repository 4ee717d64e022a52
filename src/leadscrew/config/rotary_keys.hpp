#pragma once
// The keys of machine files that say where rotary axes lie and what they carry. For machine_file.cpp alone.

#include <leadscrew/config/keys_told.hpp>
#include <leadscrew/config/toml_values.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <optional>
#include <string_view>

namespace leadscrew::config {

/// The chain of that kinematics with what the file gives in place of the preset's values; empty where the kinematics has
/// none. Codes: `machine-type`; `machine-carries`; `machine-kinematics`, of keys that have no meaning without a chain.
std::optional<machine::RotaryChain> read_rotary_chain(const toml::table& root, std::string_view kinematics,
                                                      const KeysTold& told);

}  // namespace leadscrew::config
