// The simulated probe before boxes, pockets, spheres, cylinders and bores: where it trips, by formulas and by search.

#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/probe_contact.hpp>
#include <random>

#include "probe_programs.hpp"

namespace leadscrew::gcode {
namespace test_probe_bodies {

using machine::Probe;
using machine::ProbeBody;
using machine::Vector;
using BodyKind = ProbeBody::Kind;
using Random = std::mt19937_64;

double between(Random& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

Vector any_point(Random& random, double reach) {
  return {between(random, -reach, reach), between(random, -reach, reach), between(random, -reach, reach)};
}

Vector any_direction(Random& random) {
  while (true) {
    const Vector v = any_point(random, 1);
    const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    if (square < 0.01 || square > 1) continue;
    return {v[0] / std::sqrt(square), v[1] / std::sqrt(square), v[2] / std::sqrt(square)};
  }
}

Vector along(const Vector& from, double distance, const Vector& direction) {
  return {from[0] + distance * direction[0], from[1] + distance * direction[1], from[2] + distance * direction[2]};
}

double distance(const Vector& a, const Vector& b) {
  return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

base::AxisVector axes(const Vector& v) {
  return {v[0], v[1], v[2]};
}

Vector point(const base::AxisVector& v) {
  return {v[0], v[1], v[2]};
}

Probe one(BodyKind kind, const Vector& from, const Vector& to, double radius = 0) {
  return {.bodies = {{kind, from, to, radius}}};
}

TEST(ProbeBodies, AreTouchedFromEverySide) {
  const Probe box = one(BodyKind::box, {10, 20, -30}, {40, 50, -5});
  EXPECT_EQ(told("G0 X0 Y30 Z-10\nG38.2 X60" + tell, box), "10.000 30.000 -10.000 1;");
  EXPECT_EQ(told("G0 X60 Y30 Z-10\nG38.2 X0" + tell, box), "40.000 30.000 -10.000 1;");
  EXPECT_EQ(told("G0 X20 Y70 Z-10\nG38.2 Y0" + tell, box), "20.000 50.000 -10.000 1;");
  EXPECT_EQ(told("G0 X20 Y30\nG38.2 Z-10" + tell, box), "20.000 30.000 -5.000 1;");
  const Probe post = one(BodyKind::cylinder, {0, 0, -40}, {0, 0, -10}, 8);
  EXPECT_EQ(told("G0 X20 Z-12\nG38.2 X0" + tell, post), "8.000 0.000 -12.000 1;");
  EXPECT_EQ(told("G0 X3\nG38.2 Z-12" + tell, post), "3.000 0.000 -10.000 1;");
  const Probe ball = one(BodyKind::sphere, {0, 0, -20}, {}, 13);
  EXPECT_EQ(told("G0 X-20 Y5 Z-20\nG38.2 X0" + tell, ball), "-12.000 5.000 -20.000 1;");
}

TEST(ProbeBodies, ArePassedBy) {
  const Probe ball = one(BodyKind::sphere, {0, 0, -20}, {}, 13);
  EXPECT_EQ(told("G0 Y14 X-20 Z-20\nG38.3 X20" + tell, ball), "20.000 14.000 -20.000 0;");
  EXPECT_EQ(told("G0 Y13 X-20 Z-20\nG38.3 X20" + tell, ball), "20.000 13.000 -20.000 0;");  // in one point
  EXPECT_EQ(told("G0 X-20 Z-20\nG38.2 X-14\n", ball), "3:1 probe-failed; ");
}

TEST(ProbeBodies, AreLeft) {
  const Probe two{.bodies = {{BodyKind::sphere, {0, 0, 0}, {}, 5}, {BodyKind::sphere, {8, 0, 0}, {}, 5}}};
  EXPECT_EQ(told("G38.4 X40" + tell, two), "13.000 0.000 0.000 1;");  // of the two that overlap
  EXPECT_EQ(told("G38.4 Y40" + tell, two), "0.000 5.000 0.000 1;");
  EXPECT_EQ(told("G38.4 X9\n", two), "2:1 probe-failed; ");
  EXPECT_EQ(told("G38.2 X9\n", two), "2:1 probe-state; ");
  EXPECT_EQ(told("G38.3 X9" + tell, two), "0.000 0.000 0.000 1;");
  EXPECT_EQ(told("G0 X20\nG38.4 X30\n", two), "3:1 probe-state; ");
}

TEST(ProbeBodies, GoOnFromTheFaceInTheStateThatWasFound) {
  const Probe ball = one(BodyKind::sphere, {0, 0, -20}, {}, 13);
  EXPECT_EQ(told("G0 X-20 Y5 Z-20\nG38.2 X0\nG38.4 X-20" + tell + "G38.2 X0" + tell + "G38.4 X30" + tell, ball),
            "-12.000 5.000 -20.000 1;-12.000 5.000 -20.000 1;12.000 5.000 -20.000 1;");
}

/// Away from the face, and along it, nothing is met but what stands there.
TEST(ProbeBodies, AreFreeWhereContactWasLost) {
  const Probe steps{.bodies = {{BodyKind::box, {0, 0, -30}, {40, 40, -5}}, {BodyKind::box, {40, 0, -30}, {60, 40, 0}}}};
  const std::string on = "10.000 20.000 -5.000 1;", begin = "G0 X10 Y20 Z5\nG38.2 Z-10\nG38.4 Z5" + tell;
  EXPECT_EQ(told(begin + "G38.3 Z5" + tell, steps), on + "10.000 20.000 5.000 0;");
  EXPECT_EQ(told(begin + "G38.3 X30" + tell, steps), on + "30.000 20.000 -5.000 0;");
  EXPECT_EQ(told(begin + "G38.2 X50" + tell, steps), on + "40.000 20.000 -5.000 1;");
  EXPECT_EQ(told(begin + "G38.2 X30 Z-6" + tell, steps), on + on);
  // Without a probing move that lost it, it touches where it stands.
  EXPECT_EQ(told("G0 X10 Y20 Z5\nG38.2 Z-10\nG38.3 X30" + tell, steps), on);
  const Probe plate{
      .bodies = {{BodyKind::box, {-50, -50, -30}, {50, 50, 0}}, {BodyKind::bore, {0, 0, -20}, {0, 0, 1}, 10}}};
  const std::string wall = "10.000 0.000 -5.000 1;", within = "G0 Z-5\nG38.2 X20\nG38.4 X0" + tell;
  EXPECT_EQ(told(within + "G38.2 X-20" + tell, plate), wall + "-10.000 0.000 -5.000 1;");
  EXPECT_EQ(told(within + "G38.2 X20" + tell, plate), wall + wall);
}

TEST(ProbeBodies, AreMeasuredFromWithin) {
  const Probe plate{.bodies = {{BodyKind::box, {0, 0, -30}, {100, 80, 0}},
                               {BodyKind::bore, {40, 30, -20}, {40, 30, 1}, 10},
                               {BodyKind::pocket, {60, 20, -10}, {90, 60, 1}}}};
  // The centre of the bore, found as a probing cycle does.
  EXPECT_EQ(
      told("G0 X43 Y34 Z5\nG1 Z-8\n#1=#<_x>\nG38.2 X100\n#2=#5061\nG1 X#1\nG38.2 X0\nG1 X[[#2+#5061]/2]\n#1=#<_y>\n"
           "G38.2 Y100\n#2=#5062\nG1 Y#1\nG38.2 Y0\n#3=[[#2+#5062]/2]\n(PRINT,%.4f#<_x> #3)\n",
           plate),
      "40.0000 30.0000;");
  EXPECT_EQ(told("G0 X40 Y30 Z5\nG38.2 Z-29" + tell, plate), "40.000 30.000 -20.000 1;");
  EXPECT_EQ(told("G0 X70 Y30 Z5\nG1 Z-3\nG38.2 X200 F100" + tell, plate), "90.000 30.000 -3.000 1;");
  EXPECT_EQ(told("G0 X20 Y30 Z5\nG38.2 Z-29" + tell, plate), "20.000 30.000 0.000 1;");
}

TEST(ProbeBodies, CountTheOffsetOfTheTool) {
  const Probe ball = one(BodyKind::sphere, {0, 0, -20}, {}, 13);
  EXPECT_EQ(told("G43.1 Z50\nG0 X-20 Y5 Z-20\nG38.2 X0" + tell, ball), "-12.000 5.000 -20.000 1;");
}

/// From a random side, along random lines: the first root of the quadratic, by long double and another formula than the
/// engine's.
TEST(ProbeBodies, SpheresAreMetAtTheFirstRoot) {
  Random random(19);
  int met = 0, passed = 0;
  for (int k = 0; k < 20000; ++k) {
    const double radius = between(random, 0.5, 60);
    const Vector centre = any_point(random, 100);
    const Vector start = along(centre, radius + between(random, 0.01, 80), any_direction(random));
    const Vector aim = along(centre, radius * between(random, 0, 1.5), any_direction(random));
    const Vector target =
        along(start, between(random, 0.5, 3), {aim[0] - start[0], aim[1] - start[1], aim[2] - start[2]});
    const Probe probe = one(BodyKind::sphere, centre, {}, radius);
    const auto found = ProbeContact(probe, {}).contact(axes(start), axes(target));
    long double a = 0, b = 0, c = -static_cast<long double>(radius) * radius;
    for (std::size_t i = 0; i < 3; ++i) {
      const long double d = static_cast<long double>(target[i]) - start[i];
      const long double m = static_cast<long double>(start[i]) - centre[i];
      a += d * d;
      b += d * m;
      c += m * m;
    }
    const long double square = b * b - a * c;
    if (std::abs(square) < 1e-6L * a * radius * radius) continue;  // nearly a tangent
    const long double share = square > 0 ? (-b - std::sqrt(square)) / a : 2;
    if (std::abs(share - 1) < 1e-9L) continue;
    const bool meets = square > 0 && share >= 0 && share <= 1;
    ASSERT_EQ(found.has_value(), meets) << k;
    ++(meets ? met : passed);
    if (!meets) continue;
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR((*found)[i], static_cast<double>(start[i] + share * (target[i] - start[i])), 2e-10) << k;
    EXPECT_NEAR(distance(point(*found), centre), radius, 1e-12 * 400) << k;
  }
  EXPECT_GT(met, 8000);
  EXPECT_GT(passed, 3000);
}

/// Is the point in material, by formulas of their own for each shape?
bool is_material(const Probe& probe, const Vector& p) {
  bool solid = probe.planes[2] && p[2] <= *probe.planes[2], cut = false;
  for (const ProbeBody& body : probe.bodies) {
    bool is_in = true;
    if (body.kind == BodyKind::sphere) {
      is_in = distance(p, body.from) <= body.radius;
    } else if (body.kind == BodyKind::box || body.kind == BodyKind::pocket) {
      for (std::size_t i = 0; i < 3; ++i) is_in = is_in && body.from[i] <= p[i] && p[i] <= body.to[i];
    } else {
      const double height = distance(body.from, body.to);
      double share = 0;
      for (std::size_t i = 0; i < 3; ++i)
        share += (p[i] - body.from[i]) * (body.to[i] - body.from[i]) / (height * height);
      const Vector foot =
          along(body.from, share, {body.to[0] - body.from[0], body.to[1] - body.from[1], body.to[2] - body.from[2]});
      is_in = 0 <= share && share <= 1 && distance(p, foot) <= body.radius;
    }
    (machine::is_hollow(body.kind) ? cut : solid) |= is_in;
  }
  return solid && !cut;
}

ProbeBody any_body(Random& random) {
  ProbeBody body;
  body.kind = static_cast<BodyKind>(random() % 5);
  body.from = any_point(random, 30);
  body.radius = between(random, 2, 20);
  const bool is_box = body.kind == BodyKind::box || body.kind == BodyKind::pocket;
  body.to = is_box ? along(body.from, 1, {between(random, 1, 30), between(random, 1, 30), between(random, 1, 30)})
                   : along(body.from, between(random, 1, 40), any_direction(random));
  return body;
}

/// Random heaps of bodies against steps along the line: the state changes where it is told, and nowhere before.
TEST(ProbeBodies, ChangeTheStateWhereASearchFindsIt) {
  Random random(7);
  int changes[2] = {};
  for (int k = 0; k < 2000; ++k) {
    Probe probe;
    if (random() % 3 == 0) probe.planes[2] = -20;
    for (std::size_t n = 1 + random() % 5; n > 0; --n) probe.bodies.push_back(any_body(random));
    const Vector start = any_point(random, 45), target = any_point(random, 45);
    const Vector way = {target[0] - start[0], target[1] - start[1], target[2] - start[2]};
    const bool begins_in = is_material(probe, start);
    const ProbeContact contact(probe, {});
    const auto found = begins_in ? contact.loss(axes(start), axes(target)) : contact.contact(axes(start), axes(target));
    const double length = distance(start, target), at = found ? distance(start, point(*found)) / length : 1;
    constexpr int steps = 3000;
    for (int i = 1; i < steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      if (share > at - 1e-9) break;
      ASSERT_EQ(is_material(probe, along(start, share, way)), begins_in) << k << " at " << share << " of " << at;
    }
    if (!found) continue;
    ++changes[begins_in];
    EXPECT_NE(is_material(probe, along(start, at + 1e-8 / length, way)), begins_in) << k;
  }
  EXPECT_GT(changes[0], 250);
  EXPECT_GT(changes[1], 100);
}

}  // namespace test_probe_bodies
}  // namespace leadscrew::gcode
