#pragma once
// Where a drive has come to, on disk: what it takes to go on after a stop, a kill or a power failure.

#include <leadscrew/base/result.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/drive/setup.hpp>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/kinematics/word_poses.hpp>
#include <string>
#include <string_view>

namespace leadscrew::drive {

/// What must be the same for a place on the path to mean the same.
struct Fingerprint {
  std::string program;  ///< of its bytes, and of those of the subprograms that it has called so far
  std::string machine;  ///< of the machine, its tools, and how the program is read
};
/// Errors: those of reading the program.
base::Result<Fingerprint> fingerprint_of(const files::InputFile& program, const Setup& setup);

/// The tool of a machine with a chain of rotary axes, while the axes stand as the state says.
struct ToolState {
  kinematics::Vector offset{};     ///< mm
  kinematics::Vector tip{};        ///< in the workpiece as it lies with all rotary axes at 0, mm
  kinematics::Vector direction{};  ///< a unit vector from the tip to the spindle, seen from there
};
/// None of other machines.
std::optional<ToolState> tool_state_of(const kinematics::WordPoses& poses, const base::AxisVector& axes);

struct State {
  enum class Kind { moving, stopped, ended };

  std::string program, machine;  ///< names, for people
  Fingerprint fingerprint;
  Kind kind = Kind::stopped;
  base::Word word;       ///< the last that the drives have taken
  base::PathPlace axes;  ///< where they stand, or stood when this was written: there, or ahead of it
  std::optional<ToolState> tool;
};

/// Durable before it is visible, and whole or not there at all. Errors: `io-open`, `io-write`.
base::Result<void> write_state(const std::string& path, const State& state);
/// Errors: `io-…` and `resume-state`.
base::Result<State> read_state(const std::string& path);
/// Is there no file yet, an empty one, one that is not regular, or an earlier state? Errors: `state-other`.
base::Result<void> check_replaceable(const std::string& path);

/// An error about the state file at the path.
tl::unexpected<base::Diagnostic> state_refusal(std::string_view code, std::string message, std::string hint,
                                               const std::string& path);

}  // namespace leadscrew::drive
