// Motion in step with the spindle: G33, G33.1 and G76. Feeds, leads and depths are closed forms: lead × S, J·n^(1/R),
// √(E² + K²)/E of a taper; where the tool goes was seen of rs274 of LinuxCNC 2.9 as well (tests/peer).

#include <cmath>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_threading {

using Kind = base::Event::Kind;

std::vector<base::Event> events_in_step(const Reading& reading) {
  std::vector<base::Event> found;
  for (const base::Event& event : reading.events()) {
    if (event.kind == Kind::spindle_in_step || event.kind == Kind::rigid_tap) found.push_back(event);
  }
  return found;
}

// Where a pass of G76 cuts: X of the lines at feed that go along Z alone.
std::vector<double> depths(const Reading& reading) {
  std::vector<double> found;
  for (const Move& line : reading.lines()) {
    const bool along_z = at(line.start, base::Axis::X) == at(line.end, base::Axis::X);
    if (line.feed.mode != Feed::Mode::rapid && along_z) found.push_back(at(line.end, base::Axis::X));
  }
  return found;
}

const std::string turning = "G21 G90 G18 S600 M3\n";
const std::string at_start = turning + "G0 X20 Z5\n";

TEST(Threading, GoesItsLeadInARevolution) {
  const Reading reading = read_well(turning + "G33 Z-15 K1.5\nM2\n");
  ASSERT_EQ(reading.lines().size(), 1);
  EXPECT_EQ(reading.lines()[0].feed.mode, Feed::Mode::units_per_second);
  EXPECT_DOUBLE_EQ(reading.lines()[0].feed.value, 1.5 * 600 / 60);
  const auto events = events_in_step(reading);
  ASSERT_EQ(events.size(), 2);
  EXPECT_EQ(events[0].kind, Kind::spindle_in_step);
  EXPECT_EQ(events[0].value, 1.5);
  EXPECT_TRUE(events[0].waits);
  EXPECT_EQ(events[1].value, 0);
  EXPECT_TRUE(events[1].waits);
}

TEST(Threading, LeadIsInTheUnitsOfTheProgram) {
  const Reading reading = read_well("G20 G90 S120 M4\nG33 Z-1 K0.05\nM2\n");
  EXPECT_DOUBLE_EQ(reading.lines()[0].feed.value, 0.05 * 25.4 * 120 / 60);
  EXPECT_DOUBLE_EQ(events_in_step(reading)[0].value, 0.05 * 25.4);
}

// K counts along the line, not along Z.
TEST(Threading, ATaperGoesTheLeadAlongItself) {
  EXPECT_DOUBLE_EQ(read_well(turning + "G33 X3 Z-4 K2\nM2\n").lines()[0].feed.value, 2 * 600 / 60.0);
}

// F of the blocks around it stays what it was.
TEST(Threading, KeepsTheFeed) {
  const std::vector<Move> lines = read_well(turning + "G1 X1 F120\nG33 Z-4 K1\nG1 X2\nM2\n").lines();
  EXPECT_DOUBLE_EQ(lines[1].feed.value, 10);
  EXPECT_DOUBLE_EQ(lines[2].feed.value, 2);
}

TEST(Threading, FanucTakesTheLeadFromF) {
  const Reading reading = read_well("G21 G90 S60 M3\nG33 Z-4. F2.\nM30\n", in_dialect(Dialect::fanuc));
  EXPECT_DOUBLE_EQ(reading.lines()[0].feed.value, 2);
}

TEST(Threading, RepeatedBlocksNeedTheirLead) {
  EXPECT_EQ(read_well(turning + "G33 Z-4 K1\nZ-8 K2\nM2\n").lines().size(), 2);
  EXPECT_EQ(read(turning + "G33 Z-4 K1\nZ-8\nM2\n").problems(), "3:1 missing-word; ");
}

TEST(Threading, RefusesWhatWouldMakeNoThread) {
  EXPECT_EQ(read("G33 Z-1 K1\nM2\n").problems(), "1:1 spindle-stands; ");
  EXPECT_EQ(read("M3\nG33 Z-1 K1\nM2\n").problems(), "2:1 spindle-stands; ");
  EXPECT_EQ(read(turning + "G33 Z-1\nM2\n").problems(), "2:1 missing-word; ");
  EXPECT_EQ(read(turning + "G33 K1\nM2\n").problems(), "2:1 missing-word; ");
  EXPECT_EQ(read(turning + "G33 Z-1 K1 F20\nM2\n").problems(), "2:12 unused-word; ");
  EXPECT_EQ(read(turning + "G33 Z-1 K-1\nM2\n").problems(), "2:9 bad-value; ");
  EXPECT_EQ(read(turning + "G33.1 Z-1 A3 K1\nM2\n").problems(), "2:11 unused-word; ");
}

