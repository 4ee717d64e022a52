#include <algorithm>
#include <cmath>

#include "paths.hpp"

// What a host asks of the feed, as far as the program allows it (LinuxCNC manual, M48 to M53).

namespace test_overrides {

using namespace leadscrew;
using namespace leadscrew::host_tests;

/// Of the word nearest to X, mm/s.
double feed_at(const std::vector<base::Word>& words, double x) {
  return std::ranges::min_element(words, {}, [x](const base::Word& word) { return std::abs(word.position[0] - x); })
      ->feed;
}

constexpr const char* through_m49 = "G21 G90 G61 F3000\nG1 X100\nM49\nX200\nM48\nX300\nM2\n";

TEST(HostOverrides, AreNotObeyedBehindM49AndComeBack) {
  for (const double factor : {0.5, 2.0}) {
    const auto motion = program(through_m49);
    ASSERT_TRUE(motion->override_feed(factor));
    const auto words = words_of(*motion);
    EXPECT_NEAR(feed_at(words, 50), 50 * factor, 0.01);
    EXPECT_NEAR(feed_at(words, 150), 50, 0.01);
    EXPECT_NEAR(feed_at(words, 250), 50 * factor, 0.01);
    EXPECT_EQ(words.back().position[0], 300);
  }
}

/// Not before the place, and within a slice and the time of a word behind it.
TEST(HostOverrides, ChangeAtTheirPlace) {
  host::MotionOptions options;
  std::optional<base::PassedEvent> passed;
  options.on_event = [&](const base::PassedEvent& event) {
    if (base::code_of(event) == "M49") passed = event;
  };
  const auto motion = program(through_m49, options);
  ASSERT_TRUE(motion->override_feed(0.5));
  const auto words = words_of(*motion);
  ASSERT_TRUE(passed);
  const auto begin = std::ranges::find_if(words, [](const base::Word& word) { return word.feed > 25 + 1e-6; });
  ASSERT_NE(begin, words.end());
  EXPECT_GE(begin->tick, passed->tick);
  EXPECT_LE(base::count(begin->tick) - base::count(passed->tick), 60);
}

TEST(HostOverrides, RememberWhatWasAskedMeanwhile) {
  const auto motion = program(through_m49);
  std::vector<base::Word> words(1), all;
  for (bool asked = false; motion->next(words) > 0;) {
    all.push_back(words[0]);
    if (!asked && words[0].position[0] > 120) {
      ASSERT_TRUE(motion->override_feed(0.2));
      asked = true;
    }
  }
  EXPECT_NEAR(feed_at(all, 50), 50, 0.01);
  EXPECT_NEAR(feed_at(all, 150), 50, 0.01);
  EXPECT_NEAR(feed_at(all, 250), 10, 0.01);
}

TEST(HostOverrides, OfOneKindBehindM50) {
  const auto motion = program("G21 G90 G61 F3000\nG1 X100\nM50 P0\nX200\nM50\nX300\nM51 P0\nX400\nM2\n");
  ASSERT_TRUE(motion->override_feed(0.5));
  const auto words = words_of(*motion);
  EXPECT_NEAR(feed_at(words, 150), 50, 0.01);
  EXPECT_NEAR(feed_at(words, 250), 25, 0.01);
  EXPECT_NEAR(feed_at(words, 350), 25, 0.01);
}

TEST(HostOverrides, HoldWhereM53AllowsIt) {
  const auto motion = program("G21 G90 G61 F3000\nG1 X100\nM53 P0\nX200\nM53\nX300\nM2\n");
  std::vector<base::Word> words(1);
  while (words[0].position[0] < 120 && motion->next(words) > 0) {
  }
  ASSERT_TRUE(motion->override_feed(0));
  base::Word last = words[0];
  for (; motion->next(words) > 0; last = words[0]) {
    if (words[0].position[0] < 200) {
      ASSERT_NEAR(words[0].feed, 50, 0.2);  // planned anew, a little slower
    }
  }
  EXPECT_EQ(motion->progress(), pipeline::Progress::held);
  EXPECT_GT(last.position[0], 200);
  EXPECT_LT(last.position[0], 220);
  ASSERT_TRUE(motion->override_feed(1));
  EXPECT_EQ(words_of(*motion).back().position[0], 300);
  EXPECT_EQ(motion->progress(), pipeline::Progress::ended);
}

TEST(HostOverrides, DoNotReadOnWhileTheyHold) {
  std::string text = "G21 G90 G61 F3000\n";
  for (int i = 0; i < 20'000; ++i) text += "G1 X" + std::to_string(i % 7) + " Y" + std::to_string(i % 11) + "\n";
  const auto motion = program(text + "M2\n");
  ASSERT_TRUE(motion->override_feed(0));
  std::vector<base::Word> words(100);
  for (int times = 0; times < 3; ++times) motion->next(words);
  EXPECT_EQ(motion->progress(), pipeline::Progress::held);
  EXPECT_LT(motion->summary().blocks, 100);
}

TEST(HostOverrides, AdaptWhereM52AsksForIt) {
  const auto motion = program("G21 G90 G61 F3000\nG1 X100\nM52\nX200\nM49\nX300\nM52 P0\nX400\nM2\n");
  ASSERT_TRUE(motion->override_feed(0.8));
  ASSERT_TRUE(motion->adapt_feed(0.5));
  const auto words = words_of(*motion);
  EXPECT_NEAR(feed_at(words, 50), 40, 0.01);
  EXPECT_NEAR(feed_at(words, 150), 20, 0.01);
  EXPECT_NEAR(feed_at(words, 250), 25, 0.01);
  EXPECT_NEAR(feed_at(words, 350), 50, 0.01);
  EXPECT_EQ(motion->adapt_feed(1.1).error().code, "override");
  EXPECT_EQ(motion->adapt_feed(-0.1).error().code, "override");
}

/// Each with no other feed than that of the thread, which ends where `z` is told; G84 and G74 behind their approach.
struct Synchronised {
  const char* name;
  const char* text;
  bool rests;  ///< before it; else what is asked counts until its place has been passed
  double end;  ///< Z where motion rests behind it
};
constexpr Synchronised synchronised[] = {
    {"G33", "G0 Z5\nS300 M3\nG33 Z-20 K1.5\nG0 X5\nM2\n", true, -20},
    {"G33.1", "G0 Z5\nS300 M3\nG33.1 Z-20 K1.5\nG0 X5\nM2\n", true, 5},
    {"G84", "G0 Z5\nS300 M3\nG98 G84 Z-20 R2 F450\nG0 X5\nM2\n", false, 5},
    {"G74", "G0 Z5\nS300 M4\nG98 G74 Z-20 R2 F450\nG0 X5\nM2\n", false, 5},
};

std::string of_thread(const Synchronised& each) {
  return std::string("G21 G90 G17 G61\n") + each.text;
}

std::vector<base::AxisVector> places(const std::vector<base::Word>& words) {
  std::vector<base::AxisVector> places;
  for (const base::Word& word : words) places.push_back(word.position);
  return places;
}

double feed_at_z(const std::vector<base::Word>& words, double z) {
  return std::ranges::min_element(words, {}, [z](const base::Word& word) { return std::abs(word.position[2] - z); })
      ->feed;
}

TEST(HostOverrides, DoNotTouchWhatGoesInStepWithTheSpindle) {
  for (const Synchronised& each : synchronised) {
    const auto plain = places(words_of(*program(of_thread(each))));
    for (const double factor : {0.5, 2.0}) {
      const auto motion = program(of_thread(each));
      ASSERT_TRUE(motion->override_feed(factor));
      const auto words = words_of(*motion);
      if (each.rests) {
        EXPECT_TRUE(places(words) == plain) << each.name;
      }
      EXPECT_NEAR(feed_at_z(words, -10), 7.5, 1e-6) << each.name;
    }
    const auto adapted = program("M52\n" + of_thread(each));
    ASSERT_TRUE(adapted->adapt_feed(0.5));
    const auto words = words_of(*adapted);
    if (each.rests) {
      EXPECT_TRUE(places(words) == plain) << each.name;
    }
    EXPECT_NEAR(feed_at_z(words, -10), 7.5, 1e-6) << each.name;
  }
}

/// Held anywhere in it, on its way in and back: the words are those without until it has ended.
TEST(HostOverrides, HoldBehindWhatGoesInStepWithTheSpindle) {
  for (const Synchronised& each : synchronised) {
    const auto plain = places(words_of(*program(of_thread(each))));
    const auto cuts = [&](const base::AxisVector& place) { return place[2] < -1 && place[2] > -20; };
    const auto begin = std::ranges::find_if(plain, cuts) - plain.begin();
    const auto end = std::ranges::find_if(plain.rbegin(), plain.rend(), cuts).base() - plain.begin();
    ASSERT_LT(begin, end);
    for (const int part : {0, 1, 2, 3, 4, 5}) {
      const auto at = static_cast<std::size_t>(begin + (end - begin) * part / 6);
      const auto motion = program(of_thread(each));
      std::vector<base::Word> first(at), words(1);
      ASSERT_EQ(motion->next(first), at);
      ASSERT_TRUE(motion->override_feed(0));
      auto all = places(first);
      while (motion->next(words) > 0) all.push_back(words[0].position);
      EXPECT_EQ(motion->progress(), pipeline::Progress::held) << each.name;
      const std::size_t same = std::size_t(std::ranges::mismatch(all, plain).in1 - all.begin());
      EXPECT_GE(std::ptrdiff_t(same), end) << each.name << " held at " << at;
      EXPECT_NEAR(all.back()[2], each.end, each.end > 0 ? 7 : 1e-9) << each.name;
      ASSERT_TRUE(motion->override_feed(1));
      EXPECT_EQ(words_of(*motion).back().position, plain.back()) << each.name;
    }
  }
}

TEST(HostOverrides, AbortAThreadAllTheSame) {
  const auto motion = program(of_thread(synchronised[0]));
  std::vector<base::Word> words(1);
  while (motion->next(words) > 0 && !(words[0].position[2] < 0)) {
  }
  motion->abort();
  const double rest = words_of(*motion).back().position[2];
  EXPECT_GT(rest, -19);
  EXPECT_LT(rest, 0);
}

/// What is held where a thread would begin stays so.
TEST(HostOverrides, KeepAThreadFromBeginning) {
  const auto motion = program("G21 G90 G61\nG4 P0.1\nS300 M3\nG33 Z-20 K1.5\nM2\n");
  ASSERT_TRUE(motion->override_feed(0));
  for (const base::Word& word : words_of(*motion)) ASSERT_EQ(word.position[2], 0);
  EXPECT_EQ(motion->progress(), pipeline::Progress::held);
  ASSERT_TRUE(motion->override_feed(1));
  EXPECT_EQ(words_of(*motion).back().position[2], -20);
}

/// What is held on the way to a tap comes to rest, though the tap's beginning may lie on the way there.
TEST(HostOverrides, HoldOnTheWayToATap) {
  for (const Synchronised& each : synchronised) {
    if (each.rests) continue;
    const auto plain = places(words_of(*program(of_thread(each))));
    for (const double above : {4.9, 4.0, 3.0, 2.5, 2.1}) {
      const auto motion = program(of_thread(each));
      std::vector<base::Word> words(1);
      do {
        ASSERT_EQ(motion->next(words), 1U);
      } while (!(words[0].position[2] < above && words[0].position[2] > 2));
      ASSERT_TRUE(motion->override_feed(0));
      double lowest = words[0].position[2];
      while (motion->next(words) > 0) lowest = std::min(lowest, words[0].position[2]);
      EXPECT_EQ(motion->progress(), pipeline::Progress::held) << each.name << " from " << above;
      EXPECT_GT(lowest, 0) << each.name << " from " << above;
      ASSERT_TRUE(motion->override_feed(1));
      EXPECT_EQ(words_of(*motion).back().position, plain.back()) << each.name;
    }
  }
}

}  // namespace test_overrides
