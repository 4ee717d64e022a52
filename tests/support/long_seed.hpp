#pragma once
// The seed of long tests that draw with engines of their own: that of RapidCheck, which every night is another.

#include <cstdlib>
#include <cstring>

namespace leadscrew::testing_support {

/// From `seed=` in the environment variable RC_PARAMS; 0 without.
inline unsigned long_seed() {
  const char* const parameters = std::getenv("RC_PARAMS");
  const char* const seed = parameters == nullptr ? nullptr : std::strstr(parameters, "seed=");
  return seed == nullptr ? 0 : static_cast<unsigned>(std::strtoul(seed + 5, nullptr, 10));
}

}  // namespace leadscrew::testing_support
