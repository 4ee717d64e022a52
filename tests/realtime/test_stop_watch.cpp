// Looking at clocks costs `run` next to nothing: they are looked at by counted calls.

#include <gtest/gtest.h>

#include <leadscrew/realtime/stop_watch.hpp>
#include <vector>

namespace leadscrew::realtime {
namespace test_stop_watch {

/// They count who looks; each look is a second, or 100 ns, after the last.
struct CountedClocks {
  static inline int processor_looks = 0, wall_looks = 0;
  static double processor_seconds() { return ++processor_looks; }
  static std::int64_t nanoseconds() { return 100 * ++wall_looks; }
};

class Watched : public ::testing::Test {
 protected:
  void SetUp() override { CountedClocks::processor_looks = CountedClocks::wall_looks = 0; }
  StopWatch<CountedClocks> watch;
};

TEST_F(Watched, LooksAtTheClockForOneWordOf61) {
  constexpr int words = 61'000;
  for (int k = 0; k < words; ++k) EXPECT_EQ(watch.cycle([&] { return k; }), k);
  EXPECT_EQ(CountedClocks::wall_looks, 2 * words / 61);
  EXPECT_EQ(watch.samples().count(), 1000U);
  EXPECT_EQ(watch.samples().longest(), 100U);
  EXPECT_NEAR(watch.cycling(), words * 100e-9, 1e-12);
}

TEST_F(Watched, TimesOneOf61CallsThatMakeManyWords) {
  const std::vector<int> thirty(30);
  for (int k = 0; k < 6100; ++k) EXPECT_EQ(watch.many([&] { return thirty; }).size(), 30U);
  EXPECT_EQ(CountedClocks::wall_looks, 200);
  EXPECT_EQ(watch.samples().count(), 0U);
  EXPECT_NEAR(watch.cycling(), 6100 * 100e-9, 1e-12);
}

TEST_F(Watched, SaysHowManyWordsMayBeMadeUntilOneIsTimed) {
  EXPECT_EQ(watch.words_until_sample(), 0U);
  watch.cycle([] { return 0; });
  EXPECT_EQ(watch.words_until_sample(), 60U);
  watch.many([] { return std::vector<int>(20); });
  EXPECT_EQ(watch.words_until_sample(), 40U);
  watch.many([] { return std::vector<int>(40); });
  EXPECT_EQ(watch.words_until_sample(), 0U);
  EXPECT_NEAR(watch.cycling(), 100e-9 + 3 * 100e-9, 1e-12);
}

TEST_F(Watched, TimesTheFirstWordToo) {
  watch.cycle([] { return 0; });
  EXPECT_EQ(watch.samples().count(), 1U);
}

TEST_F(Watched, LooksAtNoClockWhereNothingIsPlanned) {
  for (int k = 0; k < 1000; ++k) watch.prepare(false, [] { return true; });
  EXPECT_EQ(CountedClocks::processor_looks, 0);
  for (int k = 0; k < 3; ++k) watch.prepare(true, [] { return true; });
  EXPECT_EQ(CountedClocks::processor_looks, 6);
  EXPECT_EQ(watch.preparing(), 3);
}

TEST_F(Watched, HasNothingToTellBeforeThereAreWords) {
  EXPECT_EQ(watch.cycling(), 0);
  EXPECT_EQ(watch.samples().percentile(0.5), 0U);
}

}  // namespace test_stop_watch
}  // namespace leadscrew::realtime
