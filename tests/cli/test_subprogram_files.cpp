// Programs that call subprograms, in files too, move as the program does that is written out in full.

#include <gtest/gtest.h>

#include <filesystem>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_subprogram_files {

/// The rows of a trace without its lines' numbers: t, state and coordinates.
std::string motion_of(const Folder& folder, const std::string& trace) {
  std::istringstream text(folder.read(trace));
  std::string rows;
  for (std::string row; std::getline(text, row);) {
    const std::size_t first = row.find(',');
    const std::size_t second = row.find(',', first + 1);
    rows += row.substr(0, first) + row.substr(second) + "\n";
  }
  return rows;
}

TEST(Subprograms, MoveAsTheProgramWrittenOutInFull) {
  const Folder folder;
  std::filesystem::create_directory(folder.path() / "library");
  folder.write("main.ngc",
               "G21 G91 F3000\no<corner> call [10]\no1 repeat [3]\nG1 X5\nS100\nM98 P7 L2\no1 endrepeat\nM2\n");
  folder.write("library/corner.ngc", "o<corner> sub\nG1 X#1\nY#1\no<corner> endsub\n");
  folder.write("O0007.nc", "%\nO7 (PART)\nG1 Y2\nG2 X2 Y2 I2\nM99\n%\n");
  std::string full = "G21 G91 F3000\nG1 X10\nY10\n";
  for (int i = 0; i < 3; ++i) {
    full += "G1 X5\nS100\n";
    for (int k = 0; k < 2; ++k) full += "G1 Y2\nG2 X2 Y2 I2\n";
  }
  folder.write("full.ngc", full + "M2\n");
  ASSERT_EQ(leadscrew(folder, {"run", "main.ngc", "--subprograms", "nowhere:library", "--trace", "main.csv", "--events",
                               "main-events.csv"})
                .status,
            0);
  ASSERT_EQ(leadscrew(folder, {"run", "full.ngc", "--trace", "full.csv", "--events", "full-events.csv"}).status, 0);
  EXPECT_TRUE(motion_of(folder, "main.csv") == motion_of(folder, "full.csv"));
  EXPECT_EQ(leadscrew(folder, {"verify", "main.csv", "main.ngc", "--subprograms", "library"}).status, 0);
  const auto missing = leadscrew(folder, {"check", "main.ngc"});
  EXPECT_EQ(missing.status, 3);
  EXPECT_NE(missing.errors.find("main.ngc:2:1: error: there is no subprogram corner"), std::string::npos)
      << missing.errors;
}

TEST(Subprograms, HaveProblemsInTheirFiles) {
  const Folder folder;
  folder.write("main.ngc", "o<part> call\no<part> call\nM2\n");
  folder.write("part.ngc", "o<part> sub\nG0 Q1\no<part> endsub\n");
  const auto outcome = leadscrew(folder, {"check", "main.ngc", "--json"});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_EQ(outcome.json()["errors"], 1);
  EXPECT_EQ(outcome.json()["diagnostics"][0]["file"], "part.ngc");
}

TEST(Subprograms, AreNamedWhereAToolFitsNoContourBetweenFiles) {
  const Folder folder;
  folder.write("main.ngc", "G41.1 D6\nG1 X10 F300\nX40\no<part> call\nG40 G1 X0 Y40\nM2\n");
  folder.write("part.ngc", "o<part> sub\nY2\nX10\no<part> endsub\n");
  const auto outcome = leadscrew(folder, {"check", "main.ngc"});
  EXPECT_NE(outcome.errors.find("of line 3 of main.ngc and that of line "), std::string::npos) << outcome.errors;
}

TEST(Loops, WithoutEndAreErrors) {
  const Folder folder;
  folder.write("main.ngc", "G91\no1 while [1]\nG0 X1\nG0 X-1\no1 endwhile\nM2\n");
  const auto outcome = leadscrew(folder, {"run", "main.ngc", "--fuel", "10000"});
  EXPECT_EQ(outcome.status, 3);
  EXPECT_NE(outcome.errors.find("[fuel-exhausted]"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("--fuel BLOCKS allows more"), std::string::npos) << outcome.errors;
  for (const char* wrong : {"0", "-1", "1.5", "many"}) {
    EXPECT_EQ(leadscrew(folder, {"check", "main.ngc", "--fuel", wrong}).status, 2) << wrong;
  }
}

}  // namespace test_subprogram_files
}  // namespace leadscrew::cli::testing
