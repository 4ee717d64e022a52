// What no register would hold is refused by name.

#include <gtest/gtest.h>

#include <leadscrew/design/design_check.hpp>
#include <string>

namespace leadscrew::design {
namespace test_design_check {

using Problems = std::vector<base::Diagnostic>;

void expect(const Problems& problems, std::string_view code, const std::string& said) {
  ASSERT_EQ(problems.size(), 1u) << said;
  EXPECT_EQ(problems[0].code, code);
  EXPECT_NE(problems[0].message.find(said), std::string::npos) << problems[0].message;
}

constexpr DdaRange table{600, 0.01, 12000, 50};

TEST(DesignCheck, TakesTheLecture) {
  EXPECT_TRUE(problems_of(table).empty());
  EXPECT_TRUE(problems_of(table, {100, 50}, 3000).empty());
  EXPECT_TRUE(problems_of(table, {-655.35, 0}, 12000).empty());
  EXPECT_TRUE(problems_of(1024, {2, 4, 8}).empty());
}

TEST(DesignCheck, NamesWhatIsNotAboveZero) {
  expect(problems_of(DdaRange{0, 0.01, 12000, 50}), "not-positive", "the travel is 0");
  expect(problems_of(DdaRange{600, -0.01, 12000, 50}), "not-positive", "the BLU is -0.01");
  expect(problems_of(table, {100, 50}, 0), "not-positive", "the feed is 0");
  expect(problems_of(0, {2}), "not-positive", "the clock is 0");
  expect(problems_of(1024, {2, -4}), "not-positive", "the delay is -4");
  EXPECT_EQ(problems_of(DdaRange{}).size(), 4u);
}

TEST(DesignCheck, NamesTheRegisterThatOverflows) {
  expect(problems_of(table, {100, 655.36}, 3000), "register-overflow", "axis 2 of 16 bits would have to hold 65536");
  expect(problems_of(table, {10, 20}, 12000), "register-overflow", "S of 12 bits would have to hold 5367");
  expect(problems_of(DdaRange{600, 1e-9, 12000, 50}), "register-overflow", "axes' register");
  expect(problems_of(10, {0.8, 0.05}), "register-overflow", "timer's register of 3 bits, for the delay of 0.05 s,");
  expect(problems_of(1e6, {1e6}), "register-overflow", "timer's register");
}

TEST(DesignCheck, NamesFeedsThatHaveNoWord) {
  expect(problems_of(table, {600, 600}, 4), "feed-too-low", "feed word S is 0.047");
  expect(problems_of(table, {600, 600}, 12001), "feed-too-high", "12001 is above the greatest, 12000");
  expect(problems_of(table, {0.004, 0}, 3000), "no-way", "within half a BLU");
}

TEST(DesignCheck, HoldsTheInverseTimeCodeToItsDigits) {
  constexpr InverseTimeRange koren{12, 0.0001, 30, 0.01, 4};
  EXPECT_TRUE(problems_of(koren).empty());
  EXPECT_TRUE(problems_of(koren, 2, 10).empty());
  expect(problems_of(koren, 0.02, 30), "register-overflow", "f of 4 digits would have to hold 15000");
  expect(problems_of(koren, 12.1, 30), "register-overflow", "q would have to hold 121000");
  expect(problems_of(koren, 2, 31), "feed-too-high", "31");
  EXPECT_EQ(problems_of(koren, 2, 0.004).front().code, "feed-too-low");
}

}  // namespace test_design_check
}  // namespace leadscrew::design
