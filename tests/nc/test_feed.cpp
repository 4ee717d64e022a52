// The feed register: commands skipped to at once come at the clocks at which it makes them one by one.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <leadscrew/nc/ramped_feed.hpp>

namespace leadscrew::nc {
namespace test_feed {

std::int64_t any_capacity() {
  return std::int64_t{1} << *rc::gen::inRange(1, 41);
}

RC_GTEST_PROP(FeedRegister, SkipsToWhereItsClocksCome, ()) {
  const std::int64_t capacity = any_capacity() - *rc::gen::inRange(0, 2);
  FeedRegister skipping(capacity), stepping(capacity);
  for (int change = 0; change < 6; ++change) {
    const std::int64_t least = std::max<std::int64_t>(1, capacity / 2000);
    const std::int64_t word = *rc::gen::inRange<std::int64_t>(least, capacity + 1);
    skipping.load(word);
    stepping.load(word);
    for (int command = 0; command < 20; ++command) {
      std::int64_t clocks = 1;
      while (!stepping.step()) ++clocks;
      RC_ASSERT(skipping.skip() == clocks);
      RC_ASSERT(skipping.remainder() == stepping.remainder());
    }
  }
}

/// The law of words, clock by clock.
struct ClockByClock {
  std::int64_t capacity, word, aim, exit, by, remainder = 0, braking = 0;

  std::int64_t skip(std::int64_t commands_left) {
    const std::int64_t distance = commands_left * capacity;
    const bool is_steady = word == aim && (word <= exit || distance > braking + capacity);
    for (std::int64_t clocks = 1;; ++clocks) {
      if (!is_steady) change(distance - remainder);
      remainder += word;
      if (remainder >= capacity) {
        remainder -= capacity;
        return clocks;
      }
    }
  }

  void change(std::int64_t distance) {
    if (word > exit && distance <= braking + word) {
      word = std::max(word - by, exit);
      braking = std::max<std::int64_t>(0, braking - word);
    } else if (word > aim) {
      word = std::max(word - by, aim);
      braking = std::max<std::int64_t>(0, braking - word);
    } else if (word < aim && distance > braking + 2 * word + by) {
      if (word >= exit) braking += word;
      word = std::min(word + by, aim);
    }
  }
};

RC_GTEST_PROP(RampedFeed, RisesAndFallsAsItDoesClockByClock, ()) {
  const std::int64_t capacity = any_capacity();
  const auto any_word = [&] { return *rc::gen::inRange(std::max<std::int64_t>(1, capacity / 300), capacity + 1); };
  RampedFeed feed(capacity);
  ClockByClock expected{capacity, 1, 1, 1, 1};
  for (int block = 0; block < 4; ++block) {
    // To change from one word to another takes up to 20 000 clocks.
    expected.by = *rc::gen::inRange(capacity / 20'000 + 1, std::max(capacity / 20'000 + 2, capacity / 30));
    expected.exit = any_word();
    expected.aim = any_word();
    if (block == 0) expected.word = std::min(expected.exit, expected.aim);
    // What it takes to come down from this word to the exit.
    expected.braking = 0;
    for (std::int64_t word = expected.word; word > expected.exit; word -= expected.by) {
      expected.braking += word - expected.by;
    }
    feed.aim(expected.aim);
    feed.begin(expected.word, expected.exit, expected.by);
    const std::int64_t commands = *rc::gen::inRange<std::int64_t>(1, 3000);
    for (std::int64_t left = commands; left > 0; --left) {
      if (left == commands / 2) feed.aim(expected.aim = any_word());
      RC_ASSERT(feed.skip(left) == expected.skip(left));
      RC_ASSERT(feed.word() == expected.word);
      if (feed.steady(left - 1) > 0) RC_ASSERT(feed.word() == expected.aim);
    }
  }
}

}  // namespace test_feed
}  // namespace leadscrew::nc
