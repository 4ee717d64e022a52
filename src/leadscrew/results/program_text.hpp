#pragma once
// Results as people read them.

#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/results/figures.hpp>
#include <leadscrew/results/style.hpp>
#include <string>

namespace leadscrew::results {

/// The parts summaries are made of.
std::string clock_text(double seconds);        ///< 0:12, 3:05, 1:02:03
std::string period_text(base::Period period);  ///< "1 ms", "62.5 us"
std::string heading(const std::string& program, const std::string& machine, base::Period period, const Style& style);
std::string row(std::string_view name, const std::string& value);
std::string deviation_text(double deviation, double tolerance);  ///< mm
/// Of the tip and the tool's direction; empty where no tool centre point control was.
std::string tip_row(const referee::Verdict& verdict);

std::string run_summary(const std::string& program, const machine::Machine& machine, const RunFigures& figures,
                        const Style& style);
std::string check_summary(const std::string& program, const CheckFigures& reading, const Diagnostics& diagnostics,
                          const Style& style);
std::string verify_summary(const std::string& program, const machine::Machine& machine, const VerifyFigures& figures,
                           const Style& style);

}  // namespace leadscrew::results
