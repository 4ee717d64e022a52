// Surfaces on the command line: nothing moves where a tool gouges, unless that is allowed.

#include <gtest/gtest.h>

#include <filesystem>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_surface_programs {

TEST(SurfacePrograms, ThatGougeAreRefusedUnlessAllowed) {
  const Folder folder;
  folder.write("tools.tbl", "T1 D10 R5 L40 ;ball\n");
  folder.write("valley.ngc",
               "G21 F3000\nG6.4 D1 P3 Q2 I3 J2\nX-10 Y0 Z-10\nX0 Z-40\nX10 Z-10\nX-10 Y10\nX0 Z-40\nX10 Z-10\n"
               "G6.5 D1 T1 Q5 L2\nM2\n");
  const auto refused = leadscrew(folder, {"run", "valley.ngc", "--tools", "tools.tbl", "--trace", "words.csv"});
  EXPECT_EQ(refused.status, 3);
  EXPECT_NE(refused.errors.find("[surface-gouge]"), std::string::npos) << refused.errors;
  EXPECT_NE(refused.errors.find("--allow-gouge"), std::string::npos) << refused.errors;
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "words.csv"));
  const auto allowed =
      leadscrew(folder, {"run", "valley.ngc", "--tools", "tools.tbl", "--trace", "words.csv", "--allow-gouge"});
  EXPECT_EQ(allowed.status, 0) << allowed.errors;
  EXPECT_EQ(leadscrew(folder, {"verify", "words.csv", "valley.ngc", "--tools", "tools.tbl", "--allow-gouge"}).status,
            0);
}

/// Each pass and each link is a call of a NURBS.
TEST(SurfacePrograms, AreCurvesOfCanonicalCalls) {
  const Folder folder;
  folder.write("tools.tbl", "T1 D10 R5\n");
  folder.write("plane.ngc", "G21 F3000\nG6.4 D1 P2 Q2 I2 J2\nX0 Y0 Z-5\nX20\nX0 Y10\nX20\nG6.5 D1 T1 Q5\nM2\n");
  const auto canon = leadscrew(folder, {"canon", "plane.ngc", "--tools", "tools.tbl"});
  EXPECT_EQ(canon.status, 0) << canon.errors;
  std::size_t curves = 0;
  for (std::size_t at = 0; (at = canon.output.find("NURBS_FEED", at)) != std::string::npos; ++at) ++curves;
  EXPECT_EQ(curves, 5u) << canon.output;
}

}  // namespace test_surface_programs
}  // namespace leadscrew::cli::testing
