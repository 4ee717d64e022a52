// The identity of a block: file, line and visit.

#include <gtest/gtest.h>

#include <leadscrew/base/line.hpp>

namespace leadscrew::base {
namespace test_line {

TEST(Line, OfThePlainTextIsItsNumber) {
  EXPECT_EQ(line_at(7), Line{7});
  EXPECT_EQ(number(Line{7}), 7);
  EXPECT_EQ(file(Line{7}), 0);
  EXPECT_EQ(visit(Line{7}), 0);
}

TEST(Line, KeepsFileAndVisitApart) {
  for (const std::int64_t line : {std::int64_t{0}, std::int64_t{1}, last_line}) {
    for (const int of_file : {0, 1, last_file}) {
      for (const int of_visit : {0, 1, last_visit / 2 + 1, last_visit}) {
        const Line made = line_at(line, of_file, of_visit);
        EXPECT_EQ(number(made), line);
        EXPECT_EQ(file(made), of_file);
        EXPECT_EQ(visit(made), of_visit);
        EXPECT_EQ(place_of(made), line_at(line, of_file));
      }
    }
  }
}

TEST(Line, BeyondTheLastCountsAsTheLast) {
  EXPECT_EQ(line_at(last_line + 5, 3), line_at(last_line, 3));
}

TEST(Line, ComesBeforeOthersInTheOrderOfExecution) {
  EXPECT_TRUE(is_before(line_at(3), line_at(4)));
  EXPECT_FALSE(is_before(line_at(4), line_at(4)));
  EXPECT_FALSE(is_before(line_at(4), line_at(3)));
  EXPECT_TRUE(is_before(line_at(9, 0, 1), line_at(2, 0, 2)));
  EXPECT_FALSE(is_before(line_at(2, 0, 2), line_at(9, 0, 1)));
  EXPECT_TRUE(is_before(line_at(9, 1, 1), line_at(2, 0, 2)));
  EXPECT_TRUE(is_before(line_at(9, 0, last_visit), line_at(2, 0, last_visit + 1)));
  EXPECT_FALSE(is_before(line_at(2, 0, last_visit + 1), line_at(9, 0, last_visit)));
}

}  // namespace test_line
}  // namespace leadscrew::base
