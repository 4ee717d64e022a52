#include <gtest/gtest.h>

#include <array>
#include <leadscrew/realtime/latest.hpp>
#include <thread>

namespace {

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
  std::thread writer([&] {
    for (std::uint64_t number = 1; number <= last; ++number) latest.put(of(number));
  });
  std::uint64_t before = 0, seen = 0;
  while (before < last) {
    Value value;
    if (!latest.take(value)) continue;
    ++seen;
    if (value != of(value[0]) || value[0] <= before) {
      ADD_FAILURE() << value[0] << " after " << before;
      break;
    }
    before = value[0];
  }
  writer.join();
  EXPECT_GT(seen, 1U);
}

}  // namespace
