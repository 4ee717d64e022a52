// Every diagnostic at its exact place; and one problem makes one diagnostic.

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_diagnostics {

struct Row {
  const char* text;
  const char* problems;
};

TEST(Diagnostics, StandAtTheirLineAndColumn) {
  const Row rows[] = {
      {"G0 X1 $", "1:7 bad-character; "},
      {"\n\n  G0 X1 !Y2", "3:9 bad-character; "},
      {"G0 X1 \x80", "1:7 bad-character; "},
      {"G0 X1 \x01", "1:7 bad-character; "},
      {"G0 X1\n%", "2:1 bad-character; "},
      {"G0 X1 / Y2", "1:7 bad-character; "},
      {"G0 X1 )", "1:7 bad-character; "},
      {"G0 X", "1:5 bad-number; "},
      {"G0 X-", "1:5 bad-number; "},
      {"G0 X Y2", "1:6 bad-number; "},
      {"G0 X.", "1:5 bad-number; "},
      {"G0 X1.2.3", "1:5 bad-number; "},
      {"G0 X1 . 2 . 3", "1:5 bad-number; "},
      {"G0 X(five)", "1:5 bad-number; "},
      {"G0 X1e5", "1:6 unused-word; "},
      {"G0 Xnan", "1:5 bad-number; "},
      {"G0 X[1+2", "1:5 unclosed-bracket; "},
      {"G0 X[1+[2*3]", "1:5 unclosed-bracket; "},
      {"G0 X[1 2 ? 3]", "1:10 bad-operator; "},
      {"G0 X[2 FOO 3]", "1:8 bad-operator; "},
      {"G0 X[]", "1:6 bad-number; "},
      {"G0 X[1+]", "1:8 bad-number; "},
      {"G0 X[1/0]", "1:7 division-by-zero; "},
      {"G0 X[1 MOD 0]", "1:8 division-by-zero; "},
      {"G0 XSQRT[-1]", "1:5 expression-domain; "},
      {"G0 XLN[0]", "1:5 expression-domain; "},
      {"G0 XASIN[2]", "1:5 expression-domain; "},
      {"G0 XACOS[-1.1]", "1:5 expression-domain; "},
      {"G0 XTAN[90]", "1:5 expression-domain; "},
      {"G0 XEXP[1000]", "1:5 expression-domain; "},
      {"G0 X[-8 ** 0.5]", "1:9 expression-domain; "},
      {"G0 X[0 ** -1]", "1:8 expression-domain; "},
      {"G0 XATAN[1]", "1:5 bad-operator; "},
      {"G0 XSIN 3", "1:5 bad-number; "},
      {"G0 X#<_ini[setup]x>", "1:5 unset-parameter; "},
      {"G0 X#<none>", "1:5 unset-parameter; "},
      {"G0 X#0", "1:5 bad-parameter; "},
      {"G0 X#5603", "1:5 bad-parameter; "},
      {"G0 X#1.5", "1:5 bad-parameter; "},
      {"G0 X#<none", "1:5 bad-parameter; "},
      {"G0 X#<>", "1:5 bad-parameter; "},
      {"G0 XEXISTS[5]", "1:12 bad-parameter; "},
      {"#1", "1:1 bad-parameter; "},
      {"G0 #5220=2", "1:4 parameter-without-effect; "},
      {"#5421=2", "1:1 read-only-parameter; "},
      {"#5221=[10 ** 12]", "1:1 bad-value; "},
      {"G0 (remark", "1:4 unclosed-comment; "},
      {"G0 (a (b)", "1:7 nested-comment; "},
      {"G0 X1 X2", "1:7 repeated-word; "},
      {"G0 G1 X1 F60", "1:4 modal-conflict; "},
      {"G0 G0 X1", "1:4 modal-conflict; "},
      {"G90 G91", "1:5 modal-conflict; "},
      {"M3 M5", "1:4 modal-conflict; "},
      {"G28 G92 X1", "1:5 modal-conflict; "},
      {"G92 X1 G0", "1:8 modal-conflict; "},
      {"G43.1 Z1 G0", "1:10 modal-conflict; "},
      {"G0 X1 G123", "1:7 unknown-code; "},
      {"G-1", "1:1 unknown-code; "},
      {"G1.05", "1:1 unknown-code; "},
      {"G14", "1:1 unknown-code; "},
      {"M77", "1:1 unknown-code; "},
      {"M3.5", "1:1 unknown-code; "},
      {"G1 X1 F60 G60", "1:11 unsupported-code; "},
      {"G60", "1:1 unsupported-code; "},
      {"G31", "1:1 missing-word; "},
      {"G38.2 X1", "1:1 missing-feed; "},
      {"M98", "1:1 missing-word; "},
      {"G10 L1 P1", "1:8 unknown-tool; "},
      {"o100 sub", "1:1 unmatched-o-word; "},
      {"X1", "1:1 axis-without-motion; "},
      {"G80 X1", "1:5 axis-without-motion; "},
      {"G1 X1", "1:1 missing-feed; "},
      {"G93 G1 X1 F6\nX2", "2:1 missing-feed; "},
      {"G1 F0 X1", "1:1 missing-feed; "},
      {"F-1", "1:1 bad-value; "},
      {"S-1", "1:1 bad-value; "},
      {"T1.5", "1:1 bad-value; "},
      {"T-1", "1:1 bad-value; "},
      {"M6", "1:1 missing-word; "},
      {"G4", "1:1 missing-word; "},
      {"G4 P-1", "1:4 bad-value; "},
      {"G4 P1 G2 X10 I5 F60", "1:4 ambiguous-word; "},
      {"G10 X1", "1:1 missing-word; "},
      {"G10 L3 P1", "1:5 bad-value; "},
      {"G10 L2 P10", "1:8 bad-value; "},
      {"G10 L2 P1.5", "1:8 bad-value; "},
      {"G10 L20 P1 R5", "1:12 unused-word; "},
      {"G92", "1:1 missing-word; "},
      {"G43.1", "1:1 missing-word; "},
      {"G43 H7", "1:1 no-tool-table; "},
      {"G43 H-1", "1:5 bad-value; "},
      {"G53 X1", "1:5 axis-without-motion; "},
      {"G53 G2 X10 I5 F60", "1:1 bad-g53; "},
      {"G91 G53 G0 X1", "1:5 bad-g53; "},
      {"G2 X1 F60", "1:1 missing-word; "},
      {"G90.1 G2 X10 I5 F60", "1:7 missing-word; "},
      {"G2 X10 I5 R5 F60", "1:11 ambiguous-word; "},
      {"G2 X10 I5 P0 F60", "1:11 bad-value; "},
      {"G2 X10 I5 P1.5 F60", "1:11 bad-value; "},
      {"G17 G2 X10 I5 K1 F60", "1:15 unused-word; "},
      {"G18 G2 X10 I5 J1 F60", "1:15 unused-word; "},
      {"G0 X1 I5", "1:7 unused-word; "},
      {"G0 X1 P5 Q6", "1:7 unused-word; 1:10 unused-word; "},
      {"G0 X1 D1", "1:7 unused-word; "},
      {"G0 X1 H1", "1:7 unused-word; "},
      {"G0 X1 L1", "1:7 unused-word; "},
      {"G0 X1 R1", "1:7 unused-word; "},
      {"G64 H1", "1:5 unused-word; "},
      {"G0 X501", "1:4 travel; "},
      {"G0 X2000000000", "1:4 bad-value; "},
  };
  for (const Row& row : rows) {
    EXPECT_EQ(read(std::string(row.text) + "\n").problems(), row.problems) << row.text;
  }
}

TEST(Diagnostics, LeaveNoMoveOfTheirBlock) {
  for (const char* block : {"S100 M3 G0 X1 Q5", "G28 X1 Q5", "G81 X1 Z-1 R1 F60 Q5", "G0 X1 X2", "M0 G4 P1 X#9"}) {
    const Reading reading = read(std::string(block) + "\n");
    EXPECT_EQ(reading.errors, 1) << block;
    ASSERT_EQ(reading.moves.size(), 1u) << block;
    EXPECT_EQ(reading.moves[0].event.kind, base::Event::Kind::program_end);
  }
}

TEST(Diagnostics, AreAllOfAProgramInOnePass) {
  const Reading reading = read("G1 X2\nG0 X1 ?\nG0 Q1\nG7777\nX[1/0]\nM2\n");
  EXPECT_EQ(reading.problems(),
            "1:1 missing-feed; 2:7 bad-character; 3:4 unused-word; 4:1 unknown-code; 5:4 division-by-zero; ");
}

TEST(Diagnostics, DoNotCascade) {
  // No feed, no motion, an axis out of travel or missing: said once, not for each block.
  std::string lines;
  for (int i = 0; i < 50; ++i) lines += "X" + std::to_string(i % 2 + 1) + "\n";
  EXPECT_EQ(read("G1 Y1\n" + lines + "M2\n").errors, 1);
  EXPECT_EQ(read(lines + "M2\n").errors, 1);
  EXPECT_EQ(read("G0 Y600\n" + lines + "Y601\nM2\n").errors, 1);
  EXPECT_EQ(read("G0 F1? Y1\nG1\n" + lines + "M2\n").errors, 1);
  Conditions conditions;
  conditions.machine = machine::mill3();
  EXPECT_EQ(read("G0 A1\nA2\nA3\nB1\nM2\n", conditions).problems(), "1:4 unknown-axis; 4:1 unknown-axis; ");
  // Nor in an arc that names only the axes that are there.
  conditions.machine.axes[base::index(base::Axis::Y)].reset();
  EXPECT_EQ(read("F60 G2 X2 I1\nG3 X4 I1\nM2\n", conditions).problems(), "1:5 unknown-axis; ");
  EXPECT_EQ(read("F60 G2 X2 Y0 I1\nM2\n", conditions).problems(), "1:11 unknown-axis; ");
  EXPECT_EQ(read("F60 G18 G2 X2 I1\nM2\n", conditions).problems(), "");
}

TEST(Diagnostics, LeaveThePositionWhereTheBlockWouldHaveEnded) {
  const Reading reading = read("G0 X10 Q1\nG91 X5\nM2\n");
  ASSERT_EQ(reading.lines().size(), 1u);
  EXPECT_EQ(xyz(reading.lines()[0].start), (Point{10, 0, 0}));
  EXPECT_EQ(xyz(reading.lines()[0].end), (Point{15, 0, 0}));
}

TEST(Diagnostics, ShowTheirLine) {
  Conditions conditions;
  conditions.options.file = "part.ngc";
  const base::Diagnostic d = read("\nG0\tX1 (\xC3\xA9) ?\x01\xFF\r\nM2\n", conditions).diagnostics.at(0);
  EXPECT_EQ(d.place.file, "part.ngc");
  EXPECT_EQ(d.source, "G0 X1 (\xC3\xA9) ? ?");
  EXPECT_EQ(d.source.at(static_cast<std::size_t>(d.place.column) - 1), '?');
  EXPECT_FALSE(d.hint.empty());
}

TEST(Diagnostics, ShowTheBeginningOfLongLines) {
  const std::string blanks(150, ' ');
  const base::Diagnostic near = read("G0" + blanks + "?" + blanks + "\n").diagnostics.at(0);
  EXPECT_EQ(near.source.size(), 200u);
  EXPECT_EQ(near.source.at(static_cast<std::size_t>(near.place.column) - 1), '?');
  const base::Diagnostic far = read("G0" + blanks + blanks + "?\n").diagnostics.at(0);
  EXPECT_EQ(far.place.column, 303);
  EXPECT_EQ(far.source, "");
}

TEST(Diagnostics, EndWhereALoopOnlyRepeatsErrors) {
  Conditions conditions;
  conditions.options.fuel = 50'000'000;
  const Reading reading = read("#1=10\no1 while [1]\n#1=[#1*#1]\no1 endwhile\nM2\n", conditions);
  EXPECT_EQ(reading.problems(), "3:7 expression-domain; 3:7 too-many-problems; ");
}

// Visits of a line are counted modulo a million.
TEST(Diagnostics, ComeOnceHoweverOftenALoopPasses) {
  EXPECT_EQ(read("#1=0\no1 while [#1 LT 1100000]\n#1=[#1+1] (a (b) c)\no1 endwhile\nM2\n").problems(),
            "3:14 nested-comment; ");
}

TEST(Diagnostics, EndAfterAHundredErrors) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "?\n";
  const Reading reading = read(text);
  ASSERT_EQ(reading.diagnostics.size(), 101u);
  EXPECT_EQ(reading.diagnostics.back().code, "too-many-problems");
  EXPECT_EQ(reading.diagnostics.back().place.line, 100);
  EXPECT_TRUE(reading.moves.empty());
}

