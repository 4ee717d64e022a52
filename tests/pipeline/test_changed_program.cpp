#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/referee/referee.hpp>

// A program that is not what it was when it was checked, while it moves: motion comes to rest on the path that was
// checked, within limits, and says why.

namespace test_changed_program {

using namespace leadscrew;

constexpr double radius = 20;
constexpr std::int64_t circles = 40;

/// From X20 Y0 round the origin, again and again; the last block may be another one.
std::string circles_and(const std::string& last) {
  std::string text = "G21 G90 G17 G61 F6000\nG0 X20 Y0\n";
  for (std::int64_t k = 0; k < circles; ++k) text += "G3 X20 Y0 I-20 J0\n";
  return text + last + "M2\n";
}

constexpr std::size_t few_blocks = 60, all_of_it = 1 << 20;  // bytes that a read gives at most

/// A file that somebody writes to while it is read.
class ChangingFile {
 public:
  ChangingFile(std::string before, std::string after, std::size_t most = few_blocks)
      : text_(std::move(before)), after_(std::move(after)), most_(most) {}

  void change() {
    if (is_changed_) return;
    is_changed_ = true;
    text_ = after_;
  }
  gcode::ByteSource source() {
    return [this, offset = std::size_t{0}](std::span<char> buffer) mutable -> base::Result<std::size_t> {
      const std::string_view rest = std::string_view(text_).substr(std::min(offset, text_.size()));
      const std::size_t count = rest.copy(buffer.data(), std::min(buffer.size(), most_));
      offset += count;
      return count;
    };
  }
  base::Result<void> unchanged() const {
    if (!is_changed_) return {};
    return base::failure(base::problem("io-read", "was changed", {}));
  }

 private:
  std::string text_, after_;
  std::size_t most_;
  bool is_changed_ = false;
};

/// Is it a place of the program as it was checked, mm?
double distance_to_path(const base::Word& word) {
  const double x = word.position[0], y = word.position[1];
  const double to_circle = std::abs(std::hypot(x, y) - radius);
  return y == 0 && x >= 0 && x <= radius ? 0 : to_circle;
}

struct Ending {
  std::optional<base::Diagnostic> failure;
  std::vector<base::Word> words;
  constraints::LimitRatios plan;
  double length = 0;
};

/// The file is changed before this word.
Ending move(ChangingFile& file, std::int64_t change_at, bool is_watched) {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools;
  pipeline::Program program(file.source(), machine, tools, {}, nullptr);
  if (is_watched) program.watch([&] { return file.unchanged(); });
  Ending ending;
  while (program.prepare()) {
    ending.words.push_back(program.cycle());
    if (std::ssize(ending.words) == change_at) file.change();
  }
  ending.failure = program.failure();
  ending.plan = program.summary().plan;
  ending.length = program.summary().length_mm;
  return ending;
}

void expect_rest_on_the_path(const Ending& ending) {
  for (const base::Word& word : ending.words) ASSERT_LT(distance_to_path(word), 1e-9) << base::count(word.tick);
  ASSERT_GT(ending.words.size(), 1U);
  EXPECT_EQ(ending.words.back().speed, 0);
  EXPECT_EQ(ending.words.back().state, base::MotionState::rest);
  EXPECT_NEAR(ending.words.back().path_length, ending.length, 1e-6);
  EXPECT_LE(ending.plan.greatest(), 1.001);
}

TEST(ChangedProgram, RestsOnThePathThatWasCheckedWhateverIsSavedAndWhenever) {
  const std::string checked = circles_and("");
  const std::string others[] = {
      "G21 G90 G17 G61 F6000\nG0 X20 Y0\n" + std::string(3000, ' ') + "\nG1 X9999\nG1 X0 Y0\nM2\n",
      "",
      "nonsense\n",
      circles_and("").replace(200, 18, "G3 X30 Y0 I-20 J0\n"),
  };
  for (const std::string& other : others) {
    for (std::int64_t change_at = 1; change_at < 20'000; change_at += 1900) {
      ChangingFile file(checked, other);
      const Ending ending = move(file, change_at, true);
      expect_rest_on_the_path(ending);
      ASSERT_TRUE(ending.failure) << change_at;
      EXPECT_EQ(ending.failure->code, "io-read");
    }
  }
}

TEST(ChangedProgram, RestsOnThePathThoughAllOfItHasBeenRead) {
  ChangingFile file(circles_and(""), "", all_of_it);
  const Ending ending = move(file, 7000, true);
  expect_rest_on_the_path(ending);
  ASSERT_TRUE(ending.failure);
  EXPECT_LT(ending.words.size(), 12'000U);
}

/// Where nobody can tell that the text is another, its first error ends motion: a block behind it would begin where
/// the one in error was to end, here at X 9999.
TEST(ChangedProgram, RestsOnThePathBeforeAnErrorThatTheFirstReadingDidNotHave) {
  ChangingFile file(circles_and("G1 X10 Y0\n"), circles_and("G1 X9999\nG1 X10 Y0\n"));
  const Ending ending = move(file, 100, false);
  expect_rest_on_the_path(ending);
  ASSERT_TRUE(ending.failure);
  EXPECT_EQ(ending.failure->code, "travel");
  EXPECT_GT(ending.length, (circles - 3) * 2 * 3.14 * radius);
}

TEST(ChangedProgram, GivesItsErrorsToTheSinkAsWell) {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools;
  std::vector<std::string> codes;
  pipeline::MotionSource source(gcode::text_source("G1 X10 F600\nG1 X9999\nG1 X0\nM2\n"), machine, tools, {},
                                [&](const base::Diagnostic& diagnostic) { codes.emplace_back(diagnostic.code); });
  while (source.next()) {
  }
  EXPECT_EQ(codes, std::vector<std::string>{"travel"});
  ASSERT_TRUE(source.failure());
  EXPECT_EQ(source.failure()->code, "travel");
  EXPECT_FALSE(source.next());
}

TEST(ChangedProgram, DoesNotFailWhereItIsTheSame) {
  ChangingFile file(circles_and(""), "");
  const Ending ending = move(file, -1, true);
  expect_rest_on_the_path(ending);
  EXPECT_FALSE(ending.failure);
  EXPECT_NEAR(ending.length, radius + circles * 2 * 3.14159265358979 * radius, 1e-6);
}

}  // namespace test_changed_program
