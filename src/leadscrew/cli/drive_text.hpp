#pragma once
// What a drive has come to, as text and as JSON.

#include <leadscrew/cli/console.hpp>
#include <leadscrew/cli/diagnostic_log.hpp>
#include <leadscrew/cli/job.hpp>
#include <leadscrew/cli/json_form.hpp>
#include <leadscrew/drive/figures.hpp>
#include <string>

namespace leadscrew::cli {

Json json_of_drive(const std::string& program, const Job& job, const drive::Figures& figures, const DiagnosticLog& log);
std::string drive_summary(const std::string& program, const Job& job, const drive::Figures& figures,
                          const Style& style);

}  // namespace leadscrew::cli
