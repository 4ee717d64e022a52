#pragma once
// Times of step signals that the planner of pulses refuses, in the words of the command line and of machine files.

#include <leadscrew/cli/job.hpp>

namespace leadscrew::cli {

/// The diagnostic, one of nc::check_pulses(); of `pulse-step-length` with those of the axis' times that set the limit.
base::Diagnostic in_options(base::Diagnostic problem, const Job& job);

}  // namespace leadscrew::cli
