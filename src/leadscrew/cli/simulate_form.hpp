#pragma once
// What a simulation found, as JSON and as people read it.

#include <leadscrew/cli/console.hpp>
#include <leadscrew/cli/json_form.hpp>
#include <leadscrew/cli/simulate_figures.hpp>

namespace leadscrew::cli {

inline constexpr std::string_view simulate_schema = "leadscrew.simulate/1";

/// How the slides of each axis followed.
Json json_of_axes(const drive::TrackedAxes& axes);
std::string axis_rows(const drive::TrackedAxes& axes, const Style& style);

Json json_of_simulation(const std::string& program, const Job& job, const SimulateFigures& figures,
                        const DiagnosticLog& log);
std::string simulate_summary(const std::string& program, const Job& job, const SimulateFigures& figures,
                             const Style& style);

}  // namespace leadscrew::cli
