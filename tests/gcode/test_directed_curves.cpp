// G6.6: smooth curves with the tool's direction along them.

#include <cmath>
#include <leadscrew/kinematics/pose.hpp>

#include "surface_programs.hpp"

namespace leadscrew::gcode {
namespace test_directed_curves {

Conditions table() {
  return with_shapes("table-table-ac");
}

std::string problems(const std::string& text, const Conditions& conditions = table()) {
  return read(text + "M2\n", conditions).problems();
}

const std::string control = "F600\nG0 A-20 Z40\nG43.4\n";

TEST(DirectedCurves, GoThroughTheirPlaces) {
  const Conditions conditions = table();
  const Reading reading = read_well(
      control + "G6.6 P3\nX10 Y5 Z38 I0.2 J0.5 K1\nX20 Y5 I0.3\n(a remark)\nX30 Y0 Z39 I0.1 J0.2 K1\nG0 Z60\nM2\n",
      conditions);
  const auto curves = reading.of(Move::Kind::nurbs);
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_TRUE(curves[0].is_of_tip);
  EXPECT_EQ(base::number(curves[0].line), 4u);
  EXPECT_EQ(curves[0].feed.value, 10);
  EXPECT_EQ(xyz(curves[0].end), (Point{30, 0, 39}));
  const kinematics::Chain chain = kinematics::chain_of(conditions.machine);
  const double wanted[3][6] = {{10, 5, 38, 0.2, 0.5, 1}, {20, 5, 38, 0.3, 0, 0}, {30, 0, 39, 0.1, 0.2, 1}};
  for (const auto& row : wanted) {
    double nearest = 1;
    kinematics::Vector axis{};
    for (const base::AxisVector& place : places_on(curves[0].curve, 40'001)) {
      const double distance = std::hypot(place[0] - row[0], place[1] - row[1], place[2] - row[2]);
      if (!(distance < nearest)) continue;
      nearest = distance;
      axis = kinematics::direction_of(chain, kinematics::angles_of(chain, kinematics::Coordinates<double>(place)));
    }
    EXPECT_LT(nearest, 1e-3);
    const double length = std::hypot(row[3], row[4], row[5]);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(axis[k], row[3 + k] / length, 1e-3);
  }
}

/// The second derivative has no step at the places between.
TEST(DirectedCurves, AreSmooth) {
  const Reading reading = read_well(
      "F600\nG0 A20 Z40\nG43.4\nG6.6 P3\nX10 Y5 Z38 I0.2 J0.5 K1\nX20 Y5 I0.3 K1\nX30 Y0 Z39 I0.1 J0.2 K1\nM2\n",
      table());
  const NurbsCurve curve = reading.of(Move::Kind::nurbs).at(0).curve;
  constexpr double h = 1e-4;
  for (std::size_t k = 6; k + 6 < curve.knots.size(); k += 3) {
    const double u = curve.knots[k];
    for (std::size_t i = 0; i < 6; ++i) {
      const auto bend = [&](double middle) {
        return (place_on(curve, middle - h)[i] - 2 * place_on(curve, middle)[i] + place_on(curve, middle + h)[i]) /
               (h * h);
      };
      EXPECT_NEAR(bend(u - 2 * h), bend(u + 2 * h), 0.02 * (1 + std::abs(bend(u)))) << u << " " << i;
    }
  }
}

TEST(DirectedCurves, OfThreeAxesNeedNoControl) {
  const Reading reading = read_well("F600\nG91 G6.6 P2\nX10 Y5\nX10 Y-5\nG90 G0 X0\nM2\n");
  ASSERT_EQ(reading.of(Move::Kind::nurbs).size(), 1u);
  EXPECT_EQ(xyz(reading.of(Move::Kind::nurbs)[0].end), (Point{20, 0, 0}));
}

TEST(DirectedCurves, ReportWhatTheyCannotBe) {
  EXPECT_EQ(problems(control + "G6.6 P0\nX1\n"), "4:6 surface-counts; ");
  EXPECT_EQ(problems(control + "G6.6 P1001\nX1\n"), "4:6 surface-counts; ");
  EXPECT_EQ(problems(control + "G6.6\n"), "4:1 missing-word; ");
  EXPECT_EQ(problems(control + "G6.6 P2\nX1\nX1\n"), "6:1 curve-place; ");
  EXPECT_EQ(problems(control + "G6.6 P2\nX1\nX2 I0 J0 K0\n"), "6:4 tool-vector; ");
  EXPECT_EQ(problems(control + "G6.6 P2\nX1\nX2 K-1\n"), "6:1 tool-vector; ");
  EXPECT_EQ(problems("F600\nG6.6 P2\nX1\nX2 K1\n"), "4:4 surface-needs-tip-control; ");
  EXPECT_EQ(problems(control + "G93 G6.6 P1 F1\nX1\n"), "4:5 bad-feed-mode; ");
  EXPECT_EQ(problems(control + "G6.6 P2\nX1\nG0 X5\n"), "6:1 unfinished-curve; ");
  EXPECT_EQ(read(control + "G6.6 P2\nX1\n", table()).problems(), "4:1 unfinished-curve; ");
  EXPECT_EQ(problems("G6.6 P1\nX1\n"), "1:1 missing-feed; ");
  EXPECT_EQ(problems(control + "G6.6 P1\nX1000 Y3\n"), "4:1 travel; ");
}

/// From near to the pole to the other side of it, past it by less than a millionth of the direction.
TEST(DirectedCurves, ReportPolesThatTheyPassTooNear) {
  EXPECT_EQ(problems(control + "G6.6 P2\nX10 I0.0000001 J0 K1\nX20 J0.36397 K1\n"), "4:1 surface-pole; ");
}

}  // namespace test_directed_curves
}  // namespace leadscrew::gcode
