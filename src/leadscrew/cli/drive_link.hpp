#pragma once
// What the command and the drives have in common: memory that two processes see.
//
//   drive (plans, makes words) ── words ──▶ drives (a process of its own)
//                              ── order ──▶
//                              ◀─ phase, feedback ──
//
// The drives outlive whoever kills the command: they take the words that have reached them, come to rest by themselves,
// and write down where.

#include <termios.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <leadscrew/base/word.hpp>
#include <leadscrew/realtime/ring.hpp>
#include <string_view>

namespace leadscrew::cli {

/// One period of the drives.
struct Feedback {
  base::Word word;            ///< the last that was taken
  base::AxisVector actual{};  ///< where the axes are
};

struct DriveLink {
  enum class Order : int {
    follow,
    end,      ///< when all words are taken
    abandon,  ///< at once: words that were not taken are void
  };
  enum class Phase : int {
    starting,  ///< on the way to where the first word will be
    ready,     ///< there
    ended,     ///< all words are taken, all files written
    tripped,   ///< words ceased: the drives have come to rest by themselves, all files are written
    failed,    ///< `problem` says why
  };

  static constexpr std::size_t most_words = 1 << 16;

  realtime::Ring<base::Word, most_words> words;
  realtime::Ring<Feedback, 1 << 14> feedback;  ///< what nobody takes is dropped
  std::atomic<Order> order{Order::follow};
  std::atomic<Phase> phase{Phase::starting};
  std::atomic<bool> at_end{false};            ///< with `end`: the program has come to its end
  std::atomic<std::int64_t> taken{0};         ///< words
  std::atomic<std::int64_t> late_periods{0};  ///< that the drives' own process was late by
  std::atomic<std::int64_t> braked{0};        ///< periods without a word
  std::array<char, 256> problem{};            ///< text, ends with 0

  // The terminal is given back by whoever is left.
  std::atomic<bool> has_terminal{false};
  termios terminal{};
  void show_terminal(const termios& settings) {
    terminal = settings;
    has_terminal.store(true, std::memory_order_release);
  }
  void hide_terminal() { has_terminal.store(false, std::memory_order_release); }

  void fail(std::string_view text) {
    const std::size_t size = std::min(text.size(), problem.size() - 1);
    std::copy_n(text.data(), size, problem.data());
    phase.store(Phase::failed, std::memory_order_release);
  }
  bool is_over() const {
    const Phase now = phase.load(std::memory_order_acquire);
    return now == Phase::ended || now == Phase::tripped || now == Phase::failed;
  }
};

}  // namespace leadscrew::cli
