#pragma once
// What the command and the drives have in common: memory that two processes see.
//
//   drive (plans, makes words) ── words, events ──▶ drives (a process of its own)
//                              ── order ──────────▶
//                              ◀─ phase, feedback ──
//
// The drives outlive whoever kills the command: they take the words that have reached them, follow the stop path that
// came with them, and write down where.

#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/base/event.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/realtime/ring.hpp>
#include <leadscrew/realtime/word_stream.hpp>
#include <leadscrew/servo/tracking.hpp>
#include <string_view>

namespace leadscrew::drive {

/// One period of the drives.
struct Feedback {
  base::Word word;               ///< the last that was taken
  base::AxisVector actual{};     ///< where the slides are, two periods ago
  double measured_feed = 0;      ///< by their tachogenerators, mm/s (degrees/s where only rotary axes are)
  double following_error = 0;    ///< the greatest of any axis, mm or degrees
  std::array<double, 3> tool{};  ///< its offset, mm; of machines with a chain of rotary axes
};

/// What following came to, when all is over.
struct SharedTracking {
  std::array<servo::AxisTracking, base::axis_count> axes{};
  servo::FeedTracking feed;
};

/// A diagnostic for the other process. Its code is of static storage, which has one place in both: one is the other's
/// fork.
class SharedProblem {
 public:
  void set(const base::Diagnostic& problem) {
    code_ = problem.code;
    copy(problem.message, message_);
    copy(problem.hint, hint_);
    copy(problem.place.file, file_);
  }
  base::Diagnostic diagnostic() const {
    return {base::Severity::error, code_, message_.data(), hint_.data(), base::Place{.file = file_.data()}, {}};
  }

 private:
  using Text = std::array<char, 512>;  ///< ends with 0
  static void copy(std::string_view from, Text& to) {
    to.fill(0);
    std::copy_n(from.data(), std::min(from.size(), to.size() - 1), to.data());
  }

  std::string_view code_;
  Text message_{}, hint_{}, file_{};
};

struct Link {
  enum class Order : int {
    follow,
    end,      ///< when all words are taken
    abandon,  ///< at once: no more words are accepted
  };
  enum class Phase : int {
    starting,  ///< on the way to where the first word will be
    ready,     ///< there
    ended,     ///< all words are taken, all files written
    tripped,   ///< words ceased: the drives have come to rest by the stop path, all files are written
    failed,    ///< `problem` says why; the axes stand, and where is written down
  };

  static constexpr std::size_t most_words = 1 << 16, longest_stop_path = 1 << 18;

  /// `room` for words, 1 … most_words; of stop paths of `usual_stop` periods memory is there from the beginning.
  explicit Link(std::size_t room = most_words, std::size_t usual_stop = 0) : words(room, usual_stop) {}

  const pid_t maker = ::getpid();  ///< of the words: this is made by the command
  realtime::WordStream<most_words, longest_stop_path> words;
  realtime::Ring<base::PassedEvent, 1 << 14> events;  ///< of words, there before them
  realtime::Ring<Feedback, 1 << 14> feedback;         ///< what nobody takes is dropped
  std::atomic<Order> order{Order::follow};
  std::atomic<Phase> phase{Phase::starting};
  std::atomic<bool> stopping{false};          ///< asked to, by a signal or a key
  std::atomic<bool> at_end{false};            ///< with `end`: the program has come to its end
  std::atomic<std::int64_t> taken{0};         ///< words
  std::atomic<std::int64_t> late_periods{0};  ///< that the drives' own process was late by
  std::atomic<std::int64_t> braked{0};        ///< periods on the stop path, without a word
  std::atomic<std::int64_t> beats{0};         ///< periods that the drives' process has lived
  std::atomic<bool> concluding{false};        ///< it writes its files, which may take long
  SharedProblem problem;
  SharedTracking slides;  ///< before the phase says that all is over

  // The terminal is given back by whoever is left.
  std::atomic<bool> has_terminal{false};
  termios terminal{};
  void show_terminal(const termios& settings) {
    terminal = settings;
    has_terminal.store(true, std::memory_order_release);
  }
  void hide_terminal() { has_terminal.store(false, std::memory_order_release); }

  /// Of the drives' process: has the one that makes words ended?
  bool is_orphan() const { return ::getppid() != maker; }

  void fail(const base::Diagnostic& why) {
    problem.set(why);
    phase.store(Phase::failed, std::memory_order_release);
  }
  bool is_over() const {
    const Phase now = phase.load(std::memory_order_acquire);
    return now == Phase::ended || now == Phase::tripped || now == Phase::failed;
  }
};

}  // namespace leadscrew::drive
