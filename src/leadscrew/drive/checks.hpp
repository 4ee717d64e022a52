#pragma once
// Whether a machine can be driven, as far as that is known before anything moves.

#include <leadscrew/base/result.hpp>
#include <leadscrew/drive/setup.hpp>

namespace leadscrew::drive {

/// Its period, whether drives can hold the stop of longest duration, and whether its loops are stable where they are
/// simulated. Errors: `period-too-short`, `stop-too-long`, those of servo::check_stable().
base::Result<void> check_machine(const Setup& setup);

}  // namespace leadscrew::drive
