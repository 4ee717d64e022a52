// G38.2 … G38.5 and G31 with a simulated probe, with a real one, and with none.

#include <leadscrew/gcode/canon.hpp>

#include "probe_programs.hpp"

namespace leadscrew::gcode {
namespace test_probing {

/// A probe that is in contact at or below Z −3, and at or below X −20.
Conditions with_probe(Dialect dialect = Dialect::leadscrew) {
  Conditions conditions = in_dialect(dialect);
  machine::Probe probe;
  probe.planes[base::index(base::Axis::Z)] = -3;
  probe.planes[base::index(base::Axis::X)] = -20;
  conditions.machine.probe = probe;
  return conditions;
}

Printed probe(const std::string& program, const Conditions& conditions = with_probe()) {
  return printed(program, conditions);
}

TEST(Probing, EndsAtThePlane) {
  const Printed found = probe("G21 F60 G0 X10 Y5\nG38.2 Z-10" + tell);
  EXPECT_EQ(found.reading.problems(), "");
  EXPECT_EQ(found.text, "10.000 5.000 -3.000 1;");
  const std::vector<Move> lines = found.reading.lines();
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_FALSE(lines[0].is_probing());
  EXPECT_TRUE(lines[1].is_probing());
  EXPECT_EQ(xyz(lines[1].end), (Point{10, 5, -3}));
  EXPECT_EQ(lines[1].feed.value, 1);
}

TEST(Probing, MeetsThePlaneOnASlantedLine) {
  const Printed found = probe("F60\nG38.2 X12 Y-9 Z-9" + tell + "G1 X0");
  EXPECT_EQ(found.text, "4.000 -3.000 -3.000 1;");
  EXPECT_EQ(xyz(found.reading.lines().back().end), (Point{0, -3, -3}));
}

TEST(Probing, EndsAtTheFirstOfSeveralPlanes) {
  EXPECT_EQ(probe("F60\nG38.2 X-40 Z-12" + tell).text, "-10.000 0.000 -3.000 1;");
  EXPECT_EQ(probe("F60\nG38.2 X-40 Z-4" + tell).text, "-20.000 0.000 -2.000 1;");
}

TEST(Probing, LeadsAwayUntilContactIsLost) {
  EXPECT_EQ(probe("F60 G0 Z-5\nG38.4 X5 Z5" + tell).text, "1.000 0.000 -3.000 1;");
  // Of two planes both must be left.
  EXPECT_EQ(probe("F60 G0 Z-5 X-21\nG38.4 X-11 Z5" + tell).text, "-19.000 0.000 -3.000 1;");
  EXPECT_EQ(probe("F60 G0 Z-5 X-25\nG38.4 X25 Z5" + tell).text, "-15.000 0.000 -3.000 1;");
}

TEST(Probing, LosesNoContactWhereAnotherPlaneIsMetBefore) {
  EXPECT_EQ(probe("F60 G0 Z-4\nG38.5 X-39 Z-2" + tell).text, "-19.500 0.000 -3.000 1;");
  EXPECT_EQ(probe("F60 G0 Z-4\nG38.5 X-40 Z-2" + tell).text, "-40.000 0.000 -2.000 0;");
  EXPECT_EQ(probe("F60 G0 Z-4\nG38.5 X-41 Z-2" + tell).text, "-41.000 0.000 -2.000 0;");
}

TEST(Probing, GoesOnFromThePlaneInTheStateThatWasFound) {
  EXPECT_EQ(probe("F60\nG38.2 Z-9\nG38.4 Z9" + tell + "G38.2 Z-9" + tell + "G91 G0 Z1\nG38.2 Z-5" + tell).text,
            "0.000 0.000 -3.000 1;0.000 0.000 -3.000 1;0.000 0.000 -3.000 1;");
}

TEST(Probing, TellsPlacesInTheProgramsCoordinatesAndUnits) {
  EXPECT_EQ(probe("G21 F60 G10 L2 P1 X1 Y2 Z7\nG0 X10 Y5 Z10\nG38.2 Z-20" + tell).text, "10.000 5.000 -10.000 1;");
  EXPECT_EQ(probe("G20 F60 G0 X1 Z1\nG38.2 Z-1" + tell).text, "1.000 0.000 -0.118 1;");
  EXPECT_EQ(probe("F60 G10 L2 P1 R90\nG0 X4 Y1\nG38.2 Z-20" + tell).text, "4.000 1.000 -3.000 1;");
  EXPECT_EQ(probe("F60 G92 X100 Z50\nG38.2 Z10" + tell).text, "100.000 0.000 47.000 1;");
}

TEST(Probing, CountsTheOffsetOfTheTool) {
  const Printed found = probe("F60 G43.1 Z10\nG0 Z5\nG38.2 Z-10" + tell);
  EXPECT_EQ(found.text, "0.000 0.000 -3.000 1;");
  EXPECT_EQ(at(found.reading.lines().back().end, base::Axis::Z), 7);
}

TEST(Probing, FindsNothingBeforeThePlane) {
  for (const char* const code : {"G38.3", "G38.5"}) {
    const std::string begin = std::string(code) == "G38.5" ? "F60 G0 Z-9\n" : "F60\n";
    const std::string end = std::string(code) == "G38.5" ? " Z-5" : " Z-2";
    const Printed found = probe(begin + code + end + tell);
    EXPECT_EQ(found.text,
              "0.000 0.000" + (std::string(code) == "G38.5" ? std::string(" -5") : std::string(" -2")) + ".000 0;");
    EXPECT_EQ(found.reading.problems(), "");
  }
  EXPECT_EQ(probe("F60\nG38.2 Z-2").reading.diagnostics.at(0).code, "probe-failed");
  EXPECT_EQ(probe("F60 G0 Z-9\nG38.4 Z-5").reading.problems(), "2:1 probe-failed; ");
}

TEST(Probing, MustNotBeginInTheStateThatItLooksFor) {
  EXPECT_EQ(probe("F60 G0 Z-5\nG38.2 Z-9").reading.problems(), "2:1 probe-state; ");
  EXPECT_EQ(probe("F60\nG38.4 Z9").reading.diagnostics.at(0).code, "probe-state");
  // The others end where they begin (LinuxCNC, "EMCMOT_PROBE").
  const Printed found = probe("F60 G0 Z-5\nG38.3 Z-9" + tell);
  EXPECT_EQ(found.text, "0.000 0.000 -5.000 1;");
  EXPECT_EQ(found.reading.lines().size(), 1u);
  EXPECT_EQ(probe("F60\nG38.5 Z9" + tell).text, "0.000 0.000 0.000 1;");
  // grbl refuses all four ("mc_probe_cycle").
  EXPECT_EQ(probe("F60 G0 Z-5\nG38.3 Z-9", with_probe(Dialect::grbl)).reading.problems(), "2:1 probe-state; ");
}

TEST(Probing, IsRefusedAsLinuxCncDoes) {
  const struct {
    const char* program;
    const char* problems;
  } rows[] = {
      {"F60\nG38.2", "2:1 missing-word; "},
      {"G38.2 Z-9", "1:1 missing-feed; "},
      {"F0\nG38.2 Z-9", "2:1 missing-feed; "},
      {"F60\nG38.2 Z0", "2:1 bad-probe; "},
      {"F60\nG38.4 X0 Y0", "2:1 bad-probe; "},
      {"F60\nG53 G38.2 Z-9", "2:1 bad-g53; "},
      {"G95 F1 S60 M3\nG38.2 Z-9", "2:1 bad-probe; "},
      {"F60\nG38.2 Z-9 P3", "2:11 unused-word; "},
      {"F60\nG38.2 Z-900", "2:7 travel; "},
      {"F60\nG28 G38.2 Z-9", "2:5 modal-conflict; "},
      {"G93\nG38.2 Z-9", "2:1 missing-feed; "},
  };
  for (const auto& row : rows) EXPECT_EQ(probe(row.program).reading.problems(), row.problems) << row.program;
  EXPECT_EQ(probe("F60\nG38.3 Z0" + tell).text, "0.000 0.000 0.000 0;");
}

TEST(Probing, IsModal) {
  const Printed found = probe("F60\nG38.3 X5\nY5\nG80\nX7", {});
  EXPECT_EQ(found.reading.problems(), "5:1 axis-without-motion; ");
  EXPECT_EQ(found.reading.lines().size(), 2u);
  EXPECT_TRUE(found.reading.lines()[1].is_probing());
}

TEST(Probing, TakesTheTimeOfG93ForTheWholeMove) {
  const Move line = probe("G93\nG38.2 Z-12 F2").reading.lines().at(0);
  EXPECT_EQ(at(line.end, base::Axis::Z), -3);
  // 12 mm in half a minute.
  EXPECT_DOUBLE_EQ(line.feed.value * 3, 12 / 30.0);
}

TEST(Probing, WithoutASimulatedProbeTouchesWhereItLeads) {
  const Printed found = probe("F60\nG38.2 Z-10" + tell + "G38.2 Z-12" + tell, {});
  EXPECT_EQ(found.text, "0.000 0.000 -10.000 1;0.000 0.000 -12.000 1;");
  ASSERT_EQ(found.reading.diagnostics.size(), 1u);
  EXPECT_EQ(found.reading.diagnostics[0].code, "probe-not-simulated");
  EXPECT_EQ(found.reading.diagnostics[0].severity, base::Severity::note);
  EXPECT_EQ(found.reading.diagnostics[0].place.line, 2);
}

TEST(Skip, IsADialectsOwn) {
  EXPECT_EQ(probe("F60\nG31 Z-10" + tell).text, "0.000 0.000 -3.000 1;");
  EXPECT_EQ(probe("F60\nG31 Z-2" + tell).text, "0.000 0.000 -2.000 0;");
  EXPECT_EQ(read("G31 Z-10 F60\nM2\n", in_dialect(Dialect::linuxcnc)).problems(), "1:1 unknown-code; ");
  // G1 stays in force.
  const Reading fanuc = read("G1 X1. F60.\nG31 Z-10.\nZ5.\n#100=#5063\nX#100\nM30\n", with_probe(Dialect::fanuc));
  EXPECT_EQ(fanuc.problems(), "");
  ASSERT_EQ(fanuc.lines().size(), 4u);
  EXPECT_FALSE(fanuc.lines()[2].is_probing());
  EXPECT_EQ(at(fanuc.lines()[3].end, base::Axis::X), -3);
  EXPECT_EQ(read("G31 Z-10. F60. P4\nM30\n", with_probe(Dialect::fanuc)).problems(), "");
  EXPECT_EQ(read("G31 Z-10. F60. P5\nM30\n", with_probe(Dialect::fanuc)).problems(), "1:16 bad-value; ");
  EXPECT_EQ(read("G31 F60.\nM30\n", with_probe(Dialect::fanuc)).problems(), "1:1 missing-word; ");
}

TEST(Skip, SetsMach3sParameters) {
  const Reading reading = read("F60\nG31 Z-10\nG0 Z[#2002+10]\nM30\n", with_probe(Dialect::mach3));
  EXPECT_EQ(reading.problems(), "");
  EXPECT_EQ(at(reading.lines().back().end, base::Axis::Z), 7);
  EXPECT_EQ(read("F60 G0 Z-5\nG31 Z-10\nM30\n", with_probe(Dialect::mach3)).problems(), "2:1 probe-state; ");
}

TEST(ProbeLog, HasEachPointThatWasFound) {
  Conditions conditions = with_probe();
  std::string told;
  conditions.options.remarks = [&](const Remark& remark) {
    using Kind = Remark::Kind;
    told += (remark.kind == Kind::probe_open    ? "open "
             : remark.kind == Kind::probe_close ? "close "
                                                : "point ") +
            remark.text + "\n";
  };
  const Reading reading =
      read("F60 (PROBEOPEN a b.txt)\nG38.2 Z-9 X6\nG0 Z0\nG38.3 Z-1\n(PROBECLOSE)\n(PROBEOPEN ../c)\n(PROBEOPEN)\nM2\n",
           conditions);
  EXPECT_EQ(
      told,
      "open a b.txt\npoint 2.000000 0.000000 -3.000000 0.000000 0.000000 0.000000 0.000000 0.000000 0.000000\nclose \n"
      "close \nclose \n");
  EXPECT_EQ(reading.problems(), "6:2 bad-log; 7:2 bad-log; ");
}

/// Reads a program whose probing moves end as told, one after the other.
std::string with_answers(const std::string& program, std::vector<Probed> answers) {
  Conditions conditions;
  conditions.options.probing = ProbingMoves::real;
  std::string told;
  conditions.options.remarks = [&](const Remark& remark) { told += remark.text + ";"; };
  Reader reader(
      text_source(program), conditions.machine, conditions.tools, conditions.options,
      [&](const base::Diagnostic& d) { told += std::to_string(d.place.line) + " " + std::string(d.code) + ";"; });
  auto answer = answers.begin();
  Move move;
  while (reader.next(move)) {
    if (move.kind == Move::Kind::line) told += text(move.start[2]) + ">" + text(move.end[2]) + ";";
    if (move.is_probing() && answer != answers.end()) reader.probed(*answer++);
  }
  return told;
}

TEST(Probing, IsRefusedUnderToolCentrePointControl) {
  Conditions conditions = with_probe();
  conditions.machine.kinematics = "table-table-ac";
  conditions.machine.rotary_chain = machine::preset_chain("table-table-ac");
  const std::string problems = probe("F60 G43.4 H0\nG38.2 Z-9", conditions).reading.problems();
  EXPECT_NE(problems.find("2:1 tip-control; "), std::string::npos) << problems;
}

TEST(RealProbe, EndsTheMoveWhereItIsTold) {
  EXPECT_EQ(
      with_answers("F60\nG38.2 Z-9\n(PRINT,%.1f#5063 %d#5070)\nG0 Z1\nM2\n", {{true, false, {0, 0, -4}, {0, 0, -4.5}}}),
      "0>-9;0.000000 0.000000 -4.000000 0.000000 0.000000 0.000000 0.000000 0.000000 0.000000;-4.0 1;-4.5>1;");
  EXPECT_EQ(
      with_answers("F60\nG38.3 Z-9\n(PRINT,%.1f#5063 %d#5070)\nG0 Z1\nM2\n", {{false, false, {0, 0, -9}, {0, 0, -9}}}),
      "0>-9;-9.0 0;-9>1;");
  EXPECT_EQ(with_answers("F60\nG38.2 Z-9\nG0 Z1\nM2\n", {{false, false, {0, 0, -9}, {0, 0, -9}}}),
            "0>-9;2 probe-failed;-9>1;");
}

TEST(RealProbe, MustNotHaveFoundBeforeItMoves) {
  EXPECT_EQ(with_answers("F60\nG38.2 Z-9\nM2\n", {{true, true, {}, {}}}).substr(0, 20), "0>-9;2 probe-state;0");
  EXPECT_EQ(with_answers("F60\nG38.3 Z-9\nG0 Z1\nM2\n", {{true, true, {}, {}}}).substr(0, 6), "0>-9;0");
}

TEST(RealProbe, IsTakenToTouchWhereNobodySays) {
  EXPECT_EQ(with_answers("F60\nG38.2 Z-9\n(PRINT,%.1f#5063 %d#5070)\nG0 Z1\nM2\n", {}), "0>-9;-9.0 1;-9>1;");
}

}  // namespace test_probing
}  // namespace leadscrew::gcode
