// Fanuc's custom macros, in the dialects that have them.

#include <leadscrew/gcode/number.hpp>
#include <string>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_macro_b {

// Where X comes to, move by move: "1 2 3 ".
std::string macro_xs(std::string_view program) {
  return ends_along_x(read_well(program, in_dialect(Dialect::fanuc)));
}

TEST(Macros, GoToBlocks) {
  EXPECT_EQ(macro_xs("GOTO 20\nN10 G0 X1\nGOTO 30\nN20 G0 X2\nGOTO[5+5]\nN30 G0 X3\nM30\n"), "2 1 3 ");
  EXPECT_EQ(macro_xs("#1=1\nN10 G0 X#1\n#1=[#1+1]\nIF[#1 LT 4]GOTO10\nM30\n"), "1 2 3 ");
  EXPECT_EQ(macro_xs("#1=20\nGOTO #1\nG0 X1\nN20 G0 X2\nM30\n"), "2 ");
}

TEST(Macros, ExecuteWhatStandsBehindThen) {
  EXPECT_EQ(macro_xs("#1=1\nIF [#1 EQ 1] THEN #2=5\nIF [#1 EQ 2] THEN #2=6\nG0 X#2\nM30\n"), "5 ");
  EXPECT_EQ(macro_xs("#1=1\nIF [#1 EQ 1] THEN GOTO 9\nG0 X1\nN9 G0 X2\nM30\n"), "2 ");
}

TEST(Macros, RepeatWhile) {
  EXPECT_EQ(macro_xs("#1=0\nWHILE [#1 LT 3] DO1\n#1=[#1+1]\nG0 X#1\nEND1\nM30\n"), "1 2 3 ");
  EXPECT_EQ(macro_xs("WHILE [0] DO 1\nG0 X1\nEND 1\nG0 X2\nM30\n"), "2 ");
  EXPECT_EQ(macro_xs("#1=0\nDO1\n#1=[#1+1]\nIF [#1 GT 3] GOTO 5\nG0 X#1\nEND1\nN5 M30\n"), "1 2 3 ");
  EXPECT_EQ(
      macro_xs("#1=0\nWHILE[#1 LT 2]DO1\n#2=0\nWHILE[#2 LT 2]DO2\nG0 X[10*#1+#2]\n#2=[#2+1]\nEND2\n#1=[#1+1]\nEND1\n"
               "WHILE[#1 LT 3]DO1\nG0 X[50]\n#1=[#1+1]\nEND1\nM30\n"),
      "1 10 11 50 ");
}

TEST(Macros, AreCalledWithLetters) {
  EXPECT_EQ(macro_xs("#1=9\nG65 P8000 A1 B2 (remark) X30 M4\nG0 X#1\nM30\nO8000\nG0 X[#1+#2+#24+#13]\nM99\n"), "37 9 ");
  EXPECT_EQ(macro_xs("G65 P8000 A1 I1 J2 K3 I4 J5 K6 K9\nM30\nO8000\nG0 X[#4+#5*10+#6*100]\nG0 X[#7+#8*10+#9*100-400]\n"
                     "G0 X#12\nM99\n"),
            "321 254 9 ");
  EXPECT_EQ(macro_xs("G65 P8000 L3 A1\nM30\nO8000\nG91 G0 X#1\n#1=7\nM99\n"), "1 2 3 ");
  EXPECT_EQ(macro_xs("G65 P8000 A1\nM30\nO8000\nIF [#2 EQ #0] GOTO 5\nG0 X1\nN5 G0 X2\nM99\n"), "2 ");
}

