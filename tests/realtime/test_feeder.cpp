#include <gtest/gtest.h>

#include <cmath>
#include <leadscrew/planner/effort.hpp>
#include <leadscrew/realtime/feeder.hpp>

#include "live.hpp"

// A planner and a cycle in simulated time: while the planner plans, which takes as long as its counted work is said to
// take, the cycle makes words.

namespace test_feeder {

using namespace leadscrew;
using testing_support::judge;
using testing_support::words_of;

const std::string part =
    "G21 G90 G94 G17 F6000\nG64 P0.05\nG1 X20\nG1 Y10\nG2 X40 Y-10 I20 J0\nG1 X60 Y5\nG3 X60 Y5 I10 J0\n"
    "G3 X60 Y5 I10 J0\nG3 X60 Y5 I10 J0\nG3 X60 Y5 I10 J0\nG61\nG1 X90\nG3 X90 Y25 I0 J10\nG0 X0 Y0\nM2\n";

constexpr double look_ahead = 0.32, slice = 0.02;  // s, as drive has them

class Simulation {
 public:
  /// slow: s that a million units of work take. It looks ahead as far at all times, unless `least` s may be enough.
  Simulation(const std::string& text, const machine::Machine& machine, double slow, double least = look_ahead)
      : slowness(slow),
        machine_(machine),
        source_(gcode::text_source(text), machine, tools_, {}, nullptr),
        feeder(planning_, controller_, look_ahead, least) {
    source_.planner().slice(slice);
  }

  /// False if it has not ended after so many words.
  bool run(std::size_t most_words) {
    while (words.size() < most_words) {
      if (before_word) before_word(words.size());
      feeder.request(factor, stops);
      if (feeder.step()) continue;
      has_begun_ = true;
      make_word();
      const auto last = feeder.last_chunk();
      if (last && controller_.begun() == *last && controller_.stands()) return true;
    }
    return false;
  }

  std::vector<base::Word> words;
  double slowness;
  double factor = 1;
  bool stops = false;
  std::function<void(std::size_t)> before_word;
  double work = 0;  ///< of the planner, units

 private:
  void make_word() { words.push_back(controller_.next()); }

  std::optional<planner::Chunk> plan() {
    constexpr double units_of_a_chunk = 2000;  // for its stop tail
    const double before = source_.planner().effort();
    std::optional<planner::Chunk> chunk = source_.next();
    const double units = source_.planner().effort() - before + units_of_a_chunk;
    work += units;
    busy_ += slowness * 1e-6 * units / machine_.period.seconds();
    for (; has_begun_ && busy_ >= 1; --busy_) make_word();
    return chunk;
  }

  const machine::Machine& machine_;
  machine::ToolTable tools_;
  pipeline::MotionSource source_;
  interpolator::Controller controller_{machine_.period, {}, 800};
  realtime::Planning planning_{.next = [this] { return plan(); },
                               .refuse = [this] { source_.planner().refuse(); },
                               .override_feed = [this](double to) { source_.planner().override_feed(to); },
                               .slice = [this](double seconds) { source_.planner().slice(seconds); }};
  double busy_ = 0;  ///< periods
  bool has_begun_ = false;

