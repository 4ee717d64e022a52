#include <gtest/gtest.h>

#include <algorithm>
#include <allocations.hpp>
#include <bit>
#include <random>
#include <utility>

#include "live.hpp"

namespace test_runner {

using namespace leadscrew;
using testing_support::as_drive;
using testing_support::Drives;
using testing_support::judge;
using testing_support::Live;
using testing_support::words_of;

const std::string part =
    "G21 G90 G94 G17 F6000\nG64 P0.05\nG1 X20\nG1 Y10\nG2 X40 Y-10 I20 J0\nG1 X60 Y5\nG4 P0.05\nG61\nG1 X90\nG3 X90 "
    "Y25 I0 J10\nG0 X0 Y0\nM2\n";

machine::Machine mill(std::int64_t nanoseconds) {
  machine::Machine machine = machine::mill3();
  machine.period = {nanoseconds};
  return machine;
}

bool has_same_bits(const base::Word& a, const base::Word& b) {
  return std::bit_cast<std::array<std::uint64_t, base::axis_count>>(a.position) ==
             std::bit_cast<std::array<std::uint64_t, base::axis_count>>(b.position) &&
         a.tick == b.tick && a.line == b.line && a.state == b.state && a.speed == b.speed && a.feed == b.feed &&
         a.path_length == b.path_length;
}

void expect_kept(const referee::Verdict& verdict) {
  EXPECT_FALSE(verdict.objects()) << verdict.violations.front().what << " " << verdict.violations.front().value;
  EXPECT_EQ(verdict.start_error_mm, 0);
  EXPECT_LE(verdict.end_error_mm, 1e-9);
}

TEST(Runner, MakesTheWordsOfRunBitForBit) {
  const machine::Machine machine = mill(1'000'000);
  const std::vector<base::Word> expected = words_of(part, machine);
  Live live(part, machine, {}, 1.0);
  live.runner().start();
  live.wait();
  const realtime::Counters counters = live.runner().counters();
  EXPECT_EQ(counters.words, static_cast<std::int64_t>(live.words.size()));
  EXPECT_EQ(live.runner().latencies().count() > 0, true);
  // On a computer that stands still for a second the planner may be late; then words are others, but as good.
  if (counters.starvations > 0) return expect_kept(judge(part, machine, live.words));
  ASSERT_GE(live.words.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) ASSERT_TRUE(has_same_bits(live.words[k], expected[k])) << k;
  for (std::size_t k = expected.size(); k < live.words.size(); ++k) {
    ASSERT_EQ(live.words[k].position, expected.back().position);
  }
}

/// Whether the planner is late or not: each once, in order, with the word that passes its place.
TEST(Runner, GivesEventsWithTheirWords) {
  const machine::Machine machine = mill(1'000'000);
  std::string text = "G21 G90 G94 G17 F6000\nG64 P0.05\nG1 X20 S0\n";
  for (int k = 1; k < 60; ++k)
    text += "M8\nG1 X" + std::to_string(20 + k) + " Y" + std::to_string(k % 3) + " S" + std::to_string(k) + '\n';
  text += "M5\nG1 X0\nM2\n";
  for (const bool is_late : {false, true}) {
    std::minstd_rand random(7);
    const auto late = [&] {
      if (is_late && random() % 8 == 0) realtime::sleep_until(realtime::now() + 150'000'000);
    };
    Live live(text, machine, late, is_late ? 0.05 : 1.0);
    live.events.reserve(1000);
    live.runner().start();
    live.wait();
    EXPECT_TRUE(!is_late || live.runner().counters().starvations > 0);
    std::vector<double> speeds;
    for (const base::PassedEvent& event : live.events) {
      const auto tick = static_cast<std::size_t>(base::count(event.tick));
      ASSERT_LT(tick, live.words.size());
      EXPECT_GE(live.words[tick].path_length, event.path_length - 1e-9);
      EXPECT_LE(live.words[tick == 0 ? 0 : tick - 1].path_length, event.path_length + 1e-9);
      if (event.kind == base::Event::Kind::spindle_speed) speeds.push_back(event.value);
    }
    ASSERT_EQ(live.events.size(), 60u + 59 + 2);
    ASSERT_EQ(speeds.size(), 60u);
    for (std::size_t k = 0; k < speeds.size(); ++k) EXPECT_EQ(speeds[k], static_cast<double>(k));
    EXPECT_EQ(live.events.back().kind, base::Event::Kind::program_end);
  }
}

/// One that has no room is given the event again, and its word behind it.
TEST(Runner, GivesAnEventAgainThatTheSinkHasNoRoomFor) {
  const machine::Machine machine = mill(1'000'000);
  std::vector<std::string> given;
  int asked = 0;
  const auto take_event = [&](const base::PassedEvent& event) {
    if (++asked % 3 != 0) return false;
    given.push_back(std::string(base::code_of(event)) + std::to_string(base::count(event.tick)));
    return true;
  };
  std::int64_t words = 0;
  bool behind = true;
  const auto take = [&](const base::Word& word) {
    behind = behind && base::count(word.tick) == words++ && asked % 3 == 0;
    return true;
  };
  const std::string text = "G21 G90 G94 F6000\nM8\nG1 X1 S5\nM9\nG1 X2\nM2\n";
  Live live(text, machine, {}, {.period = machine.period},
            realtime::WordSink{.take = take, .append_stop_position = {}, .publish = {}, .event = take_event});
  live.runner().start();
  live.wait();
  ASSERT_EQ(given.size(), 4u);
  EXPECT_TRUE(given[0].starts_with("M8") && given[1].starts_with("S") && given[2].starts_with("M9"));
  EXPECT_TRUE(given[3].starts_with("M2"));
  EXPECT_TRUE(behind);
  EXPECT_GT(live.runner().counters().slips, 0);
}

TEST(Runner, StopsOnThePathWhenThePlannerIsLateAndGoesOn) {
  const machine::Machine machine = mill(1'000'000);
  std::minstd_rand random(3);
  const auto late = [&] {
    if (random() % 16 == 0) realtime::sleep_until(realtime::now() + static_cast<std::int64_t>(random() % 300'000'000));
  };
  Live live(part, machine, late, 0.05);
  live.runner().start();
  live.wait();
  EXPECT_GT(live.runner().counters().starvations, 0);
  expect_kept(judge(part, machine, live.words));
}

/// As `leadscrew drive` runs: slices, each with its way to rest, to drives that take a word a period. The planner's
/// thread sleeps before one chunk of so many, for a random time up to this.
void expect_stops_and_goes_on(std::int64_t longest_sleep, unsigned one_of, unsigned seed) {
  const machine::Machine machine = mill(1'000'000);
  std::minstd_rand random(seed);
  const auto late = [&] {
    if (random() % one_of != 0) return;
    realtime::sleep_until(realtime::now() + std::uniform_int_distribution<std::int64_t>(0, longest_sleep)(random));
  };
  Drives drives(machine.period);
  Live live(part, machine, late, as_drive(machine), drives.sink());
  live.runner().start();
  live.wait();
  drives.end();
  const realtime::Counters counters = live.runner().counters();
  EXPECT_GT(counters.starvations, 0);
  EXPECT_GT(counters.late_chunks, 0);
  EXPECT_LE(counters.late_chunks, counters.starvations);
  for (std::size_t k = 0; k < drives.words.size(); ++k) {
    ASSERT_EQ(base::count(drives.words[k].tick), static_cast<std::int64_t>(k));
  }
  // No planner keeps words from being on time: made where there are none, and taken.
  EXPECT_TRUE(drives.stop_path.empty());
  EXPECT_EQ(counters.words, static_cast<std::int64_t>(drives.words.size()));
  expect_kept(judge(part, machine, drives.words));
}

TEST(Runner, BringsDrivesToRestOnThePathWhenThePlannerIsLateAndGoesOn) {
  expect_stops_and_goes_on(300'000'000, 16, 3);
}

TEST(LongRunner, BringsDrivesToRestOnThePathWhenThePlannerIsLateByUpToFiveSecondsAndGoesOn) {
  for (const unsigned seed : {5U, 6U, 7U}) expect_stops_and_goes_on(5'000'000'000, 16, seed);
}

TEST(Runner, HoldsGoesOnAndStops) {
  const machine::Machine machine = mill(1'000'000);
  const std::string line = "G21 G90 G94\nG1 X400 F3000\nM2\n";
  Live live(line, machine, {}, 0.1);
  const auto wait_for_words = [&](std::int64_t count) {
    while (live.runner().counters().words < count) realtime::sleep_until(realtime::now() + 1'000'000);
  };
  live.runner().start();
  wait_for_words(300);
  live.runner().override_feed(0);
  wait_for_words(1500);
  live.runner().override_feed(0.5);
  wait_for_words(2500);
  live.runner().stop();
  live.wait();
  const auto rests = std::count_if(live.words.begin() + 1, live.words.end() - 1,
                                   [](const base::Word& word) { return word.speed == 0; });
  EXPECT_GT(rests, 100);
  EXPECT_EQ(live.words.back().speed, 0);
  EXPECT_LT(live.words.back().position[0], 300);
  // The part of the line that was travelled, judged as a program of its own.
  char travelled[80];
  std::snprintf(travelled, sizeof travelled, "G21 G90 G94\nG1 X%.12f F3000\nM2\n", live.words.back().position[0]);
  EXPECT_FALSE(judge(travelled, machine, live.words).objects());
}

/// What a thread sleeps through is counted, and made up for.
TEST(Runner, CountsThePeriodsThatItSleptThrough) {
  const machine::Machine machine = mill(1'000'000);
  const machine::ToolTable tools;
  pipeline::MotionSource source(gcode::text_source(part), machine, tools, {}, nullptr);
  source.planner().slice(0.02);
  std::vector<base::Word> words;
  words.reserve(100'000);
  realtime::Runner runner({.period = machine.period, .look_ahead = 1},
                          {.next = [&] { return source.next(); },
                           .refuse = [&] { source.planner().refuse(); },
                           .override_feed = [&](double factor) { source.planner().override_feed(factor); }},
                          {.take =
                               [&](const base::Word& word) {
                                 words.push_back(word);
                                 if (words.size() == 100 || words.size() == 300)
                                   realtime::sleep_until(realtime::now() + 40'000'000);
                                 return true;
                               },
                           .append_stop_position = {},
                           .publish = {}});
  runner.start();
  while (!runner.has_ended()) realtime::sleep_until(realtime::now() + 1'000'000);
  EXPECT_GE(runner.counters().overruns, 2 * 38);
  EXPECT_GE(runner.latencies().longest(), 30'000'000);
  const std::vector<base::Word> expected = words_of(part, machine);
  for (std::size_t k = 0; k < words.size(); ++k) ASSERT_EQ(base::count(words[k].tick), static_cast<std::int64_t>(k));
  EXPECT_EQ(words.back().position, expected.back().position);
}

TEST(Runner, StopsInADwell) {
  const machine::Machine machine = mill(1'000'000);
  const std::string text = "G21 G90 G94\nG1 X5 F6000\nG4 P20\nG1 X10\nM2\n";
  Live live(text, machine, {}, 0.1);
  live.runner().start();
  while (live.runner().counters().words < 1000) realtime::sleep_until(realtime::now() + 1'000'000);
  live.runner().stop();
  live.wait();
  EXPECT_LT(live.words.size(), 5000U);
  EXPECT_EQ(live.words.back().position[0], 5);
}

/// From the first word to the last, with slices, ways to rest and stops because the planner was late.
TEST(Runner, TakesNoMemoryForAWord) {
  const machine::Machine machine = mill(1'000'000);
  std::minstd_rand random(3);
  const auto late = [&] {
    if (random() % 16 == 0) realtime::sleep_until(realtime::now() + static_cast<std::int64_t>(random() % 600'000'000));
  };
  const auto stream = std::make_unique<realtime::WordStream<4096, 4096>>();
  std::optional<std::int64_t> before;
  std::int64_t after = -1;
  Live live(part, machine, late, as_drive(machine),
            realtime::WordSink{.take =
                                   [&](const base::Word& word) {
                                     if (!before) before = testing_support::allocations_of_thread();
                                     return stream->push(word);
                                   },
                               .append_stop_position =
                                   [&](const base::PathPlace& place) { return stream->append_stop_position(place); },
                               .publish =
                                   [&] {
                                     const bool is_wanted = stream->publish();
                                     for (base::Word word; stream->pop(word);) {
                                     }
                                     after = testing_support::allocations_of_thread();
                                     return is_wanted;
                                   }});
  live.runner().start();
  live.wait();
  EXPECT_GT(live.runner().counters().starvations, 0);
  EXPECT_GT(live.runner().counters().words, 2000);
  EXPECT_EQ(before, after);
}

/// A sink that has no room gets the same word again: none is lost, none repeated.
TEST(Runner, LosesAndRepeatsNoWordWhenTheSinkIsFull) {
  const machine::Machine machine = mill(1'000'000);
  const std::vector<base::Word> expected = words_of(part, machine);
  const machine::ToolTable tools;
  pipeline::MotionSource source(gcode::text_source(part), machine, tools, {}, nullptr);
  source.planner().slice(0.02);
  std::vector<base::Word> words;
  words.reserve(100'000);
  std::minstd_rand random(11);
  realtime::Runner runner({.period = machine.period, .look_ahead = 1, .lead = 100},
                          {.next = [&] { return source.next(); },
                           .refuse = [&] { source.planner().refuse(); },
                           .override_feed = [&](double factor) { source.planner().override_feed(factor); }},
                          {.take =
                               [&](const base::Word& word) {
                                 if (random() % 8 == 0) return false;
                                 words.push_back(word);
                                 return true;
                               },
                           .append_stop_position = {},
                           .publish = {}});
  runner.start();
  while (!runner.has_ended()) realtime::sleep_until(realtime::now() + 1'000'000);
  EXPECT_GT(runner.counters().slips, 0);
  for (std::size_t k = 0; k < words.size(); ++k) ASSERT_EQ(base::count(words[k].tick), static_cast<std::int64_t>(k));
  EXPECT_EQ(words.back().position, expected.back().position);
}

}  // namespace test_runner
