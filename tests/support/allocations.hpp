#pragma once
// Counting what a test program allocates. Linking the library `counting_allocations` replaces operator new.

#include <cstdint>

namespace leadscrew::testing_support {

/// Calls of operator new by the whole program so far.
std::int64_t allocations();
/// By the calling thread.
std::int64_t allocations_of_thread();

/// What the whole program holds of operator new's memory, bytes.
std::int64_t memory_held();
/// The most that it has held since watch_memory() was called.
std::int64_t most_memory_held();
void watch_memory();

}  // namespace leadscrew::testing_support
