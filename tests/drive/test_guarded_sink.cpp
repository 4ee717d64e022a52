// Words that no motion of the machine can make never reach the drives.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/drive/guarded_sink.hpp>
#include <limits>
#include <memory>

namespace leadscrew::drive {
namespace test_guarded_sink {

constexpr double T = 1e-3, acceleration = 1000;  // s; mm/s², of the built-in mill

base::Word word_at(double x) {
  base::Word word;
  word.position[0] = x;
  word.state = base::MotionState::changing;
  return word;
}

/// Along X from rest with all the acceleration there is, so many periods.
double risen(int periods) {
  return acceleration * T * T * periods * (periods + 1) / 2;
}

/// A link into which 20 words were published that rise along X, and the sink behind it.
class RisingWords {
 public:
  RisingWords() {
    for (int k = 1; k <= 20; ++k) EXPECT_TRUE(sink_.take(word_at(risen(k))));
    lead_to_rest();
    EXPECT_TRUE(sink_.publish());
  }

  /// A slice of this one word.
  bool publishes(const base::Word& word) {
    EXPECT_TRUE(sink_.take(word));
    lead_to_rest();
    return sink_.publish();
  }
  Link& link() { return *link_; }
  const GuardedSink& guarded() const { return guarded_; }

 private:
  /// To rest with the same acceleration.
  void lead_to_rest() {
    for (int k = 1; k <= 20; ++k) {
      base::PathPlace place;
      place.position[0] = risen(20) + risen(19) - risen(std::max(19 - k, 0));
      EXPECT_TRUE(sink_.append_stop_position(place));
    }
  }

  machine::Machine machine_ = machine::mill3();
  std::unique_ptr<Link> link_ = std::make_unique<Link>();
  GuardedSink guarded_{*link_, machine_, {}, 1000};
  realtime::WordSink sink_ = guarded_.sink();
};

TEST(GuardedSink, PassesMotionAtTheLimits) {
  RisingWords words;
  EXPECT_FALSE(words.guarded().has_refused());
  EXPECT_FALSE(words.guarded().problem().has_value());
  base::Word word;
  for (int k = 1; k <= 20; ++k) {
    ASSERT_TRUE(words.link().words.pop(word));
    EXPECT_EQ(word.position[0], risen(k));
  }
}

/// Drives find the words before it and the stop path behind those.
TEST(GuardedSink, KeepsAWordBackThatNoAxisCanFollow) {
  for (const double x : {9998.998, risen(20) + 0.3, risen(20) + 0.0175, risen(20) + 0.022, risen(19), -9999.0,
                         std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    RisingWords words;
    EXPECT_FALSE(words.publishes(word_at(x))) << x;
    EXPECT_TRUE(words.guarded().has_refused());
    ASSERT_TRUE(words.guarded().problem().has_value());
    EXPECT_EQ(words.guarded().problem()->code, "word-refused");
    base::Word word;
    for (int k = 1; k <= 20; ++k) ASSERT_TRUE(words.link().words.pop(word));
    EXPECT_FALSE(words.link().words.pop(word)) << x;
    EXPECT_TRUE(words.link().words.leave_if_empty());
    base::PathPlace place;
    int periods = 0;
    while (words.link().words.follow_stop_path(place)) ++periods;
    EXPECT_EQ(periods, 20);
    EXPECT_NEAR(place.position[0], risen(20) + risen(19), 1e-12);
  }
}

TEST(GuardedSink, KeepsAWordBackThatLeadsAnAxisThatIsNotThere) {
  RisingWords words;
  base::Word word = word_at(risen(21));
  word.position[base::index(base::Axis::A)] = 1;
  EXPECT_FALSE(words.publishes(word));
}

TEST(GuardedSink, KeepsASliceBackWhoseWayToRestLeavesTheTravel) {
  const machine::Machine machine = machine::mill3();
  const auto link = std::make_unique<Link>();
  base::AxisVector near_the_end{};
  near_the_end[0] = machine.limits(base::Axis::X).travel_max - 1e-4;
  GuardedSink guarded(*link, machine, near_the_end, 1000);
  const realtime::WordSink sink = guarded.sink();
  EXPECT_TRUE(sink.take(word_at(near_the_end[0] + 1e-3)));
  EXPECT_TRUE(sink.append_stop_position({word_at(near_the_end[0] + 2e-3).position, 2e-3}));
  EXPECT_FALSE(sink.publish());
}

TEST(GuardedSink, HasRoomForSoManyWords) {
  const machine::Machine machine = machine::mill3();
  const auto link = std::make_unique<Link>();
  GuardedSink guarded(*link, machine, {}, 2);
  const realtime::WordSink sink = guarded.sink();
  EXPECT_TRUE(sink.take(word_at(0)));
  EXPECT_TRUE(sink.take(word_at(0)));
  EXPECT_FALSE(sink.take(word_at(0)));
}

}  // namespace test_guarded_sink
}  // namespace leadscrew::drive
