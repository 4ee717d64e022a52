#include <gtest/gtest.h>

#include <leadscrew/realtime/schedule.hpp>
#include <leadscrew/realtime/waiting_sink.hpp>

#include "live.hpp"

namespace test_waiting_sink {

using namespace leadscrew;
using testing_support::Live;
using testing_support::words_of;

const std::string part = "G21 G90 G94\nG1 X20 F3000\nG1 Y10\nG1 X0 Y0\nM2\n";

/// A disk that stands still for a while does not keep words from being on time.
TEST(WaitingSink, HandsOverEveryWordInOrderToOneThatWaits) {
  const machine::Machine machine = machine::mill3();
  std::vector<base::Word> words;
  realtime::WaitingSink sink([&](const base::Word& word) {
    if (words.size() % 300 == 100) realtime::sleep_until(realtime::now() + 200'000'000);
    words.push_back(word);
    return true;
  });
  Live live(part, machine, {}, {.period = machine.period, .look_ahead = 1}, sink.sink());
  live.runner().start();
  live.wait();
  sink.end();
  EXPECT_EQ(live.runner().counters().slips, 0);
  EXPECT_EQ(sink.taken(), live.runner().counters().words);
  EXPECT_FALSE(sink.is_refused());
  const std::vector<base::Word> expected = words_of(part, machine);
  ASSERT_GE(words.size(), expected.size());
  if (live.runner().counters().starvations == 0) {
    for (std::size_t k = 0; k < expected.size(); ++k) ASSERT_EQ(words[k].position, expected[k].position) << k;
  }
  for (std::size_t k = 0; k < words.size(); ++k) ASSERT_EQ(base::count(words[k].tick), static_cast<std::int64_t>(k));
  EXPECT_EQ(words.back().position, expected.back().position);
}

TEST(WaitingSink, HandsOverEventsBeforeTheirWords) {
  const machine::Machine machine = machine::mill3();
  std::string text = "G21 G90 G94 F3000\nG64 P0.05\n";
  for (int k = 0; k < 40; ++k) text += "G1 X" + std::to_string(k + 1) + " S" + std::to_string(k) + '\n';
  text += "M2\n";
  std::vector<double> speeds;
  std::int64_t words = 0;
  bool in_order = true;
  const auto take = [&](const base::Word& word) {
    if (words % 100 == 50) realtime::sleep_until(realtime::now() + 100'000'000);
    in_order = in_order && base::count(word.tick) == words++;
    return true;
  };
  const auto take_event = [&](const base::PassedEvent& event) {
    in_order = in_order && base::count(event.tick) == words;
    if (event.kind == base::Event::Kind::spindle_speed) speeds.push_back(event.value);
    return true;
  };
  realtime::WaitingSink sink(take, take_event);
  Live live(text, machine, {}, {.period = machine.period, .look_ahead = 1}, sink.sink());
  live.runner().start();
  live.wait();
  sink.end();
  EXPECT_TRUE(in_order);
  ASSERT_EQ(speeds.size(), 40u);
  for (std::size_t k = 0; k < speeds.size(); ++k) EXPECT_EQ(speeds[k], static_cast<double>(k));
}

TEST(WaitingSink, EndsMotionWhenNobodyTakesEvents) {
  const machine::Machine machine = machine::mill3();
  realtime::WaitingSink sink([](const base::Word&) { return true; },
                             [](const base::PassedEvent& event) { return event.value < 3; });
  const std::string text = "G21 G90 G94 F600\nG1 X1 S1\nX2 S2\nX3 S3\nX400\nM2\n";
  Live live(text, machine, {}, {.period = machine.period}, sink.sink());
  live.runner().start();
  live.wait();
  sink.end();
  EXPECT_TRUE(sink.is_refused());
  EXPECT_LT(live.runner().counters().words, 5000);
}

TEST(WaitingSink, EndsMotionWhenNobodyTakesWords) {
  const machine::Machine machine = machine::mill3();
  std::int64_t taken = 0;
  realtime::WaitingSink sink([&](const base::Word&) { return ++taken <= 100; });
  const std::string line = "G21 G90 G94\nG1 X400 F600\nM2\n";
  Live live(line, machine, {}, {.period = machine.period}, sink.sink());
  live.runner().start();
  live.wait();
  sink.end();
  EXPECT_TRUE(sink.is_refused());
  EXPECT_EQ(sink.taken(), 100);
  EXPECT_LT(live.runner().counters().words, 5000);
}

/// One that stands still until no more words can be kept, and then wants none.
TEST(WaitingSink, EndsMotionAlsoWhenItIsFull) {
  std::atomic<bool> stands_still{true};
  realtime::WaitingSink sink([&](const base::Word&) {
    while (stands_still.load()) realtime::sleep_until(realtime::now() + 1'000'000);
    return false;
  });
  const realtime::WordSink words = sink.sink();
  std::int64_t kept = 0;
  const auto fill = [&] {
    for (; words.take({.tick = base::Tick{kept}}); ++kept) ASSERT_TRUE(words.publish());
  };
  fill();
  // One that is being handed over has left its place.
  realtime::sleep_until(realtime::now() + 50'000'000);
  fill();
  EXPECT_GE(kept, 1 << 16);
  EXPECT_FALSE(words.take({}));
  stands_still.store(false);
  while (!sink.is_refused()) realtime::sleep_until(realtime::now() + 1'000'000);
  EXPECT_TRUE(words.take({}));
  EXPECT_FALSE(words.publish());
  sink.end();
  EXPECT_EQ(sink.taken(), 0);
}

}  // namespace test_waiting_sink
