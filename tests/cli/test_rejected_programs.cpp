// What is wrong with a program is said at its place, and nothing is written.

#include <gtest/gtest.h>

#include <ostream>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_rejected_programs {

struct Bad {
  const char* name;
  std::string program;
  const char* place;  ///< line:column of the diagnostic
  const char* code;

  friend void PrintTo(const Bad& bad, std::ostream* stream) { *stream << bad.name; }
};

class RejectedProgram : public ::testing::TestWithParam<Bad> {};

TEST_P(RejectedProgram, IsNamedWithPlaceAndCodeAndWritesNothing) {
  const Bad& bad = GetParam();
  const Folder folder;
  folder.write("bad.ngc", bad.program);
  const auto run =
      leadscrew(folder, {"run", "bad.ngc", "--trace", "t.csv", "--report", "r.html", "--picture", "p.svg"});
  EXPECT_EQ(run.status, 3);
  EXPECT_EQ(run.output, "");
  const std::string begin = std::string("bad.ngc:") + bad.place + ": error: ";
  const auto at = run.errors.find(begin);
  ASSERT_NE(at, std::string::npos) << begin << " in\n" << run.errors;
  const std::string line = run.errors.substr(at, run.errors.find('\n', at) - at);
  EXPECT_TRUE(line.ends_with(std::string(" [") + bad.code + "]")) << line;
  EXPECT_EQ(folder.names(), Names{"bad.ngc"});
}

