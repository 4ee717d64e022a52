// Subprograms: O words, program numbers, M97 to M99, files; and where the blocks of each say they come from.

#include <leadscrew/gcode/number.hpp>
#include <map>
#include <string>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_subprograms {

// Where X comes to, move by move: "1 2 3 ".
std::string subprogram_xs(const Reading& reading) {
  std::string result;
  for (const Move& move : reading.lines()) result += text(at(move.end, base::Axis::X)) + " ";
  return result;
}

std::string xs(std::string_view program, const Conditions& conditions = {}) {
  return subprogram_xs(read_well(program, conditions));
}

Conditions of(Dialect dialect) {
  Conditions conditions;
  conditions.options.dialect = dialect;
  return conditions;
}

// Texts by their names; the program's own is "".
Conditions with_files(std::map<std::string, std::string> texts) {
  Conditions conditions;
  conditions.options.file = "main.ngc";
  conditions.options.opener = [texts = std::move(texts)](const std::string& name,
                                                         std::int64_t offset) -> base::Result<base::OpenedText> {
    const auto found = texts.find(name);
    if (found == texts.end()) return base::failure(base::problem("missing-sub", "no such file", ""));
    const std::string_view text = found->second;
    return base::OpenedText{text_source(text.substr(std::min(text.size(), static_cast<std::size_t>(offset)))),
                            name + ".ngc"};
  };
  return conditions;
}

Reading read_files(const std::map<std::string, std::string>& texts) {
  return read(texts.at(""), with_files(texts));
}

TEST(Subprograms, TakeArgumentsAndGiveBackLocals) {
  EXPECT_EQ(xs("o1 sub\ng0 x[#1+#2+#30]\no1 endsub\n#1=7\no1 call [1] [2]\ng0 x#1\no1 call\nm2\n"), "3 7 0 ");
  EXPECT_EQ(xs("o1 sub\n#<a>=5\ng0 x#<a>\no1 endsub\n#<a>=2\no1 call\ng0 x#<a>\nm2\n"), "5 2 ");
}

TEST(Subprograms, ReturnValues) {
  EXPECT_EQ(xs("o<f> sub\no1 if [#1 gt 0]\no<f> return [#1*2]\no1 endif\no<f> endsub [9]\n"
               "o<f> call [3]\ng0 x#<_value>\no<f> call [0]\ng0 x#<_value>\ng0 x[100+#<_value_returned>]\nm2\n"),
            "6 9 101 ");
  EXPECT_EQ(xs("o<f> sub\no<f> endsub\no<f> call\ng0 x[100+#<_value_returned>]\nm2\n"), "100 ");
}

TEST(Subprograms, StandBehindTheProgramToo) {
  EXPECT_EQ(xs("o100 call\no100 call\nm2\no100 sub\ng91 g0 x1\no100 endsub\n"), "1 2 ");
}

TEST(Subprograms, HaveNamesOfAnyCase) {
  EXPECT_EQ(xs("O<Foo Bar> SUB\ng0 x1\no<foobar> EndSub\no<FOO BAR>call\nm2\n"), "1 ");
  EXPECT_EQ(xs("o<1> sub\ng0 x1\no<1> endsub\no1 call\nm2\n"), "1 ");
  EXPECT_EQ(xs("#7=100\no100 sub\ng0 x#1\no100 endsub\no[#7] call [3]\no#7 call [5]\nm2\n"), "3 5 ");
}

// As rs274 has them: the first of a number, and none that the program comes to twice.
TEST(Subprograms, AreTheFirstOfTheirNumberInLinuxCnc) {
  const Conditions linuxcnc = of(Dialect::linuxcnc);
  EXPECT_EQ(xs("m98 p0002\nm2\nO0002\ng0 x1\nm99\nO2\ng0 x2\nm99\n", linuxcnc), "1 ");
  EXPECT_EQ(xs("o1 call\nm2\no1 sub\ng0 x1\no1 endsub\no1 sub\ng0 x2\no1 endsub\n", linuxcnc), "1 ");
  EXPECT_EQ(read("o1 sub\no1 endsub\no1 sub\no1 endsub\nm2\n", linuxcnc).problems(), "3:1 misplaced-sub; ");
  EXPECT_EQ(read("o1 call\no1 sub\no1 endsub\nm2\n", linuxcnc).problems(), "2:1 misplaced-sub; ");
  EXPECT_EQ(read("o2 repeat [2]\no1 sub\no1 endsub\no2 endrepeat\nm2\n", linuxcnc).problems(), "2:1 misplaced-sub; ");
  EXPECT_EQ(xs("o1 call\no1 sub\ng0 x1\no1 endsub\nm2\n"), "1 ");
}

