#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>
#include <random_numbers.hpp>
#include <string>
#include <utility>
#include <vector>

#include "blended.hpp"

// Programs under G64 whose P and Q change from block to block: each block is kept within its own P, the referee says,
// inside every limit; motion goes on through the changes.

namespace test_blended_tolerances {

using namespace leadscrew;
using namespace leadscrew::testing_support;

/// A move, and what G64 allows it.
struct Block {
  std::string mode;  ///< G64 P… Q…
  std::string move;
};

/// Where the mode changes, motion may be made to stop: by a dwell of no time, or the move before ends by G61.1.
enum class Changes { run_through, stop, stop_exactly };

std::string text_of(const std::vector<Block>& blocks, Changes changes) {
  std::string text = "G21 G90 G17 G94 F6000\n", mode;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    if (blocks[k].mode != mode) {
      if (!mode.empty() && changes == Changes::stop) text += "G4 P0\n";
      text += mode = blocks[k].mode;
    }
    const bool ends = k + 1 < blocks.size() && blocks[k + 1].mode != mode;
    if (ends && changes == Changes::stop_exactly) text += "G61.1\n";
    text += blocks[k].move;
  }
  return text + "M2\n";
}

double time_of(const std::vector<Block>& blocks, Changes changes = Changes::run_through) {
  return run(text_of(blocks, changes)).summary.time_s;
}

std::string within(double tolerance) {
  return "G64" + word('P', tolerance, 6) + '\n';
}

/// Lines of a quarter of a millimetre to a whole one that turn little, each with the next of these tolerances.
std::vector<Block> short_lines(int count, double most_turn, const std::vector<double>& tolerances) {
  std::mt19937 random(1);
  const auto uniform = [&](double low, double high) { return low + (high - low) * random() / 4294967296.0; };
  std::vector<Block> blocks;
  double x = 0, y = 0, angle = 0;
  for (int k = 0; k < count; ++k) {
    angle += uniform(-most_turn, most_turn);
    const double length = uniform(0.25, 1);
    x += length * std::cos(angle);
    y += length * std::sin(angle);
    blocks.push_back({within(tolerances[static_cast<std::size_t>(k) % tolerances.size()]),
                      "G1" + word('X', x, 4) + word('Y', y, 4) + '\n'});
  }
  return blocks;
}

TEST(BlendedTolerances, TakeNoLongerByTurnsThanTheLeastAllAlong) {
  for (const double turn : {0.1, 0.4}) {
    for (const auto& [least, greater] : {std::pair{0.01, 0.02}, {0.01, 0.5}, {0.001, 0.5}}) {
      const Outcome outcome = run(text_of(short_lines(400, turn, {greater, least}), Changes::run_through));
      EXPECT_TRUE(keeps_promises(outcome)) << turn << ' ' << least << ' ' << greater;
      const double lesser = time_of(short_lines(400, turn, {least}));
      EXPECT_LE(outcome.summary.time_s, 1.005 * lesser) << turn << ' ' << least << ' ' << greater;
    }
  }
}

TEST(BlendedTolerances, RunThroughAChangeOfQ) {
  std::vector<Block> blocks = short_lines(100, 0.1, {0.01}), lesser = blocks;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    lesser[k].mode = "G64 P0.01 Q0.005\n";
    if (k % 2 > 0) blocks[k].mode = lesser[k].mode;
  }
  const Outcome outcome = run(text_of(blocks, Changes::run_through));
  EXPECT_TRUE(keeps_promises(outcome));
  EXPECT_LE(outcome.summary.time_s, 1.01 * time_of(lesser));
  EXPECT_GE(outcome.summary.time_s, time_of(short_lines(100, 0.1, {0.01})));
}

TEST(BlendedTolerances, GoOnThroughAStraightLine) {
  const std::vector<Block> blocks = {{within(0.01), "G1 X30\n"}, {within(0.1), "X60\n"}, {within(0.001), "X100\n"}};
  EXPECT_EQ(run(text_of(blocks, Changes::run_through)).summary.time_s,
            run("G21 G90 F6000 G64\nG1 X100\n").summary.time_s);
}

