#include <algorithm>
#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/stepping/step_timing.hpp>
#include <string>

namespace leadscrew::stepping {

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

void check_time(std::vector<base::Diagnostic>& problems, const char* what, std::int64_t nanoseconds,
                std::int64_t least) {
  if (least <= nanoseconds && nanoseconds <= nanoseconds_per_second) return;
  problems.push_back(problem("step-time", std::string(what) + " is " + std::to_string(nanoseconds) + " ns",
                             "between " + std::to_string(least) + " ns and 1 s"));
}

void check_axis(std::vector<base::Diagnostic>& problems, base::Axis axis, const machine::AxisLimits& limits,
                const StepTiming& timing) {
  const std::string name = std::string("axis ") + base::letter(axis);
  const double reach = std::max(std::fabs(limits.travel_min), std::fabs(limits.travel_max)) / limits.blu;
  if (!(reach <= farthest)) {
    problems.push_back(problem("step-range", name + " travels to " + text(reach) + " BLU from its zero",
                               "at most 4e9; a larger BLU or less travel"));
  }
  const double rate = limits.velocity / limits.blu;
  const double given = static_cast<double>(timing.clock_hz) / static_cast<double>(in_ticks(timing).pitch());
  if (rate <= given * (1 + rounding)) return;
  problems.push_back(problem("step-rate",
                             name + " makes " + text(rate) + " steps/s at its greatest velocity; a clock of " +
                                 std::to_string(timing.clock_hz) + " Hz gives " + text(given) + ", a step every " +
                                 std::to_string(in_ticks(timing).pitch()) + " ticks",
                             "a faster clock, shorter steps, a larger BLU or a lower velocity"));
}

}  // namespace

StepTicks in_ticks(const StepTiming& timing) {
  return {ticks(timing.step_length_ns, timing.clock_hz), ticks(timing.step_space_ns, timing.clock_hz),
          ticks(timing.direction_setup_ns, timing.clock_hz), ticks(timing.direction_hold_ns, timing.clock_hz)};
}

std::vector<base::Diagnostic> validate(const StepTiming& timing, const machine::Machine& machine) {
  std::vector<base::Diagnostic> problems;
  if (timing.clock_hz < slowest_clock || fastest_clock < timing.clock_hz) {
    problems.push_back(problem("step-clock", "a step clock of " + std::to_string(timing.clock_hz) + " Hz",
                               "between 10000 and 10000000 Hz"));
  }
  check_time(problems, "step length", timing.step_length_ns, 1);
  check_time(problems, "space between steps", timing.step_space_ns, 1);
  check_time(problems, "direction setup", timing.direction_setup_ns, 0);
  check_time(problems, "direction hold", timing.direction_hold_ns, 0);
  if (!problems.empty()) return problems;
  for (const base::Axis axis : base::all_axes) {
    if (machine.has(axis)) check_axis(problems, axis, machine.limits(axis), timing);
  }
  return problems;
}

}  // namespace leadscrew::stepping
