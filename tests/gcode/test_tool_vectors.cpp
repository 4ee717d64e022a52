#include <cmath>
#include <leadscrew/gcode/canon.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <numbers>

#include "reading.hpp"

// G43.5: lines that tell the tool's direction by I, J and K.

namespace leadscrew::gcode {
namespace test_tool_vectors {

/// A trunnion table: A carries C, both turn the part; all nine axes.
Conditions trunnion() {
  Conditions conditions;
  conditions.machine.kinematics = "table-table-ac";
  conditions.machine.rotary_chain = machine::preset_chain("table-table-ac");
  machine::Tool tool;
  tool.number = 1;
  tool.offset[2] = 50;
  conditions.tools = machine::ToolTable({tool});
  return conditions;
}

Reading read_vectors(const std::string& text, const Conditions& conditions = trunnion()) {
  return read("F600 G43.5 H1\n" + text + "M2\n", conditions);
}

constexpr std::size_t a = base::index(base::Axis::A), c = base::index(base::Axis::C);

TEST(ToolVectors, BecomeAnglesOfTheRotaryAxes) {
  const Reading reading = read_vectors("G0 X1 Y2 Z3 I0 J-1 K1\n");
  EXPECT_EQ(reading.problems(), "");
  ASSERT_EQ(reading.lines().size(), 1U);
  const Move line = reading.lines().front();
  EXPECT_TRUE(line.is_of_tip);
  EXPECT_EQ(line.end[0], 1);
  EXPECT_EQ(line.end[2], 3);
  EXPECT_NEAR(std::abs(line.end[a]), 45, 1e-9);
  EXPECT_NEAR(std::abs(std::sin(line.end[c] * std::numbers::pi / 180)), 0, 1e-9);
}

TEST(ToolVectors, AreOfAnyLengthAndLackingLettersAreNone) {
  const auto end_of = [](const std::string& text) { return read_vectors(text).lines().back().end; };
  const base::AxisVector end = end_of("G0 X1 I0 J-1 K1\n");
  EXPECT_EQ(end_of("G0 X1 J-1 K1\n"), end);
  EXPECT_EQ(end_of("G0 X1 J-1000 K1000\n"), end);
  EXPECT_EQ(end_of("G0 X1 J-0.0000000000000001 K0.0000000000000001\n"), end);
  EXPECT_EQ(end_of("G0 X0.5 J-1 K1\nG1 X1\n"), end);
  EXPECT_EQ(end_of("G20 G0 X0.5 J-1 K1\n"), end_of("G0 X12.7 J-1 K1\n"));
}

/// Coordinates are turned and mirrored, and the tool with them; what scales them leaves directions alone.
TEST(ToolVectors, TurnAndMirrorAsCoordinatesDo) {
  const base::AxisVector plain = read_vectors("G0 X1 Y0 I0 J-1 K1\n").lines().back().end;
  const base::AxisVector turned = read_vectors("G68 X0 Y0 R90\nG0 X0 Y-1 I-1 J0 K1\n").lines().back().end;
  const base::AxisVector system = read_vectors("G10 L2 P1 R90\nG0 X0 Y-1 I-1 J0 K1\n").lines().back().end;
  const base::AxisVector mirrored = read_vectors("G51.1 Y0\nG0 X1 Y0 I0 J1 K1\n").lines().back().end;
  const base::AxisVector scaled = read_vectors("G51 X0 Y0 Z0 I2 J3 K0.5\nG0 X0.5 Y0 I0 J-1 K1\n").lines().back().end;
  for (std::size_t i = 0; i < base::axis_count; ++i) {
    EXPECT_NEAR(turned[i], plain[i], 1e-9) << i;
    EXPECT_NEAR(system[i], plain[i], 1e-9) << i;
    EXPECT_NEAR(mirrored[i], plain[i], 1e-9) << i;
    EXPECT_NEAR(scaled[i], plain[i], 1e-9) << i;
  }
}

TEST(ToolVectors, LeadAlongTheGreatCircleInSmallParts) {
  const Reading reading = read_vectors("G0 X0 Y0 J-1 K1\nG1 X10 J-1 K0.2\n");
  EXPECT_EQ(reading.problems(), "");
  const std::vector<Move> lines = reading.lines();
  ASSERT_GT(lines.size(), 30U);
  for (std::size_t k = 1; k < lines.size(); ++k) {
    EXPECT_EQ(lines[k].start, lines[k - 1].end);
    EXPECT_LE(std::abs(lines[k].end[a] - lines[k].start[a]), 1 + 1e-9);
    EXPECT_EQ(base::number(lines[k].line), 3);
  }
  EXPECT_EQ(lines.back().end[0], 10);
  EXPECT_NEAR(std::abs(lines.back().end[a]), std::atan(5) * 180 / std::numbers::pi, 1e-9);
}

/// On the exact path motion would rest between lines.
TEST(ToolVectors, BecomeOneCurveOnTheExactPath) {
  const Reading reading = read_vectors("G61 G0 X0 Y0 J-1 K1\nG1 X10 J-1 K0.2\nX20\n");
  const std::vector<Move> curves = reading.of(Move::Kind::nurbs);
  ASSERT_EQ(curves.size(), 1U);
  EXPECT_EQ(curves[0].curve.degree, 3);
  EXPECT_EQ(curves[0].curve.points.front().position, curves[0].start);
  EXPECT_EQ(curves[0].curve.points.back().position, curves[0].end);
  for (const ControlPoint& point : curves[0].curve.points) EXPECT_EQ(point.weight, 1);
  EXPECT_EQ(reading.lines().back().end[0], 20);
}

/// Feed of a duration is shared among the parts of a line.
TEST(ToolVectors, KeepTheDurationOfInverseTime) {
  for (const char* const line : {"G1 X10 J-1 K0.2 F6\n", "G1 J-1 K0.2 F6\n"}) {
    const Reading reading = read_vectors(std::string("G93 G0 X0 Y0 J-1 K1\n") + line);
    double seconds = 0;
    for (const Move& move : reading.lines()) {
      if (move.feed.mode == Feed::Mode::per_second) seconds += 1 / move.feed.value;
    }
    EXPECT_NEAR(seconds, 10, 1e-9) << line;
  }
}

std::string order_of(const Reading& reading) {
  std::string order;
  for (const Move& move : reading.moves) {
    const char what = move.kind == Move::Kind::event ? 'e' : move.kind == Move::Kind::dwell ? 'd' : 'l';
    const std::string told = what + std::to_string(base::number(move.line)) + " ";
    if (!order.ends_with(told)) order += told;
  }
  return order;
}

TEST(ToolVectors, KeepEventsInTheirOrder) {
  const Reading reading =
      read_vectors("G0 X0 J-1 K1\nS100\nG1 X1 J-1 K1.1 M8\nM62 P1\nM64 P2\nX2 J-1 K1.2 S200\nG4 P1\nX3 J-1 K1.3\nM9\n");
  EXPECT_EQ(reading.problems(), "");
  EXPECT_EQ(order_of(reading), "l2 e3 e4 l4 e5 e6 e7 l7 d8 l9 e10 e11 ");
}

/// What asks where rotary axes are is told where the lines before it have led them.
TEST(ToolVectors, AreDecidedWhereRotaryAxesAreAskedFor) {
  const std::string prints = "(PRINT,%.3f#5423 %.3f#<_abs_y>)\n";
  std::string said;
  Conditions conditions = trunnion();
  conditions.options.remarks = [&](const Remark& remark) { said += remark.text + ";"; };
  read_vectors("G0 X0 Y0 Z0 J-1 K1\nG1 X10 J-0.5 K1\n" + prints + "G1 X20 J-0.2 K1\n", conditions);
  EXPECT_EQ(said, "-26.565 0.000;");
  said.clear();
  read_vectors("G0 X0 Y0 Z0 J-1 K1\n#1=#5423\nG1 X[#1/-45]\n(PRINT,%.3f#5420)\n", conditions);
  EXPECT_EQ(said, "1.000;");
}

/// The axes stand where they stood, and axis words are those of the axes again.
TEST(ToolVectors, EndWithG49) {
  const Reading reading = read_vectors("G0 X10 Y0 Z0 J-1 K1\nG49\nG0 X10\n");
  EXPECT_EQ(reading.problems(), "");
  const std::vector<Move> lines = reading.lines();
  for (const Move& line : lines) EXPECT_EQ(line.is_of_tip, base::number(line.line) == 2);
  EXPECT_EQ(read_vectors("G49\nG1 X1 I1\n").problems(), "3:7 unused-word; ");
}

/// A rapid begins where the rest goes on best: the table may turn C by no more than ±100°.
TEST(ToolVectors, ChooseTheBeginningForAllOfARun) {
  Conditions conditions = trunnion();
  conditions.machine.axes[c]->travel_min = -100;
  conditions.machine.axes[c]->travel_max = 100;
  // From here the nearer angle is C-90, from which the tool turns to C-180.
  const std::string turning = "F600\nG0 C-50\nG43.5 H1\nG0 X0 Y0 I1 J0 K2\nG1 X10 I0 J1 K2\nX20 I-1 J0 K2\n";
  const Reading chosen = read(turning + "M2\n", conditions);
  EXPECT_EQ(chosen.problems(), "");
  EXPECT_NEAR(chosen.lines().at(1).end[c], 90, 1e-9);
  EXPECT_NEAR(chosen.lines().back().end[c], -90, 1e-9);
  const Reading reading = read(turning + "X40 I0 J-1 K2\nM2\n", conditions);
  ASSERT_EQ(reading.diagnostics.size(), 1U);
  EXPECT_EQ(reading.diagnostics[0].code, "rotary-travel");
  EXPECT_EQ(reading.diagnostics[0].place.line, 7);
  EXPECT_EQ(reading.diagnostics[0].place.column, 5);
  EXPECT_NE(reading.diagnostics[0].message.find("axis C would leave its travel here"), std::string::npos);
  EXPECT_NE(reading.diagnostics[0].message.find("line 4"), std::string::npos);
  EXPECT_EQ(reading.diagnostics[0].source, "X40 I0 J-1 K2");
}

/// Linear axes are looked at once the angles are known; the place is that of the line all the same.
TEST(ToolVectors, TellTravelAtTheirOwnBlock) {
  Conditions conditions = trunnion();
  for (machine::RotaryAxis& axis : conditions.machine.rotary_chain->axes) axis.point = {0, 0, -400};
  const Reading reading = read_vectors("G0 X0 Y0 Z0 J-1 K1\nG1 X10 Y400 Z300 J-1 K0.3\nX20\nG4 P1\n", conditions);
  EXPECT_EQ(reading.problems(), "3:18 travel; 3:18 travel; ");
  ASSERT_FALSE(reading.diagnostics.empty());
  EXPECT_EQ(reading.diagnostics[0].place.line, 3);
  EXPECT_EQ(reading.diagnostics[0].source, "G1 X10 Y400 Z300 J-1 K0.3");
}

TEST(ToolVectors, TellWhatTheyCannotBe) {
  EXPECT_EQ(read_vectors("G1 X1 I0 J0 K0\n").problems(), "2:7 tool-vector; ");
  EXPECT_EQ(read_vectors("G1 X1 C5\n").problems(), "2:7 tool-vector; ");
  EXPECT_EQ(read_vectors("G2 X10 I5 J0\n").problems(), "2:8 tool-vector; ");
  EXPECT_EQ(read_vectors("G2 X10 R5\n").problems(), "");
  EXPECT_EQ(read_vectors("G1 X10 K-1\n").problems(), "2:8 tool-vector; ");
  EXPECT_EQ(read_vectors("G53 G0 X1 K1\n").problems(), "2:1 tip-control; ");
  Conditions head = trunnion();
  head.machine.rotary_chain = machine::preset_chain("head-b-table-a");
  head.machine.rotary_chain->axes[1].direction = {std::sqrt(0.5), 0, std::sqrt(0.5)};
  EXPECT_EQ(read_vectors("G0 X1 K1\nG1 X10 I-1 K1\n", head).problems(), "3:8 pose-out-of-reach; ");
}

/// How far it leans ahead of its vectors is not done; that it does not is.
TEST(ToolVectors, LeanByThemselves) {
  EXPECT_EQ(read("F600 G43.5 H1 Q2\nG1 X1 K1\nM2\n", trunnion()).problems(), "1:15 unsupported-word; ");
  EXPECT_EQ(read("F600 G43.5 H1 Q0\nG1 X1 K1\nM2\n", trunnion()).problems(), "");
}

/// Through the pole and out of it another way: C turns by itself between, as fast as it can.
TEST(ToolVectors, TurnAtThePoleOnTheExactPath) {
  const Reading reading = read_vectors("G61 G0 X0 Y0 J-1 K1\nG1 X5 J0 K1\nX10 I1 K1\n");
  EXPECT_EQ(reading.errors, 0);
  std::string notes;
  for (const base::Diagnostic& each : reading.diagnostics)
    notes += std::to_string(each.place.line) + " " + std::string(each.code) + "; ";
  EXPECT_EQ(notes, "3 pole-turn; ");
  std::size_t turns = 0;
  for (const Move& line : reading.lines()) {
    if (line.feed.mode != Feed::Mode::rapid || base::number(line.line) < 3) continue;
    ++turns;
    EXPECT_EQ(line.start[0], 5);
    EXPECT_EQ(line.end[0], 5);
    EXPECT_NEAR(std::abs(line.end[c] - line.start[c]), 90, 1e-9);
  }
  EXPECT_EQ(turns, 1U);
}

TEST(ToolVectors, TakeSoManyPartsAndNoMore) {
  EXPECT_EQ(read_vectors("G64 P0.01 E0.001\nG0 X0 J-1 K1\nG1 X10 I1 K1\n").problems(), "");
  EXPECT_EQ(read_vectors("G64 P0.01 E0.00002\nG0 X0 J-1 K1\nG1 X10 I1 K1\n").problems(), "4:8 pole-too-sharp; ");
  // Where E is as good as nothing, a line is one curve.
  EXPECT_EQ(read_vectors("G64 P0.01 E0.0000001\nG0 X0 J-1 K1\nG1 X10 I1 K1\n").problems(), "");
}

TEST(ToolVectors, NeedAMachineThatTurnsTheTool) {
  EXPECT_EQ(read("F600 G43.5\nG1 X1 I1 K1\nX2 I1 K2\nM2\n").problems(), "1:6 tip-control; ");
}

/// In the block of G43.5 they belong to its motion; without one they hold from the next line on.
TEST(ToolVectors, MayStandBesideG43_5) {
  const auto end_of = [](const std::string& text) { return read("F600\n" + text + "M2\n", trunnion()).lines().back(); };
  EXPECT_NEAR(std::abs(end_of("G0 X0\nG43.5 H1 X1 J-1 K1\n").end[a]), 45, 1e-9);
  EXPECT_NEAR(std::abs(end_of("G0 X0\nG43.5 H1 J-1 K1\n").end[a]), 45, 1e-9);
  EXPECT_NEAR(std::abs(end_of("G43.5 H1 J-1 K1\nG1 X5\n").end[a]), 45, 1e-9);
  EXPECT_EQ(read("G43.5 H1 J-1 K1\nM2\n", trunnion()).problems(), "");
}

/// Runs of any length take no more memory than most_vertices.
TEST(ToolVectors, AreHandedOutBeforeALongRunEnds) {
  std::string text = "F600 G43.5\nG0 X0 Y0 Z0 J-1 K1\n";
  constexpr int lines = 90'000;
  for (int k = 1; k <= lines; ++k)
    text += "G1 X" + std::to_string(k % 100) + " J-1 K" + std::to_string(1 + 1e-3 * (k % 2)) + "\n";
  text += "M2\n";
  const Conditions conditions = trunnion();
  Reader reader(text_source(text), conditions.machine, conditions.tools, conditions.options, nullptr);
  Move move;
  std::int64_t first_blocks = 0, count = 0;
  while (reader.next(move)) {
    if (++count == 2) first_blocks = reader.blocks();
  }
  EXPECT_LT(first_blocks, lines);
  EXPECT_EQ(count, lines + 2);
  EXPECT_EQ(reader.errors(), 0);
}

TEST(ToolVectors, AreToldAsAnglesInCanon) {
  const Conditions conditions = trunnion();
  const std::string text = "F600 G43.5\nG0 X0 Y0 Z0 J-1 K1\nG1 X1 J-1 K1.01\nG20\nX1\nM2\n";
  Reader reader(text_source(text), conditions.machine, conditions.tools, conditions.options, nullptr);
  CanonWriter writer(conditions.machine.axis_set());
  std::string canon;
  Move move;
  while (reader.next(move)) writer.write(move, reader.frame(), reader.system(), reader.modal(), canon);
  EXPECT_NE(canon.find("STRAIGHT_FEED(1.0000, 0.0000, 0.0000, -44.7"), std::string::npos) << canon;
  // Inches are those of the lines behind G20.
  EXPECT_LT(canon.find("STRAIGHT_FEED(1.0000, 0.0000, 0.0000, -44.7"), canon.find("CANON_UNITS_INCHES")) << canon;
}

// What a value of a rotary axis has decided is handed out before another tool, path control or direction holds.
TEST(ToolVectors, AreHandedOutBeforeWhatFollowsAPlaceThatIsRead) {
  const auto ways = [](const std::string& asked, const std::string& behind) {
    Conditions conditions = trunnion();
    machine::Tool tool;
    tool.number = 2;
    tool.offset[2] = 30;
    conditions.tools = machine::ToolTable({*conditions.tools.find(1), tool});
    std::vector<std::array<double, 4>> told;
    const std::string text = "G61.1 F1000\nG43.5 H1\nG0 X0 Y0 Z10\nG1 X10 I0 J0.1 K1\nX20 Y5 J0.2\n";
    for (const Move& move : read(text + asked + behind + "\nM2\n", conditions).moves)
      told.push_back({move.end[0], move.end[2], move.end[a], static_cast<double>(move.path_mode)});
    EXPECT_GE(told.size(), 4u);
    return told;
  };
  for (const std::string behind : {"G49", "G43.5 H2", "G64 P2", "G49 Q5", "M429", "G1 X30 J0.3\nG49"}) {
    for (const std::string asked : {"#1=#5424\n", "o1 if [#5424 gt 100]\no1 endif\n", "(debug,A is #<_a>)\n"})
      EXPECT_EQ(ways(asked, behind), ways("", behind)) << asked << behind;
  }
}

// M72, and the end of a call with M73, leave the tip where it is told.
TEST(ToolVectors, ComeBackWithModesThatWereKept) {
  const auto last = [](const std::string& text) {
    const Reading reading = read(text + "M2\n", trunnion());
    EXPECT_EQ(reading.problems(), "") << text;
    return reading.lines().back();
  };
  const std::string begin = "F600 G43.4 H1\nG0 Z10\n", vectors = "F600 G43.5 H1\nG0 Z10\n";
  EXPECT_TRUE(last(begin + "M70\nM72\nG1 A30\n").is_of_tip);
  EXPECT_TRUE(last("o1 sub\nM73\nG91\no1 endsub\n" + begin + "o1 call\nG1 A30\n").is_of_tip);
  EXPECT_TRUE(last(begin + "M70\nG49\nM72\nG1 A30\n").is_of_tip);
  EXPECT_NEAR(std::abs(last(vectors + "M70\nM72\nG1 X9 J-1 K1\n").end[a]), 45, 1e-9);
  EXPECT_EQ(last(vectors + "G0 I0 J-1 K1\nM70\nG49\nG0 A0 C0\nM72\nG1 X10\n").end[a], 0);
  EXPECT_FALSE(last("F600 G43 H1\nG0 Z10\nM70\nG43.4 H1\nM72\nG1 A30\n").is_of_tip);
}

// From beside a contour it does not; nothing waits for ever there.
TEST(ToolVectors, DoNotComeBackBesideAContour) {
  Conditions conditions = trunnion();
  const auto problems = [&](const std::string& text) { return read("F600\n" + text + "M2\n", conditions).problems(); };
  const std::string contour = "G41.1 D6\nG1 X20\nY20\n";
  EXPECT_EQ(problems("G0 A30 C40\nG43.4 H1\nM70\nG49\n" + contour + "M72\nG1 X60\n"), "9:1 cutter-exit; ");
  EXPECT_EQ(problems("G43.5 H1\nM70\nG49\n" + contour + "M72\nG1 X60\n").substr(0, 17), "8:1 cutter-exit; ");
  EXPECT_EQ(problems("G43.5 H1\no1 sub\nM73\nG49\n" + contour +
                     "o1 endsub\no2 sub\nM73\nG1 X60\no2 endsub\no1 call\no2 call\n")
                .substr(0, 18),
            "15:1 cutter-exit; ");
  EXPECT_EQ(
      problems("o1 sub\nM73\nG41.1 D2\nG1 X10\nG43.5 H1\nG1 X20 J-1 K1\no1 endsub\no1 call\nG1 X30\n").substr(0, 25),
      "6:1 cutter-compensation; ");
}

// The level at which a series of holes began is one of the axes, or of the tip.
TEST(ToolVectors, EndASeriesOfHolesWhereTheTipIsTold) {
  const std::string hole = "G98 G81 X0 Z-5 R2 F500\n";
  for (const std::string block : {"M428", "G43.4 H1"})
    EXPECT_EQ(read("G43 H1\nG0 Z40\n" + hole + block + "\nX20\nG80\nM2\n", trunnion()).problems(),
              "5:1 missing-word; ");
  EXPECT_EQ(read("F500 G43.4 H1\nM70\nG43 H1\nG0 Z40\n" + hole + "M72\nX20\nG80\nM2\n", trunnion()).problems(),
            "7:1 missing-word; ");
  EXPECT_EQ(read("G43.4 H1\nG0 Z40\n" + hole + "G43 H1\nX20\nG80\nM2\n", trunnion()).problems(), "5:1 missing-word; ");
}

TEST(ToolVectors, StopExactlyWhereOneBlockAsksForIt) {
  const auto lines = read_vectors("G64 P1\nG0 I0 J0 K1\nG9 G1 X10 I0 J0.1 K1\nG1 X20 Y10\nX30 Y0\n").moves;
  int stops = 0, blends = 0;
  for (const Move& move : lines) {
    if (move.kind == Move::Kind::event || base::number(move.line) < 4) continue;
    const bool is_last_before = base::number(move.line) == 4;
    (is_last_before ? stops : blends) += 1;
    EXPECT_EQ(move.path_mode, is_last_before ? PathMode::exact_stop : PathMode::blend);
    EXPECT_EQ(move.tolerance, is_last_before ? 0 : 1);
  }
  EXPECT_EQ(stops, 1);
  EXPECT_GT(blends, 0);
}

TEST(KeptModes, BringBackHowFarTheToolMayTurnAside) {
  const std::string text = "G64 P1 E0.5\nM70\nG64 P1 E10\nM72\nG43.4 H1\nF600 G1 X10 A5\nM2\n";
  EXPECT_EQ(read(text, trunnion()).lines().back().orientation_tolerance, 0.5);
}

}  // namespace test_tool_vectors
}  // namespace leadscrew::gcode
