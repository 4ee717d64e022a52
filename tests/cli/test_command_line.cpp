// Arguments, help, standard input, files by --out, colour and quiet.

#include <gtest/gtest.h>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_command_line {

using Words = std::vector<std::string>;

struct Misuse {
  Words arguments;
  const char* said;
};

TEST(Usage, ErrorsSayWhatWasMeantAndDoNothing) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("t.csv", "t,X\n0,0\n");
  folder.write("mill.toml", machine_text());
  folder.write("tools.tbl", "T1 P1 D6\n");
  folder.write("tools.csv", "T1 P1 D6\n");
  folder.write("mill.svg", machine_text());
  folder.write("part.csv", square);
  folder.write("part.html", square);
  const Names before = folder.names();
  for (const auto& [arguments, said] : {
           Misuse{{}, "no command"},
           Misuse{{"rum", "part.ngc"}, "no command \"rum\"; did you mean run?"},
           Misuse{{"vreify"}, "did you mean verify?"},
           Misuse{{"zzzzzz"}, "there are run, check, verify"},
           Misuse{{"--verison"}, "did you mean --version?"},
           Misuse{{"version"}, "no command \"version\"; did you mean --version?"},
           Misuse{{"part.ngc"}, "no command before part.ngc; did you mean run part.ngc?"},
           Misuse{{"--version", "run"}, "\"run\" is one word too many behind --version"},
           Misuse{{"run"}, "PROGRAM is missing: Part programs"},
           Misuse{{"run", "--vresion"}, "no option --vresion"},
           Misuse{{"help", "run", "check"}, "\"check\" is one word too many"},
           Misuse{{"completion"}, "SHELL is missing: bash, zsh or fish"},
           Misuse{{"run", "part.ngc", "--tarce", "made.csv"}, "no option --tarce; did you mean --trace?"},
           Misuse{{"run", "part.ngc", "--tarce=made.csv"}, "no option --tarce; did you mean --trace?"},
           Misuse{{"check", "part.ngc", "--jsn"}, "did you mean --json?"},
           Misuse{{"check", "part.ngc", "--trace", "made.csv"}, "no option --trace"},
           Misuse{{"verify", "t.csv"}, "PROGRAM is missing"},
           Misuse{{"verify", "part.ngc", "t.csv"}, "t.csv is the trace, part.ngc is not: the two are swapped"},
           Misuse{{"verify", "-", "t.csv"}, "t.csv is the trace, - is not: the two are swapped"},
           Misuse{{"verify", "t.csv", "part.ngc", "more"}, "\"more\" is one word too many"},
           Misuse{{"run", "part.ngc", "--period", "1"}, "such as 1ms or 250us"},
           Misuse{{"run", "part.ngc", "--period", "fast"}, "such as 1ms or 250us"},
           Misuse{{"run", "part.ngc", "--period", "9us"}, "outside 10us to 20ms"},
           Misuse{{"run", "part.ngc", "--period", "21ms"}, "outside 10us to 20ms"},
           Misuse{{"run", "part.ngc", "--period=-1ms"}, "outside 10us to 20ms"},
           Misuse{{"run", "part.ngc", "--start", "X1,X2"}, "axis X is given twice"},
           Misuse{{"run", "part.ngc", "--start", "1,X2"}, "axis X is given twice"},
           Misuse{{"run", "part.ngc", "--start", "1,,2"}, "--start 1,,2"},
           Misuse{{"run", "part.ngc", "--start", "Q1"}, "does not begin with an axis"},
           Misuse{{"run", "part.ngc", "--start", "Xone"}, "is not a number"},
           Misuse{{"run", "part.ngc", "--start", "A1"}, "machine mill3 has no axis A"},
           Misuse{{"run", "part.ngc", "--start", "X501"}, "outside the travel of axis X"},
           Misuse{{"run", "part.ngc", "--tolerance", "-1"}, "--tolerance"},
           Misuse{{"run", "part.ngc", "--tolerance", "nan"}, "--tolerance"},
           Misuse{{"run", "part.ngc", "--mode", "fast"}, "exact-stop"},
           Misuse{{"run", "part.ngc", "--color", "blue"}, "always"},
           Misuse{{"run", "part.ngc", "--trace", "made.csv", "--blocks", "made.csv"}, "name the same file"},
           Misuse{{"run", "part.ngc", "--trace", "made.csv", "--events", "./made.csv"}, "name the same file"},
           Misuse{{"run", "part.ngc", "--trace", "made.txt"}, ".csv"},
           Misuse{{"run", "part.csv", "--trace", "part.csv"}, "is the program itself"},
           Misuse{{"run", "part.html", "--report", "./part.html"}, "is the program itself"},
           Misuse{{"run", "part.ngc", "--machine", "mill.svg", "--picture", "./mill.svg"}, "is the machine file"},
           Misuse{{"run", "part.ngc", "--tools", "tools.csv", "--blocks", "tools.csv"}, "is the tool table"},
           Misuse{{"simulate", "part.ngc", "--tools", "tools.csv", "--events", "tools.csv"}, "is the tool table"},
           Misuse{{"drive", "part.ngc", "--state", "part.ngc"}, "is the program itself"},
           Misuse{{"drive", "part.ngc", "--machine", "mill.toml", "--state", "mill.toml"}, "is the machine file"},
           Misuse{{"drive", "part.ngc", "--tools", "tools.tbl", "--resume", "tools.tbl"}, "is the tool table"},
           Misuse{{"drive", "part.ngc", "--trace", "made.csv", "--state", "made.csv"}, "name the same file"},
           Misuse{{"drive", "part.ngc", "--axes", "made.txt"}, ".csv"},
           Misuse{{"run", "part.ngc", "part.ngc", "--trace", "made.csv"}, "--out"},
           Misuse{{"run", "part.ngc", "./part.ngc", "--out", "made"}, "part"},
           Misuse{{"run", "-", "-"}, "only once"},
           Misuse{{"verify", "-", "-"}, "only once"},
       }) {
    const auto outcome = leadscrew(folder, arguments, {.input = square});
    std::string line = "leadscrew";
    for (const std::string& argument : arguments) line += " " + argument;
    EXPECT_EQ(outcome.status, 2) << line;
    EXPECT_EQ(outcome.output, "") << line;
    EXPECT_TRUE(contains(outcome.errors, "error: ")) << line << "\n" << outcome.errors;
    EXPECT_TRUE(contains(outcome.errors, said)) << line << "\n" << outcome.errors;
    EXPECT_EQ(folder.names(), before) << line;
    EXPECT_EQ(folder.read("part.ngc"), square) << line;
  }
}

