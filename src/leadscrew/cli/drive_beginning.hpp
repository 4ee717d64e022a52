#pragma once
// Where a drive begins: at the program's start, or where an earlier one has come to.

#include <leadscrew/base/result.hpp>
#include <leadscrew/cli/drive_state.hpp>
#include <optional>
#include <vector>

namespace leadscrew::cli {

struct DriveBeginning {
  DriveState state;                         ///< its word is where the first word will be, its axes where they stand
  std::vector<base::PathPlace> way_back;    ///< from the axes to that word, a place a period
  std::vector<Descriptor> held;             ///< the states' names: no other drive keeps them
  std::optional<base::Diagnostic> warning;  ///< `resume-cut-twice`

  /// Holds the states, reads the one to resume, and writes the one to keep. Errors: those of hold_state(),
  /// fingerprint_of(), read_state(), check_resumable(), find_way_back() and write_state().
  static base::Result<DriveBeginning> of(const InputFile& program, const Job& job);
};

}  // namespace leadscrew::cli
