#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "machines.hpp"

// Against what shares no code: matrices of 4 × 4 in extended precision, put together from the machine's data; and closed forms
// of single machines as they are published.

namespace leadscrew::kinematics::testing {
namespace test_independent {

using Real = long double;
using Matrix = std::array<std::array<Real, 4>, 4>;
using Column = std::array<Real, 4>;

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix c{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t k = 0; k < 4; ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}
Column image(const Matrix& a, const Column& v) {
  Column w{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < 4; ++k) w[i] += a[i][k] * v[k];
  return w;
}
Matrix unit() {
  return {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
}
Matrix shift(Real x, Real y, Real z) {
  return {{{1, 0, 0, x}, {0, 1, 0, y}, {0, 0, 1, z}, {0, 0, 0, 1}}};
}

/// From the quaternion of the half angle.
Matrix rotation(const machine::RotaryAxis& axis, double degrees) {
  const Real half = static_cast<Real>(axis.sign) * static_cast<Real>(degrees) * std::numbers::pi_v<Real> / 360;
  const Real size = std::hypot(static_cast<Real>(axis.direction[0]), static_cast<Real>(axis.direction[1]),
                               static_cast<Real>(axis.direction[2]));
  const Real s = std::sin(half) / size, w = std::cos(half);
  const Real x = s * static_cast<Real>(axis.direction[0]), y = s * static_cast<Real>(axis.direction[1]),
             z = s * static_cast<Real>(axis.direction[2]);
  const Matrix turn = {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), 0},
                        {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x), 0},
                        {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y), 0},
                        {0, 0, 0, 1}}};
  const auto [px, py, pz] = axis.point;
  return product(shift(px, py, pz),
                 product(turn, shift(-static_cast<Real>(px), -static_cast<Real>(py), -static_cast<Real>(pz))));
}

/// All axes that carry this, from order 1 on.
Matrix carried(const machine::RotaryChain& data, machine::Carries carries, const Coordinates<double>& at) {
  Matrix all = unit();
  for (std::int64_t order = 1; order <= 2; ++order) {
    for (const machine::RotaryAxis& axis : data.axes) {
      if (axis.carries != carries || axis.order != order) continue;
      all = product(all, rotation(axis, at[base::index(axis.axis)]));
    }
  }
  return all;
}

/// The tip as the table has it, and as the head has it, are one place of the machine; so are the directions.
TEST(Axes, BringTipAndPartTogetherByMatrices) {
  Draw draw(7);
  for (const NamedChain& named : all_chains()) {
    for (int k = 0; k < 300; ++k) {
      const Vector tool = {draw(-20, 20), draw(-20, 20), draw(0, 300)};
      const Coordinates<double> pose = coordinates(named.chain, {draw(-500, 500), draw(-500, 500), draw(-500, 500)},
                                                   {draw(-400, 400), draw(-400, 400)});
      const Coordinates<double> axes = machine_of(named.chain, pose, tool);
      const Matrix table = carried(named.data, machine::Carries::workpiece, pose);
      const Matrix head = carried(named.data, machine::Carries::tool, pose);
      const Column part = image(table, {pose[0], pose[1], pose[2], 1});
      const auto [gx, gy, gz] = named.data.tool_zero;
      Column tip = image(head, {Real(gx) - tool[0], Real(gy) - tool[1], Real(gz) - tool[2], 1});
      tip = image(shift(Real(axes[0]) - gx, Real(axes[1]) - gy, Real(axes[2]) - gz), tip);
      // Where only tables turn, the gauge point's place does not matter.
      for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(static_cast<double>(part[i] - tip[i]), 0, 2e-12) << named.name;

      const Vector3<double> direction = direction_of(named.chain, angles_of(named.chain, pose));
      const Column seen = image(table, {direction[0], direction[1], direction[2], 0}),
                   spindle = image(head, {0, 0, 1, 0});
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(static_cast<double>(seen[i] - spindle[i]), 0, 2e-15) << named.name;
    }
  }
}

