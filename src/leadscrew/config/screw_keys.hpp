#pragma once
// The keys of machine files that say how far a screw is off. For machine_file.cpp alone.

#include <leadscrew/base/axes.hpp>
#include <leadscrew/config/keys_told.hpp>
#include <leadscrew/config/toml_values.hpp>
#include <leadscrew/machine/screw_errors.hpp>
#include <string_view>
#include <vector>

namespace leadscrew::config {

/// A table of [axis.X], entry by entry: machine::field::pitch_errors or backward_pitch_errors. What is no entry keeps its
/// place in the list, as NaN. Code: `machine-type`.
std::vector<machine::PitchError> read_pitch_errors(const toml::table& table, base::Axis axis, std::string_view field,
                                                   const KeysTold& told);

}  // namespace leadscrew::config
