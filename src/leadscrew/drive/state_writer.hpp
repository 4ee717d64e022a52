#pragma once
// The state of a drive on disk, kept up by a thread of its own: whoever takes the words does not wait for a disk.

#include <atomic>
#include <leadscrew/drive/state.hpp>
#include <leadscrew/realtime/latest.hpp>
#include <optional>
#include <string>
#include <thread>

namespace leadscrew::drive {

class StateWriter {
 public:
  /// Without a path it keeps nothing.
  StateWriter(std::optional<std::string> path, const State& state);
  ~StateWriter() { end(); }
  StateWriter(const StateWriter&) = delete;
  StateWriter& operator=(const StateWriter&) = delete;

  /// The last word, where the axes are, and the tool there. Neither allocates nor locks.
  void observe(const base::Word& word, const base::PathPlace& axes, const std::optional<ToolState>& tool) {
    seen_.put({word, axes, tool});
  }
  /// The last state, when all stands still. Errors as those of write_state().
  base::Result<void> conclude(State::Kind kind);

 private:
  struct Seen {
    base::Word word;
    base::PathPlace axes;
    std::optional<ToolState> tool;
  };

  void write_states();
  bool take_seen();
  void end();

  std::optional<std::string> path_;
  State state_;  ///< its thread's, while there is one
  realtime::Latest<Seen> seen_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

}  // namespace leadscrew::drive
