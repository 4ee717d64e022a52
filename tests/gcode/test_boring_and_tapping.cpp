// Canned cycles that turn the spindle, leave the wall, or break chips: their steps in order, in the words that `rs274
// -g` of LinuxCNC 2.9 was seen to print for the same blocks, where it has the cycle.

#include <cmath>
#include <sstream>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_boring_and_tapping {

// "r10,0,2 f10,0,-5 cw dwell0.5": rapids, feeds, spindle events and dwells behind the first rapid.
std::string story(std::string_view text, Dialect dialect = Dialect::leadscrew) {
  std::ostringstream out;
  bool begun = false;
  for (const Move& move : read_well(text, in_dialect(dialect)).moves) {
    using Kind = base::Event::Kind;
    if (move.kind == Move::Kind::dwell) out << "dwell" << move.dwell_seconds << " ";
    if (move.kind == Move::Kind::event && begun) {
      const Kind kind = move.event.kind;
      out << (kind == Kind::spindle_clockwise          ? "cw "
              : kind == Kind::spindle_counterclockwise ? "ccw "
              : kind == Kind::spindle_stop             ? "stop "
              : kind == Kind::pause                    ? "pause "
                                                       : "");
    }
    if (move.kind != Move::Kind::line) continue;
    const Point end = xyz(move.end);
    const auto rounded = [](double value) { return std::round(value * 1e6) / 1e6 + 0.0; };
    if (begun) {
      out << (move.feed.mode == Feed::Mode::rapid ? "r" : "f") << rounded(end.x) << "," << rounded(end.y) << ","
          << rounded(end.z) << " ";
    }
    begun = true;
  }
  std::string text_out = out.str();
  if (!text_out.empty()) text_out.pop_back();
  return text_out;
}

const std::string head = "G21 G90 G99 S1000 M3\nG0 Z10\nF100\n";

TEST(CannedCycles, BreakChips) {
  EXPECT_EQ(story(head + "G73 X40 Z-5 R2 Q2\nM2\n"),
            "r40,0,10 r40,0,2 f40,0,0 r40,0,0.254 f40,0,-2 r40,0,-1.746 f40,0,-4 r40,0,-3.746 f40,0,-5 r40,0,2");
}

TEST(CannedCycles, Tap) {
  EXPECT_EQ(story(head + "G84 X10 Z-5 R2 P0.5\nM2\n"), "r10,0,10 r10,0,2 f10,0,-5 stop ccw dwell0.5 f10,0,2 stop cw");
  EXPECT_EQ(story(head + "M4\nG74 X10 Z-5 R2\nM2\n"), "ccw r10,0,10 r10,0,2 f10,0,-5 stop cw f10,0,2 stop ccw");
}

// The codes of all events behind the first line, with their values.
std::string events_of(const std::string& text) {
  std::string codes;
  for (const Move& move : read_well(text).moves) {
    if (move.kind == Move::Kind::event) codes += std::string(base::code_of(move.event)) + ' ';
  }
  return codes;
}

// LinuxCNC, G84: a tap goes as fast as the spindle turns, whatever the operator asks.
TEST(CannedCycles, TapWithoutOverrides) {
  const std::string tap = "G84 X10 Z-5 R2\nM2\n";
  EXPECT_EQ(events_of("S1000 M3 F100\n" + tap), "S M3 M49 G33 M5 M4 G33 M5 M3 M48 M2 ");
  EXPECT_EQ(events_of("S1000 M3 F100 M50 P0\n" + tap), "S M3 M50 M49 G33 M5 M4 G33 M5 M3 M51 M2 ");
  EXPECT_EQ(events_of("S1000 M3 F100 M51 P0\n" + tap), "S M3 M51 M49 G33 M5 M4 G33 M5 M3 M50 M2 ");
  EXPECT_EQ(events_of("S1000 M3 F100 M49\n" + tap), "S M3 M49 M49 G33 M5 M4 G33 M5 M3 M2 ");
}

