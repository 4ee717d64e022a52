// Slides in the report: errors in the bins of the words, bounded memory, a picture with the errors magnified.

#include <gtest/gtest.h>
#include <leadscrew/report/report.hpp>

#include <cmath>
#include <string>

namespace leadscrew::report {
namespace test_followed_report {

constexpr base::Period period{1'000'000};

/// A circle of 10 mm whose slides are `wrong` mm too far out and 0.2 mm behind in X.
struct Circle {
  machine::Machine machine = machine::mill3();
  Recording recording{machine, period};
  FollowedRecording followed{machine.axis_set()};
  int words;

  Circle(int count, double wrong) : words(count) {
    for (int k = 0; k < count; ++k) {
      const double angle = 2 * 3.14159265358979 * k / count, share = 1 + wrong / 10;
      base::Word word;
      word.tick = base::Tick{k};
      word.position = {10 * std::cos(angle), 10 * std::sin(angle)};
      const base::AxisVector actual = {share * word.position[0], share * word.position[1]};
      recording.observe(word);
      followed.observe_ideal(word.position);
      std::array<FollowedAxis, base::axis_count> axes;
      for (std::size_t i = 0; i < 2; ++i) axes[i] = {word.position[i] - actual[i], 7.0, -8.0, 9.0};
      followed.observe(axes, 3);
      followed.observe({actual, word.position, wrong}, 1);
    }
  }

  std::string page() {
    std::string text;
    const auto sink = [&](std::string_view bytes) {
      text += bytes;
      return base::Result<void>();
    };
    Report report;
    report.tolerance_mm = 0.01;
    EXPECT_TRUE(write_report(report, recording, machine, period, sink, &followed));
    return text;
  }
};

TEST(FollowedRecording, HasTheBinsOfTheWords) {
  Circle circle(100'000, 0.02);
  EXPECT_EQ(circle.followed.contour().size(), circle.recording.feed().size());
  const auto axis = [&](base::Axis of, double FollowedAxis::* value) { return circle.followed.axis(of, value); };
  EXPECT_EQ(axis(base::Axis::Y, &FollowedAxis::error).size(), circle.recording.feed().size());
  EXPECT_TRUE(axis(base::Axis::A, &FollowedAxis::error).empty());
  EXPECT_NEAR(axis(base::Axis::X, &FollowedAxis::error)[0].least, -0.02, 1e-4);
  EXPECT_EQ(axis(base::Axis::Y, &FollowedAxis::velocity)[7].least, 7);
  EXPECT_EQ(axis(base::Axis::Y, &FollowedAxis::control)[7].least, -8);
  EXPECT_EQ(axis(base::Axis::Y, &FollowedAxis::current)[7].least, 9);
  EXPECT_EQ(axis(base::Axis::Z, &FollowedAxis::current)[7].least, 0);
  EXPECT_EQ(circle.followed.contour()[7].greatest, 0.02);
  EXPECT_EQ(circle.followed.feed()[7].least, 3);
}

/// Of a hundred thousand places one is worse than all others: it stays.
TEST(FollowedRecording, KeepsTheWorstPlacesInBoundedMemory) {
  FollowedRecording followed(machine::mill3().axis_set());
  for (int k = 0; k < 100'000; ++k) {
    followed.observe(std::array<FollowedAxis, base::axis_count>{}, 0);
    followed.observe({{1.0 * k}, {1.0 * k}, k == 77'777 ? 5.0 : 0.001 * (k % 3)}, 1);
    ASSERT_LE(followed.points().size(), FollowedRecording::most_points);
  }
  EXPECT_EQ(followed.greatest_contour(), 5);
  int found = 0;
  double last = -1;
  for (const FollowedPoint& point : followed.points()) {
    found += point.distance == 5 ? 1 : 0;
    EXPECT_GT(point.actual[0], last);
    last = point.actual[0];
  }
  EXPECT_EQ(found, 1);
  EXPECT_GT(followed.points().size(), FollowedRecording::most_points / 4);
}

/// 0.02 mm of 20 mm in 560 of 640: 0.56 units, so that 50 times it is within 32 and 100 times is not.
TEST(FollowedReport, MagnifiesErrorsByRoundFactors) {
  Circle circle(1000, 0.02);
  const std::string page = circle.page();
  EXPECT_NE(page.find("The part as it is made"), std::string::npos);
  EXPECT_NE(page.find("errors × 1<"), std::string::npos);
  EXPECT_NE(page.find("errors × 5<"), std::string::npos);
  EXPECT_NE(page.find("errors × 50<"), std::string::npos);
  EXPECT_NE(page.find("<b>contour error</b>"), std::string::npos);
  EXPECT_NE(page.find("<b>following error</b>"), std::string::npos);
  // The rightmost place of the circle, 280 units from the middle, and 50 times 0.56 farther.
  const auto begins = [&](const std::string& stroke) {
    const std::string opening = "class=\"" + stroke + "\" d=\"";
    const std::size_t found = page.find(opening);
    return found == std::string::npos ? stroke : page.substr(found + opening.size(), 8);
  };
  EXPECT_EQ(begins("commanded"), "M880 320");
  EXPECT_EQ(begins("actual by2"), "M908 320");
}

TEST(FollowedReport, IsOfSlidesOnly) {
  Circle circle(10, 0.02);
  std::string text;
  const auto sink = [&](std::string_view bytes) {
    text += bytes;
    return base::Result<void>();
  };
  ASSERT_TRUE(write_report({}, circle.recording, circle.machine, period, sink));
  EXPECT_EQ(text.find("The part as it is made"), std::string::npos);
  EXPECT_EQ(text.find("contour error"), std::string::npos);
}

}  // namespace test_followed_report
}  // namespace leadscrew::report
