#pragma once
// ^C and its relatives. Signals only raise a flag; whoever works for long looks at it, cleans up and leaves, within a
// second. No call of the system waits for longer than a tenth of one (descriptor.cpp), so that the flag is seen there
// too, whichever thread got the signal.

#include <leadscrew/base/diagnostic.hpp>

namespace leadscrew::files {

/// SIGINT and SIGTERM raise the flag, and SIGHUP unless it was ignored. Closed pipes and full disks become errors of
/// write() instead of signals.
void watch_signals();

bool interrupted();

/// From now on the first signal ends the process with the status of an interruption, for work that nobody looks up from
/// and that writes nothing before its end.
void end_when_interrupted();

/// From now on interrupted() means the second signal: for who does something about the first, and needs files for it.
void let_first_interruption_pass();
/// Signals so far: 0, 1, or 2 for more.
int interruptions();

/// What ends a command once interrupted() is true.
base::Diagnostic interruption();

}  // namespace leadscrew::files
