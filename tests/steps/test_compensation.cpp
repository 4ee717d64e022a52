// Compensated words on a simulated screw: the axis ends up where words wanted it.

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <leadscrew/steps/compensation.hpp>
#include <random_numbers.hpp>

#include "steps_support.hpp"

namespace leadscrew::steps::testing {
namespace test_compensation {

using machine::PitchError;
using machine::ScrewErrors;
using testing_support::any;
using testing_support::logarithmic;

/// A screw with play and errors, moved command by command: the nut lies between the flanks at c and c + play.
class SimulatedScrew {
 public:
  SimulatedScrew(const ScrewErrors& errors, double command) : errors_(errors), nut_(command) {}

  void move(double command) {
    if (command > nut_) backward_ = false;
    if (command + errors_.backlash < nut_) backward_ = true;
    nut_ = std::clamp(nut_, command, command + errors_.backlash);
  }

  double real() const {
    const auto& table = backward_ && !errors_.backward_table.empty() ? errors_.backward_table : errors_.table;
    if (table.empty()) return nut_;
    if (nut_ <= table.front().position) return nut_ + table.front().error;
    for (std::size_t k = 1; k < table.size(); ++k) {
      if (nut_ > table[k].position) continue;
      const double pitch = table[k].position - table[k - 1].position;
      return nut_ +
             (table[k - 1].error * (table[k].position - nut_) + table[k].error * (nut_ - table[k - 1].position)) /
                 pitch;
    }
    return nut_ + table.back().error;
  }

 private:
  ScrewErrors errors_;
  double nut_;
  bool backward_ = false;
};

std::vector<PitchError> any_table() {
  std::vector<PitchError> table = {{-60.0 + any(0, 20), any(-100, 101) / 1e4}};
  const int entries = any(0, 12);
  for (int k = 0; k < entries; ++k) {
    const double pitch = logarithmic(1, 30);
    table.push_back({table.back().position + pitch, table.back().error + pitch * 1e-3 * any(-95, 96)});
  }
  return table;
}

/// Of running backward, where an axis lags behind its command more than forward, as lost motion does.
std::vector<PitchError> lagging(std::vector<PitchError> table) {
  for (PitchError& entry : table) entry.error += 0.05 + 1e-4 * (entry.position + 60) + any(0, 100) * 1e-5;
  return table;
}

/// Half an oscillation after the other, each to another place, from rest to rest; mm.
std::vector<double> to_and_fro(int turns, double velocity, double period) {
  std::vector<double> positions = {any(-500, 500) / 10.0};
  for (int k = 0; k < turns; ++k) {
    const double start = positions.back(), travel = any(-500, 501) / 10.0 - start;
    const auto count = static_cast<int>(std::ceil(std::fabs(travel) * 1.6 / velocity / period)) + 1;
    for (int i = 1; i <= count; ++i) {
      positions.push_back(start + travel * (1 - std::cos(3.14159265358979 * i / count)) / 2);
    }
  }
  return positions;
}

base::Word word_at(double position, std::int64_t tick) {
  base::Word word;
  word.tick = base::Tick{tick};
  word.position[0] = position;
  return word;
}

struct Axis {
  machine::Machine machine = mill_with(200, 0.001);
  ScrewErrors errors;

