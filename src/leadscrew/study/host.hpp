#pragma once
// What a study needs of the computer it runs on. The core has neither a clock nor threads; whoever starts a study lends
// it both.

#include <cstddef>
#include <functional>

namespace leadscrew::study {

/// Any of these may be empty.
struct Host {
  std::function<double()> thread_cpu_seconds;  ///< processor time of the calling thread
  std::function<double()> wall_seconds;        ///< a steady clock, cheap to look at
  /// Calls work(0) … work(count − 1), each once, several at a time and in any order; returns when all are done.
  std::function<void(std::size_t count, const std::function<void(std::size_t)>& work)> share_out;
};

/// By whatever threads the host has; one after the other where it lends none. What `work` writes for one index, no
/// other may read or write: then results are the same whatever the threads.
inline void share_out(const Host& host, std::size_t count, const std::function<void(std::size_t)>& work) {
  if (host.share_out) return host.share_out(count, work);
  for (std::size_t i = 0; i < count; ++i) work(i);
}

}  // namespace leadscrew::study
