#pragma once
// Work for all processors.

#include <cstddef>
#include <functional>

namespace leadscrew::realtime {

/// Calls work(0) … work(count − 1), each once, from as many threads as there are processors; returns when all are done.
/// `work` throws nothing.
void share_out(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace leadscrew::realtime
