#pragma once
// The `leadscrew` command: arguments, files, TOML and the terminal. It makes no motion of its own; it opens what the
// rooms read, puts where it belongs what they write, and says what they found.
//
//   arguments ─▶ job (machine, tools, options) ─▶ run · check · verify ─▶ files, summary or JSON, exit status
//
// Data go to standard output, all else to standard error. Files appear whole or not at all.

namespace leadscrew::cli {

/// The whole command, from main's arguments to the exit status (status.hpp).
int command(int count, const char* const* values);

}  // namespace leadscrew::cli