// An axis does 200 mm/s: K4 is that at S3000.
TEST(Threading, RefusesWhatAnAxisCannotFollow) {
  EXPECT_EQ(read("S3000 M3\nG33 Z-9 K4\nM2\n").problems(), "");
  const Reading reading = read("S3001 M3\nG33 Z-9 K4\nM2\n");
  EXPECT_EQ(reading.problems(), "2:1 thread-too-fast; ");
  EXPECT_NE(reading.diagnostics.front().hint.find("S3000"), std::string::npos);
  // Along a slope of 3 in 4 of 5, Z goes 4/5 of the lead.
  EXPECT_EQ(read("S3750 M3\nG33 X3 Z-4 K4\nM2\n").problems(), "");
  EXPECT_EQ(read("S3751 M3\nG33 X3 Z-4 K4\nM2\n").problems(), "2:1 thread-too-fast; ");
  // A tap leaves I times as fast.
  EXPECT_EQ(read("S2000 M3\nG33.1 Z-9 K4 I2\nM2\n").problems(), "2:1 thread-too-fast; ");
}

TEST(RigidTapping, GoesInAndOut) {
  const Reading reading = read_well("G21 G90 S120 M3\nG0 Z3\nG33.1 Z-9 K1.25 I2\nM2\n");
  const std::vector<Move> lines = reading.lines();
  ASSERT_EQ(lines.size(), 3);
  EXPECT_EQ(xyz(lines[1].end), (Point{0, 0, -9}));
  EXPECT_DOUBLE_EQ(lines[1].feed.value, 2.5);
  EXPECT_EQ(xyz(lines[2].end), (Point{0, 0, 3}));
  EXPECT_DOUBLE_EQ(lines[2].feed.value, 5);
  std::vector<base::Event> events = reading.events();
  ASSERT_EQ(events.size(), 7);  // S, M3, the tap, out, as before, free, M2
  EXPECT_EQ(events[2].kind, Kind::rigid_tap);
  EXPECT_EQ(events[2].value, 1.25);
  EXPECT_EQ(events[3].kind, Kind::spindle_counterclockwise);
  EXPECT_EQ(events[3].value, 240);
  EXPECT_EQ(events[4].kind, Kind::spindle_clockwise);
  EXPECT_EQ(events[4].value, 120);
  EXPECT_EQ(events[5].kind, Kind::spindle_in_step);
  EXPECT_EQ(events[5].value, 0);
}

// The crest at X19, and J·n^(1/R) below it, until K.
TEST(ThreadingCycle, DepthsOfEqualArea) {
  const std::vector<double> found = depths(read_well(at_start + "G76 P1 Z-10 I-1 J0.2 K0.5 R2\nM2\n"));
  ASSERT_EQ(found.size(), 7);
  for (int pass = 1; pass <= 6; ++pass)
    EXPECT_NEAR(found[static_cast<std::size_t>(pass - 1)], 19 - 0.2 * std::sqrt(pass), 1e-12);
  EXPECT_NEAR(found.back(), 18.5, 1e-12);
}

TEST(ThreadingCycle, SpringPassesAreAtFullDepth) {
  const std::vector<double> found = depths(read_well(at_start + "G76 P1 Z-10 I2 J0.4 K0.5 H2\nM2\n"));
  ASSERT_EQ(found.size(), 4);
  EXPECT_NEAR(found[0], 22.4, 1e-12);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_NEAR(found[i], 22.5, 1e-12);
}

// Each pass begins (K − depth)·tan Q behind the last, so that the leading flank cuts.
TEST(ThreadingCycle, CompoundSlideShiftsPasses) {
  const std::vector<Move> lines = read_well(at_start + "G76 P1 Z-10 I-1 J0.4 K0.5 Q30\nM2\n").lines();
  const double slope = 1 / std::sqrt(3.0);
  EXPECT_NEAR(at(lines[1].end, base::Axis::Z), 5 - 0.4 * slope, 1e-12);
  EXPECT_NEAR(at(lines[3].end, base::Axis::Z), -10 + 0.1 * slope, 1e-12);
  EXPECT_EQ(xyz(lines.back().end), (Point{20, 0, -10}));
}

