#include <gtest/gtest.h>

#include <leadscrew/realtime/histogram.hpp>
#include <leadscrew/realtime/ring.hpp>
#include <memory>
#include <thread>
#include <vector>

namespace test_ring {

using namespace leadscrew::realtime;

TEST(Ring, IsFullAndEmpty) {
  Ring<int, 3> ring;
  int value = 0;
  EXPECT_FALSE(ring.pop(value));
  for (int k = 0; k < 3; ++k) EXPECT_TRUE(ring.push(k));
  EXPECT_FALSE(ring.push(3));
  EXPECT_EQ(ring.size(), 3U);
  for (int k = 0; k < 3; ++k) {
    EXPECT_TRUE(ring.pop(value));
    EXPECT_EQ(value, k);
  }
  EXPECT_FALSE(ring.pop(value));
}

TEST(Ring, CarriesEveryValueOnceAndWhole) {
  struct Pair {
    std::int64_t a = 0, b = 0;
  };
  auto ring = std::make_unique<Ring<Pair, 7>>();
  constexpr std::int64_t count = 300'000;
  std::thread writer([&] {
    for (std::int64_t k = 0; k < count;) {
      if (ring->push({k, -k}))
        ++k;
      else
        std::this_thread::yield();
    }
  });
  std::int64_t wrong = 0;
  for (std::int64_t k = 0; k < count;) {
    Pair pair;
    if (!ring->pop(pair)) {
      std::this_thread::yield();
      continue;
    }
    wrong += pair.a != k || pair.b != -k;
    ++k;
  }
  writer.join();
  EXPECT_EQ(wrong, 0);
}

TEST(Histogram, CountsByPowersOfTwo) {
  Histogram histogram;
  EXPECT_TRUE(histogram.octaves().empty());
  for (const std::int64_t time : {40, 64, 100, 127, 1024}) histogram.observe(time);
  const auto octaves = histogram.octaves();
  ASSERT_EQ(octaves.size(), 6U);
  EXPECT_EQ(octaves[0].end, 64U);
  EXPECT_EQ(octaves[0].count, 1U);
  EXPECT_EQ(octaves[1].end, 128U);
  EXPECT_EQ(octaves[1].count, 3U);
  EXPECT_EQ(octaves[2].count + octaves[3].count + octaves[4].count, 0U);
  EXPECT_EQ(octaves[5].end, 2048U);
  EXPECT_EQ(octaves[5].count, 1U);
}

TEST(Histogram, PercentilesAreRightWithinABucket) {
  Histogram histogram;
  EXPECT_EQ(histogram.percentile(0.5), 0U);
  for (std::int64_t k = 1; k <= 100'000; ++k) histogram.observe(k);
  for (const double part : {0.01, 0.5, 0.9, 0.99, 1.0}) {
    const double exact = part * 100'000, told = static_cast<double>(histogram.percentile(part));
    EXPECT_GE(told, exact);
    EXPECT_LE(told, exact * 1.032);
  }
  EXPECT_EQ(histogram.longest(), 100'000U);
  EXPECT_EQ(histogram.count(), 100'000U);
}

}  // namespace test_ring
