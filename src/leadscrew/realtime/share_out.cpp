#include <algorithm>
#include <atomic>
#include <leadscrew/realtime/share_out.hpp>
#include <thread>
#include <vector>

namespace leadscrew::realtime {

void share_out(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next = 0;
  const auto take = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::jthread> others;  // this thread works as well
  while (others.size() + 1 < std::min(count, processors)) others.emplace_back(take);
  take();
}

}  // namespace leadscrew::realtime
