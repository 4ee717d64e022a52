#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <leadscrew/realtime/latest.hpp>
#include <thread>

namespace test_latest {

using namespace leadscrew;

/// So long that half of one would be seen beside half of another.
using Value = std::array<std::uint64_t, 64>;

Value of(std::uint64_t number) {
  Value value;
  value.fill(number);
  return value;
}

TEST(Latest, GivesTheLastValueOnce) {
  realtime::Latest<int> latest;
  int value = 7;
  EXPECT_FALSE(latest.take(value));
  EXPECT_EQ(value, 7);
  latest.put(1);
  latest.put(2);
  latest.put(3);
  EXPECT_TRUE(latest.take(value));
  EXPECT_EQ(value, 3);
  EXPECT_FALSE(latest.take(value));
  latest.put(4);
  EXPECT_TRUE(latest.take(value));
  EXPECT_EQ(value, 4);
}

TEST(Latest, IsWholeAndNeverOlderThanTheOneBefore) {
  constexpr std::uint64_t last = 300'000;
  realtime::Latest<Value> latest;
  std::atomic<bool> reads{false}, has_ended{false};
  std::thread writer([&] {
    while (!reads.load()) std::this_thread::yield();
    for (std::uint64_t number = 1; number <= last; ++number) latest.put(of(number));
    has_ended.store(true);
  });
  std::uint64_t before = 0;
  for (bool is_last_look = false; !is_last_look && !HasFailure();) {
    reads.store(true);
    is_last_look = has_ended.load();
    Value value;
    if (!latest.take(value)) continue;
    EXPECT_EQ(value, of(value[0]));
    EXPECT_GT(value[0], before);
    before = value[0];
  }
  writer.join();
  EXPECT_EQ(before, last);
}

}  // namespace test_latest
