#pragma once
// `leadscrew check`: reads programs and says what is wrong with them.

#include <leadscrew/cli/job.hpp>

namespace leadscrew::cli {

Status check(const Job& job, Console& console);

}  // namespace leadscrew::cli
