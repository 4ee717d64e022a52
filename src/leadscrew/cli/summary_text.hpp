#pragma once
// Results as people read them.

#include <leadscrew/cli/console.hpp>
#include <leadscrew/cli/diagnostic_log.hpp>
#include <leadscrew/cli/figures.hpp>
#include <leadscrew/cli/job.hpp>
#include <string>

namespace leadscrew::cli {

/// The parts summaries are made of.
std::string heading(const std::string& program, const std::string& machine, base::Period period, const Style& style);
std::string row(std::string_view name, const std::string& value);
std::string deviation_text(double deviation, double tolerance);  ///< mm

std::string run_summary(const std::string& program, const Job& job, const RunFigures& figures, const Style& style);
std::string check_summary(const std::string& program, const Reading& reading, const DiagnosticLog& log,
                          const Style& style);
std::string verify_summary(const std::string& program, const Job& job, const VerifyFigures& figures,
                           const Style& style);

}  // namespace leadscrew::cli