TEST(Subprograms, CallThemselves) {
  EXPECT_EQ(xs("o1 sub\no2 if [#1 gt 0]\no1 call [#1-1]\no2 endif\ng0 x[#1+1]\no1 endsub\no1 call [3]\nm2\n"),
            "1 2 3 4 ");
}

TEST(Subprograms, LeaveTheirLoopsOpen) {
  EXPECT_EQ(xs("o1 sub\no2 while [1]\ng0 x#1\no1 return\no2 endwhile\no1 endsub\n"
               "o2 repeat [2]\no1 call [1]\no1 call [2]\no2 endrepeat\nm2\n"),
            "1 2 1 2 ");
}

TEST(Subprograms, BoundRecursion) {
  const std::string endless = "o1 sub\no1 call\no1 endsub\no1 call\nm2\n";
  EXPECT_EQ(read(endless).problems(), "2:1 calls-too-deep; ");
  const auto nested = [](int depth) {
    return "o1 sub\no2 if [#1 gt 1]\no1 call [#1-1]\no2 endif\no1 endsub\no1 call [" + std::to_string(depth) +
           "]\nm2\n";
  };
  EXPECT_EQ(read(nested(64)).problems(), "");
  EXPECT_EQ(read(nested(65)).problems(), "3:1 calls-too-deep; ");
  EXPECT_EQ(read(nested(9), of(Dialect::linuxcnc)).problems(), "");
  EXPECT_EQ(read(nested(10), of(Dialect::linuxcnc)).problems(), "3:1 calls-too-deep; ");
}

TEST(Subprograms, TellWhatIsWrongWithThem) {
  std::string many = "o1 sub\no1 endsub\no1 call ";
  for (int i = 0; i < 31; ++i) many += "[1]";
  const struct {
    std::string text, problems;
  } rows[] = {
      {"o1 sub\n", "1:1 unmatched-o-word; "},
      {"o1 sub\no2 sub\n", "2:1 nested-sub; "},
      {"o1 sub\no1 endsub\no1 sub\no1 endsub\n", "3:1 duplicate-sub; "},
      {"o1 call\nm2\no1 sub\no1 endsub\no1 sub\no1 endsub\n", "5:1 duplicate-sub; "},
      {"o1 endsub\n", "1:1 return-outside-sub; "},
      {"o1 return\n", "1:1 return-outside-sub; "},
      {"o1 sub\no2 if [1]\no1 endsub\no1 call\n", "3:1 unmatched-o-word; "},
      {"o7 call\nm2\n", "1:1 missing-sub; "},
      {"o<x> call\nm2\n", "1:1 missing-sub; "},
      {"m98 p7\nm2\n", "1:1 missing-sub; "},
      {"m98 l7\nm2\n", "1:1 missing-word; "},
      {"m98 p1.5\nm2\n", "1:5 bad-value; "},
      {"m98 p1 l-1\nm2\n", "1:8 bad-value; "},
      {"o1\nm98 p1\n", "2:1 calls-too-deep; "},
      {"m98 p2\nm30\no2\ng0 x1\n", "3:1 unmatched-o-word; "},
      {"o1 sub\no1 endsub\nm98 p1\nm2\n", "3:1 missing-sub; "},
      {"o1 call\nm2\no1\nm99\n", "1:1 missing-sub; "},
      {many + "\n", "3:1 too-many-arguments; "},
  };
  for (const auto& row : rows) EXPECT_EQ(read(row.text).problems(), row.problems) << row.text;
}

TEST(Subprograms, TakeValuesOnBothSidesOfRemarks) {
  EXPECT_EQ(xs("o1 sub\ng0 x[#1+10*#2]\no1 endsub\no1 call [1] (a (b) c) [2] (d) ; [3]\nm2\n"), "21 ");
  EXPECT_EQ(read("o1 sub\no1 endsub (a) b\no1 call\nm2\n").problems(), "2:15 bad-o-word; ");
}

// LinuxCNC takes any name: the subroutine is the one that the return stands in.
TEST(Subprograms, ReturnUnderAnyName) {
  EXPECT_EQ(xs("o1 sub\no2 if [#1 gt 0]\no2 return [7]\no2 endif\no1 endsub [8]\no1 call [1]\ng0 x#<_value>\nm2\n"),
            "7 ");
}

TEST(Subprograms, OfProgramNumbersAreCalledByM98) {
  const std::string program =
      "%\nO1 (MAIN)\ng91\nm98 p100 l3\nm98 p0200\nm98 p100 l0\nm30\n:100\ng0 x1\nm99\nO200\ng0 x10\nm99\n%\n";
  EXPECT_EQ(xs(program), "1 2 3 13 ");
  EXPECT_EQ(xs(program, of(Dialect::fanuc)), "1 2 3 13 ");
  EXPECT_EQ(xs("O1\nM98 P30100\nM30\nO100\nG91 G0 X1\nM99\n", of(Dialect::fanuc)), "1 2 3 ");
  EXPECT_EQ(xs("g0 x5 m98 p100\nm30\no100\ng0 x1\nm99\n"), "5 1 ");
}

