// Several programs at a time: what is told and written is what one thread makes of one after the other.

#include <gtest/gtest.h>

#include <algorithm>

#include "command.hpp"

namespace leadscrew::cli::testing {
namespace test_many_programs {

/// Long and short, sound and rejected, missing.
std::vector<std::string> write_programs(const Folder& folder) {
  std::vector<std::string> names;
  for (int k = 0; k < 12; ++k) {
    const std::string name = "part" + std::to_string(k) + ".ngc";
    folder.write(name,
                 k % 5 == 3 ? "G1 X" + std::to_string(k) + " G2\nG99999\n" : long_program(k % 4 == 0 ? 400 : 20 + k));
    names.push_back(name);
  }
  names.insert(names.begin() + 5, "none.ngc");
  return names;
}

Outcome run(const Folder& folder, std::vector<std::string> arguments, const std::string& threads) {
  arguments.insert(arguments.end(), {"--threads", threads});
  return leadscrew(folder, arguments);
}

/// But for how long it took.
Json without_times(Json runs) {
  for (Json& program : runs["programs"]) program.erase("cpu");
  return runs;
}

TEST(ManyPrograms, AreToldInTheirOrderWhoeverWorksOnThem) {
  const Folder folder;
  for (const char* verb : {"run", "check", "simulate"}) {
    std::vector<std::string> arguments = write_programs(folder);
    arguments.insert(arguments.begin(), verb);
    const auto one = run(folder, arguments, "1"), four = run(folder, arguments, "4");
    EXPECT_EQ(four.status, one.status) << verb;
    EXPECT_EQ(four.errors, one.errors) << verb;
    if (std::string_view(verb) == "check") {
      EXPECT_EQ(four.output, one.output);
    }
    arguments.emplace_back("--json");
    EXPECT_EQ(without_times(run(folder, arguments, "4").json()), without_times(run(folder, arguments, "1").json()));
  }
}

TEST(ManyPrograms, AreWrittenBitForBit) {
  const Folder folder;
  std::vector<std::string> arguments = write_programs(folder);
  arguments.insert(arguments.begin(), "run");
  arguments.emplace_back("--out");
  auto one = arguments, four = arguments;
  one.emplace_back("one");
  four.emplace_back("four");
  run(folder, one, "1");
  run(folder, four, "4");
  int compared = 0;
  for (const std::string& name : folder.names()) {
    if (!name.starts_with("one/") || name.ends_with(".html")) continue;
    EXPECT_TRUE(folder.read(name) == folder.read("four" + name.substr(3))) << name;
    ++compared;
  }
  EXPECT_GE(compared, 18);
}

TEST(ManyPrograms, EndWithTheFirstThatIsInterrupted) {
  const Folder folder;
  for (const char* name : {"a.ngc", "b.ngc", "c.ngc", "d.ngc"}) folder.write(name, long_program(200'000));
  Running running(folder, {"run", "a.ngc", "b.ngc", "c.ngc", "d.ngc", "--out", "made", "--threads", "2"});
  ASSERT_TRUE(eventually([&] { return folder.names().size() > 6 || running.has_ended(); }));
  ASSERT_FALSE(running.has_ended());
  running.send(SIGINT);
  const auto outcome = running.wait();
  EXPECT_EQ(outcome.status, 130);
  EXPECT_EQ(outcome.errors, "");
  EXPECT_EQ(folder.names(), (Names{"a.ngc", "b.ngc", "c.ngc", "d.ngc", "made"}));
}

TEST(ManyPrograms, ReadStandardInputOnceAtMost) {
  const Folder folder;
  const auto outcome = leadscrew(folder, {"check", "-", "-"}, {.input = "G21\nG1 X1 F100\nM2\n"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_TRUE(contains(outcome.errors, "standard input (-) can be read only once")) << outcome.errors;
}

TEST(ManyPrograms, AskForThreadsThatThereCanBe) {
  const Folder folder;
  folder.write("part.ngc", square);
  for (const char* threads : {"0", "-1", "x", "1025", "1.5"})
    EXPECT_EQ(leadscrew(folder, {"run", "part.ngc", "--threads", threads}).status, 2) << threads;
}

}  // namespace test_many_programs
}  // namespace leadscrew::cli::testing
