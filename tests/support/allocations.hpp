#pragma once
// Counting what a test program allocates. Linking the library `counting_allocations` replaces operator new.

#include <cstdint>

namespace leadscrew::testing_support {

/// Calls of operator new by the whole program so far.
std::int64_t allocations();

}  // namespace leadscrew::testing_support