TEST_P(RejectedProgram, IsAnObjectOfTheSamePlaceInJson) {
  const Bad& bad = GetParam();
  const Folder folder;
  folder.write("bad.ngc", bad.program);
  for (const char* command : {"run", "check"}) {
    const auto outcome = leadscrew(folder, {command, "bad.ngc", "--json"});
    EXPECT_EQ(outcome.status, 3);
    const Json object = outcome.json();
    EXPECT_EQ(object["schema"], std::string("leadscrew.") + command + "/1");
    EXPECT_EQ(object["program"], "bad.ngc");
    Names found;
    for (const Json& problem : object["diagnostics"]) {
      EXPECT_EQ(problem["file"], "bad.ngc");
      EXPECT_FALSE(problem["message"].get<std::string>().empty());
      found.insert(std::to_string(problem["line"].get<int>()) + ":" + std::to_string(problem["column"].get<int>()) +
                   " " + problem["code"].get<std::string>() + " " + problem["severity"].get<std::string>());
    }
    const std::string wanted = std::string(bad.place) + " " + bad.code + " error";
    EXPECT_TRUE(found.contains(wanted)) << wanted << " in\n" << object.dump(1);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Every, RejectedProgram,
    ::testing::Values(Bad{"BadNumber", "G21\nG1 F600 X1.2.3\nM2\n", "2:10", "bad-number"},
                      Bad{"UnknownCode", "G21\nG123\nM2\n", "2:1", "unknown-code"},
                      Bad{"TwoCodesOfOneGroup", "G21\nG0 G1 X1 F600\nM2\n", "2:4", "modal-conflict"},
                      Bad{"ArcOfImpossibleRadius", "G21\n\nG2 X10 I1 J7 F600\nM2\n", "3:1", "arc-radius"},
                      Bad{"ArcThatCannotReach", "G21\nG2 F600 R1 X10\nM2\n", "2:1", "arc-radius"},
                      Bad{"FullCircleWithoutRadius", "G21\nG2 I0 J0 F600\nM2\n", "2:1", "arc-radius"},
                      Bad{"FullCircleByRadius", "G21\nG2 X0 Y0 R5 F600\nM2\n", "2:1", "arc-radius"},
                      Bad{"MissingFeed", "G21\nG1 X1\nM2\n", "2:1", "missing-feed"},
                      Bad{"AxisTheMachineLacks", "G21\nG1 F600 A10\nM2\n", "2:9", "unknown-axis"},
                      Bad{"OutsideTravel", "G21\nG0 X1\nG0 X500.001\nM2\n", "3:4", "travel"},
                      Bad{"DivisionByZero", "G21\nG0 X[1/0]\nM2\n", "2:7", "division-by-zero"},
                      Bad{"UnsetParameter", "G21\nG0 X#<a>\nM2\n", "2:5", "unset-parameter"},
                      Bad{"UnclosedComment", "G21\nG0 X1 (comment\nM2\n", "2:7", "unclosed-comment"},
                      Bad{"UnclosedBracket", "G21\nG0 X[1+2\nM2\n", "2:5", "unclosed-bracket"},
                      Bad{"Binary", std::string("\x7f\x45LF\0\x02\xff", 7), "1:1", "bad-character"},
                      Bad{"Empty", "", "1:1", "empty-program"}, Bad{"Blank", "\n \n\n", "3:1", "empty-program"},
                      Bad{"LongLine", "G21\n" + std::string(1 << 17, 'X') + "\nM2\n", "2:65537", "line-too-long"},
                      Bad{"DosLineEnds", "G21\r\nG123\r\nM2\r\n", "2:1", "unknown-code"}),
    [](const auto& bad) { return std::string(bad.param.name); });

TEST(RejectedPrograms, TellEveryProblemInOnePass) {
  const Folder folder;
  folder.write("bad.ngc", "G21 G90\nG1 X1\nG0 X900\nG123\nG0 Y[1/0]\nM2\n");
  const Json object = leadscrew(folder, {"check", "bad.ngc", "--json"}).json();
  EXPECT_EQ(object["errors"], 4);
  std::vector<int> lines;
  for (const Json& problem : object["diagnostics"]) lines.push_back(problem["line"]);
  EXPECT_EQ(lines, (std::vector<int>{2, 3, 4, 5}));
}

TEST(RejectedPrograms, ShowTheLineAndACaretUnderThePlace) {
  const Folder folder;
  folder.write("bad.ngc", "G21\nG1 F600 A10\nM2\n");
  EXPECT_TRUE(contains(leadscrew(folder, {"check", "bad.ngc"}).errors, "\n    G1 F600 A10\n            ^\n"));
}

TEST(RejectedPrograms, ShowNoControlBytesOfABinaryFile) {
  const Folder folder;
  folder.write("bad.ngc", "\x1b[31mred\x1b]0;title\x07\x9b\x02");
  const auto check = leadscrew(folder, {"check", "bad.ngc"});
  EXPECT_EQ(check.status, 3);
  for (const char c : check.errors) EXPECT_TRUE(c == '\n' || (c >= ' ' && c < 0x7f)) << static_cast<int>(c);
}

TEST(RejectedPrograms, LeaveAnOlderTraceAlone) {
  const Folder folder;
  folder.write("bad.ngc", "G123\n");
  folder.write("t.csv", "older");
  EXPECT_EQ(leadscrew(folder, {"run", "bad.ngc", "--trace", "t.csv"}).status, 3);
  EXPECT_EQ(folder.read("t.csv"), "older");
  EXPECT_EQ(folder.names(), (Names{"bad.ngc", "t.csv"}));
}

TEST(RejectedPrograms, DoNotKeepTheOthersFromMoving) {
  const Folder folder;
  folder.write("a.ngc", "G123\n");
  folder.write("b.ngc", square);
  const auto run = leadscrew(folder, {"run", "a.ngc", "b.ngc", "--out", "made"});
  EXPECT_EQ(run.status, 3);
  EXPECT_TRUE(contains(run.errors, "a.ngc:1:1: error: ")) << run.errors;
  EXPECT_TRUE(contains(run.output, "b.ngc on mill3")) << run.output;
  EXPECT_EQ(folder.names(), (Names{"a.ngc", "b.ngc", "made", "made/b.csv", "made/b.html", "made/b.svg"}));
  const Json both = leadscrew(folder, {"run", "a.ngc", "b.ngc", "--json"}).json();
  ASSERT_EQ(both["programs"].size(), 2u);
  EXPECT_EQ(both["programs"][0]["diagnostics"][0]["code"], "unknown-code");
  EXPECT_FALSE(both["programs"][0].contains("words"));
  EXPECT_EQ(both["programs"][1]["words"], 4179);
}

}  // namespace test_rejected_programs
}  // namespace leadscrew::cli::testing
