#include <cmath>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_polar {

std::vector<Point> ends_of(std::string_view text) {
  std::vector<Point> points;
  for (const Move& move : read_well(text).moves) {
    if (move.kind == Move::Kind::line || move.kind == Move::Kind::arc) points.push_back(xyz(move.end));
  }
  return points;
}

void expect_near(const std::vector<Point>& found, const std::vector<Point>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i].x, expected[i].x, 1e-12) << i;
    EXPECT_NEAR(found[i].y, expected[i].y, 1e-12) << i;
    EXPECT_NEAR(found[i].z, expected[i].z, 1e-12) << i;
  }
}

TEST(PolarWords, LeadToAPointSeenFromTheOrigin) {
  expect_near(ends_of("F100 G1 @1 ^90\n@2 ^0\n^180\n@5\nM2\n"), {{0, 1, 0}, {2, 0, 0}, {-2, 0, 0}, {-5, 0, 0}});
  expect_near(ends_of("G0 @-1 ^90\n@[1+1] ^[30*2-60]\nM2\n"), {{0, -1, 0}, {2, 0, 0}});
}

// The example of the manual: with @ the distance grows at each step.
TEST(PolarWords, AddUpInIncrements) {
  expect_near(ends_of("F100 G1 @.5 ^90\nG91 @.5 ^90\n@.5 ^90\n@.5 ^90\n@.5 ^90\nM2\n"),
              {{0, 0.5, 0}, {-1, 0, 0}, {0, -1.5, 0}, {2, 0, 0}, {0, 2.5, 0}});
  expect_near(ends_of("F100 G1 @.5 ^90\nG91 ^90\n^90\n^90\n^90\nM2\n"),
              {{0, 0.5, 0}, {-0.5, 0, 0}, {0, -0.5, 0}, {0.5, 0, 0}, {0, 0.5, 0}});
}

TEST(PolarWords, AreSeenFromTheOriginInForce) {
  expect_near(ends_of("G10 L2 P2 X10 Y20\nG55 G0 @5 ^90\nM2\n"), {{10, 25, 0}});
  expect_near(ends_of("G0 X3 Y4\nG92 X0 Y0\n@5 ^0\nM2\n"), {{3, 4, 0}, {8, 4, 0}});
  expect_near(ends_of("G20 G0 @1 ^90\nM2\n"), {{0, 25.4, 0}});
  expect_near(ends_of("G10 L2 P1 R90\nG0 @5 ^0\nG91 ^90\nM2\n"), {{0, 5, 0}, {-5, 0, 0}});
}

TEST(PolarWords, StandBesideOtherAxes) {
  expect_near(ends_of("G18 G0 @5 ^90 Z3\nM2\n"), {{0, 5, 3}});
}

TEST(PolarWords, EndArcs) {
  expect_near(ends_of("G0 X1 Y0\nF10 G3 ^90 I-1 J0\nM2\n"), {{1, 0, 0}, {0, 1, 0}});
}

TEST(PolarWords, PlaceHoles) {
  const std::vector<Point> ends = ends_of("G0 X1 Z2\nG81 @3 ^90 Z-1 R1 F10\nG91 ^45\nM2\n");
  const double half = 3 / std::sqrt(2.0);
  EXPECT_NEAR(ends.back().x, -half, 1e-12);
  EXPECT_NEAR(ends.back().y, half, 1e-12);
}

TEST(PolarWords, AreRefusedWhereTheyMeanNothing) {
  const char* const rows[][2] = {
      {"G0 @1 X3", "1:7 bad-polar; "},
      {"G0 Y3 ^30", "1:4 bad-polar; "},
      {"G91 G0 @1 ^30", "1:8 bad-polar; "},
      {"G53 G0 @1", "1:8 bad-polar; "},
      {"G28 @1 ^90", "1:5 bad-polar; "},
      {"G92 @1", "1:5 bad-polar; "},
      {"G10 L2 P1 ^1", "1:11 bad-polar; "},
      {"G0 @1 @2", "1:7 repeated-word; "},
      {"G0 @", "1:5 bad-number; "},
      {"G0 ^[10**10]", "1:4 bad-value; "},
      {"@1 ^30", "1:1 axis-without-motion; "},
      {"G0 @1", "1:4 bad-polar; "},
      {"G18\nG0 @1 ^2", "2:4 bad-polar; "},
  };
  for (const auto& row : rows) EXPECT_EQ(read(std::string(row[0]) + "\nM2\n").problems(), row[1]) << row[0];
}

TEST(PolarWords, AreOfLinuxCnc) {
  Conditions grbl;
  grbl.options.dialect = Dialect::grbl;
  EXPECT_EQ(read("G0 @1\nM2\n", grbl).problems(), "1:4 bad-character; ");
}

}  // namespace test_polar
}  // namespace leadscrew::gcode