  machine::Machine machine_with_errors() const {
    machine::Machine whole = machine;
    whole.screws[0] = errors;
    return whole;
  }
};

Axis any_axis() {
  Axis axis;
  axis.errors.table = any_table();
  if (any(0, 2) == 0) axis.errors.backward_table = lagging(axis.errors.table);
  if (any(0, 4) != 0) axis.errors.backlash = logarithmic(1e-4, 0.5);
  if (any(0, 2) == 0) axis.errors.takeup_velocity = logarithmic(0.5, 100);
  return axis;
}

/// The last position again and again until the axis has gone over.
template <class Send>
void run(Compensation& compensation, const std::vector<double>& positions, const Send& send) {
  std::int64_t tick = 0;
  for (const double position : positions) send(compensation.apply(word_at(position, tick++)));
  for (int k = 0; k < 100000 && !compensation.settled(); ++k) {
    send(compensation.apply(word_at(positions.back(), tick++)));
  }
  ASSERT_TRUE(compensation.settled());
}

RC_GTEST_PROP(Compensation, LeadsTheAxisWhereWordsWantIt, ()) {
  const Axis axis = any_axis();
  const auto positions = to_and_fro(any(1, 6), 200, 0.001);
  auto compensation = Compensation::create(axis.machine_with_errors()).value();
  std::optional<SimulatedScrew> screw;
  run(compensation, positions, [&](const base::Word& commanded) {
    if (!screw) screw.emplace(axis.errors, commanded.position[0]);
    screw->move(commanded.position[0]);
  });
  RC_ASSERT(std::fabs(screw->real() - positions.back()) < 1e-9);
}

RC_GTEST_PROP(Compensation, KeepsTheVelocityOfTheAxis, ()) {
  const Axis axis = any_axis();
  const auto positions = to_and_fro(any(1, 6), 200, 0.001);
  auto compensation = Compensation::create(axis.machine_with_errors()).value();
  const double velocity = compensation.stretched(axis.machine).limits(base::Axis::X).velocity;
  std::optional<double> before;
  double fastest = 0;
  run(compensation, positions, [&](const base::Word& commanded) {
    if (before) fastest = std::max(fastest, std::fabs(commanded.position[0] - *before) / 0.001);
    before = commanded.position[0];
  });
  RC_ASSERT(fastest <= velocity * (1 + 1e-9));
}

/// With steps in between: within a BLU, and as many as the compensated words say.
RC_GTEST_PROP(Compensation, LosesNoStep, ()) {
  const Axis axis = any_axis();
  const auto positions = to_and_fro(any(1, 5), 200, 0.001);
  auto compensation = Compensation::create(axis.machine_with_errors()).value();
  auto generator = StepGenerator::create(compensation.stretched(axis.machine), 2'000'000).value();
  std::optional<SimulatedScrew> screw;
  std::int64_t count = 0;
  const auto sink = [&](std::span<const StepEvent> events) {
    for (const StepEvent event : events) {
      count += event.direction();
      screw->move(static_cast<double>(count) * 0.001);
    }
  };
  double last = 0;
  run(compensation, positions, [&](const base::Word& commanded) {
    last = commanded.position[0];
    if (!screw) {
      count = std::llround(last / 0.001);
      screw.emplace(axis.errors, static_cast<double>(count) * 0.001);
    }
    generator.follow(commanded, sink);
  });
  generator.finish(sink);
  RC_ASSERT(count == generator.count(base::Axis::X));
  RC_ASSERT(std::fabs(static_cast<double>(count) - last / 0.001) <= 0.5 + 2e-6);
  RC_ASSERT(std::fabs(screw->real() - positions.back()) < 0.001);
  RC_ASSERT(!generator.complaint());
}

/// Without play every word is met, not the last alone.
TEST(Compensation, MeetsEveryWordWhereAScrewHasNoPlay) {
  Axis axis;
  axis.errors.table = {{-50, 0.02}, {-10, -0.03}, {0, 0}, {25, 0.5}, {50, 0.1}};
  auto compensation = Compensation::create(axis.machine_with_errors()).value();
  for (int k = 0; k <= 2000; ++k) {
    const double position = 60 * std::sin(k / 300.0);
    const base::Word commanded = compensation.apply(word_at(position, k));
    SimulatedScrew screw(axis.errors, commanded.position[0]);
    ASSERT_NEAR(screw.real(), position, 1e-12) << k;
  }
}

TEST(Compensation, LeavesOtherAxesAlone) {
  Axis axis;
  axis.errors.backlash = 0.1;
  auto compensation = Compensation::create(axis.machine_with_errors()).value();
  base::Word word = word_at(1, 0);
  word.position[1] = 2.5;
  word.speed = 7;
  const base::Word commanded = compensation.apply(word);
  EXPECT_EQ(commanded.position, word.position);
  EXPECT_EQ(commanded.speed, 7);
}

TEST(Compensation, DoesNotTurnForRounding) {
  Axis axis;
  axis.errors.backlash = 0.1;
  auto compensation = Compensation::create(axis.machine_with_errors()).value();
  for (int k = 0; k < 100; ++k) {
    const double position = 1 + (k % 3) * 1e-6;
    EXPECT_EQ(compensation.apply(word_at(position, k)).position[0], position);
  }
  EXPECT_LT(compensation.apply(word_at(0.9, 100)).position[0], 0.9);
}

/// Backlash of 0.1 mm at 5 mm/s: 20 ms, and some to speed up and slow down at 1000 mm/s².
TEST(Compensation, TakesBacklashUpAtItsVelocity) {
  Axis axis;
  axis.errors.backlash = 0.1;
  axis.errors.takeup_velocity = 5;
  auto compensation = Compensation::create(axis.machine_with_errors()).value();
  compensation.apply(word_at(0, 0));
  compensation.apply(word_at(-0.001, 1));
  int periods = 1;
  for (; !compensation.settled(); ++periods) compensation.apply(word_at(-0.001, 1 + periods));
  EXPECT_GE(periods, 20);
  EXPECT_LE(periods, 30);
}

TEST(Compensation, RefusesScrewsThatCannotBe) {
  Axis axis;
  axis.errors.table = {{0, 0}, {10, 0.01}, {10, 0.02}};
  const auto made = Compensation::create(axis.machine_with_errors());
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, "pitch-order");
}

}  // namespace test_compensation
}  // namespace leadscrew::steps::testing