/// A table of A that carries one of C, as LinuxCNC's manual has it ("5-Axis Kinematics", XYZAC-trt): C's axis through (x, y, z)
/// and A's by (dy, dz) beside it; a tool's length counts as more dz, where Z is that of the gauge point.
TEST(TableTable, OfAAndCHasThePublishedClosedForm) {
  Draw draw(11);
  for (int k = 0; k < 1000; ++k) {
    const double rx = draw(-50, 50), ry = draw(-50, 50), rz = draw(-50, 50), dy = draw(-20, 20), dz = draw(-90, 90);
    machine::RotaryChain data = *machine::preset_chain("table-table-ac");
    data.axes[0].point = {draw(-5, 5), ry + dy, rz + dz};
    data.axes[1].point = {rx, ry, rz};
    const double length = draw(0, 200), a = draw(-120, 120), c = draw(-360, 360);
    const double sa = std::sin(a * degree), ca = std::cos(a * degree), sc = std::sin(c * degree),
                 cc = std::cos(c * degree);
    const double x = draw(-300, 300), y = draw(-300, 300), z = draw(-300, 300);
    const double u = x - rx, v = y - ry, w = z + length - rz, d = dz + length;
    const double right_x = cc * u - sc * v + rx;
    const double right_y = sc * ca * u + cc * ca * v - sa * w - ca * dy + sa * d + dy + ry;
    const double right_z = sc * sa * u + cc * sa * v + ca * w - sa * dy - ca * d + d + rz;
    const Chain chain = Chain::of(data).value();
    const Coordinates<double> axes = machine_of(chain, coordinates(chain, {x, y, z}, {c, a}), {0, 0, length});
    EXPECT_NEAR(axes[0], right_x, 1e-12);
    EXPECT_NEAR(axes[1], right_y, 1e-12);
    EXPECT_NEAR(axes[2], right_z, 1e-12);
  }
}

/// A head of C and B whose axes meet in a pivot above the gauge point: axes = tip + r (sin B cos C, sin B sin C, cos B − 1) with
/// r from the pivot to the tip, for tools that are told by that length; longer ones begin lower.
TEST(HeadHead, OfBAndCHasThePublishedClosedForm) {
  Draw draw(12);
  for (int k = 0; k < 1000; ++k) {
    machine::RotaryChain data = *machine::preset_chain("head-head-bc");
    const double pivot = draw(50, 300), length = draw(0, 200), b = draw(-120, 120), c = draw(-360, 360),
                 r = pivot + length;
    for (machine::RotaryAxis& axis : data.axes) axis.point = {0, 0, pivot};
    const Chain chain = Chain::of(data).value();
    const Vector tip = {draw(-300, 300), draw(-300, 300), draw(-300, 300)};
    const Coordinates<double> axes = machine_of(chain, coordinates(chain, tip, {c, b}), {0, 0, length});
    EXPECT_NEAR(axes[0], tip[0] + r * std::sin(b * degree) * std::cos(c * degree), 1e-12);
    EXPECT_NEAR(axes[1], tip[1] + r * std::sin(b * degree) * std::sin(c * degree), 1e-12);
    EXPECT_NEAR(axes[2], tip[2] + length + r * (std::cos(b * degree) - 1), 1e-12);
  }
}

/// A nutating head: half a turn about the oblique axis lays the tool level, and any angle about it tilts by
/// cos η = (1 + cos B)/2.
TEST(NutatingHead, TiltsAsItsTriangleSays) {
  machine::RotaryChain data = *machine::preset_chain("head-head-bc");
  data.axes[1].direction = {0, std::sqrt(0.5), std::sqrt(0.5)};
  const Chain chain = Chain::of(data).value();
  for (double b = -180; b <= 180; b += 7.5) {
    const Vector3<double> direction = direction_of(chain, Angles<double>{33, b});
    EXPECT_NEAR(direction[2], (1 + std::cos(b * degree)) / 2, 1e-15);
  }
}

}  // namespace test_independent
}  // namespace leadscrew::kinematics::testing
