#include <gtest/gtest.h>

#include <cmath>

#include "live.hpp"

namespace test_changed_program {

using namespace leadscrew;

/// The program is changed while its words are made, at a word that the cyclic thread has just handed over.
TEST(ChangedProgram, BringsARunnerToRestOnThePathThatWasChecked) {
  const machine::Machine machine = machine::mill3();
  const machine::ToolTable tools;
  const std::string text = "G21 G90 G17 G64 F6000\nG3 X0 Y0 I20 J0\nG3 X0 Y0 I20 J0\nG3 X0 Y0 I20 J0\nM2\n";
  for (const std::size_t change_at : {1U, 700U, 1500U}) {
    std::atomic<bool> is_changed{false};
    pipeline::MotionSource source(gcode::text_source(text), machine, tools, {}, nullptr);
    source.planner().slice(0.02);
    source.unchanged = [&]() -> base::Result<void> {
      if (!is_changed.load()) return {};
      return base::failure(base::problem("io-read", "was changed", {}));
    };
    std::vector<base::Word> words;
    words.reserve(100'000);
    realtime::Runner runner({.period = machine.period, .look_ahead = 0.2},
                            {.next = [&] { return source.next(); },
                             .refuse = [&] { source.planner().refuse(); },
                             .override_feed = [&](double factor) { source.planner().override_feed(factor); }},
                            {.take =
                                 [&](const base::Word& word) {
                                   words.push_back(word);
                                   if (words.size() == change_at) is_changed.store(true);
                                   return true;
                                 },
                             .append_stop_position = {},
                             .publish = {}});
    runner.start();
    while (!runner.has_ended()) realtime::sleep_until(realtime::now() + 1'000'000);
    ASSERT_TRUE(source.failure());
    EXPECT_EQ(source.failure()->code, "io-read");
    EXPECT_EQ(words.back().state, base::MotionState::rest);
    EXPECT_LT(words.back().path_length, 3 * 2 * 3.14 * 20);
    for (const base::Word& word : words)
      ASSERT_NEAR(std::hypot(word.position[0] - 20, word.position[1]), 20, 1e-9) << base::count(word.tick);
  }
}

}  // namespace test_changed_program
