#pragma once
// The drives' process: takes a word every period, moves the axes, writes down what came and where it ended.

#include <leadscrew/drive/beginning.hpp>
#include <leadscrew/drive/link.hpp>
#include <leadscrew/drive/setup.hpp>

namespace leadscrew::drive {

/// Until words end or cease; the process then has nothing more to do. Axes stand where `begin` says and go its return path
/// to where the first word will be. Its locks are removed where the process that makes words is gone. The machine's
/// loops must be sound: check_machine().
void run_drives(Link& link, const Setup& setup, Beginning& begin);

}  // namespace leadscrew::drive