TEST(EmptyText, IsAnError) {
  for (const char* text : {"", "\n", " \n\t\r\n\n"}) {
    const Reading reading = read(text);
    ASSERT_EQ(reading.diagnostics.size(), 1u);
    EXPECT_EQ(reading.diagnostics[0].code, "empty-program");
    EXPECT_EQ(reading.errors, 1);
    EXPECT_TRUE(reading.moves.empty());
  }
}

TEST(DeepNesting, IsAnErrorAndNotACrash) {
  for (const char* opening : {"[", "#", "SIN[", "-[", "[1+[", "#[", "EXISTS[#"}) {
    std::string text = "G0 X";
    for (int i = 0; i < 8000; ++i) text += opening;
    const std::string problems = read(text + "\nM2\n").problems();
    EXPECT_NE(problems.find("nested-too-deep"), std::string::npos) << opening << " " << problems;
  }
}

TEST(Diagnostics, TellTextInUtf16Once) {
  using namespace std::literals;
  for (const std::string_view text :
       {"\xFF\xFEG\0000\0 \0X\0001\0\n\0M\0002\0\n\0"sv, "\xFE\xFF\0G\0000\0 \0X\0001\0\n"sv}) {
    const Reading reading = read(text);
    ASSERT_EQ(reading.errors, 1);
    EXPECT_EQ(reading.diagnostics[0].code, "bad-character");
    EXPECT_EQ(reading.diagnostics[0].message, "the text is in UTF-16, two bytes for a character");
  }
}

TEST(Diagnostics, KnowAnExponentWhereTheySeeOne) {
  const auto hint = [](std::string_view text) { return read(text).diagnostics.at(0).hint; };
  const std::string exponents = "numbers have no exponents: 1e-3 is written 0.001";
  EXPECT_EQ(hint("G0 X1e-5\nM2\n"), exponents);
  EXPECT_EQ(hint("#1=2.E3\nM2\n"), exponents);
  EXPECT_NE(hint("G0 X1 E5\nM2\n"), exponents);
}

}  // namespace test_diagnostics
}  // namespace leadscrew::gcode
