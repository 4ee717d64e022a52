// Steps that follow words: when they come, how they keep their distances, and that none is lost.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <allocations.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <random_numbers.hpp>

#include "steps_support.hpp"

namespace leadscrew::steps::testing {
namespace test_steps {

using testing_support::any;
using testing_support::logarithmic;

/// Positions in BLU, with speeds up to `fastest`, BLU a period, that change by up to a tenth of it and rest now and
/// then.
std::vector<double> random_walk(int periods, double fastest) {
  std::vector<double> positions = {any(-100000, 100000) / 128.0};
  double speed = 0;
  for (int k = 0; k < periods; ++k) {
    const int kind = any(0, 16);
    speed += fastest * any(-1000, 1001) / 1e4;
    if (kind == 0) speed = 0;
    speed = std::clamp(speed, -fastest, fastest);
    positions.push_back(positions.back() + speed);
  }
  return positions;
}

struct Case {
  std::int64_t clock_hz = 0;
  machine::Machine machine;
  std::vector<base::Word> words;
};

StepTicks ticks_of(const Case& tried) {
  return in_ticks(tried.machine.limits(base::Axis::X).step_times, tried.clock_hz);
}

/// On any clock and with any period, at up to 95 % of the rate that timing allows.
Case any_case() {
  Case made;
  made.clock_hz = std::llround(logarithmic(1e4, 1e7));
  machine::StepTimes times;
  times.step_length = std::llround(logarithmic(100, 1e5));
  times.step_space = std::llround(logarithmic(100, 1e5));
  times.direction_setup = any(0, 20000);
  times.direction_hold = any(0, 20000);
  const StepTicks ticks = in_ticks(times, made.clock_hz);
  const base::Period period{std::llround(logarithmic(1e4, 2e7))};
  const double rate = static_cast<double>(made.clock_hz) / static_cast<double>(ticks.pitch());
  const double blu = logarithmic(1e-4, 1e-1);
  made.machine = mill_with(rate * blu, blu, period);
  const double turn = static_cast<double>(ticks.reversal() + 1) / static_cast<double>(made.clock_hz);
  for (auto& axis : made.machine.axes) {
    if (!axis) continue;
    axis->step_times = times;
    axis->acceleration = std::min(axis->acceleration, 0.99 * blu / (turn * turn));
  }
  const double fastest = std::min(0.95 * rate * period.seconds(), 300.0);
  std::vector<double> positions = random_walk(any(1, 12), fastest * any(1, 101) / 100);
  // At rest while the first direction is set up.
  const auto at_rest = static_cast<std::size_t>(times.direction_setup / period.nanoseconds + 2);
  positions.insert(positions.begin(), at_rest, positions.front());
  made.words = words_along_x(positions, blu);
  return made;
}

/// A step beyond a half and back that follow each other faster than a drive can turn are not made.
bool turns_in_time(const std::vector<Crossing>& crossings, const StepTicks& ticks) {
  for (std::size_t k = 1; k < crossings.size(); ++k) {
    const long double apart = std::ceil(crossings[k].tick) - std::ceil(crossings[k - 1].tick);
    if (crossings[k].direction != crossings[k - 1].direction && apart < ticks.reversal() + 2) return false;
  }
  return true;
}

void expect_as_by_brute_force(const Case& tried) {
  const BruteForce force(tried.words, tried.machine.limits(base::Axis::X), tried.machine.period, tried.clock_hz);
  const std::vector<Crossing> crossings = force.crossings(2000);
  const StepTicks ticks = ticks_of(tried);
  RC_PRE(turns_in_time(crossings, ticks));
  const Made made = steps_of(tried.words, tried.machine, tried.clock_hz);
  RC_ASSERT(made.events.size() == crossings.size());
  for (std::size_t k = 0; k < crossings.size(); ++k) {
    const StepEvent event = made.events[k];
    RC_ASSERT(event.direction() == crossings[k].direction);
    const auto after = static_cast<double>(static_cast<long double>(event.tick()) - crossings[k].tick);
    RC_ASSERT(after > -1e-3);
    if (after <= 1 + 1e-3) continue;
    // A step can be held up by the one before; the first one until its direction is set up.
    if (k == 0) {
      RC_ASSERT(event.tick() == ticks.setup);
      continue;
    }
    const std::int64_t apart = event.direction() == made.events[k - 1].direction() ? ticks.pitch() : ticks.reversal();
    RC_ASSERT(event.tick() == made.events[k - 1].tick() + apart);
  }
}

RC_GTEST_PROP(Steps, LieWithinOneTickOfTheirCrossings, ()) {
  expect_as_by_brute_force(any_case());
}

RC_GTEST_PROP(Steps, KeepTheirDistances, ()) {
  const Case tried = any_case();
  const StepTicks ticks = ticks_of(tried);
  const Made made = steps_of(tried.words, tried.machine, tried.clock_hz);
  for (std::size_t k = 1; k < made.events.size(); ++k) {
    const StepEvent event = made.events[k], before = made.events[k - 1];
    const bool turns = event.direction() != before.direction();
    const std::int64_t pitch = ticks.length + ticks.space, turn = ticks.length + ticks.hold + ticks.setup;
    RC_ASSERT(event.tick() - before.tick() >= (turns ? std::max(pitch, turn) : pitch));
  }
}

/// Within half a BLU at the word, so within a BLU at the first tick after it.
RC_GTEST_PROP(Steps, StayWithHalfABluOfWords, ()) {
  const Case tried = any_case();
  const Made made = steps_of(tried.words, tried.machine, tried.clock_hz);
  const double blu = tried.machine.limits(base::Axis::X).blu;
  const long double period =
      static_cast<long double>(tried.machine.period.nanoseconds) * static_cast<long double>(tried.clock_hz) / 1e9L;
  double count = std::round(tried.words[0].position[0] / blu);
  double worst = 0;
  std::size_t next = 0;
  for (const base::Word& word : tried.words) {
    const long double tick = std::ceil(static_cast<long double>(base::count(word.tick)) * period - 1e-4L);
    for (; next < made.events.size() && static_cast<long double>(made.events[next].tick()) <= tick; ++next) {
      count += made.events[next].direction();
    }
    worst = std::max(worst, std::fabs(count - word.position[0] / blu));
  }
  RC_ASSERT(worst < 1);
  RC_ASSERT(made.report.greatest_error < 1);
}

/// Several axes in one stream are what each is alone.
RC_GTEST_PROP(Steps, OfSeveralAxesComeInOrder, ()) {
  Case tried = any_case();
  const double blu = tried.machine.limits(base::Axis::X).blu;
  const double fastest = tried.machine.limits(base::Axis::X).velocity * tried.machine.period.seconds() / blu / 2;
  std::array<std::vector<double>, 3> alone;
  for (auto& axis : alone) axis = random_walk(8, std::min(fastest, 2000.0));
  std::vector<base::Word> words = words_along_x(alone[0], blu);
  for (std::size_t k = 0; k < words.size(); ++k) {
    for (std::size_t axis = 0; axis < alone.size(); ++axis) words[k].position[axis] = alone[axis][k] * blu;
  }
  const Made made = steps_of(words, tried.machine, tried.clock_hz);
  RC_ASSERT(std::ranges::is_sorted(made.events, {}, &StepEvent::tick));
  for (std::size_t axis = 0; axis < alone.size(); ++axis) {
    std::vector<StepEvent> expected;
    for (const StepEvent event : steps_of(words_along_x(alone[axis], blu), tried.machine, tried.clock_hz).events) {
      expected.emplace_back(event.tick(), base::all_axes[axis], event.direction());
    }
    std::vector<StepEvent> found;
    std::ranges::copy_if(made.events, std::back_inserter(found),
                         [&](StepEvent event) { return base::index(event.axis()) == axis; });
    RC_ASSERT(found == expected);
  }
}

TEST(Steps, AtAnEvenRateAreEven) {
  std::vector<double> positions;
  for (int k = 0; k <= 500; ++k) positions.push_back(200.0 * k);
  const Made made = steps_of(words_along_x(positions, 0.001), machine::mill3(), 1'000'000);
  ASSERT_EQ(made.events.size(), 100000u);
  for (std::size_t k = 300; k + 300 < made.events.size(); ++k) {
    ASSERT_EQ(made.events[k + 1].tick() - made.events[k].tick(), 5) << k;
  }
}

/// Up to 500 BLU a period and down again by 1 BLU a period each period.
TEST(Steps, AtTheGreatestRateNeedNotWait) {
  std::vector<double> positions = {0};
  for (int k = 0; k <= 2000; ++k) positions.push_back(positions.back() - std::min({k, 500, 2000 - k}));
  const Made made = steps_of(words_along_x(positions, 0.001), mill_with(500, 0.001), 1'000'000);
  EXPECT_EQ(made.events.size(), static_cast<std::size_t>(-positions.back()));
  EXPECT_LE(made.report.greatest_delay, 1);
  EXPECT_LE(made.report.greatest_error, 0.5 + 1e-6);
}

/// However soon the first step is due, its direction stands for the time that the drive asks before it.
TEST(Steps, LeaveTheFirstDirectionTimeToBeSetUp) {
  for (const double sign : {1.0, -1.0}) {
    std::vector<double> positions;
    for (int k = 0; k <= 20; ++k) positions.push_back(sign * (0.4999 + 0.3 * k));
    machine::Machine machine = machine::mill3();
    machine.axes[0]->step_times = {.direction_setup = 700'000};
    const Made made = steps_of(words_along_x(positions, 0.001), machine, 1'000'000);
    ASSERT_EQ(made.events.size(), 6u);
    EXPECT_GE(made.events[0].tick(), 700);
    EXPECT_LT(made.events[0].tick(), 710);
    EXPECT_EQ(made.events[0].direction(), static_cast<int>(sign));
  }
}

/// A summit 1e-4 BLU above a half, passed in 63 µs: the step back waits until the drive has turned.
TEST(Steps, GiveADriveTimeToTurn) {
  std::vector<double> positions;
  for (int k = -3; k <= 3; ++k) positions.push_back(0.5001 - 0.1 * k * k);
  machine::Machine machine = machine::mill3();
  machine.axes[0]->step_times = {.direction_setup = 100'000, .direction_hold = 50'000};
  const Made made = steps_of(words_along_x(positions, 0.001), machine, 1'000'000);
  ASSERT_EQ(made.events.size(), 2u);
  EXPECT_EQ(made.events[0].direction(), 1);
  EXPECT_EQ(made.events[1].direction(), -1);
  EXPECT_EQ(made.events[1].tick() - made.events[0].tick(), 1 + 50 + 100);
  EXPECT_EQ(made.report.postponed, 1);
  EXPECT_NEAR(static_cast<double>(made.report.greatest_delay), 151 - 63, 2);
}

TEST(Steps, DoNotChatterWhereWordsStandOnAHalf) {
  for (const double sign : {1.0, -1.0}) {
    std::vector<double> positions = {sign * 100000.25};
    for (int k = 0; k < 1000; ++k) positions.push_back(sign * (100000.5 + (k % 3 - 1) * 1e-9));
    const Made made = steps_of(words_along_x(positions, 0.001), machine::mill3(), 1'000'000);
    EXPECT_LE(made.events.size(), 1u);
  }
}

/// A straight run that stops dead: no step beyond, none back.
TEST(Steps, NeverOvershootWordsThatStop) {
  const Made made = steps_of(words_along_x({0, 180, 360, 540, 540, 540, 540}, 0.001), machine::mill3(), 1'000'000);
  EXPECT_EQ(made.events.size(), 540u);
  EXPECT_TRUE(std::ranges::all_of(made.events, [](StepEvent event) { return event.direction() == 1; }));
}

TEST(Steps, OfWordsThatAreTooFastComeLateAndAreNotLost) {
  const machine::Machine machine = machine::mill3();
  auto generator = StepGenerator::create(machine, 1'000'000).value();
  std::int64_t sum = 0, last = -10;
  const auto sink = [&](std::span<const StepEvent> events) {
    for (const StepEvent event : events) {
      sum += event.direction();
      EXPECT_GE(event.tick(), last + 2);
      last = event.tick();
    }
  };
  std::vector<double> positions = {0, 1700, 3400, 3400, -90, -4000.2, -4000.2};
  for (const base::Word& word : words_along_x(positions, 0.001)) generator.follow(word, sink);
  generator.finish(sink);
  EXPECT_EQ(sum, -4000);
  EXPECT_EQ(generator.count(base::Axis::X), -4000);
  EXPECT_GT(generator.report().postponed, 1000);
  EXPECT_GT(generator.report().greatest_error, 1000);
  ASSERT_TRUE(generator.complaint());
  EXPECT_EQ(generator.complaint()->code, "step-late");
}

TEST(Steps, TakeNoMemory) {
  std::vector<double> positions;
  for (int k = 0; k <= 200; ++k) positions.push_back(2000 * std::sin(k / 20.0));
  const auto words = words_along_x(positions, 0.001);
  auto generator = StepGenerator::create(machine::mill3(), 1'000'000).value();
  std::int64_t count = 0;
  const auto sink = [&](std::span<const StepEvent> events) { count += static_cast<std::int64_t>(events.size()); };
  const auto before = testing_support::allocations();
  for (const base::Word& word : words) generator.follow(word, sink);
  generator.finish(sink);
  EXPECT_EQ(testing_support::allocations(), before);
  EXPECT_EQ(count, generator.report().steps);
  EXPECT_GT(count, 10000);
}

/// Steps, counted beside the words that they follow.
class CountedSteps {
 public:
  /// No two steps of an axis may be nearer than so many ticks.
  CountedSteps(const machine::Machine& machine, std::int64_t clock_hz, std::int64_t ticks_apart)
      : generator_(StepGenerator::create(machine, clock_hz).value()), ticks_apart_(ticks_apart) {
    for (std::size_t axis = 0; axis < 3; ++axis) blu_[axis] = machine.axes[axis]->blu;
    last_.fill(-ticks_apart - 1);
  }

  void follow(const base::Word& word) {
    generator_.follow(word, [this](std::span<const StepEvent> events) { count(events); });
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (words_ == 0) sum_[axis] = std::llround(word.position[axis] / blu_[axis]);
      // The period before has been made.
      if (words_ > 1)
        worst_ = std::max(worst_, std::fabs(static_cast<double>(sum_[axis]) - before_[axis] / blu_[axis]));
    }
    before_ = word.position;
    ++words_;
  }
  void finish() {
    generator_.finish([this](std::span<const StepEvent> events) { count(events); });
  }

  std::int64_t steps() const { return steps_; }
  std::int64_t at(std::size_t axis) const { return sum_[axis]; }  ///< BLU
  double worst() const { return worst_; }                         ///< at any word, BLU
  bool are_apart() const { return apart_; }
  StepReport report() const { return generator_.report(); }

 private:
  void count(std::span<const StepEvent> events) {
    for (const StepEvent event : events) {
      const std::size_t axis = base::index(event.axis());
      sum_[axis] += event.direction();
      apart_ = apart_ && event.tick() >= last_[axis] + ticks_apart_;
      last_[axis] = event.tick();
    }
    steps_ += static_cast<std::int64_t>(events.size());
  }

  StepGenerator generator_;
  std::int64_t ticks_apart_;
  std::array<double, 3> blu_{};
  std::array<std::int64_t, 3> sum_{}, last_{};
  base::AxisVector before_{};
  std::int64_t words_ = 0, steps_ = 0;
  double worst_ = 0;
  bool apart_ = true;
};

/// A Lissajous figure of three axes until so many steps are made: at every word each axis' steps sum up to within half
/// a BLU of it.
void expect_none_lost_over(std::int64_t steps) {
  CountedSteps counted(mill_with(400, 0.001), 3'000'000, 6);
  base::Word word;
  for (std::int64_t k = 0; counted.steps() < steps; ++k) {
    word.tick = base::Tick{k};
    const double t = static_cast<double>(k) / 1000;
    word.position = {60 * std::sin(5 * t), 47 * std::sin(7.1 * t + 1), 20 * std::cos(11.3 * t)};
    counted.follow(word);
  }
  EXPECT_LE(counted.worst(), 0.5 + 2e-6);
  EXPECT_TRUE(counted.are_apart());
  EXPECT_EQ(counted.report().steps, counted.steps());
  EXPECT_LE(counted.report().greatest_error, 0.5 + 2e-6);
}

/// Lines, arcs, corners to stop at and to blend, dwells and reversals, until so many steps are made.
void expect_none_lost_in_a_program(std::int64_t steps) {
  machine::Machine machine = machine::mill3();
  for (auto& axis : machine.axes) {
    if (axis) axis->blu = 0.0005;
  }
  std::string text = "G21 G90 G94 G17 F9000\n";
  const std::int64_t steps_of_a_round = 600'000;
  for (std::int64_t made = 0; made < steps; made += steps_of_a_round) {
    text +=
        "G61\nG1 X60 Y10\nG3 X80 Y30 J20\nG1 Y70 Z-5\nG4 P0.01\nG64 P0.05\nG1 X40 Y80\nX20 Y40\nG2 X0 Y0 R30\n"
        "G1 X33.3333 Y-0.0007\nG1 X0 Y0 Z0.1234\nG0 X12.5 Y60\nG1 X-0.00031 Y-0.00026 Z0\n";
  }
  text += "G1 X1.23456 Y-7.65432 Z3.14159\nM2\n";
  const machine::ToolTable tools;
  pipeline::Program program(gcode::text_source(text), machine, tools, {}, nullptr);
  CountedSteps counted(machine, 10'000'000, 20);
  while (program.prepare()) counted.follow(program.cycle());
  counted.finish();
  EXPECT_FALSE(program.failure());
  EXPECT_GE(counted.steps(), steps);
  EXPECT_LT(counted.worst(), 1);
  EXPECT_LT(counted.report().greatest_error, 1);
  EXPECT_TRUE(counted.are_apart());
  EXPECT_EQ(counted.report().steps, counted.steps());
  EXPECT_EQ(counted.at(0), 2469);    // 1.23456 mm
  EXPECT_EQ(counted.at(1), -15309);  // -7.65432 mm
  EXPECT_EQ(counted.at(2), 6283);    // 3.14159 mm
}

TEST(Steps, LoseNoneOverAMillion) {
  expect_none_lost_over(1'000'000);
}

TEST(Steps, LoseNoneAcrossBlocks) {
  expect_none_lost_in_a_program(1'000'000);
}

TEST(LongSteps, LoseNoneAcrossBlocksOverAHundredMillion) {
  expect_none_lost_in_a_program(100'000'000);
}

TEST(LongSteps, LoseNoneOverAHundredMillion) {
  expect_none_lost_over(100'000'000);
}

}  // namespace test_steps
}  // namespace leadscrew::steps::testing
