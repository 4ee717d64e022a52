// G150: where the tool goes, by hand; that it stays off the contour by its radius and clears what it can reach, by samples
// of distances that share no code with the cycle's.

#include <rapidcheck/gtest.h>

#include <cmath>
#include <sstream>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_pockets {

Conditions with_tool(double diameter) {
  Conditions conditions = in_dialect(Dialect::haas);
  machine::Tool tool;
  tool.number = 1;
  tool.diameter = diameter;
  conditions.tools = machine::ToolTable({tool});
  return conditions;
}

std::string story(const Reading& reading) {
  std::ostringstream out;
  const auto round = [](double value) { return std::round(value * 1e4) / 1e4 + 0.0; };
  for (const Move& move : reading.moves) {
    const Point end = xyz(move.end);
    if (move.kind != Move::Kind::line && move.kind != Move::Kind::arc) continue;
    out << (move.kind == Move::Kind::arc          ? 'a'
            : move.feed.mode == Feed::Mode::rapid ? 'r'
                                                  : 'f')
        << round(end.x) << ',' << round(end.y) << ',' << round(end.z) << ' ';
  }
  std::string text = out.str();
  if (!text.empty()) text.pop_back();
  return text;
}

// 20 by 12 with a corner at zero.
const std::string rectangle = "M30\nN100 G1 X0 Y0\nX20.\nY12.\nX0\nY0\nM99\n";

std::string milled(const std::string& words, const std::string& contour = rectangle, double diameter = 4) {
  return story(
      read_well("G0 Z5.\nG150 P100 X10. Y6. R1. D1 F200. " + words + "\nG1 Z9.\n" + contour, with_tool(diameter)));
}

TEST(Pockets, AreClearedLineByLine) {
  const std::string lines = "f2,6,-2 f18,6,-2 f18,2,-2 f2,2,-2 f2,6,-2 f2,10,-2 f18,10,-2 ";
  const std::string outline = "f2,10,-2 f2,2,-2 f18,2,-2 f18,10,-2 ";
  EXPECT_EQ(milled("Z-2. J4."), "r0,0,5 r10,6,5 r10,6,1 f10,6,-2 " + lines + outline + "r18,10,5 f18,10,9");
}

// G51 scales the contour; the tool, of radius 2, stays as it is.
TEST(Pockets, AreScaledButNotTheirTool) {
  const std::string head = "G0 Z5.\nG51 X0 Y0 ", cycle = "\nG150 P100 X10. Y6. R1. Z-2. I20. D1 F200.\n";
  EXPECT_EQ(story(read_well(head + "I2. J2. K1." + cycle + rectangle, with_tool(4))),
            "r0,0,5 r20,12,5 r20,12,1 f20,12,-2 f20,2,-2 f20,22,-2 f2,22,-2 f2,2,-2 f38,2,-2 f38,22,-2 "
            "f20,22,-2 r20,22,5");
  EXPECT_EQ(read(head + "I2. J1. K1." + cycle + rectangle, with_tool(4)).problems(), "3:1 unsupported-rotation; ");
  const Reading large = read(head + "P0.5" + cycle + rectangle, with_tool(8));
  EXPECT_EQ(large.problems(), "3:1 bad-contour; ");
  EXPECT_EQ(large.diagnostics.front().message,
            "G150: the tool of radius 4 mm does not get everywhere along the contour");
}

TEST(Pockets, AreClearedAlongY) {
  EXPECT_EQ(milled("Z-2. I8."),
            "r0,0,5 r10,6,5 r10,6,1 f10,6,-2 f10,2,-2 f10,10,-2 f2,10,-2 f2,2,-2 f10,2,-2 f18,2,-2 f18,10,-2 "
            "f2,10,-2 f2,2,-2 f18,2,-2 f18,10,-2 r18,10,5 f18,10,9");
}

TEST(Pockets, AreClearedLevelByLevel) {
  // J is greater than the pocket: one line.
  EXPECT_EQ(milled("Z-2. Q2. J20. G99"),
            "r0,0,5 r10,6,5 r10,6,1 f10,6,-1 f2,6,-1 f18,6,-1 f18,10,-1 f2,10,-1 f2,2,-1 f18,2,-1 f18,6,-1 r18,6,1 "
            "r10,6,1 f10,6,-2 f2,6,-2 f18,6,-2 f18,10,-2 f2,10,-2 f2,2,-2 f18,2,-2 f18,6,-2 r18,6,1 f18,6,9");
}

