#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <leadscrew/host/move_queue.hpp>
#include <leadscrew/host/moves.hpp>
#include <leadscrew/realtime/feeder.hpp>
#include <leadscrew/realtime/move_runner.hpp>
#include <optional>
#include <thread>
#include <vector>

#include "live.hpp"

// Moves that are slow to come: in simulated time, where a word takes a period and planning none, and on time.

namespace test_drought {

using namespace leadscrew;
using testing_support::judge;

struct Coming {
  double time = 0;  ///< s
  gcode::Move move;
};

class SlowWriter {
 public:
  SlowWriter(std::vector<Coming> coming, bool ends) : coming_(std::move(coming)), ends_(ends) {
    source_.planner().slice(0.02);
  }

  /// Words until so many seconds have passed, or to the end.
  void run(double seconds) {
    while (time() < seconds) {
      take_in();
      feeder_.request(1, false);
      if (feeder_.step()) continue;
      words.push_back(controller_.next());
      const auto last = feeder_.last_chunk();
      if (last && controller_.begun() == *last && controller_.stands()) return;
    }
  }

  double time() const { return machine.period.seconds() * static_cast<double>(words.size()); }
  std::int64_t stop_tails() const { return controller_.starvations() + feeder_.late_chunks(); }

  const machine::Machine machine = machine::mill3();
  std::vector<base::Word> words;
  /// realtime::Planning::quiet_to_begin, enough_to_begin.
  void begin_by(double quiet, double enough) {
    planning_.quiet_to_begin = quiet;
    planning_.enough_to_begin = enough;
  }
  /// realtime::Planning::took; in simulated time planning takes none.
  void say_planning_takes(double seconds) {
    planning_.took = [seconds] { return seconds; };
  }
  double look_ahead() const { return feeder_.look_ahead(); }

 private:
  void take_in() {
    for (; next_ < coming_.size() && coming_[next_].time <= time(); ++next_) {
      EXPECT_TRUE(moves_.push(coming_[next_].move));
      last_came_ = coming_[next_].time;
      is_open_ = true;
    }
    if (ends_ && next_ == coming_.size()) moves_.finish();
  }
  std::optional<realtime::Drought> drought() const {
    if (!source_.wants_moves()) return std::nullopt;
    return realtime::Drought{is_open_, time() - last_came_};
  }
  void end_for_now() {
    moves_.end_for_now();
    is_open_ = false;
  }

  std::vector<Coming> coming_;
  const bool ends_;
  std::size_t next_ = 0;
  double last_came_ = 0;
  bool is_open_ = false;
  host::MoveQueue moves_{machine, {}};
  pipeline::MotionSource source_{[this](gcode::Move& move) { return moves_.give(move); }, machine, {}};
  interpolator::Controller controller_{machine.period, {}, 800};
  realtime::Planning planning_{.next = [this] { return source_.next(); },
                               .refuse = [this] { source_.planner().refuse(); },
                               .override_feed = [this](double to) { source_.planner().override_feed(to); },
                               .slice = [this](double seconds) { source_.planner().slice(seconds); },
                               .drought = [this] { return drought(); },
                               .end_for_now = [this] { end_for_now(); }};
  realtime::Feeder feeder_{planning_, controller_, 0.3, 0.02};
};

constexpr double feed = 50;  // mm/s

/// So many lines of 2.5 mm round and round, 0.05 s each, one every `interval` seconds from `begin` on, with their text.
struct Lines {
  std::vector<Coming> coming;
  std::string text = "G21 G90 G64 P0.01 F3000\n";

  Lines(int count, double interval, double begin = 0) { add(count, interval, begin); }
  void add(int count, double interval, double begin) {
    for (int i = 0; i < count; ++i, ++number) {
      const double angle = 0.1 * number, radius = 25;
      const base::AxisVector end = {radius * std::sin(angle), radius * (1 - std::cos(angle))};
      coming.push_back({begin + i * interval, host::line(end, feed)});
      text += "G1 X" + std::to_string(end[0]) + " Y" + std::to_string(end[1]) + "\n";
    }
  }
  int number = 1;
};

/// Where motion began, and where it came to rest: pairs of numbers of words.
std::vector<std::pair<std::size_t, std::size_t>> motions_of(const std::vector<base::Word>& words) {
  std::vector<std::pair<std::size_t, std::size_t>> motions;
  bool moved = false;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const bool moves = words[k].state != base::MotionState::rest;
    if (moves && !moved) motions.emplace_back(k, words.size());
    if (!moves && moved) motions.back().second = k;
    moved = moves;
  }
  return motions;
}