TEST(Usage, SeesThatTwoNamesAreOneFile) {
  const Folder folder;
  folder.write("part.ngc", square);
  const auto run = leadscrew(folder, {"run", "part.ngc", "--trace", "made.csv", "--events", "./made.csv"});
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(folder.names(), Names{"part.ngc"});
}

TEST(Help, OfEveryCommandHasAnExample) {
  const Folder folder;
  for (const Words& arguments :
       {Words{"--help"}, {"-h"}, {"run", "--help"}, {"check", "--help"}, {"verify", "--help"}}) {
    const auto help = leadscrew(folder, arguments);
    EXPECT_EQ(help.status, 0);
    EXPECT_EQ(help.errors, "");
    const std::string command = arguments.size() > 1 ? arguments[0] : "run";
    const auto examples = help.output.find("Examples:\n");
    ASSERT_NE(examples, std::string::npos) << help.output;
    EXPECT_TRUE(contains(help.output.substr(examples), "\n  leadscrew " + command + " ")) << help.output;
  }
}

TEST(Help, NamesEveryOptionOfTheContract) {
  const Folder folder;
  const std::string run = leadscrew(folder, {"run", "--help"}).output;
  for (const char* option : {"--machine", "--json", "--out", "--quiet", "--color", "--period", "--trace", "--report",
                             "--mode", "--tolerance", "--tools", "--start"})
    EXPECT_TRUE(contains(run, std::string("  ") + option)) << option;
}

