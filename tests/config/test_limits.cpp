// Hostile machine files end with a problem that says which limit they pass.

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <leadscrew/config/file_text.hpp>

#include "files.hpp"

namespace leadscrew::config::testing {
namespace test_limits {

using Texts = std::vector<std::string>;

/// "a.a.a", so many parts.
std::string dotted(std::size_t parts) {
  return "a" + repeated(".a", parts - 1);
}

TEST(Size, IsBounded) {
  std::string text = one_axis + "#";
  text.resize(largest_machine_file, ' ');
  EXPECT_EQ(problems_of(text), Texts{});
  text += ' ';
  EXPECT_EQ(problems_of(text), Texts{"0:0 input-too-large"});
}

TEST(Size, OfAFileWithoutEndIsFoundWhenTheLimitIsPassed) {
  const auto read = load_machine("/dev/zero");
  ASSERT_FALSE(read);
  ASSERT_EQ(read.error().size(), 1u);
  EXPECT_EQ(read.error()[0].code, "input-too-large");
  EXPECT_NE(read.error()[0].message.find("512 KiB"), std::string::npos);
}

TEST(Nesting, OfKeysIsBounded) {
  EXPECT_EQ(problems_of(one_axis + dotted(17) + " = 1\n"), Texts{"7:1 machine-key"});
  EXPECT_EQ(problems_of(one_axis + dotted(18) + " = 1\n"), Texts{"7:34 machine-nesting"});
  EXPECT_EQ(problems_of("[" + dotted(18) + "]\n"), Texts{"1:35 machine-nesting"});
  EXPECT_EQ(problems_of("x = {" + dotted(18) + " = 1}\n"), Texts{"1:39 machine-nesting"});
  EXPECT_EQ(problems_of(repeated("\"a\" . ", 18) + "a = 1\n"), Texts{"1:101 machine-nesting"});
}

TEST(Nesting, OfKeysInAWholeFileOfThemIsBounded) {
  EXPECT_EQ(problems_of(dotted(40'000) + " = 1\n"), Texts{"1:34 machine-nesting"});
  EXPECT_EQ(problems_of("[" + dotted(largest_machine_file / 2 - 2) + "]"), Texts{"1:35 machine-nesting"});
}

TEST(Nesting, OfListsIsBounded) {
  EXPECT_EQ(problems_of(one_axis + "[x]\ny = " + repeated("[", 16) + repeated("]", 16)).size(), 1u);
  EXPECT_EQ(problems_of("x = " + repeated("[", 17) + repeated("]", 17)), Texts{"1:21 machine-nesting"});
  EXPECT_EQ(problems_of("x = " + repeated("[", 500'000)), Texts{"1:21 machine-nesting"});
  EXPECT_EQ(problems_of("x = " + repeated("{a = ", 100'000)), Texts{"1:85 machine-nesting"});
  EXPECT_EQ(problems_of("x = " + repeated("[\n", 17) + repeated("]", 17)), Texts{"17:1 machine-nesting"});
}

TEST(Nesting, IsNotHiddenByStringsAndComments) {
  const std::string deep = dotted(18) + " = 1\n";
  for (const char* before :
       {"# it's \"\n", "x = 'a\\'\n", "x = \"a\\\"\"\n", "x = '''a''''\n", "x = '''a'''''\n", "x = \"\"\"a\\\"\"\"\"\n",
        "x = \"\"\"a\"\"\"\"\"\n", "x = '''\n''\n'''\n", "x = \"\"\"\"\"\"\n", "x = ''''''\n"}) {
    const std::string text = std::string(before) + deep;
    const Texts found = problems_of(text);
    ASSERT_FALSE(found.empty()) << text;
    EXPECT_TRUE(found.back().ends_with("machine-nesting")) << text << found.back();
  }
}

TEST(Nesting, WithinStringsAndCommentsIsNone) {
  for (const std::string& before :
       {"# " + dotted(100) + "\n", "name = \"" + dotted(100) + "\"\n", "name = '''\n" + repeated("[", 100) + "'''\n",
        "name = \"\"\"\\\"\"\"" + repeated("[", 100) + "\"\"\"\n"}) {
    EXPECT_EQ(problems_of(before + one_axis), Texts{}) << before;
  }
}

TEST(Nesting, OfManyEntriesOnOneLineIsNone) {
  std::string table = "pitch_errors_mm = [";
  for (int k = 0; k < 1000; ++k) table += "[" + std::to_string(k) + ".25, 0.001], ";
  EXPECT_EQ(problems_of(one_axis + table + "]\n"), Texts{});
}

TEST(Nesting, IsTakenBackByAnErrorBefore) {
  EXPECT_EQ(problems_of(repeated("[axis.X\n", 40)), Texts{"1:8 machine-syntax"});
}

/// As many as there are told; line by line, with the text of the line.
TEST(Problems, AreToldUpToAHundred) {
  std::string text = one_axis;
  for (int k = 0; k < 50'000; ++k) text += "[t" + std::to_string(k) + "]\n";
  const auto read = read_machine(text, "m.toml");
  ASSERT_FALSE(read);
  ASSERT_EQ(read.error().size(), most_machine_problems + 1);
  for (std::size_t k = 0; k < most_machine_problems; ++k) {
    const base::Diagnostic& problem = read.error()[k];
    EXPECT_EQ(problem.code, "machine-key");
    EXPECT_EQ(problem.place.line, static_cast<std::int64_t>(k) + 7);
    EXPECT_NE(problem.message.find(problem.source.substr(1, problem.source.size() - 2)), std::string::npos);
  }
  EXPECT_EQ(read.error().back().code, "too-many-problems");
  EXPECT_NE(read.error().back().message.find("49900"), std::string::npos) << read.error().back().message;
}

TEST(Problems, ShowLittleOfLongKeysAndLines) {
  const auto read = read_machine(one_axis + repeated("ä", 100'000).insert(0, "\"") + "\" = 1\n", "m.toml");
  ASSERT_FALSE(read);
  EXPECT_LT(read.error()[0].message.size(), 120u);
  EXPECT_NE(read.error()[0].message.find("ää…"), std::string::npos);
  EXPECT_LE(read.error()[0].source.size(), 4096u);
}

TEST(Files, ThatCannotBeReadAreSaidSo) {
  const auto missing = load_machine("/nonexistent/m.toml");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error()[0].code, "io-open");
  EXPECT_EQ(missing.error()[0].place.file, "/nonexistent/m.toml");
  const auto folder = load_machine("/");
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error()[0].code, "io-read");
}

TEST(Files, OfTheProjectLoadUnderTheirNames) {
  int machines = 0;
  for (const auto& entry : std::filesystem::directory_iterator(LEADSCREW_SOURCE_DIR "/machines")) {
    if (entry.path().extension() != ".toml") continue;
    ++machines;
    const auto machine = load_machine(entry.path());
    ASSERT_TRUE(machine) << entry.path() << machine.error()[0].message;
    EXPECT_EQ(machine->name, entry.path().stem().string());
  }
  EXPECT_GE(machines, 4);
}

}  // namespace test_limits
}  // namespace leadscrew::config::testing
