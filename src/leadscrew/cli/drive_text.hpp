#pragma once
// What a drive has come to, as text and as JSON.

#include <leadscrew/cli/console.hpp>
#include <leadscrew/cli/diagnostic_log.hpp>
#include <leadscrew/cli/drive_figures.hpp>
#include <leadscrew/cli/job.hpp>
#include <leadscrew/cli/json_form.hpp>
#include <string>

namespace leadscrew::cli {

Json json_of_drive(const std::string& program, const Job& job, const DriveFigures& figures, const DiagnosticLog& log);
std::string drive_summary(const std::string& program, const Job& job, const DriveFigures& figures, const Style& style);

}  // namespace leadscrew::cli
