#pragma once
// The keys of machine files that say how a simulated spindle turns. For machine_file.cpp alone.

#include <leadscrew/config/keys_told.hpp>
#include <leadscrew/config/toml_values.hpp>
#include <leadscrew/machine/spindle.hpp>

namespace leadscrew::config {

/// The spindle of [spindle]; what is not given is as machine::Spindle has it. Codes: `machine-type`; `machine-spindle`, of
/// a seed below 0.
machine::Spindle read_spindle_keys(const toml::table& table, const KeysTold& told);

}  // namespace leadscrew::config
