#pragma once
// Words on their way to the drives, each checked by a guard, and the stop paths behind them. A slice is not published
// if it, or its stop path, holds a word that the guard refuses: the drives never see it.

#include <atomic>
#include <leadscrew/drive/link.hpp>
#include <leadscrew/drive/word_guard.hpp>
#include <leadscrew/realtime/runner.hpp>

namespace leadscrew::drive {

class GuardedSink {
 public:
  /// The axes stand at `position`, mm or degrees. At most so many words wait in the link. The link and the machine must
  /// outlive this.
  GuardedSink(Link& link, const machine::Machine& machine, const base::AxisVector& position, std::size_t most_waiting)
      : link_(link), most_waiting_(most_waiting), guard_(machine, position), stop_path_guard_(guard_) {}
  GuardedSink(const GuardedSink&) = delete;
  GuardedSink& operator=(const GuardedSink&) = delete;

  /// For a runner, which must not outlive this.
  realtime::WordSink sink();

  /// Was a slice kept back? Anybody's.
  bool has_refused() const { return has_refused_.load(std::memory_order_acquire); }
  /// Why; when the runner has ended. Error: `word-refused`.
  std::optional<base::Diagnostic> problem() const;

 private:
  bool take(const base::Word& word) noexcept;
  bool publish() noexcept;

  Link& link_;
  const std::size_t most_waiting_;
  WordGuard guard_, stop_path_guard_;  ///< of words, and of the stop path behind the last one; the cyclic thread's
  std::atomic<bool> has_refused_{false};
};

}  // namespace leadscrew::drive