TEST(Version, IsOneLine) {
  const Folder folder;
  const auto version = leadscrew(folder, {"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.errors, "");
  EXPECT_TRUE(version.output.starts_with("leadscrew ")) << version.output;
  EXPECT_EQ(version.output.find('\n'), version.output.size() - 1);
  EXPECT_TRUE(version.output.find_first_of("0123456789") == 10) << version.output;
}

TEST(StandardInput, IsAProgram) {
  const Folder folder;
  folder.write("part.ngc", square);
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--trace", "a.csv"}).status, 0);
  const auto run = leadscrew(folder, {"run", "-", "--trace", "b.csv", "--json"}, {.input = square});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.json()["words"], 4179);
  EXPECT_TRUE(folder.read("a.csv") == folder.read("b.csv"));
  EXPECT_EQ(leadscrew(folder, {"verify", "a.csv", "-"}, {.input = square}).status, 0);
  EXPECT_EQ(leadscrew(folder, {"verify", "-", "part.ngc"}, {.input = folder.read("a.csv")}).status, 0);
}

TEST(StandardInput, IsNamedInDiagnostics) {
  const Folder folder;
  const auto bad = leadscrew(folder, {"check", "-"}, {.input = "G21\nG123\n"});
  EXPECT_EQ(bad.status, 3);
  EXPECT_TRUE(bad.errors.starts_with("<stdin>:2:1: error: ")) << bad.errors;
  EXPECT_EQ(leadscrew(folder, {"run", "-"}).status, 3);
}

TEST(Out, WritesThreeFilesOfEachProgram) {
  const Folder folder;
  folder.write("a.ngc", square);
  folder.write("b.ngc", with_feed(square, "6000"));
  ASSERT_EQ(leadscrew(folder, {"run", "a.ngc", "--trace", "t.csv", "--report", "r.html", "--picture", "p.svg"}).status,
            0);
  EXPECT_EQ(leadscrew(folder, {"run", "a.ngc", "b.ngc", "-", "--out", "x/y"}, {.input = square}).status, 0);
  EXPECT_EQ(folder.names(),
            (Names{"a.ngc", "b.ngc", "t.csv", "r.html", "p.svg", "x", "x/y", "x/y/a.csv", "x/y/a.html", "x/y/a.svg",
                   "x/y/b.csv", "x/y/b.html", "x/y/b.svg", "x/y/stdin.csv", "x/y/stdin.html", "x/y/stdin.svg"}));
  EXPECT_TRUE(folder.read("x/y/a.csv") == folder.read("t.csv"));
  EXPECT_TRUE(folder.read("x/y/stdin.csv") == folder.read("t.csv"));
  EXPECT_FALSE(folder.read("x/y/b.csv") == folder.read("t.csv"));
  EXPECT_TRUE(contains(folder.read("x/y/a.html"), "</html>"));
  EXPECT_TRUE(contains(folder.read("x/y/a.svg"), "</svg>"));
}

TEST(Out, IsNeverGuessed) {
  const Folder folder;
  folder.write("part.ngc", square);
  EXPECT_EQ(leadscrew(folder, {"run", "part.ngc"}).status, 0);
  EXPECT_EQ(leadscrew(folder, {"check", "part.ngc"}).status, 0);
  EXPECT_EQ(folder.names(), Names{"part.ngc"});
}

TEST(Quiet, LeavesOnlyDiagnosticsAndData) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("bad.ngc", "G123\n");
  EXPECT_NE(leadscrew(folder, {"run", "part.ngc"}).output, "");
  for (const char* command : {"run", "check"}) {
    const auto outcome = leadscrew(folder, {command, "part.ngc", "--quiet"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.output + outcome.errors, "");
  }
  EXPECT_EQ(leadscrew(folder, {"run", "part.ngc", "--quiet", "--json"}).json()["words"], 4179);
  EXPECT_TRUE(contains(leadscrew(folder, {"run", "bad.ngc", "--quiet"}).errors, "bad.ngc:1:1: error: "));
}

TEST(Options, OverrideWhatTheProgramSays) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G64 P0.05\nG1 X10 F6000\nY10\nM2\n");
  const auto tolerance = [&](const Words& more) {
    Words arguments = {"run", "part.ngc", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const auto run = leadscrew(folder, arguments);
    EXPECT_EQ(run.status, 0) << run.errors;
    return run.json()["tolerance_mm"].get<double>();
  };
  EXPECT_EQ(tolerance({}), 0.05);
  EXPECT_EQ(tolerance({"--tolerance", "0.02"}), 0.02);
  EXPECT_EQ(tolerance({"--mode", "exact-stop"}), 0);
}

/// A terminal on which a command can write.
class Terminal {
 public:
  Terminal() : master_(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC)) {
    if (master_ < 0 || ::grantpt(master_) != 0 || ::unlockpt(master_) != 0) throw std::runtime_error("no terminal");
    name_ = ::ptsname(master_);
    own_ = ::open(name_.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  }
  ~Terminal() {
    ::close(own_);
    ::close(master_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  const std::string& name() const { return name_; }

  /// What has been written and not yet read.
  std::string text() const {
    ::fcntl(master_, F_SETFL, O_NONBLOCK);
    std::string text;
    char buffer[4096];
    for (ssize_t got = 0; (got = ::read(master_, buffer, sizeof buffer)) > 0;)
      text.append(buffer, static_cast<std::size_t>(got));
    return text;
  }

 private:
  int master_, own_ = -1;
  std::string name_;
};

constexpr std::string_view escape = "\033[";

TEST(Color, IsOffWhereNoTerminalIs) {
  const Folder folder;
  folder.write("part.ngc", square);
  folder.write("bad.ngc", "G123\n");
  const Surroundings terminal = {.environment = {"TERM=xterm"}};
  EXPECT_FALSE(contains(leadscrew(folder, {"run", "part.ngc"}, terminal).output, escape));
  EXPECT_FALSE(contains(leadscrew(folder, {"check", "bad.ngc"}, terminal).errors, escape));
  EXPECT_TRUE(contains(leadscrew(folder, {"run", "part.ngc", "--color", "always"}).output, escape));
  EXPECT_TRUE(contains(leadscrew(folder, {"check", "bad.ngc", "--color", "always"}).errors, escape));
}

TEST(Color, IsOnAtATerminalUnlessUnwanted) {
  const Folder folder;
  folder.write("part.ngc", square);
  const Terminal terminal;
  const auto shown = [&](const Words& more, std::vector<std::string> environment) {
    Words arguments = {"run", "part.ngc"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(leadscrew(folder, arguments, {.output = terminal.name(), .environment = std::move(environment)}).status,
              0);
    const std::string text = terminal.text();
    EXPECT_TRUE(contains(text, "part.ngc")) << text;
    return text;
  };
  EXPECT_TRUE(contains(shown({}, {"TERM=xterm"}), escape));
  EXPECT_FALSE(contains(shown({}, {"TERM=xterm", "NO_COLOR=1"}), escape));
  EXPECT_FALSE(contains(shown({}, {"TERM=dumb"}), escape));
  EXPECT_FALSE(contains(shown({"--color", "never"}, {"TERM=xterm"}), escape));
  EXPECT_TRUE(contains(shown({"--color", "always"}, {"TERM=xterm", "NO_COLOR=1"}), escape));
}

TEST(Color, NeverEntersJson) {
  const Folder folder;
  folder.write("part.ngc", square);
  const auto run = leadscrew(folder, {"run", "part.ngc", "--json", "--color", "always"});
  EXPECT_FALSE(contains(run.output, escape));
  EXPECT_EQ(run.json()["words"], 4179);
}

}  // namespace test_command_line
}  // namespace leadscrew::cli::testing
