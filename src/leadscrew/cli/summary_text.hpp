#pragma once
// Results as people read them.

#include <leadscrew/cli/console.hpp>
#include <leadscrew/cli/diagnostic_log.hpp>
#include <leadscrew/cli/figures.hpp>
#include <leadscrew/cli/job.hpp>
#include <string>

namespace leadscrew::cli {

std::string run_summary(const std::string& program, const Job& job, const RunFigures& figures, const Style& style);
std::string check_summary(const std::string& program, const Reading& reading, const DiagnosticLog& log,
                          const Style& style);
std::string verify_summary(const std::string& program, const Job& job, const VerifyFigures& figures,
                           const Style& style);

}  // namespace leadscrew::cli
