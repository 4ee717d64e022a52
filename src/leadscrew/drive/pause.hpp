#pragma once
// M0, M1 and M60 on a terminal: the planner's thread asks before each chunk, the view's answers when a key says so.

#include <algorithm>
#include <atomic>
#include <leadscrew/planner/motion.hpp>
#include <optional>

namespace leadscrew::drive {

class Pause {
 public:
  /// Of the first pause before the chunk, or of the one after so many of them.
  static std::optional<base::Line> line_before(const planner::Chunk& chunk, int after = 0) {
    const auto pause = std::find_if(chunk.events.begin(), chunk.events.end(), [&](const base::Event& event) {
      const bool is_pause = base::is_pause(event.kind);
      return is_pause && after-- == 0;
    });
    return pause == chunk.events.end() ? std::nullopt : std::optional(pause->line);
  }

  /// May motion go on with this chunk? Asked again until it may: there may be more than one pause before it.
  bool may_start(const planner::Chunk& chunk) {
    if (!line_before(chunk)) return true;
    if (goes_on_.exchange(false, std::memory_order_acq_rel)) ++passed_;
    const std::optional<base::Line> line = line_before(chunk, passed_);
    line_.store(line ? base::number(*line) : nowhere, std::memory_order_release);
    if (!line) passed_ = 0;
    return !line;
  }

  /// Of the pause where motion waits, or will.
  std::optional<base::Line> line() const {
    const std::int64_t line = line_.load(std::memory_order_acquire);
    return line == nowhere ? std::nullopt : std::optional(base::Line{line});
  }
  void go_on() { goes_on_.store(true, std::memory_order_release); }

 private:
  static constexpr std::int64_t nowhere = -1;
  std::atomic<std::int64_t> line_{nowhere};
  std::atomic<bool> goes_on_{false};
  int passed_ = 0;  ///< before the same chunk; the planner's
};

}  // namespace leadscrew::drive
