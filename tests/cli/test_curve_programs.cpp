// Curves of the studies in place of part programs: curve:NAME.

#include <gtest/gtest.h>

#include <cmath>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_curve_programs {

Json figures_of(const Folder& folder, const std::vector<std::string>& words, int status) {
  const auto outcome = leadscrew(folder, words);
  EXPECT_EQ(outcome.status, status) << outcome.errors;
  return outcome.json();
}

/// But for its name, and the time that planning took.
Json nameless(Json figures) {
  figures.erase("program");
  figures.erase("cpu");
  return figures;
}

const std::string plane_cubic =
    "G21 G90 G17 G94 G61.1\nG6.2 P4 K0 X0 Y0 R1 F600\nK0 X6.666666666666667 Y-3.3333333333333335 R1\n"
    "K0 X13.333333333333334 Y20 R1\nK0 X20 Y20 R1\nK1\nK1\nK1\nK1\nM2\n";
const std::string circle = "G21 G90 G17 G94 G61.1\nG3 X10 Y0 I-10 J0 F600\nM2\n";

TEST(SimulateCurve, HasTheFiguresOfTheSameProgramInAFile) {
  const Folder folder;
  folder.write("cubic.ngc", plane_cubic);
  const std::vector<std::string> gains = {"--gains", "2,2,15", "--period", "10ms", "--json"};
  const auto simulated = [&](const std::string& program) {
    std::vector<std::string> words = {"simulate", program};
    words.insert(words.end(), gains.begin(), gains.end());
    return figures_of(folder, words, 1);
  };
  const Json curve = simulated("curve:plane-cubic");
  EXPECT_EQ(curve["program"], "curve:plane-cubic");
  EXPECT_EQ(curve["feed"]["programmed_max_mm_s"], 10);
  EXPECT_NEAR(curve["length_mm"], 29.8413, 5e-5);
  EXPECT_EQ(nameless(curve), nameless(simulated("cubic.ngc")));
}

/// A curve brings its start along, to every command.
TEST(SimulateCurve, BeginsWhereItsProgramDoes) {
  const Folder folder;
  folder.write("circle.ngc", circle);
  for (const char* command : {"simulate", "run", "check"}) {
    const Json curve = figures_of(folder, {command, "curve:circle", "--json"}, 0);
    const Json file = figures_of(folder, {command, "circle.ngc", "--start", "X10", "--json"}, 0);
    EXPECT_EQ(nameless(curve), nameless(file)) << command;
  }
  EXPECT_EQ(leadscrew(folder, {"check", "circle.ngc"}).status, 3);  // it is no circle from X0
  EXPECT_EQ(leadscrew(folder, {"run", "curve:circle", "--trace", "t.csv", "--quiet"}).status, 0);
  EXPECT_EQ(leadscrew(folder, {"verify", "t.csv", "curve:circle"}).status, 0);
  EXPECT_EQ(leadscrew(folder, {"verify", "t.csv", "curve:plane-cubic"}).status, 1);
}

TEST(SimulateCurve, IsDrivenAsItIsRun) {
  const Folder folder;
  const Json run = figures_of(folder, {"run", "curve:circle@100", "--json"}, 0);
  const Json driven = figures_of(folder,
                                 {"drive", "curve:circle@100", "--trace", "d.csv", "--json",
                                  // Planned to its end before it moves: no planner is too slow.
                                  "--look-ahead", "60s", "--lead", "2s"},
                                 0);
  EXPECT_EQ(driven["program"], "curve:circle@100");
  EXPECT_EQ(driven["words"], run["words"]);
  EXPECT_EQ(leadscrew(folder, {"verify", "d.csv", "curve:circle@100"}).status, 0);
}

TEST(SimulateCurve, TakesAFeedInMillimetresPerSecond) {
  const Folder folder;
  const Json slow = figures_of(folder, {"simulate", "curve:plane-cubic@2.5", "--json"}, 0);
  EXPECT_EQ(slow["program"], "curve:plane-cubic@2.5");
  EXPECT_EQ(slow["feed"]["programmed_max_mm_s"], 2.5);
  EXPECT_NEAR(slow["time_s"], 29.8413 / 2.5, 0.03);
}

/// All there are, at their own feeds, each with files of its own.
TEST(SimulateCurve, WritesFilesOfItsName) {
  const Folder folder;
  const auto outcome = leadscrew(folder, {"simulate", "curve:plane-cubic", "curve:plane-cubic@2.5", "curve:circle",
                                          "curve:butterfly", "curve:plane-cubic-lines", "--out", "o", "--quiet"});
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  Names expected = {"o"};
  for (const char* name : {"plane-cubic", "plane-cubic@2.5", "circle", "butterfly", "plane-cubic-lines"}) {
    for (const char* ending : {".csv", ".html", ".svg"}) expected.insert(std::string("o/") + name + ending);
  }
  EXPECT_EQ(folder.names(), expected);
  EXPECT_TRUE(contains(folder.read("o/circle.html"), "<title>curve:circle "));
  const auto one = leadscrew(folder, {"simulate", "curve:circle", "--report", "r.html", "--quiet"});
  EXPECT_EQ(one.status, 0) << one.errors;
  EXPECT_TRUE(contains(folder.read("r.html"), "The part as it is made"));
}