TEST(Pockets, AreFinishedByK) {
  EXPECT_EQ(milled("Z-2. J20. K1."),
            "r0,0,5 r10,6,5 r10,6,1 f10,6,-2 f3,6,-2 f17,6,-2 f17,9,-2 f3,9,-2 f3,3,-2 f17,3,-2 f17,6,-2 "
            "f18,6,-2 f18,10,-2 f2,10,-2 f2,2,-2 f18,2,-2 f18,6,-2 r18,6,5 f18,6,9");
}

TEST(Pockets, AreRound) {
  const std::string circle = "M30\nN100 G1 X18. Y6.\nG3 I-8.\nM99\n";
  EXPECT_EQ(milled("Z-2. J20.", circle), "r0,0,5 r10,6,5 r10,6,1 f10,6,-2 f4,6,-2 f16,6,-2 a16,6,-2 r16,6,5 f16,6,9");
}

TEST(Pockets, HaveRoundEnds) {
  const std::string slot = "M30\nN100 G1 X0 Y0\nX20.\nG3 Y12. R6.\nG1 X0\nG3 Y0 J-6.\nM99\n";
  EXPECT_EQ(milled("Z-2. J20.", slot),
            "r0,0,5 r10,6,5 r10,6,1 f10,6,-2 f-4,6,-2 f24,6,-2 a20,10,-2 f0,10,-2 a0,2,-2 f20,2,-2 a24,6,-2 r24,6,5 "
            "f24,6,9");
}

// The upper part of an L is reached past its inner corner.
TEST(Pockets, GoRoundInnerCorners) {
  const std::string l = "M30\nN100 G1 X0 Y0\nX30.\nY10.\nX10.\nY20.\nX0\nY0\nM99\n";
  EXPECT_EQ(story(read_well("G0 Z5.\nG150 P100 X5. Y5. Z-2. R1. J5. D1 F200.\n" + l, with_tool(4))),
            "r0,0,5 r5,5,5 r5,5,1 f5,5,-2 f2,5,-2 f28,5,-2 f8,5,-2 f8,10,-2 f2,10,-2 f2,15,-2 f8,15,-2 "
            "f8,18,-2 f2,18,-2 f2,2,-2 f28,2,-2 f28,8,-2 f10,8,-2 a8,10,-2 f8,15,-2 r8,15,5");
}

TEST(Pockets, MayBeProgramsAndAreInInchesAndTurned) {
  EXPECT_EQ(
      story(read_well("G20\nF8.\nG150 P7 X0.4 Y0.3 Z-0.1 R0.1 J1. D0\nM30\nO7\nG1 X0 Y0\nX0.8\nY0.6\nX0\nY0\nM99\n",
                      with_tool(4)))
          .substr(0, 47),
      "r0,0,2.54 r10.16,7.62,2.54 f10.16,7.62,-2.54 f2");
  EXPECT_EQ(story(read_well("G68 X0 Y0 R90.\nG150 P100 X10. Y6. Z-2. R1. J20. D1 F200.\n" + rectangle, with_tool(4))),
            "r0,0,1 r-6,10,1 f-6,10,-2 f-6,2,-2 f-6,18,-2 f-10,18,-2 f-10,2,-2 f-2,2,-2 f-2,18,-2 f-6,18,-2 r-6,18,1");
}

TEST(Pockets, HaveTheSideThatTheirContourSays) {
  EXPECT_EQ(milled("Z-2. J20. G41"), milled("Z-2. J20."));
  EXPECT_EQ(read("G0 Z5.\nG150 G42 P100 X10. Y6. Z-2. R1. J4. D1 F200.\n" + rectangle, with_tool(4)).problems(),
            "2:1 bad-contour; ");
  EXPECT_EQ(read("G41 D1\nM30\n", with_tool(4)).problems(), "");
}

