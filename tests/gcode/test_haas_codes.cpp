// Codes that Haas and Fanuc have for what others write otherwise.

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_haas_codes {

Point last_place(std::string_view program) {
  const std::vector<Move> lines = read_well(program, in_dialect(Dialect::haas)).lines();
  return lines.empty() ? Point{} : xyz(lines.back().end);
}

TEST(FurtherSystems, HaveCodesOfTheirOwn) {
  const std::string set = "G10 L20 P1 X100.\nG10 L20 P3 X10.\nG10 L20 P20 X20.\n";
  EXPECT_EQ(last_place(set + "G110 G0 X1.\nM30\n"), (Point{101, 0, 0}));
  EXPECT_EQ(last_place(set + "G112 G0 X1.\nM30\n"), (Point{11, 0, 0}));
  EXPECT_EQ(last_place(set + "G129 G0 X1.\nM30\n"), (Point{21, 0, 0}));
  EXPECT_EQ(last_place(set + "G112\nG54 G0 X1.\nM30\n"), (Point{1, 0, 0}));
  EXPECT_EQ(read("G130\nM30\n", in_dialect(Dialect::haas)).problems(), "1:1 unknown-code; ");
  EXPECT_EQ(read("G110\nM30\n", in_dialect(Dialect::fanuc)).problems(), "1:1 unknown-code; ");
}

TEST(MirrorOfHaas, IsAboutZero) {
  EXPECT_EQ(last_place("G101 X5.\nG0 X10. Y5.\nM30\n"), (Point{-10, 5, 0}));
  EXPECT_EQ(last_place("G101 X0 Y0\nG0 X10. Y5.\nM30\n"), (Point{-10, -5, 0}));
  EXPECT_EQ(last_place("G101 X0 Y0\nG100 X0\nG0 X10. Y5.\nM30\n"), (Point{10, -5, 0}));
  EXPECT_EQ(last_place("G101 X0 Y0\nG100\nG0 X10. Y5.\nM30\n"), (Point{10, 5, 0}));
  const Reading reading = read_well("G101 X0\nG0 X10. Y0.\nG2 X0. Y-10. I-10. F100.\nM30\n", in_dialect(Dialect::haas));
  ASSERT_EQ(reading.arcs().size(), 1u);
  EXPECT_GT(reading.arcs()[0].turns, 0);
  EXPECT_EQ(reading.arcs()[0].center_first, 0);
}

TEST(Smoothness, IsTheToleranceOfCorners) {
  const Reading reading =
      read_well("F100.\nG187 E0.02\nG1 X1.\nG20\nG187 P2 E0.001\nX0.\nG187\nX1.\nM30\n", in_dialect(Dialect::haas));
  const std::vector<Move> lines = reading.lines();
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_NEAR(lines[0].tolerance, 0.02, 1e-15);
  EXPECT_NEAR(lines[1].tolerance, 0.0254, 1e-15);
  EXPECT_EQ(lines[2].tolerance, nine_axes().tolerance);
  EXPECT_EQ(read("G187 E-1.\nM30\n", in_dialect(Dialect::haas)).problems(), "1:6 bad-value; ");
}

TEST(PathControlOfFanuc, HasTwoMoreCodes) {
  const std::vector<Move> lines =
      read_well("F100.\nG61\nG1 X1.\nG62\nX2.\nG61\nX3.\nG63\nX4.\nG64\nX5.\nM30\n", in_dialect(Dialect::fanuc))
          .lines();
  ASSERT_EQ(lines.size(), 5u);
  for (std::size_t i = 0; i < lines.size(); ++i)
    EXPECT_EQ(lines[i].path_mode, i == 0 || i == 2 ? PathMode::exact_stop : PathMode::blend) << i;
}

}  // namespace test_haas_codes
}  // namespace leadscrew::gcode
