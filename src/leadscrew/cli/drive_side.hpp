#pragma once
// The drives' process: takes a word every period, moves the axes, writes down what came and where it ended.

#include <leadscrew/cli/drive_link.hpp>
#include <leadscrew/cli/drive_state.hpp>
#include <leadscrew/cli/job.hpp>
#include <vector>

namespace leadscrew::cli {

/// Until words end or cease; the process then has nothing more to do. `begin`: what is known before the first word: its
/// word is where the first word will be, its axes where they stand; the way back leads from the one to the other. The
/// machine's loops must be sound: servo::check_stable().
void run_drives(DriveLink& link, const Job& job, const DriveState& begin, const std::vector<base::PathPlace>& way_back);

}  // namespace leadscrew::cli
