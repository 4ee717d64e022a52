// What a program says in remarks: on standard error, and in log files beside it.

#include <gtest/gtest.h>

#include <filesystem>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_remark_output {

TEST(RemarkOutput, SaysMessagesOnce) {
  const Folder folder;
  folder.write("a.ngc", "G21 F600\n#<r>=2\n(MSG,begin)\nG1 X1 (DEBUG,r is %d#<r>)\n(PRINT,done)\nM2\n");
  EXPECT_EQ(leadscrew(folder, {"run", "a.ngc", "--quiet"}).errors, "a.ngc:3: begin\na.ngc:4: r is 2\ndone\n");
  EXPECT_EQ(leadscrew(folder, {"check", "a.ngc"}).errors, "a.ngc:3: begin\na.ngc:4: r is 2\ndone\n");
  EXPECT_EQ(leadscrew(folder, {"check", "a.ngc", "--quiet"}).errors, "");
}

TEST(RemarkOutput, TellsMessagesInTheJsonOfCheck) {
  const Folder folder;
  folder.write("a.ngc", "(LOGOPEN,b.txt)\n(LOG,new)\n(MSG,begin)\nG0 X1 (PRINT,at %d#5021)\nM2\n");
  const auto json = leadscrew(folder, {"check", "a.ngc", "--json"}).json();
  EXPECT_EQ(json["message_count"], 2);
  ASSERT_EQ(json["messages"].size(), 2U);
  EXPECT_EQ(json["messages"][0]["kind"], "message");
  EXPECT_EQ(json["messages"][0]["text"], "begin");
  EXPECT_EQ(json["messages"][0]["line"], 3);
  EXPECT_EQ(json["messages"][0]["column"], 2);
  EXPECT_EQ(json["messages"][1]["kind"], "print");
  EXPECT_EQ(json["messages"][1]["text"], "at 0");
  EXPECT_EQ(folder.names(), (Names{"a.ngc"}));
}

TEST(RemarkOutput, KeepsTheFirstThousandMessages) {
  const Folder folder;
  folder.write("a.ngc", "o1 repeat [1500]\n(PRINT,again)\no1 endrepeat\nM2\n");
  const auto json = leadscrew(folder, {"check", "a.ngc", "--json", "--quiet"}).json();
  EXPECT_EQ(json["message_count"], 1500);
  EXPECT_EQ(json["messages"].size(), 1000U);
}

TEST(RemarkOutput, ShowsNoControlCharacters) {
  const Folder folder;
  folder.write("a.ngc", "(MSG,a\033[31mb)\nM2\n");
  EXPECT_EQ(leadscrew(folder, {"run", "a.ngc", "--quiet"}).errors.find('\033'), std::string::npos);
}

TEST(RemarkOutput, WritesLogsBesideTheProgram) {
  const Folder folder;
  std::filesystem::create_directory(folder.path() / "parts");
  folder.write("parts/a.ngc",
               "(LOGOPEN,logs/a.txt)\n(LOG,one)\n(LOGOPEN,b.txt)\n(LOG,two)\n(LOGAPPEND,logs/a.txt)\n(LOG,three)\n"
               "(LOGCLOSE)\nM2\n");
  folder.write("parts/b.txt", "old\n");
  const auto ran = leadscrew(folder, {"run", "parts/a.ngc"});
  EXPECT_EQ(ran.status, 0);
  EXPECT_NE(ran.output.find("parts/b.txt"), std::string::npos);
  EXPECT_NE(ran.output.find("parts/logs/a.txt"), std::string::npos);
  EXPECT_EQ(folder.read("parts/logs/a.txt"), "one\nthree\n");
  EXPECT_EQ(folder.read("parts/b.txt"), "two\n");
}

TEST(RemarkOutput, ContinuesLogs) {
  const Folder folder;
  folder.write("a.ngc", "(LOGAPPEND,b.txt)\n(LOG,new)\nM2\n");
  folder.write("b.txt", "old\n");
  EXPECT_EQ(leadscrew(folder, {"run", "a.ngc"}).status, 0);
  EXPECT_EQ(leadscrew(folder, {"run", "a.ngc"}).status, 0);
  EXPECT_EQ(folder.read("b.txt"), "old\nnew\nnew\n");
}

TEST(RemarkOutput, WritesNothingWhereTheProgramIsRefused) {
  const Folder folder;
  folder.write("a.ngc", "(LOGOPEN,b.txt)\n(LOG,new)\nG0 X900\nM2\n");
  EXPECT_EQ(leadscrew(folder, {"run", "a.ngc"}).status, 3);
  EXPECT_EQ(leadscrew(folder, {"check", "a.ngc"}).status, 3);
  EXPECT_EQ(folder.names(), (Names{"a.ngc"}));
}

TEST(RemarkOutput, ReplacesNoFileOfTheRun) {
  const Folder folder;
  folder.write("a.ngc", "(LOGOPEN,a.ngc)\n(LOG,new)\nM2\n");
  const auto ran = leadscrew(folder, {"run", "a.ngc"});
  EXPECT_EQ(ran.status, 3);
  EXPECT_NE(ran.errors.find("bad-log"), std::string::npos);
  EXPECT_EQ(folder.read("a.ngc"), "(LOGOPEN,a.ngc)\n(LOG,new)\nM2\n");
}

TEST(RemarkOutput, FollowsNoLinkOutOfTheFolder) {
  const Folder outside, folder;
  std::filesystem::create_directory_symlink(outside.path(), folder.path() / "out");
  std::filesystem::create_symlink(outside.path() / "c.txt", folder.path() / "c.txt");
  for (const char* const name : {"out/b.txt", "c.txt"}) {
    folder.write("a.ngc", "(LOGOPEN," + std::string(name) + ")\n(LOG,new)\nM2\n");
    EXPECT_EQ(leadscrew(folder, {"run", "a.ngc"}).status, 3) << name;
  }
  EXPECT_EQ(outside.names(), Names{});
}

TEST(Abort, IsAnError) {
  const Folder folder;
  folder.write("a.ngc", "#1=3\nG0 X1\n(ABORT,no tool %d#1)\nG0 X2\nM2\n");
  const auto checked = leadscrew(folder, {"check", "a.ngc", "--json"});
  EXPECT_EQ(checked.status, 3);
  EXPECT_EQ(checked.json()["diagnostics"][0]["code"], "program-abort");
  EXPECT_EQ(leadscrew(folder, {"run", "a.ngc"}).status, 3);
}

}  // namespace test_remark_output
}  // namespace leadscrew::cli::testing
