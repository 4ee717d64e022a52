#pragma once
// What interpolators of reference pulses make, as people and programs read it.

#include <leadscrew/results/program_json.hpp>
#include <leadscrew/results/style.hpp>
#include <leadscrew/waves/pulses.hpp>
#include <string>
#include <vector>

namespace leadscrew::results {

inline constexpr std::string_view pulse_schema = "leadscrew.pulse/1";

using AllPulses = std::vector<waves::MeasuredPulses>;

/// A line of figures for each method, with the conventions that were in force; behind them every register at every clock
/// `with_tables`, or where there is one method of no more than 64 clocks.
std::string pulse_text(const nc::PulseCurve& curve, const AllPulses& pulses, const Style& style, bool with_tables);

/// `too-many-clocks` where all of them together are more than text can have a line for: 10 million. `option`: what asks
/// for every clock.
base::Result<void> check_clocks(const AllPulses& pulses, std::string_view option);

Json json_of_pulses(const nc::PulseCurve& curve, const AllPulses& pulses, bool with_path);
Json json_of_rejected_pulses(const nc::PulseCurve& curve, const Diagnostics& diagnostics);

}  // namespace leadscrew::results
