// Axes over time as a picture: shares of limits, colours by axis, bounded size.

#include <gtest/gtest.h>
#include <leadscrew/report/report.hpp>

#include <cmath>

#include "byte_sinks.hpp"

namespace leadscrew::report {
namespace test_motion_charts {

using namespace testing_support;

std::string charts_of(const Recording& recording, const machine::Machine& machine) {
  std::string text;
  EXPECT_TRUE(write_motion_charts("moves <fast>", recording, machine, into(text)));
  return text;
}

std::size_t count_of(const std::string& text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++count;
  return count;
}

/// X at 100 mm/s for a second, half of what it may: in the chart of velocity, which reaches from −112 to 112 % in 170 units,
/// half of the way from the middle to the dashed line.
TEST(MotionCharts, ShowDerivativesAsSharesOfTheirLimits) {
  const machine::Machine machine = machine::mill3();
  Recording recording(machine, millisecond);
  for (int k = 0; k <= 1000; ++k) {
    base::Word word;
    word.tick = base::Tick{k};
    word.position = {0.1 * k, 0, 0};
    recording.observe(word);
  }
  const std::string picture = charts_of(recording, machine);
  EXPECT_NE(picture.find("moves &lt;fast&gt;"), std::string::npos);
  EXPECT_NE(picture.find(">X:  200 mm/s, 1000 mm/s², 20\u202f000 mm/s³<"), std::string::npos);
  for (const char* title :
       {"position, mm", "velocity, % of the limit", "acceleration, % of the limit", "jerk, % of the limit"})
    EXPECT_NE(picture.find(std::string(">") + title + "<"), std::string::npos) << title;
  EXPECT_EQ(picture.find("position, °"), std::string::npos);
  EXPECT_EQ(count_of(picture, "class=\"line c0\""), 5u);  // a curve in each chart, and the key
  EXPECT_EQ(count_of(picture, "class=\"wanted\""), 6u);
  const std::size_t chart = picture.find("velocity, %"), line = picture.find("class=\"line c0\"", chart);
  const std::string curve = picture.substr(line, picture.find("/>", line) - line);
  const auto level_of = [&](std::size_t from) {
    const std::size_t at = picture.find("class=\"wanted\" d=\"M", from) + 19;
    return std::stod(picture.substr(picture.find(' ', at)));
  };
  const double greatest = level_of(chart), least = level_of(picture.find("class=\"wanted\"", chart) + 5);
  const double at_end = std::stod(curve.substr(curve.rfind(' ')));
  EXPECT_NEAR((least + greatest) / 2 - at_end, (least - greatest) / 4, 0.2);
  EXPECT_LT(curve.size(), 200u);  // straight lines are two points
  EXPECT_LT(picture.size(), 12'000u);
}

TEST(MotionCharts, AreOfBoundedSizeForNineAxesAndManyWords) {
  machine::Machine machine = machine::mill3();
  for (auto& axis : machine.axes) axis = machine::AxisLimits{-1e6, 1e6, 200, 1000, 20000, 0.001};
  Recording recording(machine, millisecond);
  for (const base::Word& word : random_train(100'000, 4)) recording.observe(word);
  const std::string picture = charts_of(recording, machine);
  EXPECT_NE(picture.find("position, °"), std::string::npos);
  EXPECT_LT(picture.size(), 2'000'000u);
  for (const char* text : {"nan", "inf"}) EXPECT_EQ(picture.find(text), std::string::npos) << text;
}

TEST(MotionCharts, OfNothingAreSane) {
  const machine::Machine machine = machine::mill3();
  Recording recording(machine, millisecond);
  EXPECT_EQ(charts_of(recording, machine).find("nan"), std::string::npos);
  recording.observe(base::Word{});
  EXPECT_EQ(charts_of(recording, machine).find("nan"), std::string::npos);
}

}  // namespace test_motion_charts
}  // namespace leadscrew::report
