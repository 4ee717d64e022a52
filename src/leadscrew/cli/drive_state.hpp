#pragma once
// Where a drive has come to, on disk: what it takes to go on after a stop, a kill or a power failure.

#include <leadscrew/base/result.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/cli/descriptor.hpp>
#include <leadscrew/cli/input_file.hpp>
#include <leadscrew/cli/job.hpp>
#include <string>
#include <vector>

namespace leadscrew::cli {

/// What must be the same for a place on the path to mean the same.
struct Fingerprint {
  std::string program;  ///< of its bytes
  std::string machine;  ///< of the machine, its tools, and how the program is read
};
base::Result<Fingerprint> fingerprint_of(const InputFile& program, const Job& job);

struct DriveState {
  enum class Kind { moving, stopped, ended };

  std::string program, machine;  ///< names, for people
  Fingerprint fingerprint;
  Kind kind = Kind::stopped;
  base::Word word;       ///< the last that the drives have taken
  base::PathPlace axes;  ///< where they stand, or stood when this was written: there, or ahead of it
};

/// Held by this process and those that it forks, until the last of them ends: no two drives keep the same state. Waits
/// some seconds for the drives of a command that was killed to come to rest. Errors: `state-busy`, interruption.
base::Result<Descriptor> hold_state(const std::string& path);

/// Durable before it is visible, and whole or not there at all. Errors: `io-open`, `io-write`.
base::Result<void> write_state(const std::string& path, const DriveState& state);
/// Errors: `io-…` and `resume-state`.
base::Result<DriveState> read_state(const std::string& path);
/// Errors: `resume-program`, `resume-machine` where another was being driven, `resume-ended` where nothing is left.
/// `resume-state` where an axis would stand outside its travel.
base::Result<void> check_resumable(const DriveState& state, const Fingerprint& now, const machine::Machine& machine,
                                   const std::string& path);

/// Is there no file yet, an empty one, one that is not regular, or an earlier state? Errors: `state-other`.
base::Result<void> check_replaceable(const std::string& path);
/// From where the axes stand to where the last word was, a place a period; empty if they stand there. The path is read
/// anew so far. Errors: `resume-state` where it does not pass there; those of reading it, interruption.
base::Result<std::vector<base::PathPlace>> find_way_back(const DriveState& state, const InputFile& program,
                                                         const Job& job, const std::string& path);

}  // namespace leadscrew::cli