// Fanuc 0i operator's manual, "Local variables" and "Macro call nesting": #1 to #33 are of a level, which G65 begins and
// M99 ends, and M98 does not.
TEST(Macros, HaveThirtyThreeVariablesALevel) {
  const std::string main = "#1=1\n#31=31\n#33=33\n";
  EXPECT_EQ(macro_xs(main + "G65 P8000 B2\nG0 X[#31+#33+#1]\nM30\nO8000\n"
                            "IF [#33 NE #0] GOTO 9\nIF [#31 NE #0] GOTO 9\nIF [#1 NE #0] GOTO 9\n"
                            "#33=5\n#31=6\nG65 P8001\nG0 X[#31+#33]\nN9 M99\n"
                            "O8001\nIF [#33 NE #0] GOTO 9\nG0 X2\n#33=8\nN9 M99\n"),
            "2 11 65 ");
  EXPECT_EQ(macro_xs(main + "M98 P8000\nG0 X#33\nM30\nO8000\nG0 X[#31+#33]\n#33=7\nM99\n"), "64 7 ");
  EXPECT_EQ(
      macro_xs("#33=9\nG65 P8000 I0 J0 K0 I0 J0 K0 I0 J0 K0 I0 J0 K0 I0 J0 K0 I0 J0 K0 I0 J0 K0 I0 J0 K0 I0 J0 K0 "
               "I31 J32 K33\nG0 X#33\nM30\nO8000\nG0 X[#31-#32*10+#33*10]\nM99\n"),
      "41 9 ");
}

TEST(Macros, TellWhatIsWrong) {
  const struct {
    std::string_view text, problems;
  } rows[] = {
      {"GOTO 5\nM30\n", "1:1 missing-label; "},
      {"GOTO 5\nN5 G0 X1\nN5 G0 X2\nM30\n", "1:1 duplicate-label; "},
      {"GOTO 5\nWHILE[1]DO1\nN5 G0 X1\nEND1\nM30\n", "1:1 goto-into-loop; "},
      {"GOTO 0\nM30\n", "1:1 bad-value; "},
      {"GOTO X\nM30\n", "1:6 bad-number; "},
      {"GOTO 5\nM30\nO2\nN5 G0 X1\nM99\n", "1:1 missing-label; "},
      {"IF [1] G0 X1\nM30\n", "1:1 bad-o-word; "},
      {"WHILE [1] G0 X1\nM30\n", "1:1 bad-o-word; "},
      {"WHILE [1] DO4\nM30\n", "1:1 bad-value; "},
      {"WHILE [1] DO1\nM30\n", ""},
      {"WHILE [0] DO1\nM30\n", "1:1 unmatched-o-word; "},
      {"END1\nM30\n", "1:1 unmatched-o-word; "},
      {"DO1\nEND2\nM30\n", "2:1 unmatched-o-word; "},
      {"DO1\nDO1\nM30\n", "2:1 duplicate-label; "},
      {"G65 A1\nM30\n", "1:1 missing-word; "},
      {"G65 P1 N1\nM30\n", "1:8 unused-word; "},
      {"G65 P1 L-1\nM30\n", "1:1 bad-value; "},
      {"G65 P1 I1 I1 I1 I1 I1 I1 I1 I1 I1 I1 I1\nM30\n", "1:38 too-many-arguments; "},
      {"G90 G65 P1\nM30\n", "1:5 bad-o-word; "},
      {"o1 if [1]\nM30\n", "1:1 unsupported-o-word; "},
  };
  for (const auto& row : rows)
    EXPECT_EQ(read(row.text, in_dialect(Dialect::fanuc)).problems(), row.problems) << row.text;
}

TEST(Macros, AreNotOfOtherDialects) {
  EXPECT_NE(read("GOTO 5\nN5 M2\n").problems(), "");
  EXPECT_NE(read("WHILE [1] DO1\nM2\n").problems(), "");
}

TEST(Macros, WithoutEndEnd) {
  Conditions conditions = in_dialect(Dialect::fanuc);
  conditions.options.fuel = 1000;
  EXPECT_EQ(read("N5 GOTO 5\nM30\n", conditions).problems(), "1:1 fuel-exhausted; ");
  std::string chain;
  for (int i = 1; i <= 500; ++i) chain += "GOTO " + std::to_string(i) + "\nN" + std::to_string(i) + "\n";
  EXPECT_EQ(read(chain + "M30\n", conditions).diagnostics.at(0).code, "fuel-exhausted");
  EXPECT_EQ(read(chain + "M30\n", in_dialect(Dialect::fanuc)).problems(), "");
  EXPECT_EQ(read("DO1\nEND1\nM30\n", conditions).problems(), "1:1 fuel-exhausted; ");
}

}  // namespace test_macro_b
}  // namespace leadscrew::gcode
