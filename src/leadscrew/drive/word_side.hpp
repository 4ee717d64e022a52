#pragma once
// What all who take words in a process of their own have in common: the last word, the state on disk, and how it ends.

#include <leadscrew/drive/link.hpp>
#include <leadscrew/drive/setup.hpp>
#include <leadscrew/drive/state.hpp>
#include <leadscrew/drive/state_writer.hpp>
#include <leadscrew/files/event_file.hpp>
#include <leadscrew/files/word_file.hpp>
#include <leadscrew/kinematics/word_poses.hpp>
#include <optional>
#include <span>
#include <vector>

namespace leadscrew::drive {

class WordSide {
 public:
  /// Nothing moves, because a file that was asked for cannot be opened: that problem is reported.
  void give_up() { static_cast<void>(state_writer_.conclude(State::Kind::stopped)); }

 protected:
  WordSide(Link& link, const Setup& setup, const State& begin)
      : link_(link), state_writer_(setup.options.state, begin), last_(begin.word), poses_(setup.machine) {
    if (begin.tool) poses_.hold(begin.tool->offset);
  }
  ~WordSide() = default;
  WordSide(const WordSide&) = delete;
  WordSide& operator=(const WordSide&) = delete;

  /// What the command wants; after a failure, no more words.
  Link::Order order() const { return failed_ ? Link::Order::abandon : link_.order.load(std::memory_order_acquire); }
  /// Nobody will send the next word.
  bool is_orphan() const { return link_.is_orphan(); }
  void took(const base::Result<void>& result) {
    if (!result && !failed_) failed_ = result.error();
  }
  base::Result<void> open_events(const Setup& setup);
  /// What a file of words has beside them.
  static trace::MoreColumns columns_of(const machine::Machine& machine) {
    return {.power = machine.laser.has_value(), .pose = machine.rotary_chain.has_value()};
  }
  /// Takes those of the word, and of all before it that have not been taken: the tool is that of the word from then on. Good
  /// until the next call.
  std::span<const base::PassedEvent> take_events(const base::Word& word);
  /// Writes those that have been taken.
  base::Result<void> write_events();
  /// Files before the last state: who sees that finds them. One that cannot be written does not keep the others from
  /// being written.
  base::Result<void> conclude(std::span<files::WordFile* const> files);

  Link& link_;
  StateWriter state_writer_;
  base::Word last_;  ///< taken
  kinematics::WordPoses poses_;
  std::optional<base::Diagnostic> failed_;

 private:
  files::EventFile event_file_;
  std::optional<base::PassedEvent> next_event_;  ///< of a word that has not been taken
  std::vector<base::PassedEvent> events_;        ///< taken, not written
};

}  // namespace leadscrew::drive