// On the taper Z goes on with the pitch: the tool goes √(E² + K²)/E of it.
TEST(ThreadingCycle, TapersKeepThePitchAlongZ) {
  const Reading reading = read_well(at_start + "G76 P1.5 Z-10 I-1 J0.25 K0.5 E1.2 L3\nM2\n");
  const double taper_lead = 1.5 * std::hypot(1.2, 0.5) / 1.2;
  const auto events = events_in_step(reading);
  ASSERT_EQ(events.size(), 8);
  const double expected[] = {taper_lead, 1.5, taper_lead, 0};
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_DOUBLE_EQ(events[i].value, expected[i % 4]);
    EXPECT_EQ(events[i].waits, i % 4 == 0 || i % 4 == 3);
  }
  for (const Move& line : reading.lines()) {
    const double x = at(line.end, base::Axis::X) - at(line.start, base::Axis::X);
    const double z = at(line.end, base::Axis::Z) - at(line.start, base::Axis::Z);
    if (line.feed.mode == Feed::Mode::rapid || z == 0) continue;
    EXPECT_NEAR(line.feed.value * std::fabs(z) / std::hypot(x, z), 1.5 * 600 / 60, 1e-12);
  }
}

// I, J and K are diameters in G7.
TEST(ThreadingCycle, OfDiameters) {
  const std::vector<double> radii = depths(read_well(at_start + "G76 P1 Z-10 I-1 J0.2 K0.5 R2\nM2\n"));
  const std::vector<double> diameters = depths(read_well(turning + "G7 G0 X40 Z5\nG76 P1 Z-10 I-2 J0.4 K1 R2\nM2\n"));
  EXPECT_EQ(radii, diameters);
}

TEST(ThreadingCycle, GoesWithTurnedCoordinates) {
  const std::vector<Move> lines =
      read_well("G10 L2 P1 R90\nG90 S60 M3\nG0 X20 Z5\nG76 P1 Z-10 I-1 J0.2 K0.5\nM2\n").lines();
  EXPECT_NEAR(at(lines[2].end, base::Axis::Y), 18.8, 1e-12);
  EXPECT_NEAR(at(lines[2].end, base::Axis::X), 0, 1e-12);
}

TEST(ThreadingCycle, RefusesWhatMakesNoThread) {
  const auto problems = [](std::string_view words) {
    return read(at_start + "G76 " + std::string(words) + "\nM2\n").problems();
  };
  EXPECT_EQ(problems("Z-10 I-1 J0.2 K0.5"), "3:1 missing-word; ");
  EXPECT_EQ(problems("P1 I-1 J0.2 K0.5"), "3:1 missing-word; ");
  EXPECT_EQ(problems("P0 Z-10 I-1 J0.2 K0.5"), "3:5 bad-value; ");
  EXPECT_EQ(problems("P1 Z-10 I0 J0.2 K0.5"), "3:13 bad-value; ");
  EXPECT_EQ(problems("P1 Z-10 I-1 J0 K0.5"), "3:17 bad-value; ");
  EXPECT_EQ(problems("P1 Z-10 I-1 J0.5 K0.5"), "3:22 bad-value; ");
  EXPECT_EQ(problems("P1 Z-10 I-1 J0.2 K0.5 R0.5"), "3:27 bad-value; ");
  EXPECT_EQ(problems("P1 Z-10 I-1 J0.2 K0.5 L4"), "3:27 bad-value; ");
  EXPECT_EQ(problems("P1 Z-10 I-1 J0.2 K0.5 H0.5"), "3:27 bad-value; ");
  EXPECT_EQ(problems("P1 Z-10 I-1 J0.2 K0.5 E8 L3"), "3:27 bad-value; ");
  EXPECT_EQ(problems("P1 Z-10 I-1 J0.2 K0.5 B3"), "3:27 unused-word; ");
  EXPECT_EQ(problems("P1 Z-10 I-1 J0.0001 K0.5 R2"), "3:1 too-many-passes; ");
  EXPECT_EQ(problems("P1 Z-600 I-1 J0.2 K0.5"), "3:8 travel; ");
  EXPECT_EQ(problems("P30 Z-10 I-1 J0.2 K0.5"), "3:1 thread-too-fast; ");
}

}  // namespace test_threading
}  // namespace leadscrew::gcode
