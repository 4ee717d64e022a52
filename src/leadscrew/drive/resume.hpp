#pragma once
// Whether a state can be gone on from, and the return path to where it goes on.

#include <leadscrew/drive/state.hpp>
#include <vector>

namespace leadscrew::drive {

/// Errors: `resume-program`, `resume-machine` where another was being driven, `resume-ended` where nothing is left.
/// `resume-state` where an axis would stand outside its travel.
base::Result<void> check_resumable(const State& state, const Fingerprint& now, const machine::Machine& machine,
                                   const std::string& path);

/// From where the axes stand to where the last word was, a place a period; empty if they stand there. The path is read
/// anew so far. Errors: `resume-state` where it does not pass there; those of reading it, interruption.
base::Result<std::vector<base::PathPlace>> find_return_path(const State& state, const files::InputFile& program,
                                                            const Setup& setup, const std::string& path);

}  // namespace leadscrew::drive
