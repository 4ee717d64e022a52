#pragma once
// Whether the files of a drive can be written.

#include <leadscrew/base/result.hpp>
#include <leadscrew/cli/job.hpp>
#include <leadscrew/files/input_file.hpp>

namespace leadscrew::cli {

/// Errors: those of check_written(), `state-other`, `usage`.
base::Result<void> check_drive_files(const files::InputFile& program, const Job& job);

}  // namespace leadscrew::cli
