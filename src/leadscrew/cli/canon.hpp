#pragma once
// `leadscrew canon`: prints the canonical machining calls of a program.

#include <leadscrew/cli/job.hpp>

namespace leadscrew::cli {

Status canon(const Job& job, Console& console);

}  // namespace leadscrew::cli