TEST(BlendedTolerances, CutACornerByTheLesserOfItsTwoBlocks) {
  const auto corner = [](double before, double behind) {
    return std::vector<Block>{{within(before), "G1 X10\n"}, {within(behind), "Y10\n"}};
  };
  const double lesser = time_of(corner(0.01, 0.01));
  for (const auto& [before, behind] : {std::pair{0.01, 0.1}, std::pair{0.1, 0.01}}) {
    const Outcome outcome = run(text_of(corner(before, behind), Changes::run_through));
    EXPECT_TRUE(keeps_promises(outcome));
    EXPECT_EQ(outcome.summary.time_s, lesser);
    EXPECT_GT(outcome.verdict.deviation_mm, 0.009);
    EXPECT_LE(outcome.verdict.deviation_mm, 0.01);
  }
}

/// A corner takes what its own blocks allow, whatever is asked for elsewhere.
TEST(BlendedTolerances, CutEachCornerByItsOwn) {
  const std::string corners = "G1 X10\nY10\nX0\nY0\n";
  const auto both = [&](const std::string& first, const std::string& second) {
    return time_of({{within(0.05), first}, {within(0.001), second}});
  };
  const double wide = time_of({{within(0.05), corners + "X20\n"}});
  const double mixed = both(corners + "X10\n", "X20\n");
  EXPECT_LE(mixed, wide + 0.001);
}

TEST(BlendedTolerances, StopForAnExactPathAsBefore) {
  const std::string lines = "G1 X1 Y0.05\nX2 Y0.15\nX3 Y0.3\n";
  for (const std::string exact : {"G61\n", "G61.1\n"}) {
    const std::string text = head + lines + exact + "X4 Y0.5\nX5 Y0.75\nG64 P0.1\nX6 Y1.05\nX7 Y1.4\n";
    const Outcome outcome = run(text);
    EXPECT_TRUE(keeps_promises(outcome));
    const double dwelling =
        run(head + lines + "G4 P0\n" + exact + "X4 Y0.5\nG4 P0\nX5 Y0.75\nG4 P0\nG64 P0.1\nX6 Y1.05\nX7 Y1.4\n")
            .summary.time_s;
    EXPECT_NEAR(outcome.summary.time_s, dwelling, 0.0011);
  }
}

void expect_no_slower_than_with_stops(const std::vector<Block>& blocks) {
  const std::string text = text_of(blocks, Changes::run_through);
  EXPECT_TRUE(keeps_promises(run(text)));
  EXPECT_LE(time_of(blocks), time_of(blocks, Changes::stop) + 0.001);
}

/// Beside a vertex that a spline has to come close to, it could not bend as little as the wide tolerance allows.
TEST(BlendedTolerances, AreNotHeldToANarrowNeighbours) {
  const std::string narrow = within(0.001), wide = within(0.5);
  expect_no_slower_than_with_stops({{narrow, "G1 X-17.3 Y-3.8\nX-29.5 Y-10.4\nX-52.3 Y-10.8\nX-57.9 Y-10.5\n"},
                                    {wide, "X-61 Y-16.5\nX-58.2 Y-18.3\nX-54.2\nX-50.850534 Y-18.223394\n"},
                                    {wide, "G2 X-21.137587 Y-58.253561 I9.246041 J-24.179504\nG1 X-27 Y-64.2\n"},
                                    {narrow, "X-31.5 Y-66.4\nX-34.575484 Y-63.309814\n"},
                                    {wide, "G2 X-50.482811 Y-46.053081 I8.399657 J23.702923\nG1 X-56.7 Y-38.3\n"},
                                    {narrow, "X-78.2 Y-30.2\n"},
                                    {wide, "X-80.5 Y-27.5\nX-78.9 Y-22.3\nX-72.7 Y-8.9\nX-74 Y4.5\nX-76.3 Y10.6\n"}});
}

