#pragma once
// The keys of machine files that say what a simulated probe touches beside planes. For machine_file.cpp alone.

#include <leadscrew/config/keys_told.hpp>
#include <leadscrew/config/toml_values.hpp>
#include <leadscrew/machine/probe.hpp>
#include <vector>

namespace leadscrew::config {

/// The bodies of [probe], kind by kind. An entry that is none keeps its place as one of NaN. Code: `machine-type`.
std::vector<machine::ProbeBody> read_probe_bodies(const toml::table& table, const KeysTold& told);

}  // namespace leadscrew::config
