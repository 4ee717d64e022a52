#pragma once
// `leadscrew drive`: a program on time (drive/drive.hpp), with a view and keys where there is a terminal.

#include <leadscrew/cli/job.hpp>
#include <leadscrew/cli/options.hpp>
#include <leadscrew/console/console.hpp>

namespace leadscrew::cli {

Status drive(const Job& job, Console& console);

}  // namespace leadscrew::cli
