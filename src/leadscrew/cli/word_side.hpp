#pragma once
// What all who take words in a process of their own have in common: the last word, the state on disk, and how it ends.

#include <unistd.h>

#include <leadscrew/cli/drive_link.hpp>
#include <leadscrew/cli/drive_state.hpp>
#include <leadscrew/cli/job.hpp>
#include <leadscrew/cli/state_keeper.hpp>
#include <leadscrew/cli/word_file.hpp>
#include <optional>
#include <span>

namespace leadscrew::cli {

class WordSide {
 public:
  /// Nothing moves: a file that was asked for cannot be opened, and that is what is told.
  void give_up() { static_cast<void>(keeper_.conclude(DriveState::Kind::stopped)); }

 protected:
  WordSide(DriveLink& link, const Job& job, const DriveState& begin)
      : link_(link), keeper_(job.arguments.drive.state, begin), last_(begin.word) {}
  ~WordSide() = default;
  WordSide(const WordSide&) = delete;
  WordSide& operator=(const WordSide&) = delete;

  /// What the command wants; after a failure, no more words.
  DriveLink::Order order() const {
    return failed_ ? DriveLink::Order::abandon : link_.order.load(std::memory_order_acquire);
  }
  /// Nobody will send the next word.
  bool is_orphan() const { return ::getppid() != link_.maker; }
  void took(const base::Result<void>& result) {
    if (!result && !failed_) failed_ = result.error();
  }
  /// Files first: who sees the last state finds them. One that could not be written takes no other with it.
  base::Result<void> conclude(std::span<WordFile* const> files);

  DriveLink& link_;
  StateKeeper keeper_;
  base::Word last_;  ///< taken
  std::optional<base::Diagnostic> failed_;
};

}  // namespace leadscrew::cli
