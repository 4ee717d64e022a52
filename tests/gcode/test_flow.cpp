// Loops and conditions go where LinuxCNC's manual has them go; structure that cannot be followed is told.

#include <leadscrew/gcode/number.hpp>
#include <string>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_flow {

std::string xs(std::string_view program, const Conditions& conditions = {}) {
  return ends_along_x(read_well(program, conditions));
}

TEST(Flow, RepeatsWhileAConditionHolds) {
  EXPECT_EQ(xs("#1=0\no100 while [#1 lt 3]\n#1=[#1+1]\ng0 x#1\no100 endwhile\ng0 x9\nm2\n"), "1 2 3 9 ");
  EXPECT_EQ(xs("o100 while [0]\ng0 x1\no100 endwhile\ng0 x9\nm2\n"), "9 ");
}

TEST(Flow, RepeatsUntilAConditionFailsAtTheEnd) {
  EXPECT_EQ(xs("#1=7\no<l> do\n#1=[#1+1]\ng0 x#1\no<l> while [#1 lt 3]\ng0 x9\nm2\n"), "8 9 ");
  EXPECT_EQ(xs("#1=0\no<l> do\n#1=[#1+1]\ng0 x#1\no<l> while [#1 lt 3]\nm2\n"), "1 2 3 ");
}

TEST(Flow, RepeatsSoManyTimes) {
  EXPECT_EQ(xs("g91\no1 repeat [3]\ng0 x1\no1 endrepeat\nm2\n"), "1 2 3 ");
  EXPECT_EQ(xs("g91\no1 repeat [2.6]\ng0 x1\no1 endrepeat\nm2\n"), "1 2 3 ");
  EXPECT_EQ(xs("g91\no1 repeat [0]\ng0 x1\no1 endrepeat\ng0 x7\nm2\n"), "7 ");
  EXPECT_EQ(xs("g91\no1 repeat [-1]\ng0 x1\no1 endrepeat\ng0 x7\nm2\n"), "7 ");
}

TEST(Flow, TakesTheFirstBranchWhoseConditionHolds) {
  const auto branch = [](int value) {
    return xs("#1=" + std::to_string(value) +
              "\no1 if [#1 eq 1]\ng0 x1\no1 elseif [#1 le 2]\ng0 x2\no1 elseif [#1 le 3]\ng0 x3\no1 else\ng0 x4\n"
              "o1 endif\nm2\n");
  };
  EXPECT_EQ(branch(1), "1 ");
  EXPECT_EQ(branch(2), "2 ");
  EXPECT_EQ(branch(3), "3 ");
  EXPECT_EQ(branch(4), "4 ");
}

TEST(Flow, SkipsConditionsWithinThoseThatDoNotHold) {
  EXPECT_EQ(xs("o1 if [0]\no2 if [1]\no2 else\ng0 x1\no2 endif\no1 else\ng0 x2\no1 endif\nm2\n"), "2 ");
}

TEST(Flow, BreaksAndGoesOn) {
  EXPECT_EQ(xs("#1=0\no1 while [1]\n#1=[#1+1]\no2 if [#1 eq 2]\no1 continue\no2 endif\no3 if [#1 eq 5]\no1 break\n"
               "o3 endif\ng0 x#1\no1 endwhile\ng0 x9\nm2\n"),
            "1 3 4 9 ");
  EXPECT_EQ(xs("#1=0\no1 do\n#1=[#1+1]\no2 if [#1 eq 2]\no1 continue\no2 endif\ng0 x#1\no1 while [#1 lt 4]\nm2\n"),
            "1 3 4 ");
  EXPECT_EQ(xs("#1=0\no1 repeat [4]\n#1=[#1+1]\no2 if [#1 eq 2]\no1 continue\no2 endif\ng0 x#1\no1 endrepeat\nm2\n"),
            "1 3 4 ");
}

TEST(Flow, LeavesSeveralLoopsAtOnce) {
  EXPECT_EQ(
      xs("o1 while [1]\no2 repeat [5]\no3 do\ng0 x1\no1 break\no3 while [1]\no2 endrepeat\no1 endwhile\ng0 x9\nm2\n"),
      "1 9 ");
}

TEST(Flow, ReadsStatementsHoweverTheyAreWritten) {
  EXPECT_EQ(xs("N10 O 1 0 0 IF[1](yes)\nn20 g0 x1\nn30 o100 EndIf ; done\nm2\n"), "1 ");
  EXPECT_EQ(xs("/o1 if [0]\ng0 x1\n/o1 endif\nm2\n"), "1 ");
  EXPECT_EQ(xs("o[99+1] if [1]\ng0 x1\no100 endif\nm2\n"), "1 ");
}

TEST(Flow, ALabelMayBeUsedAgainBehindItsEnd) {
  const std::string program =
      "#1=0\no1 while [#1 lt 2]\n#1=[#1+1]\no1 endwhile\no1 repeat [2]\ng91 g0 x1\no1 endrepeat\nm2\n";
  EXPECT_EQ(xs(program), "1 2 ");
  Conditions linuxcnc;
  linuxcnc.options.dialect = Dialect::linuxcnc;
  EXPECT_EQ(read(program, linuxcnc).problems(), "5:1 duplicate-label; ");
}

