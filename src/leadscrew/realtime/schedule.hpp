#pragma once
// The clock, for pacing and nothing else: absolute times, so that what one period takes is not added to the next.

#include <cstdint>
#include <leadscrew/base/diagnostic.hpp>
#include <optional>

namespace leadscrew::realtime {

/// Nanoseconds of CLOCK_MONOTONIC.
std::int64_t now() noexcept;

/// Returns at that time or later; at once if it has passed.
void sleep_until(std::int64_t time) noexcept;

/// The calling thread before all others of the system (SCHED_FIFO), the process' memory locked: its code and static data, what else
/// has been touched, the thread's stack among that, and the rest from when it is touched. Returns a warning `not-real-time` that says
/// what the system did not permit; what it did holds.
std::optional<base::Diagnostic> become_real_time();

}  // namespace leadscrew::realtime