// Feeds of the cut, and speeds of the spindle on the way out.
void expect_taps(const std::string& text, Dialect dialect, const std::vector<double>& expected_feeds,
                 const std::vector<double>& expected_speeds) {
  std::vector<double> feeds, speeds;
  for (const Move& move : read_well(text, in_dialect(dialect)).moves) {
    if (move.kind == Move::Kind::line && move.feed.mode != Feed::Mode::rapid) feeds.push_back(move.feed.value);
    if (move.kind == Move::Kind::event && move.event.kind == base::Event::Kind::spindle_counterclockwise)
      speeds.push_back(move.event.value);
  }
  EXPECT_EQ(feeds, expected_feeds) << text;
  EXPECT_EQ(speeds, expected_speeds) << text;
}

TEST(CannedCycles, TapInPecksAndLeaveFaster) {
  EXPECT_EQ(story("S1000 M3\nG0 Z10\nF100\nG98 G84 X10 Z-5 R2 Q3 J2\nX20 Z-1\nM30\n", Dialect::haas),
            "r10,0,10 r10,0,2 f10,0,-1 stop ccw f10,0,2 stop cw f10,0,-4 stop ccw f10,0,2 stop cw f10,0,-5 stop ccw "
            "f10,0,2 stop cw r10,0,10 r20,0,10 r20,0,2 f20,0,-1 stop ccw f20,0,2 stop cw r20,0,10");
  expect_taps("S600 M3\nG84 X10 Z-5 R2 F600 Q4 J3\nM30\n", Dialect::haas, {10, 30, 10, 30}, {1800, 1800});
  const auto problems = [](const std::string& words, Dialect dialect) {
    return read("S600 M3\nG84 X10 Z-5 R2 F600 " + words + "\nM30\n", in_dialect(dialect)).problems();
  };
  EXPECT_EQ(problems("J0.5", Dialect::haas), "2:21 bad-value; ");
  EXPECT_EQ(problems("J10", Dialect::haas), "2:21 bad-value; ");
  EXPECT_EQ(problems("Q0", Dialect::haas), "2:21 bad-value; ");
  EXPECT_EQ(problems("Q2", Dialect::linuxcnc), "2:21 unused-word; ");
}

// Haas' J says how many times as fast, Fanuc's at which speed.
TEST(CannedCycles, LeaveATapAsFastAsTheDialectSays) {
  const std::string begin = "S600 M3\nG84 X10 Z-5 R2 F600 ", end = "\nX20 S800 M3\nM30\n";
  expect_taps(begin + "J2" + end, Dialect::haas, {10, 20, 10, 20}, {1200, 1600});
  expect_taps(begin + "J2" + end, Dialect::leadscrew, {10, 20, 10, 20}, {1200, 1600});
  expect_taps(begin + "J1200" + end, Dialect::fanuc, {10, 20, 10, 15}, {1200, 1200});
  expect_taps(begin + "J600" + "\nM30\n", Dialect::fanuc, {10, 10}, {600});
  const auto problems = [&](const std::string& words) {
    return read(begin + words + "\nX20\nS1000 M3 X30\nM30\n", in_dialect(Dialect::fanuc));
  };
  EXPECT_EQ(problems("J1200").problems(), "");
  EXPECT_EQ(problems("J900").problems(), "4:1 bad-value; ");  // below 1000
  EXPECT_EQ(problems("J1201").problems(), "2:21 bad-value; ");
  EXPECT_EQ(problems("J599").problems(), "2:21 bad-value; ");
  const Reading reading = problems("J2");
  EXPECT_EQ(reading.problems(), "2:21 bad-value; ");
  EXPECT_EQ(reading.diagnostics.front().message, "the spindle is to turn at J2 on the way out, at S600 in");
  EXPECT_EQ(read("G84 X10 Z-5 R2 F600 J600\nM30\n", in_dialect(Dialect::fanuc)).problems(), "1:21 bad-value; ");
}

