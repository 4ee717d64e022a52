// What dialects write that are no codes, and what those that lack it say.

#include <leadscrew/gcode/dialect_forms.hpp>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_dialect_forms {

Reading read_in(Dialect dialect, std::string_view text) {
  Conditions conditions;
  conditions.options.dialect = dialect;
  return read(text, conditions);
}

Reading read_on_mill(Dialect dialect, std::string_view text) {
  Conditions conditions;
  conditions.machine = machine::mill3();
  conditions.options.dialect = dialect;
  return read(text, conditions);
}

std::vector<Point> ends(const Reading& reading) {
  std::vector<Point> points;
  for (const Move& move : reading.moves) {
    if (move.kind != Move::Kind::event && move.kind != Move::Kind::dwell) points.push_back(xyz(move.end));
  }
  return points;
}

double dwell(Dialect dialect, std::string_view text) {
  const Reading reading = read_in(dialect, text);
  EXPECT_EQ(reading.problems(), "") << text;
  const auto dwells = reading.of(Move::Kind::dwell);
  return dwells.size() == 1 ? dwells[0].dwell_seconds : -1;
}

TEST(DialectForms, G80StandsBesideAnotherMotion) {
  for (const Dialect dialect : {Dialect::leadscrew, Dialect::linuxcnc, Dialect::fanuc, Dialect::haas, Dialect::mach3}) {
    for (const char* text : {"G0 G80 X5\nX7\nM2\n", "G80 G0 X5\nX7\nM2\n"}) {
      const Reading reading = read_in(dialect, text);
      EXPECT_EQ(reading.problems(), "") << text;
      EXPECT_EQ(ends(reading), (std::vector<Point>{{5, 0, 0}, {7, 0, 0}})) << text;
    }
  }
  EXPECT_EQ(read_in(Dialect::grbl, "G0 G80 X5\n").problems(), "1:4 modal-conflict; ");
}

TEST(DialectForms, AxisWordsBehindG80GoOnAsBeforeTheCycle) {
  const std::string program = "G0 X0 Y0 Z5\nG81 X10 Z-5 R1 F100\nG80\nZ20\nM2\n";
  for (const Dialect dialect : {Dialect::leadscrew, Dialect::fanuc, Dialect::haas, Dialect::mach3}) {
    const Reading reading = read_in(dialect, program);
    EXPECT_EQ(reading.problems(), "");
    ASSERT_FALSE(reading.lines().empty());
    EXPECT_EQ(xyz(reading.lines().back().end), (Point{10, 0, 20}));
    EXPECT_EQ(reading.lines().back().feed.mode, Feed::Mode::rapid);
  }
  EXPECT_EQ(read_in(Dialect::linuxcnc, program).problems(), "4:1 axis-without-motion; ");
}

TEST(DialectForms, OffsetsOutsideThePlaneMayBeZero) {
  const Reading reading = read_in(Dialect::leadscrew, "G2 X10 I5 J0 K0 F60\nM2\n");
  EXPECT_EQ(reading.problems(), "");
  EXPECT_EQ(reading.arcs().size(), 1u);
  EXPECT_EQ(read_in(Dialect::leadscrew, "G2 X10 I5 K1 F60\nM2\n").problems(), "1:11 unused-word; ");
  EXPECT_EQ(read_in(Dialect::linuxcnc, "G2 X10 I5 K0 F60\nM2\n").problems(), "1:11 unused-word; ");
}

