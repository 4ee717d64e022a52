// Where an option is the remedy, the hint names it; and a trace is told from a program.

#include <gtest/gtest.h>

#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/console/option_hints.hpp>
#include <regex>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_hints {

using Words = std::vector<std::string>;

struct Remedy {
  Words arguments;
  const char* code;
  const char* hint;  ///< its part that names the option
};

TEST(Hints, NameTheOptionThatMends) {
  const Folder folder;
  folder.write("tool.ngc", "G21 G94 F600\nG43 H5 G1 Z1\nM2\n");
  folder.write("one.tbl", "T1 P1 Z10\n");
  folder.write("far.ngc", "G21 G94 F600\nG1 X1000\nM2\n");
  folder.write("turn.ngc", "G21 G94 F600\nG1 A30\nM2\n");
  folder.write("square.ngc", square);
  folder.write("uneven.csv", "t,X,Y,Z\n0,0,0,0\n0.001,0,0,0\n0.005,0,0,0\n");
  folder.write("slow.csv", "t,X,Y,Z\n0,0,0,0\n5,0,0,0\n");
  folder.write("fast.csv", "t,X,Y,Z\n0,0,0,0\n0.001,5,0,0\n0.002,9,0,0\n");
  folder.write("flat.csv", "t,X,Y\n0,0,0\n0.001,0,0\n");
  folder.write("other.state", "no state\n");
  for (const auto& [arguments, code, hint] : {
           Remedy{{"check", "tool.ngc", "--tools", "one.tbl"},
                  "unknown-tool",
                  "give a tool table that holds it; --tools FILE gives the table"},
           Remedy{{"run", "tool.ngc"}, "no-tool-table", "; --tools FILE"},
           Remedy{{"run", "far.ngc"}, "travel", "--machine FILE names another machine, --start "},
           Remedy{{"check", "turn.ngc"}, "unknown-axis", "--machine FILE"},
           Remedy{{"run", "square.ngc", "--pulses", "made.vcd", "--step-clock", "10kHz"}, "step-rate", "--step-clock"},
           Remedy{{"verify", "uneven.csv", "square.ngc"}, "trace-period", "--period TIME"},
           Remedy{{"verify", "slow.csv", "square.ngc"}, "trace-period", "--period TIME"},
           Remedy{{"verify", "flat.csv", "square.ngc"}, "trace-axis", "which --start says"},
           Remedy{{"verify", "fast.csv", "square.ngc"}, "judged-by", "--period TIME, --mode MODE and --tolerance MM"},
           Remedy{{"drive", "square.ngc", "--state", "other.state"}, "state-other", "--state FILE"},
       }) {
    const auto told = leadscrew(folder, arguments);
    std::string line;
    for (const std::string& argument : arguments) line += argument + " ";
    const std::size_t place = told.errors.find(std::string("[") + code + "]");
    ASSERT_NE(place, std::string::npos) << line << told.errors;
    const std::size_t begin = told.errors.find("\n    hint: ", place);
    ASSERT_NE(begin, std::string::npos) << line << told.errors;
    const std::string said = told.errors.substr(begin + 1, told.errors.find('\n', begin + 1) - begin);
    EXPECT_TRUE(contains(said, hint)) << line << told.errors;
  }
  // In JSON as well.
  const Json checked = leadscrew(folder, {"check", "far.ngc", "--json"}).json();
  EXPECT_TRUE(contains(checked["diagnostics"][0]["hint"].get<std::string>(), "--machine FILE"));
}

/// Commands that meet a problem have every option that its hint names.
TEST(Hints, NameOptionsThatThereAre) {
  Arguments arguments;
  options::Program program("leadscrew", "", "0");
  describe_program(program, arguments);
  const Words of_programs = {"run", "check", "verify", "simulate", "drive"};
  const std::vector<std::pair<std::string_view, Words>> met = {{"unknown-tool", of_programs},
                                                               {"no-tool-table", of_programs},
                                                               {"travel", of_programs},
                                                               {"unknown-axis", of_programs},
                                                               {"servo-unstable", {"simulate", "drive"}},
                                                               {"step-rate", {"run"}},
                                                               {"step-turn", {"run"}},
                                                               {"pulse-velocity", {"run"}},
                                                               {"pulse-feed-word", {"run"}},
                                                               {"pulse-rate", {"run"}},
                                                               {"state-busy", {"drive"}},
                                                               {"state-other", {"drive"}},
                                                               {"resume-program", {"drive"}},
                                                               {"resume-ended", {"drive"}},
                                                               {"trace-period", {"verify"}}};
  const std::regex option("--[a-z-]+");
  for (const auto& [code, commands] : met) {
    const std::string hint = console::with_options(base::problem(code, "", "")).hint;
    int named = 0;
    for (auto match = std::sregex_iterator(hint.begin(), hint.end(), option); match != std::sregex_iterator();
         ++match) {
      ++named;
      for (const std::string& command : commands) {
        const auto& options = (*program.find(command))->options();
        EXPECT_NE(std::ranges::find(options, match->str(), &options::Option::name), options.end()) << command << hint;
      }
    }
    EXPECT_GT(named, 0) << code;
  }
}

TEST(Hints, OfDefectsAndOfOtherProblemsStay) {
  const auto defect = base::problem("travel", "", "this is a defect of leadscrew: please report it");
  EXPECT_EQ(console::with_options(defect).hint, defect.hint);
  EXPECT_EQ(console::with_options(base::problem("arc-radius", "", "as it is")).hint, "as it is");
  EXPECT_EQ(console::with_options(base::problem("arc-radius", "", "")).hint, "");
}

TEST(Traces, AreToldFromPrograms) {
  const Folder folder;
  folder.write("part.ngc", square);
  for (const std::string trace : {"words.csv", "words.npy"}) {
    ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--quiet", "--trace", trace}).status, 0);
    const auto swapped = leadscrew(folder, {"verify", "part.ngc", trace});
    EXPECT_EQ(swapped.status, 2);
    EXPECT_EQ(swapped.errors, "leadscrew: error: " + trace +
                                  " is the trace, part.ngc is not: the two are swapped [usage]\n"
                                  "    hint: leadscrew verify " +
                                  trace + " part.ngc\n");
    EXPECT_EQ(leadscrew(folder, {"verify", trace, "part.ngc"}).status, 0);
    for (const Words& words : {Words{"run", trace}, {"check", trace}, {"simulate", trace}, {"verify", trace, trace}}) {
      const auto refused = leadscrew(folder, words);
      EXPECT_EQ(refused.status, 3) << words.front();
      EXPECT_TRUE(contains(refused.errors, trace + ": error: is a trace, not a part program [not-a-program]\n"))
          << refused.errors;
      EXPECT_EQ(std::count(refused.errors.begin(), refused.errors.end(), '\n'), 2) << refused.errors;
    }
  }
  // Two programs: the first is no trace, which is told.
  const auto programs = leadscrew(folder, {"verify", "part.ngc", "part.ngc"});
  EXPECT_EQ(programs.status, 3);
  EXPECT_TRUE(contains(programs.errors, "[trace-header]")) << programs.errors;
}

}  // namespace test_hints
}  // namespace leadscrew::cli::testing
