#pragma once
// Where a drive begins: at the program's start, or where an earlier one has come to.

#include <leadscrew/base/result.hpp>
#include <leadscrew/drive/state.hpp>
#include <leadscrew/drive/state_lock.hpp>
#include <optional>
#include <vector>

namespace leadscrew::drive {

struct Beginning {
  State state;                               ///< its word is where the first word will be, its axes where they stand
  std::vector<base::PathPlace> return_path;  ///< from the axes to that word, a place a period
  std::vector<StateLock> held;               ///< of the states that are kept and gone on from
  std::vector<base::Diagnostic> warnings;    ///< `resume-cut-twice`, `resume-out-of-step`

  /// Holds the states, reads the one to resume, and writes the one to keep. Errors: those of StateLock::hold(),
  /// fingerprint_of(), read_state(), check_resumable(), find_return_path() and write_state().
  static base::Result<Beginning> of(const files::InputFile& program, const Setup& setup);
};

}  // namespace leadscrew::drive