/// What Q does not hold, a blend, gets through where a narrow fit ends.
TEST(BlendedTolerances, BlendWhereANarrowFitBegins) {
  const std::string wide = within(0.5);
  expect_no_slower_than_with_stops(
      {{wide, "G1 Y-24.07\nX-0.075 Y-24.116\n"},
       {within(0.001), "X-0.523 Y-24.314\nX-0.59 Y-24.341\nX-0.602 Y-24.346\n"},
       {wide, "X-7.113 Y-28.005\n"},
       {"G64 P0.5 Q0.002645\n", "X-7.156 Y-28.037\nX-8.314 Y-29.092\nX-8.347 Y-29.123\n"}});
}

/// Tolerances that are alike, or as different as can be; now and then one of the naive CAM.
std::string random_mode(bool extreme) {
  std::string mode = "G64" + word('P', extreme ? *rc::gen::element(0.001, 0.5) : logarithmic(1e-3, 0.5), 6);
  if (any(0, 5) == 0) mode += word('Q', any(0, 3) == 0 ? 0 : logarithmic(1e-3, 0.5), 6);
  return mode + '\n';
}

/// An arc from a place, about a centre that it names.
std::string random_arc(double& x, double& y, double& angle, double size) {
  const double side = any(0, 2) == 0 ? 1 : -1, radius = size * logarithmic(1, 10), sweep = any(50, 3000) / 1000.0;
  const double i = -side * radius * std::sin(angle), j = side * radius * std::cos(angle);
  const double from = std::atan2(-j, -i), to = from + side * sweep;
  x += i + radius * std::cos(to);
  y += j + radius * std::sin(to);
  angle += side * sweep;
  return (side > 0 ? "G3" : "G2") + word('X', x, 6) + word('Y', y, 6) + word('I', i, 6) + word('J', j, 6) + '\n';
}

/// Lines that turn a little, and sometimes much, and arcs, the mode changing every so many blocks.
std::vector<Block> random_blocks() {
  const bool extreme = any(0, 2) == 0, alike = any(0, 2) == 0;
  const int seldom = *rc::gen::element(1, 1, 3, 8), arcs = *rc::gen::element(4, 15);
  const double usual = logarithmic(0.03, 10), bend = logarithmic(0.01, 0.6);
  double x = 0, y = 0, angle = any(0, 6283) / 1000.0;
  std::string mode = random_mode(extreme);
  std::vector<Block> blocks;
  for (int k = any(2, 40); k > 0; --k) {
    if (any(0, seldom) == 0) mode = random_mode(extreme);
    const double length = alike ? usual * logarithmic(0.3, 3) : logarithmic(0.01, 50);
    std::string move;
    if (any(0, arcs) == 0) {
      move = random_arc(x, y, angle, std::max(length, 0.05));
    } else {
      x += length * std::cos(angle);
      y += length * std::sin(angle);
      move = "G1" + word('X', x, 6) + word('Y', y, 6);
      if (any(0, 12) == 0) move += word('F', any(600, 12000), 0);
      move += '\n';
    }
    angle += (any(0, 8) == 0 ? 3.1 : bend) * any(-1000, 1001) / 1000.0;
    blocks.push_back({mode, move});
  }
  return blocks;
}

void keep_each_tolerance_and_lose_no_time() {
  const std::vector<Block> blocks = random_blocks();
  const std::string text = text_of(blocks, Changes::run_through);
  RC_LOG() << text;
  const Outcome outcome = run(text), coarse = run(text, {}, base::Period{10'000'000});
  RC_ASSERT(keeps_promises(outcome));
  RC_ASSERT(keeps_promises(coarse));
  RC_ASSERT(outcome.summary.time_s <= time_of(blocks, Changes::stop_exactly) + 0.002);
  RC_ASSERT(outcome.summary.time_s <= run_with_stops(text).summary.time_s + 0.001);
}

RC_GTEST_PROP(RandomTolerances, AreEachKeptAndNoSlowerThanWithStopsWhereTheyChange, ()) {
  keep_each_tolerance_and_lose_no_time();
}
RC_GTEST_PROP(LongRandomTolerances, AreEachKeptAndNoSlowerThanWithStopsWhereTheyChange, ()) {
  constexpr int programs = 2;  // a case
  for (int k = 0; k < programs; ++k) keep_each_tolerance_and_lose_no_time();
}

}  // namespace test_blended_tolerances
