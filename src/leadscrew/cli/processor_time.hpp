#pragma once
// Processor time of this thread: on a busy machine it is less than what the clock on the wall says.

#include <ctime>

namespace leadscrew::cli {

/// s since the thread began. Costs a call of the system.
inline double processor_seconds() {
  std::timespec time = {};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) / 1e9;
}

}  // namespace leadscrew::cli
