#pragma once
// Passes of a surface made by a thread of their own, a few ahead of who asks for them: who reads a program to check it works on one
// pass while the next is made.

#include <atomic>
#include <leadscrew/surfaces/passes.hpp>
#include <memory>

namespace leadscrew::realtime {

/// At most eight passes are kept. Who has had enough destroys it, which waits until the pass under way is made. `seconds`, which
/// outlives it, gets the thread's processor time added, s, before the source says that there is no pass more and when it is
/// destroyed. None where the system has no thread to give. For gcode::ReaderOptions::pass_source, where the reader may start threads.
std::unique_ptr<surfaces::PassSource> passes_ahead(surfaces::Passes& passes, std::atomic<double>& seconds);

}  // namespace leadscrew::realtime
