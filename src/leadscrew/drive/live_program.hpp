#pragma once
// A program that is read while it moves, by a thread of its own, for it waits for whoever writes it: a pipe or a
// socket. Nothing of it is checked before it comes. The first error ends it: motion rests where the last move
// before it ends. A line is executed once its line feed has come.

#include <atomic>
#include <cstdint>
#include <leadscrew/drive/setup.hpp>
#include <leadscrew/files/descriptor.hpp>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/realtime/live_moves.hpp>
#include <optional>
#include <string>
#include <thread>

namespace leadscrew::drive {

class LiveProgram {
 public:
  /// Begins to read setup.live_program; `name` is for places in diagnostics. The setup must outlive it.
  LiveProgram(const Setup& setup, std::string name);
  ~LiveProgram() { end(); }
  LiveProgram(const LiveProgram&) = delete;
  LiveProgram& operator=(const LiveProgram&) = delete;

  /// That have come.
  realtime::LiveMoves& moves() { return moves_; }
  std::int64_t blocks() const { return blocks_.load(std::memory_order_relaxed); }
  bool has_failed() const { return has_failed_.load(std::memory_order_acquire); }

  /// Reads no more.
  void end();
  /// Why the program ended: its first error, or the input's. After end().
  const std::optional<base::Diagnostic>& failure() const { return failure_; }

 private:
  void read();
  gcode::ByteSource source();
  bool is_dry();
  void fail(const base::Diagnostic& problem);

  const Setup& setup_;
  const std::string name_;
  realtime::LiveMoves moves_;
  files::Descriptor input_;       ///< the thread's, as the next
  bool is_inside_line_ = false;   ///< what has come so far ends there
  std::int64_t kept_since_ = -1;  ///< ns: since when lines have waited for others
  std::atomic<std::int64_t> blocks_{0};
  std::atomic<bool> has_failed_{false}, is_unwanted_{false};
  std::optional<base::Diagnostic> failure_;
  std::thread thread_;
};

}  // namespace leadscrew::drive
