#pragma once
// The feed register with a word that rises and falls by a fixed amount a clock.
//
//   word ^    ____________          to the block's word, or that of an override; and down again in time for the word
//        |   /            \         at the block's end. How far it takes to come down is kept in a register of its own:
//        |  /              \___     each clock of rising adds to it what a clock of falling will take off.
//        +--------------------> clock

#include <algorithm>
#include <leadscrew/stepping/feed_register.hpp>

namespace leadscrew::stepping {

class RampedFeed {
 public:
  constexpr explicit RampedFeed(std::int64_t capacity) : register_(capacity) {}

  /// Begins a block with a word, to end with another; `by` is added a clock. All > 0, ≤ capacity; the way from the
  /// word to rest is below 2²² commands.
  constexpr void begin(std::int64_t word, std::int64_t exit, std::int64_t by) {
    word_ = word;
    exit_ = exit;
    by_ = by;
    braking_ = 0;
    if (word_ <= exit_) return;
    // exit, exit + by, …: the words of the clocks on the way down.
    const std::int64_t clocks = (word_ - exit_ + by_ - 1) / by_;
    braking_ = clocks * word_ - by_ * (clocks * (clocks + 1) / 2);
  }

  /// Begins a block at the word aimed at, and stays with it.
  constexpr void begin_constant() {
    word_ = aim_;
    exit_ = by_ = register_.capacity();
    braking_ = 0;
  }

  /// To be aimed at from now on, ≥ 1.
  constexpr void aim(std::int64_t word) { aim_ = word; }

  /// Clocks up to the next command, where so many are left in the block.
  constexpr std::int64_t skip(std::int64_t commands_left) {
    const std::int64_t way = std::clamp(commands_left, std::int64_t{0}, most_commands) * register_.capacity();
    // Far from the end at the word that is aimed at nothing changes up to the next command.
    if (word_ == aim_ && (word_ <= exit_ || way > braking_ + register_.capacity())) {
      register_.load(word_);
      return register_.skip();
    }
    for (std::int64_t clocks = 1;; ++clocks) {
      change(way - register_.remainder());
      register_.load(word_);
      if (register_.step()) return clocks;
    }
  }

  constexpr std::int64_t word() const { return word_; }

 private:
  static constexpr std::int64_t most_commands = std::int64_t{1} << 22;  // times the capacity of 2⁴⁰ they fit a register

  constexpr void change(std::int64_t way) {
    if (word_ > exit_ && way <= braking_ + word_) {
      fall(exit_);
    } else if (word_ > aim_) {
      fall(aim_);
    } else if (word_ < aim_ && way > braking_ + 2 * word_ + by_) {
      if (word_ >= exit_) braking_ += word_;
      word_ = std::min(word_ + by_, aim_);
    }
  }

  constexpr void fall(std::int64_t to) {
    word_ = std::max(word_ - by_, to);
    braking_ = std::max<std::int64_t>(0, braking_ - word_);
  }

  FeedRegister register_;
  std::int64_t word_ = 1, aim_ = 1, exit_ = 1, by_ = 1;
  std::int64_t braking_ = 0;  // words added on the way down to the exit, from the next clock on
};

}  // namespace leadscrew::stepping