TEST(DialectForms, G4DwellsAsLongAsTheDialectSays) {
  EXPECT_EQ(dwell(Dialect::leadscrew, "G4 P1.5\nM2\n"), 1.5);
  EXPECT_EQ(dwell(Dialect::leadscrew, "G4 P2\nM2\n"), 2);
  EXPECT_EQ(dwell(Dialect::leadscrew, "G4 X1.5\nM2\n"), 1.5);
  EXPECT_EQ(dwell(Dialect::leadscrew, "G4 U.5\nM2\n"), 0.5);
  EXPECT_EQ(dwell(Dialect::fanuc, "G4 P500\nM2\n"), 0.5);
  EXPECT_EQ(dwell(Dialect::fanuc, "G4 P1.5\nM2\n"), 1.5);
  EXPECT_EQ(dwell(Dialect::fanuc, "G04 X2.\nM2\n"), 2);
  EXPECT_EQ(dwell(Dialect::haas, "G4 P250\nM2\n"), 0.25);
  EXPECT_EQ(dwell(Dialect::haas, "G4 P2.\nM2\n"), 2);
  EXPECT_EQ(dwell(Dialect::grbl, "G4 P2\nM2\n"), 2);
  EXPECT_EQ(dwell(Dialect::mach3, "G4 P2\nM2\n"), 2);
  EXPECT_EQ(dwell(Dialect::marlin, "G4 P500\nM2\n"), 0.5);
  EXPECT_EQ(dwell(Dialect::marlin, "G4 S3\nM2\n"), 3);
  EXPECT_EQ(read_in(Dialect::linuxcnc, "G4 X1.5\nM2\n").errors, 2);
}

TEST(DialectForms, DwellsOfCyclesAreWholeMillisecondsOnFanuc) {
  for (const auto& [dialect, word] :
       {std::pair{Dialect::fanuc, "P300"}, {Dialect::haas, "P.3"}, {Dialect::leadscrew, "P.3"}}) {
    const Reading reading = read_in(dialect, "G0 Z5\nG82 X1 Z-1 R1 " + std::string(word) + " F60\nM2\n");
    EXPECT_EQ(reading.problems(), "");
    ASSERT_EQ(reading.of(Move::Kind::dwell).size(), 1u);
    EXPECT_NEAR(reading.of(Move::Kind::dwell)[0].dwell_seconds, 0.3, 1e-12);
  }
}

TEST(DialectForms, KRepeatsCyclesOfFanuc) {
  const Reading of_fanuc = read_in(Dialect::fanuc, "G0 Z5\nG91 G98 G81 X5 Z-3 R-2 K4 F60\nM2\n");
  const Reading of_linuxcnc = read_in(Dialect::linuxcnc, "G0 Z5\nG91 G98 G81 X5 Z-3 R-2 L4 F60\nM2\n");
  EXPECT_EQ(of_fanuc.problems(), "");
  EXPECT_EQ(ends(of_fanuc), ends(of_linuxcnc));
  EXPECT_EQ(of_fanuc.lines().size(), of_linuxcnc.lines().size());
}

TEST(DialectForms, UVWAreDistancesHomeWhereThereAreNoSuchAxes) {
  EXPECT_EQ(ends(read_on_mill(Dialect::fanuc, "G90 G0 X10 Y20 Z30\nG28 U0 W5\nM2\n")),
            (std::vector<Point>{{10, 20, 30}, {10, 20, 35}, {0, 20, 0}}));
  EXPECT_EQ(ends(read_on_mill(Dialect::fanuc, "G90 G0 X10 Y20 Z30\nG91 G28 V-2\nM2\n")),
            (std::vector<Point>{{10, 20, 30}, {10, 18, 30}, {10, 0, 30}}));
  EXPECT_EQ(read_on_mill(Dialect::linuxcnc, "G28 U0\nM2\n").problems(), "1:5 unknown-axis; ");
}

TEST(DialectForms, AToolWithoutATableHasNoOffsetWhichIsToldOnce) {
  const Reading reading = read_in(Dialect::leadscrew, "G43 H7\nG0 Z5\nG43 H8\nG0 Z6\nM2\n");
  EXPECT_EQ(reading.problems(), "1:1 no-tool-table; ");
  EXPECT_EQ(reading.errors, 0);
  EXPECT_EQ(ends(reading), (std::vector<Point>{{0, 0, 5}, {0, 0, 6}}));
}