TEST(Subprograms, OfProgramNumbersShareParameters) {
  EXPECT_EQ(xs("#1=5\nm98 p100\ng0 x#1\nm30\no100\n#1=7\nm99\n"), "7 ");
}

TEST(Subprograms, OfBlockNumbersAreCalledByM97) {
  EXPECT_EQ(xs("G91\nM97 P100 L2\nG0 X10\nM30\nN100 G0 X1\nM99\n", of(Dialect::haas)), "1 2 12 ");
  EXPECT_EQ(read("M97 P100\nM30\n", of(Dialect::haas)).problems(), "1:1 missing-label; ");
}

TEST(Subprograms, MayReturnToABlock) {
  EXPECT_EQ(xs("M98 P5\nG0 X1\nN50 G0 X2\nM30\nO5\nM99 P50\n", of(Dialect::fanuc)), "2 ");
}

TEST(Subprograms, M99EndsAMainProgramOrBeginsItAgain) {
  const Reading once = read_well("g91 g0 x1\nm99\ng0 x2\nm2\n");
  EXPECT_EQ(subprogram_xs(once), "1 ");
  ASSERT_EQ(once.diagnostics.size(), 1u);
  EXPECT_EQ(once.diagnostics[0].code, "program-repeats");
  EXPECT_EQ(once.events().back().kind, base::Event::Kind::program_end);
  Conditions conditions;
  conditions.options.repeats = true;
  EXPECT_EQ(xs("#1=[#5420+1]\ng0 x#1\no1 if [#1 lt 3]\nm99\no1 endif\nm2\n", conditions), "1 2 3 ");
}

TEST(Subprograms, InFilesAreFoundByName) {
  const Reading reading =
      read_files({{"", "g0 x1\no<part> call [2]\no5 call\nm98 p7\ng0 x9\nm2\n"},
                  {"part", "g0 x99\no<part> sub\ng0 x#1\no<in> call\no<part> endsub\no<in> sub\ng0 x3\no<in> endsub\n"},
                  {"5", "o5 sub\ng0 x4\no5 endsub\nm2\n"},
                  {"7", "%\ng0 x5\nm99\n%\n"}});
  EXPECT_EQ(reading.problems(), "");
  EXPECT_EQ(subprogram_xs(reading), "1 2 3 4 5 9 ");
  const int files[] = {0, 1, 1, 2, 3, 0};
  const int lines[] = {1, 3, 7, 2, 2, 5};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(base::file(reading.lines()[i].line), files[i]);
    EXPECT_EQ(base::number(reading.lines()[i].line), lines[i]);
  }
}

TEST(Subprograms, InFilesHaveProblemsOfTheirOwnPlaces) {
  const Reading reading = read_files({{"", "o<a> call\no<a> call\nm2\n"}, {"a", "o<a> sub\ng0 q1\no<a> endsub\n"}});
  ASSERT_EQ(reading.problems(), "2:4 unused-word; ");
  EXPECT_EQ(reading.diagnostics[0].place.file, "a.ngc");
  const Reading open = read_files({{"", "o<a> call\nm2\n"}, {"a", "o<a> sub\ng0 x1\n"}});
  EXPECT_EQ(open.diagnostics.at(0).place.file, "a.ngc");
  EXPECT_EQ(read_files({{"", "o<a> call\nm2\n"}, {"a", "o<b> sub\no<b> endsub\n"}}).problems(), "1:1 missing-sub; ");
}

TEST(Places, OfBlocksThatAreReadAgainDiffer) {
  const Reading reading = read_well("g91\no1 repeat [3]\ng0 x1\no1 endrepeat\ng0 x5\nm2\n");
  const auto lines = reading.lines();
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0].line, base::Line{3});
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_TRUE(base::is_before(lines[i - 1].line, lines[i].line));
    EXPECT_EQ(base::number(lines[i].line), i < 3 ? 3 : 5);
  }
}

TEST(Places, OfProblemsAreToldOnce) {
  EXPECT_EQ(read("g91\no1 repeat [30]\ng0 x1 q1\no1 endrepeat\nm2\n").problems(), "3:7 unused-word; ");
  EXPECT_EQ(read("o1 repeat [30]\nt999 m6\no1 endrepeat\nm2\n").problems(), read("\nt999 m6\nm2\n").problems());
}

}  // namespace test_subprograms
}  // namespace leadscrew::gcode
