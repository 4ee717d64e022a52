#pragma once
// M66 where there are no inputs: motion rests until the time is over in which an input should have risen, fallen or come
// on (LinuxCNC manual, "M66 Wait on Input"). The planner's thread asks before each chunk that begins at rest.

#include <atomic>
#include <cstdint>
#include <leadscrew/planner/motion.hpp>
#include <optional>

namespace leadscrew::drive {

class InputWait {
 public:
  /// s that motion waits before the chunk.
  static double seconds_before(const planner::Chunk& chunk) {
    constexpr double at_once = 0, off = 4;  // L words that an input which is off meets
    double seconds = 0;
    for (const base::Event& event : chunk.events) {
      const bool waits = base::is_input(event.kind) && event.value != at_once && event.value != off;
      if (waits) seconds += event.q;
    }
    return seconds;
  }

  /// May motion go on with this chunk at the time `now`, ns? `stands`: words of the motion before it have been made, and
  /// drives are there `lead` s later.
  bool may_start(const planner::Chunk& chunk, bool stands, double lead, std::int64_t now) {
    const double seconds = seconds_before(chunk);
    if (seconds == 0) return true;
    if (!stands) return false;
    if (!begun_) begun_ = now;
    const bool is_over = static_cast<double>(now - *begun_) >= (seconds + lead) * 1e9;
    waits_.store(!is_over, std::memory_order_relaxed);
    return is_over;
  }
  /// The chunk has been handed over.
  void end() { begun_.reset(); }
  /// Does motion wait? Anybody's.
  bool waits() const { return waits_.load(std::memory_order_relaxed); }

 private:
  std::optional<std::int64_t> begun_;  ///< ns
  std::atomic<bool> waits_{false};
};

}  // namespace leadscrew::drive