// Nothing waits for it, and it has the travel in a revolution that F and S give.
TEST(CannedCycles, TapInStepWithTheSpindle) {
  std::vector<base::Event> events;
  for (const Move& move : read_well("S1000 M3 F1250\nG84 X10 Z-5 R2\nM2\n").moves) {
    if (move.kind == Move::Kind::event && move.event.kind == base::Event::Kind::spindle_in_step)
      events.push_back(move.event);
  }
  ASSERT_EQ(events.size(), 2U);
  EXPECT_DOUBLE_EQ(events[0].value, 1.25);
  EXPECT_EQ(events[1].value, 0);
  for (const base::Event& event : events) {
    EXPECT_FALSE(event.waits);
    EXPECT_EQ(event.output, base::in_tapping_cycle);
  }
}

TEST(CannedCycles, OrientTheSpindleWhereTheyLeaveTheWall) {
  EXPECT_EQ(events_of("S1000 M3 F100\nG87 X9 Y9 Z-5 R3 I1 J2 K-3\nM2\n"), "S M3 M5 M19 M3 M5 M19 M3 M2 ");
}

// LinuxCNC feeds out to the clear level, others to R.
TEST(CannedCycles, GoOutAtFeed) {
  const std::string bore = head + "G98 G89 X10 Z-5 R2 P1\nM2\n", down = "r10,0,10 r10,0,2 f10,0,-5 dwell1 ";
  EXPECT_EQ(story(bore, Dialect::linuxcnc), down + "f10,0,10");
  EXPECT_EQ(story(bore, Dialect::mach3), down + "f10,0,2 r10,0,10");
  const std::string tap = head + "G98 G84 X10 Z-5 R2\nM2\n", in = "r10,0,10 r10,0,2 f10,0,-5 stop ccw ";
  EXPECT_EQ(story(tap, Dialect::linuxcnc), in + "f10,0,10 stop cw");
  EXPECT_EQ(story(tap, Dialect::fanuc), in + "f10,0,2 stop cw r10,0,10");
}

// A machine that taps rigidly turns the spindle for the cycle alone.
TEST(CannedCycles, TapWithASpindleThatStood) {
  EXPECT_EQ(story("G0 Z10\nG98 G84 X10 Z-5 R2 F100\nM2\n", Dialect::fanuc),
            "r10,0,10 r10,0,2 f10,0,-5 stop ccw f10,0,2 stop stop r10,0,10");
}

TEST(CannedCycles, Bore) {
  EXPECT_EQ(story(head + "G85 X10 Z-5 R2\nM2\n"), "r10,0,10 r10,0,2 f10,0,-5 f10,0,2");
  EXPECT_EQ(story(head + "G86 X10 Z-5 R2 P0.1\nM2\n"), "r10,0,10 r10,0,2 f10,0,-5 dwell0.1 stop r10,0,2 cw");
  EXPECT_EQ(story(head + "G88 X10 Z-5 R2 P0.1\nM2\n"), "r10,0,10 r10,0,2 f10,0,-5 dwell0.1 stop pause r10,0,2 cw");
  EXPECT_EQ(story(head + "G89 X10 Z-5 R2 P0.2\nM2\n"), "r10,0,10 r10,0,2 f10,0,-5 dwell0.2 f10,0,2");
}

TEST(CannedCycles, BoreFromBehind) {
  const std::string in = "r10,11,3 stop r10,11,-5 r9,9,-5 cw f9,9,-3 f9,9,-5 stop r10,11,-5 r10,11,10 r9,9,10 cw";
  EXPECT_EQ(story(head + "G98 G87 X9 Y9 Z-5 R3 I1 J2 K-3\nM2\n"), "r9,9,10 r9,9,3 " + in);
  EXPECT_EQ(read(head + "G87 X9 Y9 Z-5 R3 I1\nM2\n").problems(), "4:1 missing-word; ");
}