 public:
  realtime::Feeder feeder;
};

constexpr double ten_times = 10;  // s for a million units: as fast as real time where ordinary motion takes 50'000/s
constexpr std::size_t most_words = 100'000;

TEST(Feeder, OfAPlannerInTimeGivesTheWordsOfRun) {
  const machine::Machine machine = machine::mill3();
  const std::vector<base::Word> expected = words_of(part, machine);
  Simulation simulation(part, machine, 1);
  ASSERT_TRUE(simulation.run(most_words));
  EXPECT_EQ(simulation.feeder.late_chunks(), 0);
  ASSERT_GE(simulation.words.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) ASSERT_EQ(simulation.words[k].position, expected[k].position) << k;
}

/// Motion takes what planning takes, and little more: not many times that, for being stopped again and again.
TEST(Feeder, OfALatePlannerMakesItNoLater) {
  const machine::Machine machine = machine::mill3();
  Simulation undisturbed(part, machine, 0);
  ASSERT_TRUE(undisturbed.run(most_words));
  const double seconds = machine.period.seconds() * static_cast<double>(undisturbed.words.size());
  for (const double slowness : {ten_times, 2 * ten_times, 4 * ten_times}) {
    SCOPED_TRACE(slowness);
    Simulation simulation(part, machine, slowness);
    ASSERT_TRUE(simulation.run(most_words));
    EXPECT_LE(simulation.work, 1.5 * undisturbed.work);
    EXPECT_GE(simulation.feeder.late_chunks(), 1);
    EXPECT_LE(simulation.feeder.late_chunks(), 6);
    const double taken = machine.period.seconds() * static_cast<double>(simulation.words.size());
    EXPECT_LE(taken, 2 * seconds + slowness * 1e-6 * 1.5 * undisturbed.work);
    EXPECT_FALSE(judge(part, machine, simulation.words).objects());
  }
}

/// What is held back at rest has not been begun: a stop must not begin it, nor a hold.
TEST(Feeder, BeginsNothingWhenItIsStoppedWhileItHoldsBack) {
  const machine::Machine machine = machine::mill3();
  Simulation simulation(part, machine, ten_times);
  std::optional<std::size_t> stopped_at;
  simulation.before_word = [&](std::size_t word) {
    const bool rests = word > 0 && simulation.words.back().speed == 0;
    if (stopped_at || simulation.feeder.late_chunks() < 2 || !rests) return;
    stopped_at = word;
    simulation.stops = true;
  };
  ASSERT_TRUE(simulation.run(most_words));
  ASSERT_TRUE(stopped_at);
  for (std::size_t k = *stopped_at; k < simulation.words.size(); ++k)
    ASSERT_EQ(simulation.words[k].position, simulation.words[*stopped_at - 1].position);
}

TEST(Feeder, HoldsAndGoesOnWhateverIsLate) {
  const machine::Machine machine = machine::mill3();
  Simulation simulation(part, machine, ten_times);
  simulation.before_word = [&](std::size_t word) { simulation.factor = word % 3000 < 1000 ? 0 : 1; };
  ASSERT_TRUE(simulation.run(most_words));
  EXPECT_FALSE(judge(part, machine, simulation.words).objects());
}

/// Waves of short lines, rounded: windows follow windows, 6 s of motion.
std::string waves() {
  std::string text = "G21 G90 G94 G17 F6000\nG64 P0.02\n";
  for (int k = 1; k <= 850; ++k) {
    const double x = 0.5 * k, y = 4 * std::sin(0.15 * k);
    text += "G1 X" + std::to_string(x) + " Y" + std::to_string(y) + "\n";
  }
  return text + "M2\n";
}

constexpr double least_look_ahead = 0.02, as_usual = 0.5;  // s; s for a million units: a third of a core or less

/// The words from the request to the first that differs from what it would have been.
std::size_t words_until_change(const std::vector<base::Word>& undisturbed, std::size_t request, double factor,
                               const std::string& text, const machine::Machine& machine) {
  Simulation simulation(text, machine, as_usual, least_look_ahead);
  simulation.before_word = [&](std::size_t word) {
    simulation.factor = word >= request && word < request + 500 ? factor : 1;
  };
  EXPECT_TRUE(simulation.run(most_words));
  EXPECT_EQ(simulation.feeder.late_chunks(), 0);
  EXPECT_FALSE(judge(text, machine, simulation.words).objects());
  std::size_t k = 0;
  while (k < undisturbed.size() && simulation.words[k].position == undisturbed[k].position) ++k;
  EXPECT_GE(k, request);
  return k - request;
}

/// Once the planner has been in time for some seconds; a word a millisecond.
TEST(Feeder, LetsAChangeOfFeedActWithin50Milliseconds) {
  machine::Machine machine = machine::mill3();
  machine.period = {1'000'000};
  machine.axes[0]->travel_max = 1000;
  const std::string text = waves();
  const std::vector<base::Word> undisturbed = words_of(text, machine);
  ASSERT_GT(undisturbed.size(), 5600U);
  for (const std::size_t request : {4000U, 4411U, 5077U}) {
    SCOPED_TRACE(request);
    EXPECT_LE(words_until_change(undisturbed, request, 0.5, text, machine), 50U);
  }
  EXPECT_LE(words_until_change(undisturbed, 4700, 0, text, machine), 50U);
}

/// It is late once, and then plans as far ahead as it may.
TEST(Feeder, LooksFarAheadAgainWhereThePlannerBecomesSlow) {
  machine::Machine machine = machine::mill3();
  machine.period = {1'000'000};
  machine.axes[0]->travel_max = 1000;
  const std::string text = waves();
  Simulation simulation(text, machine, as_usual, least_look_ahead);
  double nearest = look_ahead, at_end = 0;
  simulation.before_word = [&](std::size_t word) {
    nearest = std::min(nearest, simulation.feeder.look_ahead());
    at_end = simulation.feeder.look_ahead();
    if (word >= 3500) simulation.slowness = ten_times;
  };
  ASSERT_TRUE(simulation.run(most_words));
  EXPECT_LE(nearest, 0.04);
  EXPECT_EQ(at_end, look_ahead);
  EXPECT_GE(simulation.feeder.late_chunks(), 1);
  EXPECT_LE(simulation.feeder.late_chunks(), 6);
  EXPECT_FALSE(judge(text, machine, simulation.words).objects());
}

}  // namespace test_feeder
