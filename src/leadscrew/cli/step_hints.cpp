#include <fmt/format.h>
#include <fmt/ranges.h>

#include <leadscrew/base/number_text.hpp>
#include <leadscrew/cli/machine_keys.hpp>
#include <leadscrew/cli/step_hints.hpp>
#include <leadscrew/gcode/number.hpp>
#include <leadscrew/machine/step_times.hpp>
#include <leadscrew/stepping/step_timing.hpp>
#include <string>
#include <utility>
#include <vector>

namespace leadscrew::cli {

namespace {

/// "--direction-setup (40 us)", or its key where the machine file, or its default, says so.
std::string time_text(std::size_t k, base::Axis axis, const Job& job) {
  const bool is_option = job.arguments.run.step_times[k].has_value();
  const std::string_view name = is_option ? step_time_options[k] : keys_of(axis).step_times[k];
  const std::int64_t nanoseconds = job.machine.limits(axis).step_times.*machine::all_step_times[k].value;
  return fmt::format("{} ({} us)", name, base::text(static_cast<double>(nanoseconds) / 1e3));
}

/// By their place in machine::all_step_times.
std::vector<std::size_t> limiting_times(const stepping::StepTicks& ticks) {
  constexpr std::size_t length = 0, space = 1, setup = 2, hold = 3;
  const std::int64_t turn = ticks.length + ticks.hold + ticks.setup;
  std::vector<std::size_t> times = {length};
  if (ticks.pitch() >= turn) times.push_back(space);
  if (turn >= ticks.pitch()) times.insert(times.end(), {hold, setup});
  return times;
}

/// The planner knows how many ticks there are from step to step, but not whose.
base::Diagnostic with_step_times(base::Diagnostic problem, const Job& job) {
  const std::int64_t clock_hz = job.arguments.run.step_clock;
  const auto [slowest, axis] = stepping::longest_reversal(job.machine, clock_hz);
  const stepping::StepTicks ticks = stepping::in_ticks(job.machine.limits(axis).step_times, clock_hz);
  const std::string asked = problem.message.substr(0, problem.message.find(','));
  problem.message =
      fmt::format("{}, axis {} allows {} a second: {} ticks of the clock from a step to one {}", asked,
                  base::letter(axis), gcode::text(static_cast<double>(clock_hz) / static_cast<double>(slowest)),
                  slowest, ticks.pitch() == slowest ? "behind it" : "back");
  std::vector<std::string> times;
  for (const std::size_t k : limiting_times(ticks)) times.push_back(time_text(k, axis, job));
  problem.hint = fmt::format("program a lower feed, or shorten what sets it: {}", fmt::join(times, ", "));
  return problem;
}

}  // namespace

base::Diagnostic in_options(base::Diagnostic problem, const Job& job) {
  if (problem.code == "pulse-step-length") return with_step_times(std::move(problem), job);
  if (problem.code == "pulse-velocity")
    problem.hint = "program a lower feed, or give --accelerate: the feed then keeps to what the axes can do";
  if (problem.code == "pulse-rate") problem.hint = "program a lower feed, or give a faster --step-clock, up to 10MHz";
  return problem;
}

}  // namespace leadscrew::cli
