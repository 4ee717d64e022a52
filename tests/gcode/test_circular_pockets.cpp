// G12 and G13: where the tool's middle goes, computed by hand.

#include <cmath>
#include <sstream>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_circular_pockets {

Conditions with_tools(Dialect dialect = Dialect::haas) {
  Conditions conditions = in_dialect(dialect);
  machine::Tool tool;
  tool.number = 1;
  tool.diameter = 10;
  conditions.tools = machine::ToolTable({tool});
  return conditions;
}

// "r10,5,2 f10,5,-2 a13,5@11.5,5+": rapids and feeds to X Y Z; arcs to X Y about a centre.
std::string story(const Reading& reading) {
  std::ostringstream out;
  const auto round = [](double value) { return std::round(value * 1e6) / 1e6 + 0.0; };
  for (const Move& move : reading.moves) {
    const Point end = xyz(move.end);
    if (move.kind == Move::Kind::line) {
      out << (move.feed.mode == Feed::Mode::rapid ? 'r' : 'f') << round(end.x) << ',' << round(end.y) << ','
          << round(end.z) << ' ';
    } else if (move.kind == Move::Kind::arc) {
      out << 'a' << round(end.x) << ',' << round(end.y) << '@' << round(move.center_first) << ','
          << round(move.center_second) << (move.turns > 0 ? '+' : '-') << ' ';
    }
  }
  std::string text = out.str();
  if (!text.empty()) text.pop_back();
  return text;
}

std::string story(const std::string& text, Dialect dialect = Dialect::haas) {
  return story(read_well(text, with_tools(dialect)));
}

const std::string head = "G90 G0 X20. Y10. Z1.\n";
const std::string at_start = "r20,10,1 ";

// Behind G40 the tool comes back before it goes down.
TEST(CircularPockets, BeginBesideAContourWhereTheProgramStands) {
  const std::string aside = "F200.\nG41 D1\nG1 X40.\nY40.\nG40\n";
  for (const char* const code : {"G12", "G13"}) {
    const std::string text = story(head + aside + code + " I15. Z-3. D0 F200.\nM30\n");
    EXPECT_NE(text.find("f35,40,1 r40,40,1 f40,40,-3 a"), std::string::npos) << text;
  }
}

TEST(CircularPockets, GoRoundOnce) {
  EXPECT_EQ(story(head + "G13 I15. Z-3. D1 F200.\nM30\n"),
            at_start + "f20,10,-3 a30,10@25,10+ a30,10@20,10+ a20,10@25,10+");
  EXPECT_EQ(story(head + "G12 I15. Z-3. D0 F200.\nM30\n"),
            at_start + "f20,10,-3 a35,10@27.5,10- a35,10@20,10- a20,10@27.5,10-");
}

TEST(CircularPockets, GrowByQUpToK) {
  EXPECT_EQ(story(head + "G13 I8. K15. Q4. Z-3. D1 F200.\nM30\n"), at_start +
                                                                       "f20,10,-3 a23,10@21.5,10+ a23,10@20,10+ "
                                                                       "a13,10@18,10+ a13,10@20,10+ "
                                                                       "a30,10@21.5,10+ a30,10@20,10+ a20,10@25,10+");
}

TEST(CircularPockets, GoDeeperLTimesUnderG91) {
  EXPECT_EQ(story(head + "G91 G12 I7. Z-2. D1 L2 F200.\nM30\n"),
            at_start +
                "f20,10,-1 a22,10@21,10- a22,10@20,10- a20,10@21,10- "
                "f20,10,-3 a22,10@21,10- a22,10@20,10- a20,10@21,10-");
}

TEST(CircularPockets, GoToTheirMiddleAtRapid) {
  EXPECT_EQ(story("F200.\nG12 X5. Y6. I7. Z-2. D1\nG1 X0\nM30\n"),
            "r5,6,0 f5,6,-2 a7,6@6,6- a7,6@5,6- a5,6@6,6- f0,6,-2");
}

TEST(CircularPockets, TakeTheDThatStoodBefore) {
  EXPECT_EQ(story("F200.\nG43 H1 D1\nG12 I7.\nM30\n"), "a2,0@1,0- a2,0@0,0- a0,0@1,0-");
  EXPECT_EQ(read("F200.\nG12 I7.\nM30\n", with_tools()).problems(), "2:1 missing-word; ");
}

TEST(CircularPockets, AreInInches) {
  EXPECT_EQ(story("G20\nF20.\nG12 I1. D0\nM30\n"), "a25.4,0@12.7,0- a25.4,0@0,0- a0,0@12.7,0-");
}

// Turned by 90 degrees, mirrored, and scaled.
TEST(CircularPockets, AreTransformed) {
  EXPECT_EQ(story("F200.\nG68 X0 Y0 R90.\nG12 I7. D1\nM30\n"), "a0,2@0,1- a0,2@0,0- a0,0@0,1-");
  EXPECT_EQ(story("F200.\nG101 X0\nG12 I7. D1\nM30\n"), "a-2,0@-1,0+ a-2,0@0,0+ a0,0@-1,0+");
}