TEST(CannedCycles, BoreFinely) {
  EXPECT_EQ(story(head + "G98 G76 X9 Y9 Z-5 R3 Q0.5\nM2\n", Dialect::fanuc),
            "r9,9,10 r9,9,3 f9,9,-5 stop r9.5,9,-5 r9.5,9,10 r9,9,10 cw");
  for (const char* const q : {"", " Q0"})
    EXPECT_EQ(read(head + "G98 G76 X9 Y9 Z-5 R3" + q + "\nX12\nM2\n", in_dialect(Dialect::fanuc)).problems(),
              "4:5 missing-word; ");
}

TEST(CannedCycles, PeckLessAndLess) {
  EXPECT_EQ(story("G0 Z10\nG99 G83 X1 Z-8 R0 I3 J1 K1.5 F100\nM2\n", Dialect::haas),
            "r1,0,10 r1,0,0 f1,0,-3 r1,0,0 r1,0,-2.746 f1,0,-5 r1,0,0 r1,0,-4.746 f1,0,-6.5 r1,0,0 r1,0,-6.246 "
            "f1,0,-8 r1,0,0");
}

TEST(CannedCycles, FollowPatternsOfHoles) {
  const std::string drill = "G0 Z10\nG99 G81 Z-1 R1 F100 L0\n";
  EXPECT_EQ(story(drill + "G70 I10 J90 L4\nM2\n", Dialect::haas),
            "r0,10,10 r0,10,1 f0,10,-1 r0,10,1 r-10,0,1 f-10,0,-1 r-10,0,1 r0,-10,1 f0,-10,-1 r0,-10,1 r10,0,1 "
            "f10,0,-1 r10,0,1");
  EXPECT_EQ(story(drill + "G71 I10 J0 K90 L2\nM2\n", Dialect::haas),
            "r10,0,10 r10,0,1 f10,0,-1 r10,0,1 r0,10,1 f0,10,-1 r0,10,1");
  EXPECT_EQ(story(drill + "G72 I10 J90 L2\nM2\n", Dialect::haas), "r0,0,1 f0,0,-1 r0,0,1 r0,10,1 f0,10,-1 r0,10,1");
  const Conditions haas = in_dialect(Dialect::haas);
  EXPECT_EQ(read("G70 I10 J0 L4\nM2\n", haas).problems(), "1:1 missing-cycle; ");
}

// Before G98 or G99 has been said.
TEST(CannedCycles, RetractAsTheDialectBegins) {
  const std::string drill = "G21 G90 G0 Z10\nG81 X1 Z-1 R2 F100\nM2\n", down = "r1,0,10 r1,0,2 f1,0,-1 ";
  for (const Dialect dialect : {Dialect::leadscrew, Dialect::linuxcnc})
    EXPECT_EQ(story(drill, dialect), down + "r1,0,2");
  for (const Dialect dialect : {Dialect::fanuc, Dialect::haas, Dialect::mach3})
    EXPECT_EQ(story(drill, dialect), down + "r1,0,10");
}

TEST(CannedCycles, LookAtTheSpindleAsLinuxCncDoes) {
  const Conditions linuxcnc = in_dialect(Dialect::linuxcnc);
  const std::string stands = "G0 Z10\nF100\n";
  EXPECT_EQ(read(stands + "G84 X1 Z-1 R1\nM2\n", linuxcnc).problems(), "3:1 spindle-stands; ");
  EXPECT_EQ(read(stands + "G86 X1 Z-1 R1 P1\nM2\n", linuxcnc).problems(), "3:1 spindle-stands; ");
  EXPECT_EQ(read(head + "M4 G84 X1 Z-1 R1\nM2\n").problems(), "4:4 spindle-turns-back; ");
  EXPECT_EQ(read(head + "G86 X1 Z-1 R1\nM2\n", linuxcnc).problems(), "4:1 missing-word; ");
  EXPECT_EQ(read(head + "G86 X1 Z-1 R1\nM2\n").problems(), "");
}

}  // namespace test_boring_and_tapping
}  // namespace leadscrew::gcode
