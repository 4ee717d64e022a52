#pragma once
// M0, M1 and M60 on a terminal or a page: the planner's thread asks before each chunk, the one that drives answers when a key or
// a viewer says so.

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

  /// May motion go on with this chunk? Asked again until it may: there may be more than one pause before it. And once more
  /// where the chunk then could not be handed over: it may.
  bool may_start(const planner::Chunk& chunk) {
    const std::optional<base::Line> first = line_before(chunk);
    if (!first || first == let_) return true;
    if (goes_on_.exchange(false, std::memory_order_acq_rel)) ++passed_;
    const std::optional<base::Line> line = line_before(chunk, passed_);
    line_.store(line ? base::number(*line) : nowhere, std::memory_order_release);
    if (line) return false;
    passed_ = 0;
    let_ = first;
    return true;
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
  // The planner's:
  int passed_ = 0;  ///< before the same chunk
  std::optional<base::Line>
      let_;  ///< the first pause before the last chunk that had any and might go on; no other has its visit
};

}  // namespace leadscrew::drive