// G51 scales the circle; the tool, of radius 5, stays as it is.
TEST(CircularPockets, AreScaledButNotTheirTool) {
  EXPECT_EQ(story("F200.\nG51 X0 Y0 P3.\nG12 I7. D1\nM30\n"), "a16,0@8,0- a16,0@0,0- a0,0@8,0-");
  EXPECT_EQ(story("F200.\nG51 X0 Y0 P3.\nG13 I2. D1\nM30\n"), "a1,0@0.5,0+ a1,0@0,0+ a0,0@0.5,0+");
  EXPECT_EQ(story("F200.\nG51 X0 Y0 P0.5\nG12 I20. D1\nM30\n"), "a5,0@2.5,0- a5,0@0,0- a0,0@2.5,0-");
  EXPECT_EQ(story("F200.\nG51 X0 Y0 I-2. J2.\nG12 I7. D1\nM30\n"), "a-9,0@-4.5,0+ a-9,0@0,0+ a0,0@-4.5,0+");
  const Reading small = read("F200.\nG51 X0 Y0 P0.5\nG12 I8. D1\nM30\n", with_tools());
  EXPECT_EQ(small.problems(), "3:5 bad-value; ");
  EXPECT_EQ(small.diagnostics.front().message, "G12 has I8, which G51 scales by 0.5, with a tool of radius 5 mm");
}

// Every point of the pocket is nearer to the tool's way than its radius, and none outside is.
TEST(CircularPockets, ClearTheWholeCircle) {
  const Reading reading = read_well("F200.\nG13 I8. K21. Q9. D1\nM30\n", with_tools());
  const auto distance = [&](double x, double y) {
    double least = 1e9;
    for (const Move& arc : reading.arcs()) {
      if (arc.start != arc.end) continue;
      const double radius = std::hypot(xyz(arc.end).x - arc.center_first, xyz(arc.end).y - arc.center_second);
      least = std::min(least, std::fabs(std::hypot(x - arc.center_first, y - arc.center_second) - radius));
    }
    return least;
  };
  for (double radius = 0; radius <= 21; radius += 0.25) EXPECT_LE(distance(radius, 0), 5 + 1e-9) << radius;
  EXPECT_NEAR(distance(21, 0), 5, 1e-9);
  EXPECT_GT(distance(21.1, 0), 5);
}

TEST(CircularPockets, RefuseWhatIsNone) {
  const auto problems = [](const std::string& block) {
    return read("F200.\n" + block + "\nM30\n", with_tools()).problems();
  };
  EXPECT_EQ(problems("G12 Z-1. D1"), "2:1 missing-word; ");
  EXPECT_EQ(problems("G12 I5. D1"), "2:5 bad-value; ");
  EXPECT_EQ(problems("G12 I8. K7. Q1. D1"), "2:9 bad-value; ");
  EXPECT_EQ(problems("G12 I8. K9. D1"), "2:1 missing-word; ");
  EXPECT_EQ(problems("G12 I8. K9. Q0 D1"), "2:13 bad-value; ");
  EXPECT_EQ(problems("G12 I8. K9. Q0.00001 D1"), "2:13 bad-value; ");
  EXPECT_EQ(problems("G12 I8. D2"), "2:9 unknown-tool; ");
  EXPECT_EQ(problems("G18 G12 I8. D1"), "2:5 bad-plane; ");
  EXPECT_EQ(problems("G12 I8. L0.5 D1"), "2:9 bad-value; ");
  EXPECT_EQ(problems("G12 I600. D1"), "2:1 travel; ");
  EXPECT_EQ(problems("G91 G12 I8. Z-300. L3 D1"), "2:1 travel; ");
  EXPECT_EQ(problems("G51 X0 Y0 I1. J2.\nG12 I8. D1"), "3:1 unsupported-rotation; ");
  EXPECT_EQ(read("G12 I8. D1\nM30\n", with_tools()).problems(), "1:1 missing-feed; ");
  EXPECT_EQ(read("F9\nG12 I8. D1\nM30\n", in_dialect(Dialect::haas)).problems(), "2:9 no-tool-table; ");
}

// A cycle that is refused moves nothing.
TEST(CircularPockets, ThatAreRefusedDoNotMove) {
  EXPECT_TRUE(read("F200.\nG12 I8. K600. Q10. D1\nM30\n", with_tools()).arcs().empty());
}

TEST(CirclesOfMach3, GoOutAlongX) {
  EXPECT_EQ(story("F200\nG0 X3 Y4\nG13 I5\nM30\n", Dialect::mach3), "r3,4,0 f8,4,0 a8,4@3,4+ f3,4,0");
  EXPECT_EQ(read("F200\nG12 I5 K6\nM30\n", with_tools(Dialect::mach3)).problems(), "2:8 unused-word; ");
}

}  // namespace test_circular_pockets
}  // namespace leadscrew::gcode
