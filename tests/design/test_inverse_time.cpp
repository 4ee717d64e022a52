// Koren's figures of feed words and clocks, and his hardware clocked register by register.

#include <gtest/gtest.h>

#include <leadscrew/design/inverse_time.hpp>
#include <leadscrew/pulse/integrator.hpp>
#include <leadscrew/pulse/linear.hpp>

namespace leadscrew::design {
namespace test_inverse_time {

/// 12 in, 0.0001 in, 30 in/min in steps of 0.01.
constexpr InverseTimeRange koren{12, 0.0001, 30, 0.01, 4};

TEST(KorenInverseTime, TakesAClockOf2MHz) {
  const InverseTimeDesign design = design_inverse_time(koren);
  EXPECT_EQ(design.capacity, 120000);
  EXPECT_EQ(design.feed_capacity, 10000);
  EXPECT_NEAR(design.clock_pps, 2e6, 1e-6);
}

TEST(KorenInverseTime, IsTenTimesTheInverseOfTheTime) {
  const FeedWord word = inverse_time_word(koren, 2, 10, false);
  EXPECT_DOUBLE_EQ(word.word, 50);  // 10 in/min along 2 in: 5 of them a minute
  const double length = 2 / 0.0001;
  EXPECT_NEAR(600 * word.feed_pps / length, word.word, 1e-9);  // (16)
}

TEST(KorenSoftware, IsInterrupted5000TimesASecond) {
  const InverseTimeDesign design = design_inverse_time(koren);
  EXPECT_EQ(design.software_feed_capacity, 3000);
  EXPECT_NEAR(design.software_clock_pps, 5000, 1e-9);
  EXPECT_NEAR(software_word(koren, 30, true).word, 3000, 1e-9);
  EXPECT_NEAR(software_word(koren, 12.34, true).word, 1234, 1e-9);
  EXPECT_NEAR(software_word(koren, 12.34, true).feed_pps, 2056.67, 0.005);
  EXPECT_NEAR(software_word(koren, 12.34, true).feed, 12.34, 1e-9);
}

TEST(KorenInverseTime, LosesWhatItsDigitsDoNotHold) {
  const FeedWord real = inverse_time_word(koren, 7, 10, true);
  EXPECT_EQ(real.word, 14);  // of 14.29
  EXPECT_NEAR(real.feed, 9.8, 1e-12);
  EXPECT_NEAR(software_word(koren, 10, true).feed, 10, 1e-12);
}

/// A feed DDA of capacity q₀ clocks axis DDAs of capacity q: as long as f says.
TEST(KorenInverseTime, TakesAsLongAsItsRegistersDo) {
  const InverseTimeDesign design = design_inverse_time(koren);
  const FeedWord word = inverse_time_word(koren, 0.25, 20, true);
  pulse::FeedDda feed(design.feed_capacity, static_cast<std::int64_t>(word.word));
  pulse::LinearDda<2> axes({1500, 2000}, design.capacity, pulse::Preload::none);
  std::int64_t clocks = 0;
  for (; !axes.done(); ++clocks) {
    if (feed.step()) axes.step();
  }
  EXPECT_NEAR(static_cast<double>(clocks) / design.clock_pps, 0.25 / word.feed * 60, 2e-4);
}

}  // namespace test_inverse_time
}  // namespace leadscrew::design