TEST(Flow, OfLinuxCncTakesNoMoreThanThat) {
  Conditions linuxcnc;
  linuxcnc.options.dialect = Dialect::linuxcnc;
  EXPECT_EQ(read("o1 repeat [2]\no1 break\no1 endrepeat\nm2\n", linuxcnc).problems(), "2:1 unmatched-o-word; ");
  EXPECT_EQ(read("g0 x1 m98 p1\nm2\no1\nm99\n", linuxcnc).problems(), "1:7 bad-o-word; ");
  EXPECT_EQ(read("m98 p1\nm2\nn5\no1\nm99 p5\n", linuxcnc).problems(), "5:1 bad-o-word; ");
  EXPECT_EQ(read("o1 sub\nm99\no1 endsub\no1 call\nm2\n", linuxcnc).problems(), "2:1 unmatched-o-word; ");
}

TEST(Flow, TellsWhatIsNotMatched) {
  const struct {
    std::string_view text, problems;
  } rows[] = {
      {"o1 if [1]\nm2\no2 if [1]\n", ""},
      {"o1 if [0]\nm2\n", "1:1 unmatched-o-word; "},
      {"o1 if [1]\n", "1:1 unmatched-o-word; "},
      {"g0 x1\n\n o1 endif\nm2\n", "3:2 unmatched-o-word; "},
      {"o1 else\n", "1:1 unmatched-o-word; "},
      {"o1 endwhile\n", "1:1 unmatched-o-word; "},
      {"o1 endrepeat\n", "1:1 unmatched-o-word; "},
      {"o1 while [0]\n", "1:1 unmatched-o-word; "},
      {"o1 repeat [0]\n", "1:1 unmatched-o-word; "},
      {"o1 do\no2 endif\n", "2:1 unmatched-o-word; "},
      {"o1 break\n", "1:1 unmatched-o-word; "},
      {"o1 if [1]\no1 continue\n", "2:1 unmatched-o-word; "},
      {"o1 while [1]\no2 if [1]\no1 endwhile\n", "3:1 unmatched-o-word; "},
      {"o1 if [1]\no1 if [1]\n", "2:1 duplicate-label; "},
      {"o1 if [0]\no1 if [1]\no1 endif\n", "2:1 duplicate-label; "},
      {"o1 if 1\n", "1:7 bad-o-word; "},
      {"o1 repeat #1\n", "1:11 bad-o-word; "},
      {"o1 if [1] g0 x1\n", "1:11 bad-o-word; "},
      {"o1 fi [1]\n", "1:1 bad-o-word; "},
      {"o<> if [1]\n", "1:2 bad-o-word; "},
      {"o<a if [1]\n", "1:2 bad-o-word; "},
      {"o[0-1] if [1]\n", "1:2 bad-value; "},
      {"o1 repeat [1e]\n", "1:13 bad-operator; "},
      {"o1 repeat [9**99]\n", "1:1 bad-value; "},
      {"o1 while [#<no> lt 2]\n", "1:11 unset-parameter; "},
  };
  for (const auto& row : rows) EXPECT_EQ(read(row.text).problems(), row.problems) << row.text;
}

TEST(Flow, EndsLoopsWithoutEnd) {
  Conditions conditions;
  conditions.options.fuel = 1000;
  EXPECT_EQ(read("o1 while [1]\no1 endwhile\nm2\n", conditions).problems(), "1:1 fuel-exhausted; ");
  EXPECT_EQ(read("o1 do\no1 while [1]\nm2\n", conditions).problems(), "1:1 fuel-exhausted; ");
  const Reading moving = read("g91\no1 while [1]\ng0 x1\ng0 x-1\no1 endwhile\nm2\n", conditions);
  EXPECT_EQ(moving.errors, 1);
  EXPECT_EQ(moving.diagnostics.back().code, "fuel-exhausted");
}

TEST(Flow, FuelIsForWhatIsReadAgain) {
  Conditions conditions;
  conditions.options.fuel = 0;
  std::string program;
  for (int i = 0; i < 100; ++i) program += "g0 x" + std::to_string(i) + "\no1 if [0]\ng0 x1\no1 endif\n";
  EXPECT_EQ(read(program + "m2\n", conditions).errors, 0);
}

TEST(Flow, BoundsNesting) {
  std::string inner;
  for (int i = 0; i < 10'000; ++i) inner += "o" + std::to_string(i) + " if [1]\n";
  EXPECT_EQ(read(inner).problems(), "101:1 nested-too-deep; ");
}

TEST(Flow, ReadsLoopsThatNoWindowHolds) {
  std::string program = "g91\no1 repeat [3]\ng0 x1\n";
  for (int i = 0; i < 20'000; ++i) program += "(a remark that fills the window)\n";
  EXPECT_EQ(xs(program + "o1 endrepeat\ng0 x5\nm2\n"), "1 2 3 8 ");
}

TEST(Flow, GoesBackOnlySoFarInATextThatComesOnce) {
  std::string program = "o1 repeat [2]\n";
  while (program.size() < (std::size_t{17} << 20)) program += "(a remark that is longer than the others, to fill)\n";
  EXPECT_EQ(read(program + "o1 endrepeat\nm2\n").diagnostics.at(0).code, "text-not-kept");
}

}  // namespace test_flow
}  // namespace leadscrew::gcode
