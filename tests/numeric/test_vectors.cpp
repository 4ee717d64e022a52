#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <leadscrew/numeric/vectors.hpp>

namespace test_vectors {

using namespace leadscrew::numeric;

using Three = std::array<double, 3>;

TEST(Vectors, HaveEuclidsNormAndDistance) {
  EXPECT_EQ(dot(Three{1, 2, 3}, Three{4, -5, 6}), 12);
  EXPECT_EQ(norm(Three{2, 3, 6}), 7);
  EXPECT_EQ(distance(Three{1, 1, 1}, Three{3, 4, 7}), 7);
}

TEST(Vectors, CanBeTakenByTheirFirstCoordinatesOnly) {
  EXPECT_EQ(dot(Three{1, 2, 3}, Three{4, -5, 6}, 2), -6);
  EXPECT_EQ(norm(Three{3, 4, 100}, 2), 5);
}

TEST(Vectors, AreSummedInTheOrderOfTheirCoordinates) {
  // (10¹⁶ + 1) + 1 stays 10¹⁶; (1 + 1) + 10¹⁶ does not.
  EXPECT_EQ(dot(Three{1e16, 1, 1}, Three{1, 1, 1}), 1e16);
  EXPECT_EQ(dot(Three{1, 1, 1e16}, Three{1, 1, 1}), 1e16 + 2);
}

TEST(Vectors, AreAsFarFromASegmentAsFromItsNearestPlace) {
  const Three begin{0, 0, 0}, end{4, 0, 0};
  EXPECT_EQ(distance_to_segment(Three{1, 3, 4}, begin, end), 5);
  EXPECT_EQ(distance_to_segment(Three{-3, 4, 0}, begin, end), 5);
  EXPECT_EQ(distance_to_segment(Three{7, 0, 4}, begin, end), 5);
  EXPECT_EQ(distance_to_segment(Three{0, 3, 4}, begin, begin), 5);
}

}  // namespace test_vectors
