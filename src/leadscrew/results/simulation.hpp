#pragma once
// What a simulation found, as JSON and as people read it.

#include <leadscrew/results/program_json.hpp>
#include <leadscrew/results/simulate_figures.hpp>
#include <leadscrew/results/style.hpp>

namespace leadscrew::results {

inline constexpr std::string_view simulate_schema = "leadscrew.simulate/1";

/// How the slides of each axis followed.
Json json_of_axes(const drive::TrackedAxes& axes);
std::string axis_rows(const drive::TrackedAxes& axes, const Style& style);

Json json_of_simulation(const std::string& program, const machine::Machine& machine, const SimulateFigures& figures,
                        const Diagnostics& diagnostics);
std::string simulate_summary(const std::string& program, const machine::Machine& machine,
                             const SimulateFigures& figures, const Style& style);

}  // namespace leadscrew::results
