// What a program does to its own coordinates: mirror, scaling, turn, polar words. Expected places are worked out by
// hand; arcs that become curves are compared with points of the arc that are transformed one by one.

#include <cmath>
#include <leadscrew/gcode/nurbs.hpp>
#include <numbers>
#include <random>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_transforms {

void expect_ends(std::string_view text, const std::vector<Point>& ends) {
  const Reading reading = read_well(text, in_dialect(Dialect::fanuc));
  std::vector<Point> found;
  for (const Move& move : reading.moves) {
    if (move.kind != Move::Kind::event) found.push_back(xyz(move.end));
  }
  ASSERT_EQ(found.size(), ends.size()) << text;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    EXPECT_NEAR(found[i].x, ends[i].x, 1e-9) << text << i;
    EXPECT_NEAR(found[i].y, ends[i].y, 1e-9) << text << i;
    EXPECT_NEAR(found[i].z, ends[i].z, 1e-9) << text << i;
  }
}

// A point of a curve, by de Boor's algorithm in homogeneous coordinates.
base::AxisVector place_along(const NurbsCurve& curve, double u) {
  const auto degree = static_cast<std::size_t>(curve.degree);
  std::size_t k = degree;
  while (k + 1 < curve.points.size() && u >= curve.knots[k + 1]) ++k;
  std::vector<std::array<double, 10>> d;
  for (std::size_t i = 0; i <= degree; ++i) {
    const ControlPoint& point = curve.points[k - degree + i];
    std::array<double, 10> h{};
    for (std::size_t a = 0; a < 9; ++a) h[a] = point.position[a] * point.weight;
    h[9] = point.weight;
    d.push_back(h);
  }
  for (std::size_t r = 1; r <= degree; ++r) {
    for (std::size_t i = degree; i >= r; --i) {
      const double low = curve.knots[i + k - degree], high = curve.knots[i + 1 + k - r];
      const double share = (u - low) / (high - low);
      for (std::size_t a = 0; a < 10; ++a) d[i][a] = (1 - share) * d[i - 1][a] + share * d[i][a];
    }
  }
  base::AxisVector result{};
  for (std::size_t a = 0; a < 9; ++a) result[a] = d[degree][a] / d[degree][9];
  return result;
}

TEST(Turn, GoesAboutAPoint) {
  expect_ends("G68 X10 Y0 R90\nG0 X20 Y0\nX10 Y5\nG69\nX20 Y0\nM2\n", {{10, 10, 0}, {5, 0, 0}, {20, 0, 0}});
}

TEST(Turn, GoesAboutTheToolWhereNoPointIsGiven) {
  expect_ends("G0 X10 Y10\nG68 R90\nG0 X20 Y10\nM2\n", {{10, 10, 0}, {10, 20, 0}});
}

TEST(Turn, TakesOtherPlanes) {
  // In G18 from Z to X.
  expect_ends("G18 G68 X0 Z0 R90\nG0 X0 Z10\nX5 Z0\nM2\n", {{10, 0, 0}, {0, 0, -5}});
}

TEST(Turn, AddsToThatOfTheSystem) {
  expect_ends("G10 L2 P1 R30\nG68 X0 Y0 R60\nG0 X10 Y0\nM2\n", {{0, 10, 0}});
}

TEST(Turn, TurnsIncrementsAndArcs) {
  const Reading reading = read_well("F60 G68 X0 Y0 R90\nG91 G1 X10\nG2 X10 I5\nM2\n", in_dialect(Dialect::fanuc));
  ASSERT_EQ(reading.arcs().size(), 1u);
  const Move arc = reading.arcs()[0];
  EXPECT_NEAR(arc.start[1], 10, 1e-12);
  EXPECT_NEAR(arc.end[1], 20, 1e-12);
  EXPECT_NEAR(arc.center_second, 15, 1e-12);
  EXPECT_EQ(arc.turns, -1);
}

TEST(Scale, GoesAboutAPoint) {
  expect_ends("G51 X10 Y0 Z0 P2.\nG0 X20 Y5 Z1\nG50\nX20 Y5\nM2\n", {{30, 10, 2}, {20, 5, 2}});
}

TEST(Scale, TakesAxesByThemselves) {
  expect_ends("G51 X0 Y0 Z0 I2. J-3. K1.\nG0 X1 Y1 Z1\nM2\n", {{2, -3, 1}});
}

TEST(Scale, TurnsArcsRoundWhereItMirrors) {
  const Reading reading = read_well("F60 G51 X0 Y0 Z0 I-2. J2. K1.\nG2 X10 Y0 I5 J0\nM2\n", in_dialect(Dialect::fanuc));
  ASSERT_EQ(reading.arcs().size(), 1u);
  EXPECT_EQ(reading.arcs()[0].turns, 1);
  EXPECT_NEAR(reading.arcs()[0].center_first, -10, 1e-12);
}