TEST(DialectForms, SomeBeginInG0) {
  for (const Dialect dialect : {Dialect::haas, Dialect::grbl}) {
    const Reading reading = read_in(dialect, "G90 X5\nM2\n");
    EXPECT_EQ(reading.problems(), "");
    EXPECT_EQ(ends(reading), (std::vector<Point>{{5, 0, 0}}));
  }
  EXPECT_EQ(read_in(Dialect::fanuc, "G90 X5\nM2\n").problems(), "1:5 axis-without-motion; ");
}

TEST(DialectForms, OnlyLinuxcncAsksForAnEnd) {
  EXPECT_EQ(read_in(Dialect::linuxcnc, "G0 X1\n").errors, 1);
  for (const Dialect dialect : {Dialect::leadscrew, Dialect::fanuc, Dialect::grbl, Dialect::marlin}) {
    EXPECT_EQ(read_in(dialect, "G0 X1\n").errors, 0);
  }
}

TEST(DialectForms, CommandsToGrblArePassedOver) {
  const Reading reading = read_in(Dialect::grbl, "$H\n$J=G91 X1\n?\nG0 X1 ! X\nM2\n");
  EXPECT_EQ(reading.problems(),
            "1:1 controller-command; 2:1 controller-command; 4:7 controller-command; 4:10 bad-number; ");
  const Reading elsewhere = read_in(Dialect::leadscrew, "$H\n");
  ASSERT_EQ(elsewhere.errors, 1);
  EXPECT_NE(elsewhere.diagnostics[0].hint.find("--dialect grbl"), std::string::npos);
}

TEST(DialectForms, ChecksumsAreChecked) {
  EXPECT_EQ(read_in(Dialect::marlin, "N3 G28*16\nN4 G0 X1*0\n").problems(), "2:9 bad-checksum; ");
  EXPECT_EQ(read_in(Dialect::linuxcnc, "N3 G28*16\nM2\n").problems(), "1:7 bad-character; ");
}

TEST(DialectForms, WhatPrintersHeatIsPassedOver) {
  const Reading reading = read_in(
      Dialect::marlin, "M104 S200\nM104 S210\nM117 Hello X\nG92 E0\nG1 X5 E2 F600\nG1 E-2\nX6 E3\nM400\nM0 press\n");
  EXPECT_EQ(reading.problems(), "1:1 printer-command; 4:5 no-extruder; ");
  EXPECT_EQ(ends(reading), (std::vector<Point>{{5, 0, 0}, {6, 0, 0}}));
  EXPECT_EQ(reading.of(Move::Kind::dwell).size(), 1u);
}

// Fanuc 0i operator's manual, "Scaling": the magnification counts thousandths, as P500 in common use.
TEST(DialectForms, FanucScalesByThousandths) {
  EXPECT_EQ(
      ends(read_in(Dialect::fanuc, "G51 X0 Y0 Z0 P500\nG0 X10 Y4\nG51 X0 Y0 Z0 I2000 J-1000 K1.\nX1 Y1 Z3\nM30\n")),
      (std::vector<Point>{{5, 2, 0}, {2, -1, 3}}));
  EXPECT_EQ(ends(read_in(Dialect::fanuc, "G51 X0 Y0 Z0 P.5\nG0 X10\nM30\n")), (std::vector<Point>{{5, 0, 0}}));
  EXPECT_EQ(ends(read_in(Dialect::haas, "G51 X0 Y0 Z0 P2\nG0 X10\nM30\n")), (std::vector<Point>{{20, 0, 0}}));
}

TEST(DialectForms, WhatPrintersAskIsPassedOver) {
  const Reading reading = read_in(Dialect::marlin, "M16 X\nM48 P3\nG60 S0\nM122\nG1 X5 F600\nM226 P4\nM112\nG1 X6\n");
  EXPECT_EQ(reading.problems(), "2:1 printer-command; 6:1 printer-command; ");
  EXPECT_EQ(ends(reading), (std::vector<Point>{{5, 0, 0}}));
  // What goes somewhere is not passed over.
  EXPECT_EQ(read_in(Dialect::marlin, "G61\n").problems(), "1:1 unknown-code; ");
}

