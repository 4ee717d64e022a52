#include <leadscrew/referee/referee.hpp>

#include "called.hpp"

// Words judged one by one, by the program that they were made for.

using namespace leadscrew;
using namespace leadscrew::capi_tests;

namespace test_referee {

struct FreeReferee {
  void operator()(leadscrew_referee* referee) const { leadscrew_referee_free(referee); }
};
using Referee = std::unique_ptr<leadscrew_referee, FreeReferee>;

Referee begun(const std::string& text, const leadscrew_options& options = no_options()) {
  leadscrew_referee* referee = nullptr;
  leadscrew_error error = sized_error();
  EXPECT_EQ(leadscrew_referee_begin(mill().get(), text.data(), text.size(), &options, &referee, &error), LEADSCREW_OK)
      << error.message;
  return Referee(referee);
}

leadscrew_judged judge(leadscrew_referee* referee, const leadscrew_word& word) {
  leadscrew_judged judged{};
  judged.size = sizeof judged;
  leadscrew_error error = sized_error();
  EXPECT_EQ(leadscrew_referee_observe(referee, &word, sizeof word, &judged, &error), LEADSCREW_OK) << error.message;
  return judged;
}

leadscrew_verdict verdict_of(leadscrew_referee* referee) {
  leadscrew_verdict verdict{};
  verdict.size = sizeof verdict;
  EXPECT_EQ(leadscrew_referee_conclude(referee, &verdict, nullptr), LEADSCREW_OK);
  return verdict;
}

/// Along X to a corner, and along Y from there.
const std::string corner = "G21 G90 G64 P0.05 F3000\nG1 X20\nY20\nM2\n";

double distance_from_corner(const leadscrew_word& word) {
  const double x = word.position[0], y = word.position[1];
  const double along_x = std::hypot(x - std::min(x, 20.0), y);
  const double along_y = std::hypot(x - 20, y - std::max(y, 0.0));
  return std::min(along_x, along_y);
}

TEST(Referee, TellsHowFarEachWordIsFromACornerAndWhatIsAllowed) {
  const Referee referee = begun(corner);
  double farthest = 0;
  for (const leadscrew_word& word : words_of(program(corner).get())) {
    const leadscrew_judged judged = judge(referee.get(), word);
    EXPECT_NEAR(judged.distance, distance_from_corner(word), 0.05 / 8) << word.tick;
    EXPECT_EQ(judged.tolerance, 0.05);
    farthest = std::max(farthest, judged.distance);
  }
  // The corner itself may be farther from the way around it than any word from the lines.
  const leadscrew_verdict verdict = verdict_of(referee.get());
  EXPECT_GT(farthest, 0.3 * 0.05);
  EXPECT_GE(verdict.deviation, farthest - 1e-9);
  EXPECT_LE(verdict.deviation, 0.05 + 1e-6);
  EXPECT_EQ(verdict.tolerance, 0.05);
  EXPECT_EQ(verdict.objections, 0);
}

TEST(Referee, IsThatOfTheRoom) {
  const Referee referee = begun(plate);
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools;
  gcode::Reader reader(gcode::text_source(plate), machine, tools, {}, nullptr);
  referee::Referee same([&](gcode::Move& move) { return reader.next(move); }, machine, machine.period);
  for (const leadscrew_word& word : words_of(program(plate).get())) {
    const leadscrew_judged judged = judge(referee.get(), word);
    base::AxisVector position{};
    std::copy_n(word.position, LEADSCREW_AXES, position.begin());
    same.observe(position, word.feed);
    ASSERT_EQ(judged.distance, same.matched().distance) << word.tick;
    ASSERT_EQ(judged.tolerance, same.matched().tolerance) << word.tick;
    ASSERT_EQ(judged.line, base::number(same.matched().line)) << word.tick;
  }
  const referee::Verdict expected = same.conclude();
  const leadscrew_verdict verdict = verdict_of(referee.get());
  EXPECT_EQ(verdict.deviation, expected.deviation_mm);
  EXPECT_EQ(verdict.tolerance, expected.tolerance_mm);
  EXPECT_EQ(verdict.start_error, expected.start_error_mm);
  EXPECT_EQ(verdict.end_error, expected.end_error_mm);
  EXPECT_EQ(verdict.objections, expected.violation_count);
}

TEST(Referee, TellsOfWordsThatLeaveThePath) {
  const Referee referee = begun(corner);
  double farthest = 0;
  for (leadscrew_word word : words_of(program(corner).get())) {
    if (word.tick > 100) word.position[2] += 0.3;
    farthest = std::max(farthest, judge(referee.get(), word).distance);
  }
  EXPECT_NEAR(farthest, std::hypot(0.3, 0.05), 0.01);
  const leadscrew_verdict verdict = verdict_of(referee.get());
  EXPECT_GT(verdict.objections, 0);
  EXPECT_NEAR(verdict.end_error, 0.3, 1e-9);
}

TEST(Referee, TakesTheToleranceThatOptionsAskFor) {
  leadscrew_options options = no_options();
  options.path_mode = LEADSCREW_BLEND;
  options.has_tolerance = 1;
  options.tolerance = 0.2;
  const Referee referee = begun(corner, options);
  EXPECT_EQ(judge(referee.get(), leadscrew_word{}).tolerance, 0.2);
}

TEST(Referee, RefusesAProgramWithAnErrorOnceItIsRead) {
  const Referee referee = begun("G21 G90 F600\nG1 X1Q\nX2\nM2\n");
  leadscrew_error error = sized_error();
  leadscrew_word word{};
  int code = LEADSCREW_OK;
  for (int i = 0; i < 100 && code == LEADSCREW_OK; ++i, word.position[0] += 0.01)
    code = leadscrew_referee_observe(referee.get(), &word, sizeof word, nullptr, &error);
  EXPECT_EQ(code, LEADSCREW_REJECTED);
  EXPECT_EQ(error.line, 2);
}

TEST(Referee, EndsWhereProgressSaysSo) {
  leadscrew_options options = no_options();
  options.on_progress = [](double, void*) { return 1; };
  const Referee referee = begun(corner, options);
  const leadscrew_word word{};
  EXPECT_EQ(leadscrew_referee_observe(referee.get(), &word, sizeof word, nullptr, nullptr), LEADSCREW_INTERRUPTED);
}

TEST(Referee, RefusesWhatIsNone) {
  leadscrew_referee* none = nullptr;
  EXPECT_EQ(leadscrew_referee_begin(nullptr, "M2", 2, nullptr, &none, nullptr), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_referee_begin(mill().get(), nullptr, 2, nullptr, &none, nullptr), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_referee_begin(mill().get(), "M2", 2, nullptr, nullptr, nullptr), LEADSCREW_MISUSE);
  const Referee referee = begun(corner);
  const leadscrew_word word{};
  leadscrew_judged judged{};
  EXPECT_EQ(leadscrew_referee_observe(nullptr, &word, sizeof word, nullptr, nullptr), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_referee_observe(referee.get(), nullptr, sizeof word, nullptr, nullptr), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_referee_observe(referee.get(), &word, 8, nullptr, nullptr), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_referee_observe(referee.get(), &word, sizeof word, &judged, nullptr), LEADSCREW_MISUSE);
  EXPECT_EQ(leadscrew_referee_conclude(referee.get(), nullptr, nullptr), LEADSCREW_MISUSE);
  verdict_of(referee.get());
  EXPECT_EQ(leadscrew_referee_observe(referee.get(), &word, sizeof word, nullptr, nullptr), LEADSCREW_MISUSE);
  leadscrew_referee_free(nullptr);
}

}  // namespace test_referee
