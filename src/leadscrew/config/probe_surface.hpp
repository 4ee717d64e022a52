#pragma once
// The keys of machine files that say which surface a simulated probe touches. For machine_file.cpp alone.
//
//     [probe]
//     surface = "face.ngc"           blocks of G6.4, as the verb surfaces writes them; beside the machine file
//     surface_at_mm = [0, 0, -20]    where its origin lies, in the machine's coordinates

#include <leadscrew/config/keys_told.hpp>
#include <leadscrew/config/toml_values.hpp>
#include <leadscrew/machine/probe.hpp>
#include <string>
#include <vector>

namespace leadscrew::config {

/// Bytes of a file of surfaces.
inline constexpr std::size_t largest_surface_file = std::size_t{1} << 24;

/// All surfaces that the file of [probe] defines, span by span, in machine coordinates, mm. `machine_file`: a relative path goes
/// from its folder. Codes: `machine-type`; `machine-probe-surface`: the file cannot be read, is larger, has an error, which is
/// told with its line, or defines no surface.
std::vector<machine::ProbePatch> read_probe_surface(const toml::table& table, const std::string& machine_file,
                                                    const KeysTold& told);

}  // namespace leadscrew::config