TEST(Pockets, AreRefusedWhereTheToolDoesNotFit) {
  const auto problems = [](const std::string& block, const std::string& contour = rectangle, double diameter = 4) {
    return read("F200.\n" + block + "\n" + contour, with_tool(diameter)).problems();
  };
  const std::string sound = "G150 P100 X10. Y6. Z-2. R1. J4. D1";
  EXPECT_EQ(problems(sound), "");
  EXPECT_EQ(problems(sound, rectangle, 13), "2:1 bad-contour; ");
  EXPECT_EQ(problems("G150 P100 X1. Y6. Z-2. R1. J4. D1"), "2:1 bad-contour; ");
  EXPECT_EQ(problems("G150 P100 X30. Y6. Z-2. R1. J4. D1"), "2:1 bad-contour; ");
  EXPECT_EQ(problems(sound + " K5."), "2:1 bad-contour; ");
  // An inner fillet that is smaller than the tool.
  EXPECT_EQ(problems(sound, "M30\nN100 G1 X0 Y0\nX19.\nG3 X20. Y1. R1.\nG1 Y12.\nX0\nY0\nM99\n"), "");
  // A neck of 3 between two chambers; a slot that the tool does not enter; a bow tie; an open contour; the hole.
  EXPECT_EQ(
      problems(sound, "M30\nN100 G1 X0 Y0\nX14.\nY4.5\nX20.\nY0\nX34.\nY12.\nX20.\nY7.5\nX14.\nY12.\nX0\nY0\nM99\n"),
      "2:1 bad-contour; ");
  EXPECT_EQ(problems(sound, "M30\nN100 G1 X0 Y0\nX20.\nY4.\nX30.\nY7.\nX20.\nY12.\nX0\nY0\nM99\n"),
            "2:1 bad-contour; ");
  EXPECT_EQ(problems(sound, "M30\nN100 G1 X0 Y0\nX20. Y12.\nX20. Y0\nX0 Y12.\nX0 Y0\nM99\n"), "2:1 bad-contour; ");
  EXPECT_EQ(problems(sound, "M30\nN100 G1 X0 Y0\nX20.\nY12.\nX0\nM99\n"), "2:1 bad-contour; ");
  EXPECT_EQ(problems(sound, "M30\nN100 G1 X0 Y0\nX20.\nY12.\nX0\nY0\nX10. Y6.\nM99\n"), "2:1 bad-contour; ");
  EXPECT_EQ(problems(sound, "M30\nN100 M99\n"), "2:1 bad-contour; ");
  EXPECT_EQ(problems(sound, "M30\nN100 G1 X0 Y0 Z1.\nX20.\nY12.\nX0\nY0\nM99\n"), "4:6 bad-contour; ");
  EXPECT_EQ(problems(sound, "M30\nN100 G0 X0 Y0\nG1 X20.\nY12.\nX0\nY0\nM99\n"), "4:6 bad-contour; ");
  EXPECT_EQ(problems(sound, "M30\nN100 G1 X0 Y0\nX20.\nY12.\nG2 X0\nG1 Y0\nM99\n"), "7:1 missing-word; ");
  EXPECT_EQ(problems("G150 P101 X10. Y6. Z-2. R1. J4. D1"), "2:1 missing-sub; ");
}

TEST(Pockets, NeedTheirWords) {
  const auto problems = [](const std::string& words) {
    return read("F200.\nG150 " + words + "\n" + rectangle, with_tool(4)).problems();
  };
  EXPECT_EQ(problems("X10. Y6. Z-2. R1. J4. D1"), "2:1 missing-word; ");
  EXPECT_EQ(problems("P100 X10. Y6. R1. J4. D1"), "2:1 missing-word; ");
  EXPECT_EQ(problems("P100 X10. Y6. Z-2. J4. D1"), "2:1 missing-word; ");
  EXPECT_EQ(problems("P100 X10. Y6. Z-2. R1. D1"), "2:1 missing-word; ");
  EXPECT_EQ(problems("P100 X10. Y6. Z-2. R1. I4. J4. D1"), "2:1 ambiguous-word; ");
  EXPECT_EQ(problems("P100 X10. Y6. Z-2. R1. J0 D1"), "2:29 bad-value; ");
  EXPECT_EQ(problems("P100 X10. Y6. Z-2. R1. J4. Q-1. D1"), "2:33 bad-value; ");
  EXPECT_EQ(problems("P100 X10. Y6. Z-2. R1. J4."), "2:1 missing-word; ");
  EXPECT_EQ(problems("P100 X10. Y6. Z-2. R1. J4. D3"), "2:33 unknown-tool; ");
  EXPECT_EQ(problems("P100 X10. Y6. Z2. R1. J4. D1"), "2:20 cycle-levels; ");
  EXPECT_EQ(problems("P100 X10. Y6. Z-2. R1. J0.0001 D1"), "2:1 too-many-passes; ");
  EXPECT_EQ(problems("P100 X10. Y6. Z-2. R1. J4. Q0.0001 D1"), "2:33 too-many-passes; ");
  EXPECT_EQ(problems("P100 X10. Y6. Z-600. R1. J4. D1"), "2:1 travel; ");
  EXPECT_EQ(problems("P100 X10. Y6. Z-2. R1. J4. D1 A5."), "2:36 unused-word; ");
  EXPECT_EQ(problems("G18 P100 X10. Y6. Z-2. R1. J4. D1"), "2:1 bad-plane; ");
}