/// What the study has of words that begin at the full feed, simulate tells where limits hardly hold it back; the
/// study's words are those of a rule of parameter steps.
TEST(SimulateCurve, OvershootsAsInTheStudy) {
  const Folder folder;
  Json rows = leadscrew(folder, {"study", "real-time-vs-offline", "--json"}).json()["rows"];
  int compared = 0;
  for (const auto& [gain, lag, plant] :
       {std::tuple{"10", "20", "K 10.0, τ 20 ms"}, {"17.8", "50", "K 17.8, τ 50 ms"}}) {
    std::string machine = machine_text(1e8, 1e14);
    for (const char axis : {'X', 'Y', 'Z'})
      machine += std::string("[axis.") + axis + ".drive]\ncontroller = \"pid\"\ngain_mm_s = " + gain +
                 "\ntime_constant_ms = " + lag + "\nencoder_counts_per_mm = 1000000\n";
    folder.write("m.toml", machine);
    for (const auto& [gains, set] : {std::pair{"2,2,15", "(2, 2, 15)"}, {"6,50,25", "(6, 50, 25)"}}) {
      const Json figures = figures_of(
          folder,
          {"simulate", "curve:plane-cubic", "--machine", "m.toml", "--gains", gains, "--period", "10ms", "--json"}, 1);
      const double measured = figures["feed"]["measured_max_mm_s"];
      const std::string what =
          std::string("gains (P, I, D) = ") + set + ", " + plant + ": curve: overshoot of the feed";
      for (const Json& row : rows) {
        if (row["what"] != what) continue;
        EXPECT_NEAR((measured / 10 - 1) * 100, row["ours"].get<double>(), 0.1) << what;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 4);
}

TEST(CommandLineCurve, SaysWhichThereAre) {
  const Folder folder;
  struct Misuse {
    std::vector<std::string> arguments;
    const char* said;
  };
  for (const auto& [arguments, said] : {
           Misuse{{"simulate", "curve:plane-cubik"},
                  "no curve \"plane-cubik\" among plane-cubic, plane-cubic-lines, circle, butterfly; did you mean "
                  "plane-cubic?; a file is given as ./curve:plane-cubik"},
           Misuse{{"run", "curve:zzz"},
                  "no curve \"zzz\" among plane-cubic, plane-cubic-lines, circle, butterfly; a file"},
           Misuse{{"check", "curve:"}, "no curve \"\" among"},
           Misuse{{"run", "curve:circle@"}, "curve:circle@: behind @ stands a feed in mm/s, above 0"},
           Misuse{{"run", "curve:circle@0"}, "such as curve:circle@10"},
           Misuse{{"run", "curve:circle@10mm"}, "behind @ stands a feed"},
           Misuse{{"drive", "curve:circle@-1"}, "behind @ stands a feed"},
           Misuse{{"verify", "t.csv", "curve:squircle"}, "did you mean circle?"},
           Misuse{{"simulate", "curve:circle", "--start", "X1"}, "--start is of files; curve:circle begins at X10 Y0"},
       }) {
    const Outcome outcome = leadscrew(folder, arguments);
    EXPECT_EQ(outcome.status, 2) << said;
    EXPECT_EQ(outcome.output, "") << said;
    EXPECT_TRUE(contains(outcome.errors, said)) << outcome.errors;
  }
  for (const char* command : {"run", "check", "verify", "simulate", "drive"})
    EXPECT_TRUE(contains(leadscrew(folder, {command, "--help"}).output, "curve:NAME")) << command;
}

TEST(CommandLineCurve, IsNamedInDiagnostics) {
  const Folder folder;
  const auto bad = leadscrew(folder, {"check", "curve:circle@1e9"});
  EXPECT_EQ(bad.status, 3);
  EXPECT_TRUE(bad.errors.starts_with("curve:circle@1e9:2:")) << bad.errors;
}

/// What begins like a curve's name but is a file has a way to be given.
TEST(CommandLineCurve, LeavesFilesToTheirPaths) {
  const Folder folder;
  folder.write("curve:circle", square);
  EXPECT_EQ(figures_of(folder, {"check", "./curve:circle", "--json"}, 0)["moves"], 4);
  EXPECT_EQ(figures_of(folder, {"check", "curve:circle", "--json"}, 0)["moves"], 1);
}

/// So slow that no word would ever move: refused where it is read, from a file as well.
TEST(SimulateCurve, AreRefusedWhereNothingWouldMove) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94\nG1 X20 F0.0000001\nM2\n");
  for (const std::string program : {"curve:circle@1e-320", "curve:plane-cubic@1e-100", "part.ngc"}) {
    const Outcome outcome = leadscrew(folder, {"run", program});
    EXPECT_EQ(outcome.status, 3) << program;
    EXPECT_TRUE(contains(outcome.errors, "F must be 0.000001 or more")) << outcome.errors;
  }
}

}  // namespace test_curve_programs
}  // namespace leadscrew::cli::testing
