#pragma once
// The feed routine's register: at every clock the word f is added to the remainder; where that reaches the capacity
// q0, there is a command and q0 is taken off. Between words the remainder stays, so that no share of a command is lost
// where blocks meet.

#include <cstdint>

namespace leadscrew::stepping {

class FeedRegister {
 public:
  /// capacity q0: 1 … 2⁴⁰.
  constexpr explicit FeedRegister(std::int64_t capacity) : capacity_(capacity) {}

  /// From the next clock on; 0 ≤ word ≤ capacity.
  constexpr void load(std::int64_t word) { word_ = word; }

  /// One clock: is there a command?
  constexpr bool step() {
    remainder_ += word_;
    const bool overflows = remainder_ >= capacity_;
    remainder_ -= overflows ? capacity_ : 0;
    return overflows;
  }

  /// All clocks up to the next command, at once: how many those are, ≥ 1. The word must not be 0.
  constexpr std::int64_t skip() {
    const std::int64_t missing = capacity_ - remainder_;
    // At high rates the next command is near, and a comparison is quicker than a division.
    if (missing <= word_) {
      remainder_ = word_ - missing;
      return 1;
    }
    const std::int64_t clocks = (missing + word_ - 1) / word_;
    remainder_ = clocks * word_ - missing;
    return clocks;
  }

  constexpr std::int64_t word() const { return word_; }
  constexpr std::int64_t capacity() const { return capacity_; }
  constexpr std::int64_t remainder() const { return remainder_; }

 private:
  std::int64_t capacity_, word_ = 0, remainder_ = 0;
};

}  // namespace leadscrew::stepping
