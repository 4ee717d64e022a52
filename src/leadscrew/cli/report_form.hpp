#pragma once
// The report's contents, from what a run found and the text of the blocks that its tables name.

#include <leadscrew/cli/diagnostic_log.hpp>
#include <leadscrew/cli/job.hpp>
#include <leadscrew/report/recording.hpp>
#include <leadscrew/report/report.hpp>
#include <leadscrew/results/figures.hpp>
#include <leadscrew/results/simulate_figures.hpp>

namespace leadscrew::cli {

/// Errors: those of reading the file once more.
base::Result<report::Report> report_of(const files::InputFile& file, const Job& job, const results::RunFigures& figures,
                                       const DiagnosticLog& log, const report::Recording& recording);

/// Of slides: deviation and tolerance are theirs, limits those of the plan.
base::Result<report::Report> report_of(const files::InputFile& file, const Job& job,
                                       const results::SimulateFigures& figures, const DiagnosticLog& log,
                                       const report::Recording& recording);

/// The programmed geometry, move by move, curves in 64 parts.
void observe_ideal_path(const files::InputFile& file, const Job& job, report::FollowedRecording& followed);

}  // namespace leadscrew::cli
