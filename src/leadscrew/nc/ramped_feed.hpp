#pragma once
// The feed register with a word that rises and falls by a fixed amount a clock.
//
//   word ^    ____________          to the block's word, or that of an override; and down again in time for the word
//        |   /            \         at the block's end. How far it takes to come down is kept in a register of its own:
//        |  /              \___     each clock of rising adds to it what a clock of falling will take off.
//        +--------------------> clock
//
// The clocks up to a command are passed at once where the word rises or falls, or stays, in all of them.

#include <algorithm>
#include <leadscrew/nc/feed_register.hpp>
#include <limits>

namespace leadscrew::nc {

class RampedFeed {
 public:
  constexpr explicit RampedFeed(std::int64_t capacity) : register_(capacity) {}

  /// Begins a block with a word, to end with another; `by` is added a clock. All > 0, ≤ capacity; coming
  /// from the word to rest takes fewer than 2²² commands.
  constexpr void begin(std::int64_t word, std::int64_t exit, std::int64_t by) {
    word_ = word;
    exit_ = exit;
    by_ = by;
    clocks_ = 1;
    braking_ = 0;
    if (word_ <= exit_) return;
    // exit, exit + by, …: the words of the clocks of falling.
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

  /// How many of the next commands are made by the word as it is, where so many are left in the block; 0 where it
  /// changes.
  constexpr std::int64_t steady(std::int64_t commands_left) const {
    if (word_ != aim_) return 0;
    if (word_ <= exit_) return std::numeric_limits<std::int64_t>::max();
    const std::int64_t needed = braking_ / register_.capacity() + 1;  // for braking
    return needed < most_commands ? std::max<std::int64_t>(0, commands_left - needed) : 0;
  }

  /// Clocks up to the next command, of those that are steady.
  constexpr FeedRegister& at_its_word() {
    register_.load(word_);
    return register_;
  }

  /// Clocks up to the next command, whatever the word does, where so many commands are left in the block.
  constexpr std::int64_t skip(std::int64_t commands_left) {
    if (steady(commands_left) > 0) return at_its_word().skip();
    const std::int64_t distance = std::clamp(commands_left, std::int64_t{0}, most_commands) * register_.capacity();
    if (change_throughout(distance - register_.remainder())) return clocks_;
    clocks_ = 1;
    for (std::int64_t clocks = 1;; ++clocks) {
      change(distance - register_.remainder());
      if (register_.add(word_)) return clocks;
    }
  }

  constexpr std::int64_t word() const { return word_; }

 private:
  static constexpr std::int64_t most_commands = std::int64_t{1} << 22;  // times the capacity of 2⁴⁰ they fit a register

  constexpr bool must_fall(std::int64_t word, std::int64_t distance, std::int64_t braking) const {
    return word > exit_ && distance <= braking + word;
  }
  constexpr bool may_rise(std::int64_t word, std::int64_t distance, std::int64_t braking) const {
    return word < aim_ && distance > braking + 2 * word + by_;
  }

  /// For one clock. A distance is a sum of words, as the feed register adds them up: a command is its capacity.
  constexpr void change(std::int64_t distance) {
    if (must_fall(word_, distance, braking_)) {
      fall(exit_);
    } else if (word_ > aim_) {
      fall(aim_);
    } else if (may_rise(word_, distance, braking_)) {
      if (word_ >= exit_) braking_ += word_;
      word_ = std::min(word_ + by_, aim_);
    }
  }

  constexpr void fall(std::int64_t to) {
    word_ = std::max(word_ - by_, to);
    braking_ = std::max<std::int64_t>(0, braking_ - word_);
  }

  /// For all clocks up to the command, if it is the same change in each of them.
  constexpr bool change_throughout(std::int64_t distance) {
    if (must_fall(word_, distance, braking_)) return fall_throughout(exit_, distance);
    if (word_ > aim_) return fall_throughout(aim_, distance);
    return word_ >= exit_ && may_rise(word_, distance, braking_) && rise_throughout(distance);
  }

  /// The distance left falls and the braking distance grows: what holds at the last clock has held at all before.
  constexpr bool rise_throughout(std::int64_t distance) {
    if (!count_clocks(by_, aim_)) return false;
    const std::int64_t before = clocks_ - 1, passed = sum(before, by_);
    if (!may_rise(word_ + before * by_, distance - passed, braking_ + passed - before * by_)) return false;
    const std::int64_t words = sum(clocks_, by_);
    register_.add(words);
    word_ += clocks_ * by_;
    braking_ += words - clocks_ * by_;
    return true;
  }

  /// The distance left and the braking distance fall together.
  constexpr bool fall_throughout(std::int64_t to, std::int64_t distance) {
    if (!count_clocks(-by_, to)) return false;
    const std::int64_t before = clocks_ - 1, passed = sum(before, -by_);
    if (word_ > exit_ && passed > braking_) return false;
    if (to == exit_ && !must_fall(word_ - before * by_, distance, braking_)) return false;
    const std::int64_t words = sum(clocks_, -by_);
    register_.add(words);
    word_ -= clocks_ * by_;
    braking_ = std::max<std::int64_t>(0, braking_ - words);
    return true;
  }

  /// Of words that go on from the present one by ± by, over so many clocks.
  constexpr std::int64_t sum(std::int64_t clocks, std::int64_t by) const {
    return clocks * word_ + by * (clocks * (clocks + 1) / 2);
  }

  /// Of such words: how many there are up to the command, if none goes beyond `to`. The search begins with the clocks
  /// of the command before: a few more or less.
  constexpr bool count_clocks(std::int64_t by, std::int64_t to) {
    const std::int64_t missing = register_.capacity() - register_.remainder();
    const auto is_beyond = [&] { return by > 0 ? word_ + clocks_ * by > to : word_ + clocks_ * by < to; };
    while (!is_beyond()) {
      if (sum(clocks_, by) < missing) {
        ++clocks_;
      } else if (clocks_ > 1 && sum(clocks_ - 1, by) >= missing) {
        --clocks_;
      } else {
        return true;
      }
    }
    return false;
  }

  FeedRegister register_;
  std::int64_t word_ = 1, aim_ = 1, exit_ = 1, by_ = 1;
  std::int64_t braking_ = 0;  // braking distance: the sum of the words down to the exit, from the next clock on
  std::int64_t clocks_ = 1;   // of the last command whose clocks were passed at once
};

}  // namespace leadscrew::nc
