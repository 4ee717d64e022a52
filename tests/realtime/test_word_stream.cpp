#include <gtest/gtest.h>

#include <leadscrew/realtime/word_stream.hpp>
#include <memory>
#include <random>
#include <thread>

namespace test_word_stream {

using namespace leadscrew;

base::Word word_at(double place) {
  base::Word word;
  word.position[0] = place;
  return word;
}

TEST(WordStream, ShowsWordsOnlyOncePublished) {
  realtime::WordStream<3, 2> stream;
  base::Word word;
  EXPECT_TRUE(stream.push(word_at(1)));
  EXPECT_TRUE(stream.push(word_at(2)));
  EXPECT_FALSE(stream.pop(word));
  EXPECT_EQ(stream.waiting(), 2U);
  EXPECT_TRUE(stream.publish());
  EXPECT_TRUE(stream.push(word_at(3)));
  EXPECT_FALSE(stream.push(word_at(4)));
  for (const double place : {1.0, 2.0}) {
    EXPECT_TRUE(stream.pop(word));
    EXPECT_EQ(word.position[0], place);
  }
  EXPECT_FALSE(stream.pop(word));
  EXPECT_TRUE(stream.push(word_at(4)));
}

/// Round and round in the room that is asked for, which may be less than there could be.
TEST(WordStream, HoldsAsManyWordsAsItHasRoomFor) {
  const auto stream = std::make_unique<realtime::WordStream<1 << 20, 1 << 20>>(3);
  base::Word word;
  for (int round = 0; round < 5; ++round) {
    for (const int k : {0, 1, 2}) EXPECT_TRUE(stream->push(word_at(10 * round + k)));
    EXPECT_FALSE(stream->push(word_at(-1)));
    EXPECT_TRUE(stream->publish());
    for (const int k : {0, 1, 2}) {
      EXPECT_TRUE(stream->pop(word));
      EXPECT_EQ(word.position[0], 10 * round + k);
    }
    EXPECT_FALSE(stream->pop(word));
  }
}

TEST(WordStream, LeadsToRestBehindTheLastPublishedWord) {
  realtime::WordStream<4, 2> stream;
  base::Word word;
  base::PathPlace place;
  EXPECT_TRUE(stream.push(word_at(1)));
  EXPECT_TRUE(stream.append_stop_position({{1.5}, 1.5}));
  EXPECT_TRUE(stream.append_stop_position({{1.6}, 1.6}));
  EXPECT_FALSE(stream.append_stop_position({{1.7}, 1.7}));
  EXPECT_TRUE(stream.publish());
  EXPECT_TRUE(stream.push(word_at(2)));
  EXPECT_TRUE(stream.append_stop_position({{2.5}, 2.5}));
  EXPECT_FALSE(stream.leave_if_empty());
  EXPECT_FALSE(stream.has_left());
  EXPECT_TRUE(stream.pop(word));
  EXPECT_TRUE(stream.leave_if_empty());
  EXPECT_TRUE(stream.has_left());
  EXPECT_FALSE(stream.publish());
  EXPECT_FALSE(stream.pop(word));
  for (const double at : {1.5, 1.6}) {
    EXPECT_TRUE(stream.follow_stop_path(place));
    EXPECT_EQ(place.position[0], at);
    EXPECT_EQ(place.path_length, at);
  }
  EXPECT_FALSE(stream.follow_stop_path(place));
}

TEST(WordStream, WhatWasPublishedIsTakenAfterLeaving) {
  realtime::WordStream<4, 2> stream;
  base::Word word;
  base::PathPlace place;
  EXPECT_TRUE(stream.push(word_at(1)));
  EXPECT_TRUE(stream.append_stop_position({{1.5}, 1.5}));
  EXPECT_TRUE(stream.publish());
  stream.leave();
  EXPECT_TRUE(stream.push(word_at(2)));
  EXPECT_FALSE(stream.publish());
  EXPECT_TRUE(stream.pop(word));
  EXPECT_FALSE(stream.pop(word));
  EXPECT_TRUE(stream.follow_stop_path(place));
  EXPECT_EQ(place.position[0], 1.5);
}

/// Word n is at n; the stop path behind it goes n + 0.25, n + 0.5, …: whenever the drives leave, they follow the one
/// that belongs to the last word they took, and the maker knows how far it came.
TEST(WordStream, TwoThreadsAgreeOnWhereTheDrivesLeft) {
  std::minstd_rand random(7);
  int left_in_the_middle = 0;
  for (int round = 0; round < 400; ++round) {
    auto stream = std::make_unique<realtime::WordStream<16, 3>>();
    constexpr int most = 1000;
    int published = 0;
    std::thread maker([&] {
      for (int number = 1; number <= most;) {
        if (!stream->push(word_at(number))) {
          if (stream->has_left()) return;
          std::this_thread::yield();
          continue;
        }
        for (int part = 1; part <= 3 && number % 3 == 0; ++part) {
          ASSERT_TRUE(stream->append_stop_position({{number + part / 4.0}, number + part / 4.0}));
        }
        if (number % 3 == 0) {
          if (!stream->publish()) return;
          published = number;
        }
        ++number;
      }
    });
    const auto patience = random() % 300;
    double last = 0;
    base::Word word;
    for (unsigned tries = 0;;) {
      if (stream->pop(word)) {
        ASSERT_EQ(word.position[0], last + 1);
        last = word.position[0];
      } else if (++tries > patience && stream->leave_if_empty()) {
        break;
      } else {
        std::this_thread::yield();
      }
    }
    maker.join();
    EXPECT_EQ(last, published);
    base::PathPlace place;
    for (int part = 1; part <= 3 && last > 0; ++part) {
      ASSERT_TRUE(stream->follow_stop_path(place));
      ASSERT_EQ(place.position[0], last + part / 4.0);
    }
    EXPECT_FALSE(stream->follow_stop_path(place));
    left_in_the_middle += last > 0 && last < most - 1;
  }
  EXPECT_GT(left_in_the_middle, 0);
}

}  // namespace test_word_stream
