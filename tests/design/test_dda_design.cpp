// "Interpolators linear", lecture 12: problem 2 and the DDA as a timer; rates beside a count of pulses.

#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/design/dda_design.hpp>
#include <leadscrew/pulse/integrator.hpp>
#include <leadscrew/pulse/linear.hpp>

namespace leadscrew::design {
namespace test_dda_design {

constexpr DdaRange table{600, 0.01, 12000, 50};

TEST(LectureDda, Takes16And12BitsAnd447392PulsesASecond) {
  const DdaDesign design = design_dda(table);
  EXPECT_EQ(design.axis_bits, 16);
  EXPECT_EQ(design.feed_bits, 12);
  EXPECT_EQ(design.feed_word_max, 2400);
  EXPECT_EQ(std::floor(design.clock_pps), 447392);
}

TEST(LectureDda, StepsAt4472And2236PulsesASecond) {
  const DdaLine line = along_line(design_dda(table), table, {100, 50}, 3000, false);
  EXPECT_EQ(line.pulses, (std::vector<std::int64_t>{10000, 5000}));
  EXPECT_NEAR(line.feed_pps, 29309.43, 1);  // the lecture rounds the length
  EXPECT_EQ(std::floor(line.axis_pps[0]), 4472);
  EXPECT_EQ(std::floor(line.axis_pps[1]), 2236);
  EXPECT_NEAR(line.feed_mm_min, 3000, 1e-9);
}

TEST(LectureDda, LosesAnEighthOfAPercentInARealRegister) {
  const DdaLine line = along_line(design_dda(table), table, {100, 50}, 3000, true);
  EXPECT_EQ(line.feed_word, 268);
  EXPECT_NEAR(line.axis_pps[0], 4466.67, 0.005);
  EXPECT_NEAR(line.axis_pps[1], 2233.33, 0.005);
  EXPECT_NEAR(line.feed_mm_min, 2996.33, 0.005);
  EXPECT_NEAR(line.seconds, 2.2388, 5e-5);
}

/// The registers themselves, clocked.
TEST(LectureDda, TakesAsLongAsItsRegistersDo) {
  const DdaDesign design = design_dda(table);
  const DdaLine line = along_line(design, table, {100, 50}, 3000, true);
  pulse::FeedDda feed(std::int64_t{1} << design.feed_bits, 268);
  pulse::LinearDda<2> axes({line.pulses[0], line.pulses[1]}, std::int64_t{1} << design.axis_bits, pulse::Preload::none);
  std::int64_t clocks = 0;
  for (; !axes.done(); ++clocks) {
    if (feed.step()) axes.step();
  }
  EXPECT_NEAR(static_cast<double>(clocks) / design.clock_pps, line.seconds, 1e-4);
}

TEST(LectureTimerDesign, Takes13BitsFor8Seconds) {
  const DdaTimer timer = design_timer(1024, {2, 4, 8});
  EXPECT_EQ(timer.bits, 13);
  EXPECT_EQ(timer.loads, (std::vector<std::int64_t>{4, 2, 1}));
  EXPECT_EQ(timer.seconds, (std::vector<double>{2, 4, 8}));
}

}  // namespace test_dda_design
}  // namespace leadscrew::design
