// Long work ends soon after it is cancelled, also inside one call.

#include <gtest/gtest.h>

#include "track.hpp"

namespace leadscrew::referee::test {
namespace test_cancellation {

const machine::Machine mill = machine::mill3();
constexpr base::Period period{1'000'000};

TEST(Cancellation, EndsTheSearchForTheEndOfAnEndlessProgram) {
  Program program;
  program.line(10, 0).line(0, 0);
  std::int64_t moves = 0;
  const MoveSource endless = [&](Move& move) {
    move = program.moves[static_cast<std::size_t>(moves++ % 2)];
    return true;
  };
  Referee referee(endless, mill, period, [&] { return moves > 1000; });
  referee.observe({});
  referee.conclude();
  EXPECT_LT(moves, 2000);
}

TEST(Cancellation, EndsARematchOfManyWordsOnManyPieces) {
  // Everything lies within the tolerance of everything: 4000 words, 500 pieces, and then a word outside.
  Program program;
  program.blended(0.1);
  for (int i = 0; i < 250; ++i) program.line(0.05, 0).line(0, 0);
  const auto asked_until_the_end = [&](std::int64_t most) {
    std::int64_t asked = 0;
    bool outside = false;
    Referee referee(source_of(program.moves), mill, period, [&] { return outside && ++asked > most; });
    for (int n = 0; n < 4000; ++n) referee.observe({1e-6 * n});
    outside = true;
    referee.observe({0, 0.2});
    referee.conclude();
    return asked;
  };
  EXPECT_GT(asked_until_the_end(1'000'000), 1000);
  EXPECT_EQ(asked_until_the_end(10), 11);
}

TEST(Cancellation, ThatIsNotAskedForChangesNothing) {
  Program program;
  program.line(10, 0).line(10, 5);
  const Words words = exact_motion(program, mill, period);
  Referee referee(source_of(program.moves), mill, period, [] { return false; });
  for (const AxisVector& word : words) referee.observe(word);
  const Verdict verdict = referee.conclude(), plain = judge(program.moves, words, mill, period);
  EXPECT_EQ(verdict.deviation_mm, plain.deviation_mm);
  EXPECT_EQ(verdict.feed_max_ratio, plain.feed_max_ratio);
  EXPECT_EQ(verdict.violation_count, plain.violation_count);
}

}  // namespace test_cancellation
}  // namespace leadscrew::referee::test
