#pragma once
// Events for any number of viewers. Whoever publishes never waits for one of them: the latest events are kept, and a viewer
// that is farther behind than these is told how many it has missed.
//
//   publish ─▶ [ 17 18 19 20 ]   kept
//                 ▲        ▲
//              viewer A  viewer B                each with a number of its own: the next event that it has not seen

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::serve {

class Channel {
 public:
  /// What a viewer has seen.
  struct Place {
    std::int64_t next = 0;  ///< number of the event that it has not seen, from 0
  };
  struct Taken {
    std::vector<std::shared_ptr<const std::string>> events;  ///< in order
    std::int64_t missed = 0;                                 ///< before these: they are kept no more
    bool is_over = false;                                    ///< no more events come; these are the last
  };

  /// So many events are kept, ≥ 1.
  explicit Channel(std::size_t kept) : kept_(kept) {}

  /// From any thread; waits for no viewer. Ignored after close().
  void publish(std::string event);
  /// No more events will come.
  void close();

  /// Of a viewer that begins now: with the latest event, if there is one.
  Place latest() const;
  /// All that the place has not seen, and moves it behind them; waits for the first, but not longer than so.
  Taken take(Place& place, std::chrono::milliseconds longest_wait);

 private:
  const std::size_t kept_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::shared_ptr<const std::string>> events_;
  std::int64_t first_ = 0;  ///< number of events_.front()
  bool is_over_ = false;

  std::int64_t end() const { return first_ + static_cast<std::int64_t>(events_.size()); }
};

}  // namespace leadscrew::serve
