#include <algorithm>
#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/steps/step_timing.hpp>
#include <string>

namespace leadscrew::steps {

namespace {

using base::problem;
using base::text;

constexpr std::int64_t slowest_clock = 10'000;
constexpr std::int64_t fastest_clock = 10'000'000;
constexpr std::int64_t nanoseconds_per_second = 1'000'000'000;
constexpr double rounding = 1e-12;  // of velocity/BLU
constexpr double farthest = 4e9;    // BLU; there doubles are half a hysteresis apart (axis_steps.cpp)

std::int64_t ticks(std::int64_t nanoseconds, std::int64_t clock_hz) {
  return (nanoseconds * clock_hz + nanoseconds_per_second - 1) / nanoseconds_per_second;
}

std::string milliseconds(double seconds) {
  return base::rounded_text(seconds * 1e3) + " ms";
}

class AxisCheck {
 public:
  AxisCheck(base::Axis axis, const machine::AxisLimits& limits, std::int64_t clock_hz)
      : axis_(axis),
        name_(std::string("axis ") + base::letter(axis)),
        limits_(limits),
        clock_hz_(clock_hz),
        ticks_(in_ticks(limits.step_times, clock_hz)) {}

  void check(std::vector<base::Diagnostic>& problems) const {
    const double reach = std::max(std::fabs(limits_.travel_min), std::fabs(limits_.travel_max)) / limits_.blu;
    if (!(reach <= farthest)) {
      problems.push_back(problem("step-range", name_ + " travels to " + text(reach) + " BLU from its zero",
                                 "at most 4e9; a larger BLU or less travel", {.axis = axis_}));
    }
    check_rate(problems);
    check_turn(problems);
  }

 private:
  void check_rate(std::vector<base::Diagnostic>& problems) const {
    const double rate = limits_.velocity / limits_.blu;
    const double given = static_cast<double>(clock_hz_) / static_cast<double>(ticks_.pitch());
    if (rate <= given * (1 + rounding)) return;
    problems.push_back(problem("step-rate",
                               name_ + " makes " + text(rate) + " steps/s at its greatest velocity; a clock of " +
                                   std::to_string(clock_hz_) + " Hz gives " + text(given) + ", a step every " +
                                   std::to_string(ticks_.pitch()) + " ticks",
                               "a faster clock, shorter steps, a larger BLU or a lower velocity", {.axis = axis_}));
  }

  /// An axis that turns as it makes a step is half a BLU from where its steps lead, and by the time T at which it may
  /// step back, aT²/2 further away. The step before its turn may lie a tick after that place.
  void check_turn(std::vector<base::Diagnostic>& problems) const {
    const double turn = static_cast<double>(ticks_.reversal() + 1) / static_cast<double>(clock_hz_);
    if (limits_.acceleration * turn * turn < limits_.blu) return;
    problems.push_back(problem("step-turn",
                               name_ + " may step back " + milliseconds(turn) +
                                   " after a step; at its greatest acceleration it is a BLU from its steps by then",
                               "at most " + milliseconds(std::sqrt(limits_.blu / limits_.acceleration)) +
                                   " for step length, direction hold and setup and a tick of the clock",
                               {.axis = axis_}));
  }

  base::Axis axis_;
  std::string name_;
  const machine::AxisLimits& limits_;
  std::int64_t clock_hz_;
  StepTicks ticks_;
};

}  // namespace

StepTicks in_ticks(const machine::StepTimes& times, std::int64_t clock_hz) {
  return {ticks(times.step_length, clock_hz), ticks(times.step_space, clock_hz), ticks(times.direction_setup, clock_hz),
          ticks(times.direction_hold, clock_hz)};
}

std::vector<std::size_t> StepTicks::limiting() const {
  constexpr std::size_t length_place = 0, space_place = 1, setup_place = 2, hold_place = 3;
  const std::int64_t turn = length + hold + setup;
  std::vector<std::size_t> times = {length_place};
  if (pitch() >= turn) times.push_back(space_place);
  if (turn >= pitch()) times.insert(times.end(), {hold_place, setup_place});
  return times;
}

LongestReversal longest_reversal(const machine::Machine& machine, std::int64_t clock_hz) {
  LongestReversal longest;
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const std::int64_t ticks = in_ticks(machine.limits(axis).step_times, clock_hz).reversal();
    if (ticks > longest.ticks) longest = {ticks, axis};
  }
  return longest;
}

std::vector<base::Diagnostic> validate(std::int64_t clock_hz, const machine::Machine& machine) {
  std::vector<base::Diagnostic> problems;
  if (clock_hz < slowest_clock || fastest_clock < clock_hz) {
    problems.push_back(
        problem("step-clock", "a step clock of " + std::to_string(clock_hz) + " Hz", "between 10000 and 10000000 Hz"));
    return problems;
  }
  for (const base::Axis axis : base::all_axes) {
    if (machine.has(axis)) AxisCheck(axis, machine.limits(axis), clock_hz).check(problems);
  }
  return problems;
}

}  // namespace leadscrew::steps