double distance(const base::Word& word, const gcode::Move& move) {
  return std::hypot(word.position[0] - move.end[0], word.position[1] - move.end[1]);
}

TEST(Drought, OfAWriterWhoKeepsUpIsNone) {
  // As fast as motion, once it has begun: 0.05 s for 0.05 s.
  Lines lines(60, 0, 0);
  lines.add(100, 0.045, 0.1);
  SlowWriter writer(lines.coming, true);
  writer.run(60);
  EXPECT_EQ(writer.stop_tails(), 0);
  ASSERT_EQ(motions_of(writer.words).size(), 1U);
  EXPECT_LT(distance(writer.words.back(), lines.coming.back().move), 1e-6);
  EXPECT_LT(writer.time(), 160 * 0.05 + 1);
}

TEST(Drought, BeginsWithTwoSecondsOfMotion) {
  Lines lines(200, 0.01);  // 0.05 s of motion every 0.01 s
  SlowWriter writer(lines.coming, true);
  writer.run(60);
  const auto motions = motions_of(writer.words);
  ASSERT_EQ(motions.size(), 1U);
  const double begin = 1e-3 * static_cast<double>(motions[0].first);
  EXPECT_GE(begin, 2.0 / 5);
  EXPECT_LE(begin, 0.7);  // what is planned is less than what is known
  EXPECT_EQ(writer.stop_tails(), 0);
}

TEST(Drought, BeginsByWhatItsPlanningSays) {
  Lines lines(200, 0.01);
  SlowWriter soon(lines.coming, true);
  soon.begin_by(0.1, 0.5);
  soon.run(60);
  const auto begin = static_cast<double>(motions_of(soon.words).at(0).first);
  EXPECT_GE(begin, 100);
  EXPECT_LE(begin, 300);
  SlowWriter patient({{0.05, host::line({100}, feed)}}, false);
  patient.begin_by(0.3, 2);
  patient.run(10);
  EXPECT_NEAR(static_cast<double>(motions_of(patient.words).at(0).first), 350, 3);
}

/// How far ahead it looks a tenth of a second behind the beginning of motion, s, of which 0.2 s were planned before.
double look_ahead_at_first(std::optional<double> took) {
  Lines lines(100, 0);
  SlowWriter writer(lines.coming, true);
  writer.begin_by(0.1, 0.2);
  if (took) writer.say_planning_takes(*took);
  writer.run(0.1);
  EXPECT_EQ(motions_of(writer.words).size(), 1U);
  const double found = writer.look_ahead();
  writer.run(60);
  EXPECT_EQ(writer.stop_tails(), 0);
  return found;
}

TEST(Drought, LooksAheadFromTheFirstByWhatPlanningTook) {
  EXPECT_EQ(look_ahead_at_first({}), 0.3);
  EXPECT_EQ(look_ahead_at_first(0.001), 0.02);
  EXPECT_NEAR(look_ahead_at_first(0.1), 0.16, 1e-12);
  EXPECT_EQ(look_ahead_at_first(1), 0.3);
}

TEST(Drought, OfOneMoveIsOverInATenthOfASecond) {
  SlowWriter writer({{0.05, host::line({100}, feed)}}, false);
  writer.run(10);
  const auto motions = motions_of(writer.words);
  ASSERT_EQ(motions.size(), 1U);
  EXPECT_NEAR(static_cast<double>(motions[0].first), 150, 3);
  EXPECT_EQ(writer.words.back().position[0], 100);
}

