// Greatest errors of the pulse interpolators, by the rows of the study.

#include <gtest/gtest.h>

#include <leadscrew/study/bounds.hpp>
#include <leadscrew/study/studies.hpp>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "found.hpp"

namespace leadscrew::study::testing {
namespace test_bounds {

constexpr std::int64_t quick_radius = 300;

const Rows& quick_bounds() {
  static const Rows rows = bounds_to({}, quick_radius);
  return rows;
}

/// Expected of arcs of which is not told which they are.
bool is_share(const Row& row) {
  return row.what.ends_with(": share");
}

/// What each row is to be judged as: no bound is exceeded, no count is another, and a row without a bound says so.
TEST(BoundsStudy, KeepsEveryBoundAndCountsEveryEndlessArc) {
  const Rows& rows = quick_bounds();
  std::set<std::string> whats;
  for (const Row& row : rows) {
    const bool is_count = row.what.starts_with("endless") || row.what.ends_with("R² = 2") ||
                          row.group.find("one counter") != std::string::npos;
    const bool is_mean = row.what.starts_with("clocks by R") || row.what.ends_with("mean to R = 2000");
    const Verdict told = row.what == "arcs tried" ? Verdict::not_reproducible
                         : is_share(row)          ? Verdict::differs
                         : is_count               ? Verdict::exact
                         : is_mean                ? Verdict::reproduced
                                                  : Verdict::kept;
    EXPECT_EQ(row.verdict, row.expected.has_value() ? told : Verdict::measured) << row.group << ": " << row.what;
    EXPECT_TRUE(row.expected.has_value() || !row.what.starts_with("greatest error") || !row.why.empty()) << row.group;
    EXPECT_TRUE(whats.insert(row.group + row.what).second) << "twice: " << row.group << ": " << row.what;
  }
  EXPECT_EQ(rows.size(), 339u);
}

TEST(BoundsStudy, ReachesTheBoundsItIsToldOf) {
  const Rows& rows = quick_bounds();
  EXPECT_NEAR(ours(rows, "circles, point comparison, inward on the circle", "greatest error to R = 300"), 1, 1e-12);
  EXPECT_NEAR(ours(rows, "circles, DDA, x first, half", "greatest error to R = 300"), 0.96, 0.01);
  EXPECT_NEAR(ours(rows, "lines, DDA, q = L rounded up, empty", "greatest error to a, b = 120"), 0.992, 5e-4);
  EXPECT_NEAR(ours(rows, "free circles by eq. 27, half", "magnitudes, greatest error to R = 2000"), 1.026, 5e-4);
  // Endless without the drain rule, of the 54496 arcs of irrational R through more than a quadrant.
  constexpr const char* endless = "endless without the drain rule, more, other R";
  EXPECT_EQ(ours(rows, "arcs of R² ≤ 900, DDA, parallel, empty", endless), 960);
  EXPECT_EQ(ours(rows, "arcs of R² ≤ 900, DDA, x first, empty", endless), 4624);
  EXPECT_EQ(ours(rows, "arcs of R² ≤ 900, DDA, x first, half", endless), 4032);
  EXPECT_EQ(ours(rows, "arcs of R² ≤ 900, DDA, shrinking axis first, half", endless), 8064);
  EXPECT_EQ(ours(rows, "arcs of R² ≤ 900, DDA, growing axis first, empty", endless), 1024);
}

/// 35 624 arcs are missed, 120 of them endless: counters of whole arcs are safe in one quadrant only.
TEST(KorenEndConditions, MissSoManyArcsByTotalCounters) {
  const Rows& rows = quick_bounds();
  constexpr const char* group = "arcs that one counter an axis does not end where they are to";
  EXPECT_EQ(verdict(rows, group, "eq. 27, half"), "exact");
  EXPECT_EQ(verdict(rows, group, "eq. 27, half: endless"), "exact");
  EXPECT_EQ(ours(rows, group, "eq. 27, two's complement, half"), 37316);
  EXPECT_EQ(ours(rows, group, "as in hardware, two's complement, half"), 144636);
  EXPECT_NEAR(ours(rows, group, "as in hardware, two's complement, half: share"), 73, 1);
}

TEST(BoundsStudy, IsTheSameToTheBitByThreeThreadsThatWorkBackwards) {
  const Host three_threads{.share_out = [](std::size_t count, const auto& work) {
    std::vector<std::jthread> threads;
    for (std::size_t rest = 0; rest < 3; ++rest)
      threads.emplace_back([&work, count, rest] {
        for (std::size_t i = count; i-- > 0;) {
          if (i % 3 == rest) work(i);
        }
      });
  }};
  const Rows shared = bounds_to(three_threads, quick_radius);
  const Rows& alone = quick_bounds();
  ASSERT_EQ(shared.size(), alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(shared[i].group + shared[i].what, alone[i].group + alone[i].what);
    EXPECT_EQ(shared[i].ours, alone[i].ours) << alone[i].group << ": " << alone[i].what;
    EXPECT_EQ(shared[i].verdict, alone[i].verdict);
  }
}

/// At full length: what the quick one cannot reach.
TEST(LongBoundsStudy, KeepsEveryBoundToR4096) {
  for (const Row& row : bounds_rows({}))
    EXPECT_TRUE(row.verdict != Verdict::exceeded && (row.verdict != Verdict::differs || is_share(row)))
        << row.group << ": " << row.what;
}

}  // namespace test_bounds
}  // namespace leadscrew::study::testing