TEST(DialectForms, Mach3ReferencesAxesByG28_1) {
  const Reading reading = read_in(Dialect::mach3, "G0 X5 Y6 Z7\nG28.1 X1 Y0\nM30\n");
  EXPECT_EQ(reading.problems(), "");
  EXPECT_EQ(ends(reading), (std::vector<Point>{{5, 6, 7}, {1, 0, 7}, {0, 0, 7}}));
}

TEST(DialectForms, Mach3RepeatsByM47AndHasMacros) {
  const Reading reading = read_in(Dialect::mach3, "G0 X5\nM120\nM47\nG0 X6\n");
  EXPECT_EQ(reading.problems(), "");
  EXPECT_EQ(ends(reading), (std::vector<Point>{{5, 0, 0}}));
  ASSERT_FALSE(reading.events().empty());
  EXPECT_EQ(reading.events()[0].kind, base::Event::Kind::user_function);
  EXPECT_EQ(reading.events()[0].output, 120);
}

TEST(DialectForms, MarlinGoesHomeStraight) {
  const Reading reading = read_in(Dialect::marlin, "G0 X5 Y6 Z7\nG28 X Y\nG0 X1\nG28\n");
  EXPECT_EQ(reading.problems(), "");
  EXPECT_EQ(ends(reading), (std::vector<Point>{{5, 6, 7}, {0, 0, 7}, {1, 0, 7}, {0, 0, 0}}));
}

TEST(ForeignLanguages, AreOneErrorEach) {
  const char* const heidenhain =
      "0 BEGIN PGM 100 MM\n1 BLK FORM 0.1 Z X+0 Y+0 Z-20\n2 TOOL CALL 5 Z S2000\n3 L X+10 Y+5 R0 FMAX M3\n4 END PGM "
      "100 MM\n";
  const char* const siemens = "%_N_PLATE_MPF\n;$PATH=/_N_WKS_DIR\nN10 G54 D1\nN20 CYCLE81(10,0,2,-5)\nN30 M30\n";
  const char* const lines = "N10 G0 X10\nN20 MSG(\"ROUGHING\")\nN30 CYCLE832(0.01,1)\nN40 Q\n";
  EXPECT_EQ(read(heidenhain).problems(), "1:1 foreign-language; ");
  EXPECT_EQ(read(siemens).problems(), "1:1 foreign-language; ");
  EXPECT_EQ(read(lines).problems(), "2:1 foreign-language; ");
}

TEST(ForeignLanguages, AreFilesOfSurfacesToo) {
  const std::string step = "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\n";
  const auto section = [](const std::string& text, char letter) {
    return text + std::string(72 - text.size(), ' ') + letter + "      1\n";
  };
  const std::string iges = section("", 'S') + section("1H,,1H;,4HPART,8Hpart.igs", 'G');
  for (const auto& [text, line] : {std::pair(step, 1), {section("A part.", 'S') + iges, 1}, {iges, 2}}) {
    const Reading reading = read(text);
    EXPECT_EQ(reading.problems(), std::to_string(line) + ":1 foreign-language; ");
    ASSERT_FALSE(reading.diagnostics.empty());
    EXPECT_NE(reading.diagnostics.front().hint.find("leadscrew surfaces"), std::string::npos);
  }
}

TEST(ForeignLanguages, AreNotSeenInRemarksAndNames) {
  EXPECT_EQ(read("(SUPA FMAX) G0 X\nM2\n").problems(), "1:17 bad-number; ");
  EXPECT_EQ(read("(BEGIN PGM) G0 X\nM2\n").problems(), "1:17 bad-number; ");
  EXPECT_EQ(read("G0 X#<trans x>\nM2\n").problems(), "1:5 unset-parameter; ");
}

}  // namespace test_dialect_forms
}  // namespace leadscrew::gcode
