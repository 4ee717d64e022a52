#pragma once
// `leadscrew verify`: the referee judges a trace, ours or another controller's, against its program and machine.

#include <leadscrew/cli/job.hpp>

namespace leadscrew::cli {

Status verify(const Job& job, Console& console);

}  // namespace leadscrew::cli