TEST(Drought, OnTheWayIsARestWhereTheMovesEnd) {
  // 3 s of motion, then nothing for 3 s after its end, then 1.5 s more.
  Lines lines(60, 0);
  lines.add(30, 0, 6);
  SlowWriter writer(lines.coming, true);
  writer.run(60);
  EXPECT_EQ(writer.stop_tails(), 0);
  const auto motions = motions_of(writer.words);
  ASSERT_EQ(motions.size(), 2U);
  EXPECT_LT(distance(writer.words[motions[0].second], lines.coming[59].move), 1e-9);
  EXPECT_NEAR(static_cast<double>(motions[1].first), 6000, 10);  // the end is known, so that it need not be waited for
  EXPECT_LT(distance(writer.words.back(), lines.coming.back().move), 1e-9);
  EXPECT_FALSE(judge(lines.text + "M2\n", writer.machine, writer.words).objects());
}

/// The next move comes when the others have nearly been planned to their end: motion goes on through it.
TEST(Drought, ThatEndsInTimeIsNotSeen) {
  Lines patient(60, 0);
  SlowWriter alone(patient.coming, false);
  alone.run(10);
  const double rests_at = 1e-3 * static_cast<double>(motions_of(alone.words).at(0).second);
  for (const double before : {1.0, 0.5, 0.4}) {
    Lines lines(60, 0);
    lines.add(60, 0, rests_at - before);
    SlowWriter writer(lines.coming, true);
    writer.run(60);
    EXPECT_EQ(writer.stop_tails(), 0);
    EXPECT_EQ(motions_of(writer.words).size(), 1U) << before;
  }
}

TEST(Drought, AgainAndAgainKeepsEveryLimit) {
  // One by one at first, then by tens, slower than motion.
  Lines lines(20, 0.4);
  for (int i = 0; i < 10; ++i) lines.add(10, 0.01, 10 + 1.3 * i);
  SlowWriter writer(lines.coming, true);
  writer.run(200);
  EXPECT_EQ(writer.stop_tails(), 0);
  const auto motions = motions_of(writer.words);
  EXPECT_EQ(motions.size(), 30U);
  EXPECT_LT(distance(writer.words.back(), lines.coming.back().move), 1e-9);
  EXPECT_FALSE(judge(lines.text + "M2\n", writer.machine, writer.words).objects());
}

/// On time: a thread that writes a move every 20 ms, with a pause.
TEST(MoveRunner, RunsWhatASlowThreadWrites) {
  Lines lines(60, 0);
  const machine::Machine machine = machine::mill3();
  std::vector<base::Word> words;
  words.reserve(100'000);
  realtime::MoveRunner runner(machine, {.look_ahead = 0.3, .least_look_ahead = 0.02},
                              {.take =
                                   [&](const base::Word& word) {
                                     words.push_back(word);
                                     return true;
                                   },
                               .publish = [] { return true; }});
  runner.runner().start();
  std::thread writer([&] {
    for (std::size_t k = 0; k < lines.coming.size(); ++k) {
      realtime::sleep_until(realtime::now() + (k == 30 ? 1'500'000'000 : 5'000'000));
      EXPECT_TRUE(runner.push(lines.coming[k].move));
    }
    runner.finish();
    EXPECT_EQ(runner.push(host::line({}, feed)).error().code, "motion-ended");
  });
  writer.join();
  while (!runner.runner().has_ended()) realtime::sleep_until(realtime::now() + 1'000'000);
  EXPECT_FALSE(runner.failure());
  ASSERT_FALSE(words.empty());
  EXPECT_LT(distance(words.back(), lines.coming.back().move), 1e-9);
  EXPECT_EQ(words.back().state, base::MotionState::rest);
  EXPECT_FALSE(judge(lines.text + "M2\n", machine, words).objects());
}

TEST(MoveRunner, EndsWhenItIsStoppedBeforeTheMovesEnd) {
  realtime::MoveRunner runner(machine::mill3(), {}, {.take = [](const base::Word&) { return true; }, .publish = {}});
  ASSERT_TRUE(runner.push(host::line({300}, feed)));
  runner.runner().start();
  realtime::sleep_until(realtime::now() + 400'000'000);
  EXPECT_GT(runner.runner().counters().words, 0);
  runner.runner().stop();
  const std::int64_t given_up = realtime::now() + 5'000'000'000;
  while (!runner.runner().has_ended() && realtime::now() < given_up) realtime::sleep_until(realtime::now() + 1'000'000);
  EXPECT_TRUE(runner.runner().has_ended());
}

}  // namespace test_drought
