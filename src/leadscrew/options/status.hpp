#pragma once
// What the command says to the shell that started it.

#include <leadscrew/base/diagnostic.hpp>

namespace leadscrew::options {

/// Exit status. Of several programs the greatest counts.
enum class Status : int {
  done = 0,
  not_kept = 1,      ///< a limit or tolerance was not kept, or the referee objects
  usage = 2,         ///< the command line makes no sense
  rejected = 3,      ///< a program, machine file, tool table or trace has errors
  input_output = 4,  ///< a file cannot be opened, read on or written
  interrupted = 130,
};

constexpr Status worse(Status a, Status b) {
  return static_cast<int>(a) > static_cast<int>(b) ? a : b;
}

/// The status of a command that ended with this diagnostic. Of files are codes that begin with "io-", those of files
/// that are others when they are read again, and of files that are too large.
inline Status status_of(const base::Diagnostic& diagnostic) {
  if (diagnostic.severity != base::Severity::error) return Status::done;
  if (diagnostic.code == "interrupted") return Status::interrupted;
  if (diagnostic.code == "usage") return Status::usage;
  if (diagnostic.code == "gouge" || diagnostic.code == "gouge-contact") return Status::not_kept;
  const bool is_of_files = diagnostic.code.starts_with("io-") || diagnostic.code.ends_with("-changed") ||
                           diagnostic.code == "input-too-large";
  return is_of_files ? Status::input_output : Status::rejected;
}

}  // namespace leadscrew::options
