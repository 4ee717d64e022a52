#pragma once
// `leadscrew measure`: what the tool of a trace leaves of the surfaces that its program machines.

#include <leadscrew/cli/job.hpp>

namespace leadscrew::cli {

Status measure(const Job& job, Console& console);

}  // namespace leadscrew::cli
