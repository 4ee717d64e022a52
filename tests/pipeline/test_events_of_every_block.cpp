#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "motion_with_events.hpp"

// Events and tolerances of every block that motion does not rest for cost no time, and change no word.

namespace test_events_of_every_block {

using namespace leadscrew;
using base::PassedEvent;
using testing_support::Motion;
using testing_support::numbered;
using testing_support::run_with_events;
using testing_support::seconds;

std::vector<base::Event> travelling(const std::vector<PassedEvent>& events) {
  std::vector<base::Event> found;
  std::copy_if(events.begin(), events.end(), std::back_inserter(found), [](const auto& event) { return !event.waits; });
  return found;
}

/// 400 short lines, back and forth as a laser's raster, with this at the end of each block.
std::string raster(const std::function<std::string(int)>& word) {
  std::string text = "G21 G90 G94 G17 F6000\nG64 P0.01\nG0 X0 Y0\n";
  for (int k = 0; k < 400; ++k) {
    char block[80];
    const int row = k / 100, column = k % 100 + 1;
    std::snprintf(block, sizeof block, "G1 X%.3f Y%.3f", 0.5 * (row % 2 == 0 ? column : 100 - column), 0.5 * row);
    text += block + word(k) + '\n';
  }
  return text + "M2\n";
}

void expect_same_words(const Motion& motion, const Motion& same) {
  ASSERT_EQ(motion.words.size(), same.words.size());
  for (std::size_t k = 0; k < motion.words.size(); ++k) {
    const base::Word &word = motion.words[k], &other = same.words[k];
    for (std::size_t i = 0; i < word.position.size(); ++i) {
      ASSERT_EQ(std::bit_cast<std::uint64_t>(word.position[i]), std::bit_cast<std::uint64_t>(other.position[i])) << k;
    }
    ASSERT_EQ(word.path_length, other.path_length) << k;
    ASSERT_EQ(word.line, other.line) << k;
  }
}

/// 400 short lines about a bend, each with this at its end.
std::string bent_lines(const std::function<std::string(int)>& word) {
  std::string text = "G21 G90 G94 G17 F6000\nG64 P0.01\nG0 X0 Y0\n";
  for (int k = 1; k <= 400; ++k) {
    char block[80];
    const double angle = 0.02 * k;
    std::snprintf(block, sizeof block, "G1 X%.4f Y%.4f Z%.4f", 25 * std::sin(angle), 12 * (1 - std::cos(2 * angle)),
                  -0.005 * k);
    text += block + word(k) + '\n';
  }
  return text + "M2\n";
}

/// A laser's picture of 20 by 20 dots, each row in the direction opposite to the one before, with this before each dot.
std::string dots(const std::function<std::string(int)>& word) {
  std::string text = "G21 G90 G94 G17 F9000\nG64 P0.02\nM3 S0\nG0 X5 Y5\n";
  for (int k = 0; k < 400; ++k) {
    char block[80];
    const int row = k / 20, dot = k % 20 + 1;
    std::snprintf(block, sizeof block, "G1 X%.2f Y%.2f", 5 + 0.25 * (row % 2 == 0 ? dot : 20 - dot), 5 + 0.1 * row);
    text += block + word(k) + '\n';
  }
  return text + "M5\nM2\n";
}

class EveryBlock : public testing::TestWithParam<const char*> {};

TEST_P(EveryBlock, OfARasterCostsNothing) {
  const Motion plain = run_with_events(raster([](int) { return std::string(); }));
  const Motion busy = run_with_events(raster([](int k) { return numbered(GetParam(), k); }));
  EXPECT_EQ(busy.problems, "");
  EXPECT_LT(seconds(busy), 1.01 * seconds(plain));
  expect_same_words(busy, plain);
  EXPECT_GE(travelling(busy.events).size(), 400u);
}

TEST_P(EveryBlock, OfABendCostsNothing) {
  const Motion plain = run_with_events(bent_lines([](int) { return std::string(); }));
  const Motion busy = run_with_events(bent_lines([](int k) { return numbered(GetParam(), k); }));
  EXPECT_EQ(busy.problems, "");
  EXPECT_LT(seconds(busy), 1.01 * seconds(plain));
  expect_same_words(busy, plain);
}

/// With a laser that follows feed, too: its events are more.
TEST(EveryDot, OfALasersPictureCostsNothing) {
  machine::Machine machine = machine::mill3();
  machine.spindle_waits = false;
  const Motion plain = run_with_events(dots([](int) { return std::string(); }), machine);
  machine.laser.emplace();
  for (const char* event : {" S", " M67 E0 Q"}) {
    const Motion busy = run_with_events(dots([&](int k) { return numbered(event, k % 7); }), machine);
    EXPECT_EQ(busy.problems, "");
    EXPECT_LT(seconds(busy), 1.01 * seconds(plain));
    expect_same_words(busy, plain);
    EXPECT_GE(travelling(busy.events).size(), 400u);
  }
}

/// A tolerance of its own for each block takes no longer than the least of them for all.
TEST(EveryTolerance, OfShortLinesCostsNothing) {
  for (const auto& make : {bent_lines, raster}) {
    const double least = seconds(run_with_events(make([](int) { return std::string(); })));
    const Motion mixed = run_with_events(make([](int k) { return k % 2 == 0 ? "\nG64 P0.01" : "\nG64 P0.012"; }));
    EXPECT_EQ(mixed.problems, "");
    EXPECT_LT(seconds(mixed), 1.01 * least);
  }
}

INSTANTIATE_TEST_SUITE_P(Events, EveryBlock,
                         testing::Values(" S", " T", " M67 E0 Q", " M68 E3 Q", " M62 P1 S", " M65 P0 T", " M8 S"),
                         [](const auto& each) {
                           std::string name(each.param);
                           std::erase(name, ' ');
                           return name;
                         });

}  // namespace test_events_of_every_block
