// What a driven program says, and the parameters that it leaves.

#include <gtest/gtest.h>

#include "driven.hpp"

namespace leadscrew::cli::testing {
namespace test_drive_remarks {

const std::string speaking =
    "G21 F6000\n#100=[#100+1]\n(MSG,begin)\n(LOGOPEN,log.txt)\n(LOG,%d#100)\nG1 X5 (PRINT,at %d#<_x>)\nM2\n";

TEST(DriveRemarks, AreSaidOnceAndParametersAreKept) {
  const Folder folder;
  folder.write("a.ngc", speaking);
  folder.write("a.var", "100\t6\n");
  const auto driven = leadscrew(folder, {"drive", "a.ngc", "--parameters", "a.var", "--quiet"});
  EXPECT_EQ(driven.status, 0);
  EXPECT_EQ(driven.errors, "a.ngc:3: begin\nat 0\n");
  EXPECT_EQ(folder.read("log.txt"), "7\n");
  EXPECT_TRUE(folder.read("a.var").starts_with("100\t7\n"));
}

TEST(DriveRemarks, AreSaidOfALiveProgram) {
  const Folder folder;
  const auto driven = leadscrew(folder, {"drive", "--live", "-", "--quiet"}, {.input = speaking});
  EXPECT_EQ(driven.status, 0);
  EXPECT_EQ(driven.errors, "<stdin>:3: begin\nat 0\n");
  EXPECT_EQ(folder.read("log.txt"), "1\n");
}

TEST(DriveRemarks, KeepNothingOfAProgramThatFails) {
  const Folder folder;
  folder.write("a.var", "100\t6\n");
  const std::string aborting = "#100=9\n(LOGOPEN,log.txt)\n(LOG,x)\nG0 X1\n(ABORT,no)\nM2\n";
  const auto driven =
      leadscrew(folder, {"drive", "--live", "-", "--quiet", "--parameters", "a.var"}, {.input = aborting});
  EXPECT_NE(driven.status, 0);
  EXPECT_EQ(folder.read("a.var"), "100\t6\n");
  EXPECT_EQ(folder.names(), Names{"a.var"});
}

}  // namespace test_drive_remarks
}  // namespace leadscrew::cli::testing
