// G47: where letters lie, by hand; that every character of the font is drawn within its field.

#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/stroke_font.hpp>
#include <sstream>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_engraving {

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

Reading engraved(const std::string& words, const std::string& before = "") {
  return read_well(before + "F300.\nG0 Z5.\nG47 " + words + "\nM30\n", in_dialect(Dialect::haas));
}

TEST(Engraving, DrawsStrokesAndLiftsBetweenThem) {
  EXPECT_EQ(story(engraved("P0 X10. Y20. J12. R1. Z-0.5 E60. (LT)")),
            "r0,0,5 r10,32,5 r10,32,1 f10,32,-0.5 f10,20,-0.5 f18,20,-0.5 r18,20,1 "
            "r26,20,1 f26,20,-0.5 f26,32,-0.5 r26,32,1 r22,32,1 f22,32,-0.5 f30,32,-0.5 r30,32,1");
}

TEST(Engraving, PlungesByE) {
  const std::vector<Move> lines = engraved("P0 X0 Y0 J12. R1. Z-0.5 E60. (I)").lines();
  EXPECT_EQ(lines[3].feed.value, 1);
  EXPECT_EQ(lines[4].feed.value, 5);
  EXPECT_EQ(engraved("P0 X0 Y0 J12. R1. Z-0.5 (I)").lines()[3].feed.value, 5);
}

TEST(Engraving, IsTurnedByI) {
  EXPECT_EQ(story(engraved("P0 X10. Y20. I90. J12. R1. Z-0.5 (L)")),
            "r0,0,5 r-2,20,5 r-2,20,1 f-2,20,-0.5 f10,20,-0.5 f10,28,-0.5 r10,28,1");
}

// A P: half a circle of radius 3 about 5 9.
TEST(Engraving, DrawsArcs) {
  const Reading reading = engraved("P80 X0. Y0. J12. R1. Z-0.5");
  EXPECT_EQ(story(reading), "r0,0,5 r0,0,1 f0,0,-0.5 f0,12,-0.5 f5,12,-0.5 a5,6,-0.5 f0,6,-0.5 r0,6,1");
  const Move arc = reading.arcs().at(0);
  EXPECT_NEAR(arc.center_first, 5, 1e-12);
  EXPECT_NEAR(arc.center_second, 9, 1e-12);
  EXPECT_EQ(arc.turns, -1);
}

TEST(Engraving, CountsNumbers) {
  const std::string block = "G47 P1 X0 Y0 J12. R1. Z-0.5 (####)\n";
  const auto number = [](const Reading& reading) { return story(reading); };
  const Reading twice = read_well("F300.\n#599=41\nG0 Z5.\n" + block + block + "M30\n", in_dialect(Dialect::haas));
  const Reading text =
      read_well("F300.\nG0 Z5.\nG47 P0 X0 Y0 J12. R1. Z-0.5 (0041)\nG47 P0 X0 Y0 J12. R1. Z-0.5 (0042)\nM30\n",
                in_dialect(Dialect::haas));
  EXPECT_EQ(number(twice), number(text));
}

TEST(Engraving, RefusesWhatItCannotDraw) {
  const auto problems = [](const std::string& words) {
    return read("F300.\nG47 " + words + "\nM30\n", in_dialect(Dialect::haas)).problems();
  };
  EXPECT_EQ(problems("P0 X0 Y0 Z-1. R1."), "2:1 bad-text; ");
  EXPECT_EQ(problems("P0 X0 Y0 Z-1. R1. (\xC3\xA4)"), "2:1 bad-text; ");
  EXPECT_EQ(problems("P1 X0 Y0 Z-1. R1. (12)"), "2:1 bad-text; ");
  EXPECT_EQ(read("F300.\n#599=100\nG47 P1 X0 Y0 Z-1. R1. (##)\nM30\n", in_dialect(Dialect::haas)).problems(),
            "3:1 bad-text; ");
  EXPECT_EQ(problems("P2 X0 Y0 Z-1. R1. (A)"), "2:5 bad-value; ");
  EXPECT_EQ(problems("P0 X0 Y0 R1. (A)"), "2:1 missing-word; ");
  EXPECT_EQ(problems("X0 Y0 Z-1. R1. (A)"), "2:1 missing-word; ");
  EXPECT_EQ(problems("P0 Z-1. R1. J0 (A)"), "2:17 bad-value; ");
  EXPECT_EQ(problems("P0 Z-1. R1. I400. (A)"), "2:17 bad-value; ");
  EXPECT_EQ(problems("P0 Z2. R1. (A)"), "2:8 cycle-levels; ");
  EXPECT_EQ(problems("P0 X490. Z-1. R1. (AAAA)"), "2:1 travel; ");
  EXPECT_EQ(read("G47 P0 Z-1. R1. (A)\nM30\n", in_dialect(Dialect::haas)).problems(), "1:1 missing-feed; ");
}

TEST(StrokeFont, HasAllOfAsciiWithinItsField) {
  EXPECT_FALSE(strokes_of('\x1F'));
  EXPECT_FALSE(strokes_of('\x7F'));
  EXPECT_FALSE(strokes_of('\xC3'));
  std::vector<std::string> shapes;
  for (char each = ' '; each <= '~'; ++each) {
    const auto strokes = strokes_of(each);
    ASSERT_TRUE(strokes) << each;
    EXPECT_EQ(strokes->empty(), each == ' ') << each;
    std::ostringstream shape;
    for (const Stroke& stroke : *strokes) {
      EXPECT_FALSE(stroke.steps.empty()) << each;
      PlanePoint from = stroke.start;
      shape << "M" << from.first << "," << from.second;
      for (const Stroke::Step& step : stroke.steps) {
        PlaneBox box{step.to, step.to};
        if (step.turn != 0) {
          EXPECT_NEAR(std::hypot(from.first - step.center.first, from.second - step.center.second),
                      std::hypot(step.to.first - step.center.first, step.to.second - step.center.second), 1e-12)
              << each;
          box = arc_extent(from, step.to, step.center, step.turn);
          // Halves and quarters, no more.
          EXPECT_LT(sweep(from, step.to, step.center, step.turn), 3.15) << each;
        }
        EXPECT_GE(box.low.first, -1e-12) << each;
        EXPECT_GE(box.low.second, -1e-12) << each;
        EXPECT_LE(box.high.first, 8.0 / 12 + 1e-12) << each;
        EXPECT_LE(box.high.second, 1 + 1e-12) << each;
        from = step.to;
        shape << "L" << from.first << "," << from.second << "/" << step.turn;
      }
    }
    shapes.push_back(shape.str());
  }
  // No two look alike.
  std::sort(shapes.begin(), shapes.end());
  EXPECT_EQ(std::adjacent_find(shapes.begin(), shapes.end()), shapes.end());
}

}  // namespace test_engraving
}  // namespace leadscrew::gcode
