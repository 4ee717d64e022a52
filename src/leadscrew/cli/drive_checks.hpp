#pragma once
// Whether a program can be driven, as far as that is known before it is read.

#include <leadscrew/base/result.hpp>
#include <leadscrew/cli/input_file.hpp>
#include <leadscrew/cli/job.hpp>

namespace leadscrew::cli {

/// Of motion that is handed over at a time, seconds.
inline constexpr double drive_slice = 0.02;

/// Its files, its period, and whether drives can hold the way of a stop. Errors: those of check_written(),
/// `state-other`, `usage`, `period-too-short`, `stop-too-long`.
base::Result<void> check_drive(const InputFile& program, const Job& job);

}  // namespace leadscrew::cli
