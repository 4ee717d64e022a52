#pragma once
// Whether a state can be gone on from, and the return path to where it goes on.

#include <leadscrew/drive/state.hpp>
#include <vector>

namespace leadscrew::drive {

/// Errors: `resume-program`, `resume-machine` where another was being driven, `resume-ended` where nothing is left.
/// `resume-state` where an axis would stand outside its travel.
base::Result<void> check_resumable(const State& state, const Fingerprint& now, const machine::Machine& machine,
                                   const std::string& path);

/// The way back to the path.
struct ReturnPath {
  std::vector<base::PathPlace> places;  ///< from where the axes stand to where the last word was, a place a period
  bool leads_in_step = false;           ///< planner::Planner::starts_in_step()
};

/// Without places if the axes stand there. The path is read anew so far. Errors: `resume-state` where it does not pass there; those of reading it, interruption.
base::Result<ReturnPath> find_return_path(const State& state, const files::InputFile& program, const Setup& setup,
                                          const std::string& path);

}  // namespace leadscrew::drive