TEST(Scale, ScalesCycles) {
  expect_ends("G0 Z10\nG51 X0 Y0 Z0 P2.\nG98 G81 X1 Y2 Z-1 R1 F60\nM2\n",
              {{0, 0, 10}, {2, 4, 10}, {2, 4, 2}, {2, 4, -2}, {2, 4, 10}});
}

TEST(Scale, NeedsANumberThatIsNotZero) {
  EXPECT_EQ(read("G51 X0 Y0\nM2\n", in_dialect(Dialect::fanuc)).problems(), "1:1 missing-word; ");
  EXPECT_EQ(read("G51 X0 Y0 P0.\nM2\n", in_dialect(Dialect::fanuc)).problems(), "1:11 bad-value; ");
}

TEST(Mirror, IsAtACoordinate) {
  expect_ends("G51.1 X10\nG0 X12 Y1\nG50.1 X0\nX12\nM2\n", {{8, 1, 0}, {12, 1, 0}});
}

// Mirror, then scaling, then turn; the turn's centre is scaled with all else.
TEST(Transforms, ComeInFanucsOrder) {
  // X3 mirrored at 1 is −1, scaled −2, turned about (2·1, 0) by 90 degrees: (2, −4).
  expect_ends("G51.1 X1\nG51 X0 Y0 Z0 P2.\nG68 X1 Y0 R90\nG0 X3 Y0\nM2\n", {{2, -4, 0}});
}

TEST(Transforms, LetG92CallThePositionWhatItIsGiven) {
  expect_ends("G51 X0 Y0 Z0 P2.\nG0 X10 Y10\nG92 X0 Y0\nG0 X1 Y0\nM2\n", {{20, 20, 0}, {22, 20, 0}});
}

// An arc under unequal scales, or turned out of its plane, is the curve of its transformed points.
TEST(Transforms, MakeCurvesOfArcs) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> of_length(-40, 40), of_scale(0.3, 2.5), of_angle(-180, 180);
  for (int i = 0; i < 200; ++i) {
    const double i_word = of_length(random), j_word = of_length(random), pitch = i % 3 == 0 ? 0 : of_length(random) / 4;
    const double a = of_scale(random), b = of_scale(random), angle = of_angle(random);
    const double sweep_angle = 0.3 + 5.5 * (i % 11) / 11.0;
    const double radius = std::hypot(i_word, j_word), from = std::atan2(-j_word, -i_word);
    const double end_x = i_word + radius * std::cos(from + sweep_angle);
    const double end_y = j_word + radius * std::sin(from + sweep_angle);
    std::ostringstream text;
    text.precision(15);
    text << std::fixed << "F600 G51 X0 Y0 Z0 I" << a << " J" << b << " K1.\n"
         << "G18 G68 X0 Z0 R" << angle << "\nG17 G3 X" << end_x << " Y" << end_y << " I" << i_word << " J" << j_word
         << " Z" << pitch << "\nM2\n";
    const Reading reading = read_well(text.str(), in_dialect(Dialect::fanuc));
    const std::vector<Move> curves = reading.of(Move::Kind::nurbs);
    ASSERT_EQ(curves.size(), 1u) << text.str();
    const NurbsCurve& curve = curves[0].curve;
    const double turned = angle * std::numbers::pi / 180;
    const double last = curve.knots.back();
    for (int k = 0; k <= 60; ++k) {
      const base::AxisVector p = place_along(curve, std::min(last * k / 60, last * (1 - 1e-15)));
      // Back to the program: Z and X are turned in G18, then X and Y scaled.
      const double z = std::cos(turned) * p[2] + std::sin(turned) * p[0];
      const double x = (-std::sin(turned) * p[2] + std::cos(turned) * p[0]) / a, y = p[1] / b;
      EXPECT_NEAR(std::hypot(x - i_word, y - j_word), radius, 1e-8 * radius) << text.str();
      double along = std::atan2(y - j_word, x - i_word) - from;
      while (along < -1e-6) along += 2 * std::numbers::pi;
      if (k > 0 && k < 60) {
        EXPECT_NEAR(z, pitch * along / sweep_angle, 2e-5) << text.str();
      }
    }
  }
}

TEST(PolarCoordinates, AreARadiusAndAnAngle) {
  expect_ends("G16\nG0 X10 Y90\nY180\nX20\nG91 Y-90\nG90 G15\nX1 Y2\nM2\n",
              {{0, 10, 0}, {-10, 0, 0}, {-20, 0, 0}, {0, 20, 0}, {1, 2, 0}});
  expect_ends("G0 Z10\nG16\nG99 G81 X10 Y0 Z-1 R1 F60\nY90\nG80 G15\nM2\n",
              {{0, 0, 10}, {10, 0, 10}, {10, 0, 1}, {10, 0, -1}, {10, 0, 1}, {0, 10, 1}, {0, 10, -1}, {0, 10, 1}});
}

}  // namespace test_transforms
}  // namespace leadscrew::gcode
