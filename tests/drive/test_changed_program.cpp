// A program that is written over while it moves: nothing of the new text is ever cut.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <memory>
#include <random>

#include "driven.hpp"

namespace leadscrew::cli::testing {
namespace test_changed_program {

namespace fs = std::filesystem;

/// Round a square of 10 mm, 0.3 s a side, as long in the file as ten pages: the text is read while it moves.
std::string program_of(int corners) {
  std::string text = "G21 G90 G94 G61\n";
  const std::string remark = " (" + std::string(12'000, '.') + ")\n";
  for (int k = 0; k < corners; ++k)
    text += "G1 X" + std::to_string(k % 4 == 0 || k % 4 == 3 ? 10 : 20) + " Y" + std::to_string(k % 4 < 2 ? 10 : 20) +
            " F6000" + remark;
  return text + "M2\n";
}

/// As long as the text, with these blocks instead: before and behind every place at which a reader may stand.
std::string written_over(const std::string& text, const std::string& block) {
  std::string other;
  while (other.size() + block.size() + 10 < text.size()) other += block + "\n";
  other += "M2\n";
  other.resize(text.size(), ' ');
  return other;
}

struct Change {
  const char* name;
  std::function<std::string(const std::string&)> text;
};

const std::vector<Change> changes = {
    {"other geometry", [](const std::string& text) { return written_over(text, "G1 X-40 Y-40 F6000"); }},
    {"geometry beyond travel", [](const std::string& text) { return written_over(text, "G1 X9999 Y15 F6000"); }},
    {"an error", [](const std::string& text) { return written_over(text, "G1 X15 Y"); }},
    {"another corner, of the same length",
     [](std::string text) {
       for (std::size_t at = 0; (at = text.find("X20", at)) != std::string::npos; ++at) text[at + 1] = '3';
       return text;
     }},
    {"half of it", [](const std::string& text) { return text.substr(0, text.size() / 2); }},
    {"nothing", [](const std::string&) { return std::string(); }},
};

/// In place, as an editor does that does not rename; as old as it was, if its age is to say nothing.
void write_over(const fs::path& file, const std::string& text, bool keeps_time) {
  const auto time = fs::last_write_time(file);
  std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
  if (keeps_time) fs::last_write_time(file, time);
}

/// Drives the program, which is changed so long after it has begun to move; what reached the axes is on its path.
void expect_checked_words_only(const Change& change, int milliseconds, bool keeps_time) {
  SCOPED_TRACE(std::string(change.name) + " after " + std::to_string(milliseconds) + " ms" +
               (keeps_time ? ", at the old time" : ""));
  const std::string text = program_of(60);
  const Folder folder;
  folder.write("part.ngc", text);
  ASSERT_EQ(leadscrew(folder, {"run", "part.ngc", "--trace", "run.csv"}).status, 0);
  Running running(folder, {"drive", "part.ngc", "--trace", "words.csv", "--axes", "axes.csv", "--state", "state",
                           "--json", "--look-ahead", "50ms", "--lead", "50ms"});
  ASSERT_TRUE(comes_to(folder, 1));
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
  write_over(folder.path() / "part.ngc", change.text(text), keeps_time);
  const auto outcome = running.wait();
  EXPECT_EQ(outcome.status, 4) << outcome.errors;
  const Json json = outcome.json();
  EXPECT_EQ(json["end"], "failed");
  const std::string code = json["diagnostics"].back()["code"];
  EXPECT_TRUE(code == "program-changed" || code == "io-read") << code;
  EXPECT_EQ(state_of(folder), "stopped");
  const auto path = rows_of(folder.read("run.csv")), words = rows_of(folder.read("words.csv")),
             axes = rows_of(folder.read("axes.csv"));
  for (const Row& word : words) ASSERT_LE(distance(word.q, at(path, word.s)), 3e-4) << word.t;
  for (std::size_t k = 0; k < axes.size(); k += 10) ASSERT_LE(distance_to(path, axes[k].q), 3e-4) << axes[k].t;
  EXPECT_LE(worst_ratio(axes), 1.001);
  EXPECT_LT(words.back().s, path.back().s - 1);
  // The checked program goes on from there.
  write_over(folder.path() / "part.ngc", text, false);
  Running rest(folder, {"drive", "part.ngc", "--resume", "state", "--quiet"});
  EXPECT_TRUE(eventually([&] { return state_of(folder) == "moving"; }));
  rest.send(SIGTERM);
  EXPECT_EQ(rest.wait().status, 130);
}

class ChangedProgram : public ::testing::TestWithParam<unsigned> {};

TEST_P(ChangedProgram, LeavesNoWordOutsideTheCheckedOne) {
  std::minstd_rand random(GetParam());
  const Change& change = changes[GetParam() % changes.size()];
  // Its age says nothing in half of the cases: then the pieces that are read later do, and there are some.
  expect_checked_words_only(change, static_cast<int>(random() % 3000), GetParam() % 2 == 1);
}

INSTANTIATE_TEST_SUITE_P(At20Instants, ChangedProgram, ::testing::Range(0u, 20u));

/// All of it was read before it was changed.
TEST(ChangedProgram, ThatIsShortComesToRestToo) {
  const Folder folder;
  folder.write("part.ngc", "G21 G90 G94\nG1 X400 F3000\nM2\n");
  Running running(folder, {"drive", "part.ngc", "--axes", "axes.csv", "--state", "state", "--json"});
  ASSERT_TRUE(comes_to(folder, 10));
  folder.write("part.ngc", "G21 G90 G94\nG1 X300 F3000\nM2\n");
  const auto outcome = running.wait();
  EXPECT_EQ(outcome.status, 4) << outcome.errors;
  EXPECT_EQ(outcome.json()["diagnostics"].back()["code"], "program-changed");
  EXPECT_EQ(state_of(folder), "stopped");
  const auto axes = rows_of(folder.read("axes.csv"));
  EXPECT_LT(axes.back().q[0], 390);
  EXPECT_LE(worst_ratio(axes), 1.001);
}

/// An editor that writes another file and gives it the name leaves the one that is read as it is.
TEST(ChangedProgram, UnderItsNameAloneIsDrivenToItsEnd) {
  const Folder folder;
  folder.write("part.ngc", part);
  Running running(folder, {"drive", "part.ngc", "--trace", "words.csv", "--state", "state", "--lead", "1s"});
  ASSERT_TRUE(comes_to(folder, 5));
  folder.write("new.ngc", "G21 G90 G94\nG1 X9 F3000\nM2\n");
  fs::rename(folder.path() / "new.ngc", folder.path() / "part.ngc");
  const auto outcome = running.wait();
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_EQ(state_of(folder), "ended");
}

}  // namespace test_changed_program
}  // namespace leadscrew::cli::testing
