// --parameters: read where a program begins, written where it ends.

#include <gtest/gtest.h>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_parameter_option {

const std::string counter = "G21 F600\n#100=[#100+1]\nG10 L2 P2 X5\nG1 X#100\nM2\n";

TEST(ParameterOption, KeepsWhatAProgramLeaves) {
  const Folder folder;
  folder.write("a.ngc", counter);
  folder.write("a.var", "100\t6\n");
  EXPECT_EQ(leadscrew(folder, {"check", "a.ngc", "--parameters", "a.var"}).status, 0);
  EXPECT_EQ(folder.read("a.var"), "100\t6\n");
  const auto ran = leadscrew(folder, {"run", "a.ngc", "--parameters", "a.var", "--json"});
  EXPECT_EQ(ran.status, 0);
  EXPECT_DOUBLE_EQ(ran.json()["length_mm"], 7);
  EXPECT_TRUE(folder.read("a.var").starts_with("100\t7\n5161\t0\n"));
  EXPECT_NE(folder.read("a.var").find("\n5241\t5\n"), std::string::npos);
  EXPECT_EQ(leadscrew(folder, {"run", "a.ngc", "--parameters", "a.var"}).status, 0);
  EXPECT_TRUE(folder.read("a.var").starts_with("100\t8\n"));
}

TEST(ParameterOption, LeavesTheFileWhereTheProgramIsRefused) {
  const Folder folder;
  folder.write("a.ngc", counter + "G0 X1 Q\n");
  folder.write("b.ngc", "#100=9\n(ABORT,x)\nM2\n");
  folder.write("a.var", "100\t900\n");
  EXPECT_EQ(leadscrew(folder, {"run", "a.ngc", "--parameters", "a.var"}).status, 3);
  EXPECT_EQ(leadscrew(folder, {"run", "b.ngc", "--parameters", "a.var"}).status, 3);
  EXPECT_EQ(folder.read("a.var"), "100\t900\n");
}

TEST(ParameterOption, MakesAFileThatIsNotThere) {
  const Folder folder;
  folder.write("a.ngc", counter);
  const auto checked = leadscrew(folder, {"check", "a.ngc", "--parameters", "a.var", "--json"});
  EXPECT_EQ(checked.status, 0);
  EXPECT_TRUE(contains(checked.errors, "[new-parameters]")) << checked.errors;
  EXPECT_EQ(folder.names(), Names{"a.ngc"});
  EXPECT_EQ(leadscrew(folder, {"run", "a.ngc", "--parameters", "a.var"}).status, 0);
  EXPECT_TRUE(folder.read("a.var").starts_with("5161\t0\n"));
}

TEST(ParameterOption, TellsWhatIsWrongWithTheFile) {
  const Folder folder;
  folder.write("a.ngc", counter);
  folder.write("a.var", "5162\t1\n5161\t1\n");
  const auto checked = leadscrew(folder, {"check", "a.ngc", "--parameters", "a.var"});
  EXPECT_EQ(checked.status, 3);
  EXPECT_NE(checked.errors.find("a.var:2:1: error"), std::string::npos);
}

TEST(ParameterOption, IsForOneProgramThatRuns) {
  const Folder folder;
  folder.write("a.ngc", counter);
  folder.write("b.ngc", counter);
  EXPECT_EQ(leadscrew(folder, {"run", "a.ngc", "b.ngc", "--parameters", "a.var"}).status, 2);
  EXPECT_EQ(leadscrew(folder, {"run", "a.ngc", "--trace", "a.csv", "--parameters", "a.csv"}).status, 2);
}

}  // namespace test_parameter_option
}  // namespace leadscrew::cli::testing
