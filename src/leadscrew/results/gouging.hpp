#pragma once
// What `check --gouge` says.

#include <leadscrew/gouging/program_check.hpp>
#include <leadscrew/json/json.hpp>
#include <leadscrew/report/report.hpp>
#include <leadscrew/results/figures.hpp>
#include <leadscrew/results/style.hpp>
#include <string>

namespace leadscrew::results {

/// At the blocks, in their order: `gouge`, `gouge-contact`; and of the check as a whole `gouge-coarse`, `gouge-no-shape`,
/// `gouge-too-large`.
Diagnostics gouging_diagnostics(const gouging::GougeVerdict& verdict, const std::string& program);

/// As it stands under "gouging".
json::Json json_of_gouging(const gouging::GougeVerdict& verdict);

/// As a report shows it; shows_tip: its pictures are of the tip in the workpiece, not of X, Y and Z of the axes.
report::Gouging reported_gouging(const gouging::GougeVerdict& verdict, bool shows_tip);

/// For people: one line, without its end.
std::string gouging_text(const gouging::GougeVerdict& verdict, const Style& style);

}  // namespace leadscrew::results
