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

/// A line of figures for each method, and the conventions that were in force.
std::string pulse_summary(const nc::PulseCurve& curve, const AllPulses& pulses, const Style& style);

/// Every register at every clock.
std::string pulse_table(const nc::PulseCurve& curve, const waves::MeasuredPulses& pulses, const Style& style);

Json json_of_pulses(const nc::PulseCurve& curve, const AllPulses& pulses, bool with_path);
Json json_of_rejected_pulses(const nc::PulseCurve& curve, const Diagnostics& diagnostics);

}  // namespace leadscrew::results