// Of a line, or an arc cut into many lines.
std::vector<Point> sampled(const Move& move) {
  std::vector<Point> points;
  const Point a = xyz(move.start), b = xyz(move.end);
  constexpr int steps = 40;
  const double first = std::atan2(a.y - move.center_second, a.x - move.center_first);
  double sweep = std::atan2(b.y - move.center_second, b.x - move.center_first) - first;
  if (move.turns > 0 && sweep <= 1e-12) sweep += 2 * M_PI;
  if (move.turns < 0 && sweep >= -1e-12) sweep -= 2 * M_PI;
  const double radius = std::hypot(a.x - move.center_first, a.y - move.center_second);
  for (int k = 0; k <= steps; ++k) {
    const double part = static_cast<double>(k) / steps;
    if (move.kind == Move::Kind::arc) {
      const double angle = first + part * sweep;
      points.push_back(
          {move.center_first + radius * std::cos(angle), move.center_second + radius * std::sin(angle), b.z});
    } else {
      points.push_back({a.x + part * (b.x - a.x), a.y + part * (b.y - a.y), a.z + part * (b.z - a.z)});
    }
  }
  return points;
}

double to_segment(const Point& p, const Point& a, const Point& b) {
  const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
  const double at = square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - at * dx, p.y - a.y - at * dy);
}

double to_loop(const Point& p, const std::vector<Point>& loop) {
  double least = 1e9;
  for (std::size_t i = 0; i < loop.size(); ++i)
    least = std::min(least, to_segment(p, loop[i], loop[(i + 1) % loop.size()]));
  return least;
}

bool inside(const Point& p, const std::vector<Point>& loop) {
  bool result = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point &a = loop[i], &b = loop[(i + 1) % loop.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) result = !result;
  }
  return result;
}

struct Star {
  std::vector<Point> corners;
  std::string text;  // of the subprogram
};

// About zero; of lines. Corners of a convex one lie on a circle.
Star random_star(bool is_convex) {
  Star star;
  const int count = *rc::gen::inRange(4, 9);
  star.text = "M30\nN100 G1";
  for (int i = 0; i <= count; ++i) {
    if (i < count) {
      const double angle = 2 * M_PI * (i + *rc::gen::inRange(-20, 21) / 100.0) / count;
      const double radius = is_convex ? 30 : *rc::gen::inRange(12, 40);
      star.corners.push_back(
          {std::round(1e3 * radius * std::cos(angle)) / 1e3, std::round(1e3 * radius * std::sin(angle)) / 1e3, 0});
    }
    const Point& corner = star.corners[static_cast<std::size_t>(i % count)];
    star.text += " X" + text(corner.x) + " Y" + text(corner.y) + "\n";
  }
  star.text += "M99\n";
  return star;
}

void check_star(bool is_convex) {
  const Star star = random_star(is_convex);
  const double radius = *rc::gen::inRange(50, 500) / 100.0, step = radius * *rc::gen::inRange(50, 101) / 100.0;
  const double allowance = *rc::gen::inRange(0, 3) / 4.0;
  const std::string letter = *rc::gen::element<std::string>("I", "J");
  const Reading reading = read(
      "F200. G0 Z2.\nG150 P100 X0. Y0. Z-1. R1. " + letter + text(step) + " K" + text(allowance) + " D1\n" + star.text,
      with_tool(2 * radius));
  if (is_convex) RC_ASSERT(reading.problems().empty());
  RC_CLASSIFY(reading.problems().empty());
  std::vector<std::pair<Point, Point>> way;
  for (const Move& move : reading.moves) {
    if (move.kind != Move::Kind::line && move.kind != Move::Kind::arc) continue;
    const std::vector<Point> points = sampled(move);
    for (const Point& point : points) {
      if (point.z >= 1) continue;
      RC_ASSERT(inside(point, star.corners));
      RC_ASSERT(to_loop(point, star.corners) > radius - 1e-5);
    }
    if (points.front().z == -1 && points.back().z == -1) {
      for (std::size_t i = 0; i + 1 < points.size(); ++i) way.emplace_back(points[i], points[i + 1]);
    }
  }
  if (!reading.problems().empty()) return;
  // What the tool's middle can reach is no farther from its way than its radius.
  for (int i = 0; i < 60; ++i) {
    const Point point{*rc::gen::inRange(-4000, 4000) / 100.0, *rc::gen::inRange(-4000, 4000) / 100.0, 0};
    if (!inside(point, star.corners) || to_loop(point, star.corners) < radius + allowance) continue;
    double least = 1e9;
    for (const auto& [a, b] : way) least = std::min(least, to_segment(point, a, b));
    RC_ASSERT(least <= radius + 1e-6);
  }
}

RC_GTEST_PROP(Pockets, OfConvexContoursAreClearedAndKept, ()) {
  check_star(true);
}
RC_GTEST_PROP(Pockets, OfStarsAreClearedAndKeptOrRefused, ()) {
  check_star(false);
}

}  // namespace test_pockets
}  // namespace leadscrew::gcode
