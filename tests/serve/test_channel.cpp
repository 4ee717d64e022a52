// Events for viewers that come, lag and go: each gets what it has not seen, in order, or is told how much it has missed.

#include <gtest/gtest.h>

#include <leadscrew/serve/channel.hpp>
#include <thread>

namespace leadscrew::serve {
namespace test_channel {

using namespace std::chrono_literals;

std::vector<std::string> texts_of(const Channel::Taken& taken) {
  std::vector<std::string> texts;
  for (const auto& event : taken.events) texts.push_back(*event);
  return texts;
}

using Texts = std::vector<std::string>;

TEST(Channel, GivesEachViewerWhatItHasNotSeen) {
  Channel channel(4);
  Channel::Place early = channel.latest();
  channel.publish("a");
  channel.publish("b");
  Channel::Place late = channel.latest();
  EXPECT_EQ(texts_of(channel.take(early, 0ms)), (Texts{"a", "b"}));
  EXPECT_EQ(texts_of(channel.take(late, 0ms)), (Texts{"b"}));
  channel.publish("c");
  EXPECT_EQ(texts_of(channel.take(early, 0ms)), (Texts{"c"}));
  EXPECT_EQ(texts_of(channel.take(early, 0ms)), (Texts{}));
}

TEST(Channel, TellsHowManyEventsAViewerHasMissed) {
  Channel channel(3);
  Channel::Place place = channel.latest();
  for (int number = 0; number < 10; ++number) channel.publish(std::to_string(number));
  const Channel::Taken taken = channel.take(place, 0ms);
  EXPECT_EQ(taken.missed, 7);
  EXPECT_EQ(texts_of(taken), (Texts{"7", "8", "9"}));
  channel.publish("10");
  EXPECT_EQ(channel.take(place, 0ms).missed, 0);
}

TEST(Channel, EndsWithItsLastEvents) {
  Channel channel(3);
  Channel::Place place = channel.latest();
  channel.publish("last");
  channel.close();
  channel.publish("ignored");
  const Channel::Taken taken = channel.take(place, 1h);
  EXPECT_EQ(texts_of(taken), (Texts{"last"}));
  EXPECT_TRUE(taken.is_over);
  EXPECT_TRUE(channel.take(place, 1h).is_over);
}

/// Every event is seen once or told as missed, whoever is faster.
TEST(Channel, LosesNoCountBetweenThreads) {
  constexpr int count = 20'000;
  Channel channel(16);
  std::vector<std::jthread> viewers;
  std::vector<std::int64_t> counted(4), disordered(4);
  for (std::size_t i = 0; i < counted.size(); ++i) {
    viewers.emplace_back([&, i, place = Channel::Place{}]() mutable {
      std::int64_t last = -1;
      for (bool is_over = false; !is_over;) {
        const Channel::Taken taken = channel.take(place, 1s);
        counted[i] += taken.missed + static_cast<std::int64_t>(taken.events.size());
        for (const auto& event : taken.events) {
          disordered[i] += std::stoll(*event) <= last ? 1 : 0;
          last = std::stoll(*event);
        }
        is_over = taken.is_over;
      }
    });
  }
  for (int number = 0; number < count; ++number) channel.publish(std::to_string(number));
  channel.close();
  viewers.clear();
  EXPECT_EQ(counted, (std::vector<std::int64_t>(4, count)));
  EXPECT_EQ(disordered, (std::vector<std::int64_t>(4, 0)));
}

}  // namespace test_channel
}  // namespace leadscrew::serve
