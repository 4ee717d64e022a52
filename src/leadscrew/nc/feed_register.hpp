#pragma once
// The feed routine's register: at every clock the word f is added to the remainder r; where that reaches the capacity
// q0, there is a command and q0 is taken off. Between words the remainder stays, so that no share of a command is lost
// where blocks meet.
//
// At a steady word q0 = k f + e, 0 ≤ e < f: after a command, at r < f, the next one comes after k clocks with the
// remainder r − e, or if that is negative after k + 1 with r − e + f.

#include <cstdint>

namespace leadscrew::nc {

class FeedRegister {
 public:
  /// capacity q0: 1 … 2⁴⁰.
  constexpr explicit FeedRegister(std::int64_t capacity) : capacity_(capacity) {}

  /// From the next clock on; 0 ≤ word ≤ capacity.
  constexpr void load(std::int64_t word) {
    if (word == word_) return;
    word_ = word;
    if (word == 0) return;
    clocks_ = capacity_ / word;
    excess_ = capacity_ - clocks_ * word;
  }

  /// One clock: is there a command?
  constexpr bool step() { return add(word_); }

  /// The same of another word, or of the sum of some clocks' words, of which only the last one may give a command.
  constexpr bool add(std::int64_t words) {
    remainder_ += words;
    const bool overflows = remainder_ >= capacity_;
    remainder_ -= overflows ? capacity_ : 0;
    return overflows;
  }

  /// All clocks up to the next command, at once: how many those are, ≥ 1. The word must not be 0.
  [[gnu::always_inline]] constexpr std::int64_t skip() {
    if (remainder_ >= word_) return skip_after_a_greater_word();
    remainder_ -= excess_;
    const bool one_more = remainder_ < 0;
    remainder_ += one_more ? word_ : 0;
    return clocks_ + one_more;
  }

  constexpr std::int64_t word() const { return word_; }
  constexpr std::int64_t capacity() const { return capacity_; }
  constexpr std::int64_t remainder() const { return remainder_; }

 private:
  constexpr std::int64_t skip_after_a_greater_word() {
    const std::int64_t missing = capacity_ - remainder_, clocks = (missing + word_ - 1) / word_;
    remainder_ = clocks * word_ - missing;
    return clocks;
  }

  std::int64_t capacity_, word_ = 0, remainder_ = 0;
  std::int64_t clocks_ = 0, excess_ = 0;  // k and e
};

}  // namespace leadscrew::nc
