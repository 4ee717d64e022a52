// What `check --lint` warns of, and what it does not.

#include <leadscrew/gcode/frame.hpp>
#include <leadscrew/gcode/modal_state.hpp>
#include <leadscrew/language/lint.hpp>

#include "reading.hpp"

namespace leadscrew::language {
namespace test_lint {

std::string found_in(std::string_view text, std::optional<double> stock_top = {},
                     machine::Machine machine = gcode::nine_axes()) {
  const machine::ToolTable tools;
  gcode::ReaderOptions options;
  options.dialect = machine.dialect;
  options.warns_of_unset = true;
  std::string found;
  gcode::Reader reader(gcode::text_source(text), machine, tools, options, [&](const base::Diagnostic& each) {
    if (each.severity == base::Severity::note) return;
    found += std::to_string(each.place.line) + " " + std::string(each.code) + "; ";
  });
  Lint lint(machine, stock_top);
  gcode::Move move;
  while (reader.next(move)) {
    for (const base::Diagnostic& each : lint.see(move, reader.frame(), reader.modal())) reader.warn(move, each);
  }
  return found;
}

const std::string ready = "T1 M6\nS1000 M3\nG0 Z5\n";

TEST(Lint, FindsNothingInAPlainProgram) {
  EXPECT_EQ(found_in(ready + "G0 X10 Y10\nG1 Z-2 F20\nX50 F600\nG0 Z5\nX0\nM5\nM2\n"), "");
}

TEST(Lint, FindsThatTheSpindleStandsBehindAChangeOfTool) {
  EXPECT_EQ(found_in(ready + "G1 Z-2 F20\nG0 Z5\nT2 M6\nG1 Z-2\nG0 Z5\nM2\n"), "7 lint-spindle-off; ");
}

TEST(Lint, FindsNothingInProbing) {
  EXPECT_EQ(found_in("G0 X0 Z5\nG38.2 Z-1 F20\nG38.2 X9\nM2\n"), "");
}

TEST(Lint, FindsRapidsBelowTheTop) {
  EXPECT_EQ(found_in(ready + "G0 Z-2\nX10\nZ5\nX0\nM2\n"), "4 lint-rapid; 5 lint-rapid; ");
  EXPECT_EQ(found_in(ready + "G0 Z1\nX10\nM2\n", 2.0), "4 lint-rapid; 5 lint-rapid; ");
  EXPECT_EQ(found_in(ready + "G0 Z-2\nX10\nM2\n", -3.0), "");
}

TEST(Lint, TheTopIsThatOfTheOffsetInForce) {
  EXPECT_EQ(found_in("G10 L2 P1 Z-20\n" + ready + "G0 Z1\nX10\nM2\n"), "");
  EXPECT_EQ(found_in("G10 L2 P1 Z20\nT1 M6\nG0 Z-1\nX10\nM2\n"), "4 lint-rapid; ");
}

// There Z0 is the face of the work, and rapids beside it are usual.
TEST(Lint, KnowsNoTopOnLathes) {
  EXPECT_EQ(found_in("G18\n" + ready + "G0 X22 Z-10\nG1 X20 F100\nZ-20\nG0 X30\nM2\n"), "");
}

TEST(Lint, KnowsNoTopInTheMachinesCoordinates) {
  EXPECT_EQ(found_in(ready + "G53 G0 Z-2\nG53 G0 X10\nZ5\nM2\n"), "");
  EXPECT_EQ(found_in(ready + "G53 G0 Z-2\nG0 X10\nM2\n"), "5 lint-rapid; ");
}

TEST(Lint, LetsCyclesGoBackIntoTheirHoles) {
  EXPECT_EQ(found_in(ready + "G83 X10 Z-10 R1 Q3 F100\nX20\nG80\nM2\n"), "");
}

TEST(Lint, LetsFineBoringLeaveTheWall) {
  machine::Machine haas = gcode::nine_axes();
  haas.dialect = machine::Dialect::haas;
  EXPECT_EQ(found_in(ready + "G99 G76 X10 Z-10 R2 Q0.2 F100\nG80\nG0 Z-1 X0\nM30\n", {}, haas), "6 lint-rapid; ");
}

TEST(Lint, LetsFanucsTappingTurnTheSpindle) {
  machine::Machine haas = gcode::nine_axes();
  haas.dialect = machine::Dialect::haas;
  const std::string tapping = "T1 M6\nG0 Z5\nG95 G84 X10 Z-10 R2 F1 S500\nG80\nG94 ";
  EXPECT_EQ(found_in(tapping + "M30\n", {}, haas), "");
  EXPECT_EQ(found_in(tapping + "G1 Z-1 X30 F100\nM30\n", {}, haas), "5 lint-spindle-off; ");
}

TEST(Lint, FindsCutsWithoutASpindleOrATool) {
  EXPECT_EQ(found_in("G0 X0 Z5\nG1 Z-1 F100\nX50\nM2\n"), "2 lint-no-tool; 2 lint-spindle-off; ");
  EXPECT_EQ(found_in(ready + "G1 Z-1 F100\nM5\nX50 F600\nM3\nX0\nM5\nX5\nM2\n"),
            "6 lint-spindle-off; 10 lint-spindle-off; ");
  machine::Machine grbl = gcode::nine_axes();
  grbl.dialect = machine::Dialect::grbl;
  EXPECT_EQ(found_in("M3 S1000\nG1 X1 Z-1 F100\nM2\n", {}, grbl), "");
}

TEST(Lint, FindsFeedsThatLookLikeInches) {
  EXPECT_EQ(found_in(ready + "G21 G1 X50 F12\nM2\n"), "4 lint-feed-unit; ");
  EXPECT_EQ(found_in(ready + "G20\nG1 X2 F12\nM2\n"), "");
  EXPECT_EQ(found_in(ready + "G21 G1 Z1 F12\nM2\n"), "");
}

TEST(Lint, FindsParametersThatWereNeverSet) {
  const std::string set = "#1=1\n#<n>=300\n#300=0\n", read = "G0 X[#1+#300] Y#5421\nG0 X##<n>\n";
  EXPECT_EQ(found_in(set + "G0 X[EXISTS[#2]]\nM2\n"), "");
  EXPECT_EQ(found_in(set + "#300=1\n" + read + "M2\n"), "");
  EXPECT_EQ(found_in("G0 X#2\nG0 Y[#3+#1234]\nM2\n"),
            "1 lint-unset-parameter; 2 lint-unset-parameter; 2 lint-unset-parameter; ");
  EXPECT_EQ(found_in("o1 while [#7 LT 3]\n#7=[#7+#8]\n#8=1\no1 endwhile\nM2\n"),
            "1 lint-unset-parameter; 2 lint-unset-parameter; 2 lint-unset-parameter; ");
  EXPECT_EQ(found_in("o1 sub\nG0 X#2\no1 endsub\no1 call [5]\nM2\n"), "");  // arguments are given, as 0
  machine::Machine fanuc = gcode::nine_axes();
  fanuc.dialect = machine::Dialect::fanuc;
  EXPECT_EQ(found_in("IF [#2 EQ #0] THEN #2=1\nG0 X#2\nM30\n", {}, fanuc), "");
}

TEST(Lint, TellsAFewOfEachKind) {
  std::string program = ready;
  for (int i = 1; i <= 50; ++i) program += "G0 Z-1 X" + std::to_string(i) + "\n";
  const std::string found = found_in(program + "M2\n");
  EXPECT_EQ(std::ranges::count(found, ';'), 10);
}

}  // namespace test_lint
}  // namespace leadscrew::language
