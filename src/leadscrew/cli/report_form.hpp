#pragma once
// The report's contents, from what a run found and the text of the blocks that its tables name.

#include <leadscrew/cli/diagnostic_log.hpp>
#include <leadscrew/cli/figures.hpp>
#include <leadscrew/cli/job.hpp>
#include <leadscrew/trace/recording.hpp>
#include <leadscrew/trace/report.hpp>

namespace leadscrew::cli {

/// Errors: those of reading the file once more.
base::Result<trace::Report> report_of(const InputFile& file, const Job& job, const RunFigures& figures,
                                      const DiagnosticLog& log, const trace::Recording& recording);

}  // namespace leadscrew::cli
