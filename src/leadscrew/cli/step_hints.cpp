#include <fmt/format.h>
#include <fmt/ranges.h>

#include <leadscrew/base/number_text.hpp>
#include <leadscrew/cli/step_hints.hpp>
#include <leadscrew/config/machine_keys.hpp>
#include <leadscrew/machine/step_times.hpp>
#include <leadscrew/steps/step_timing.hpp>
#include <string>
#include <vector>

namespace leadscrew::cli {

namespace {

/// "--direction-setup (40 us)", or its key where the machine file, or its default, says so.
std::string time_text(std::size_t k, base::Axis axis, const Job& job) {
  const bool is_option = job.arguments.run.step_times[k].has_value();
  const std::string_view name =
      is_option ? step_time_options[k] : config::axis_key_of(axis, machine::all_step_times[k].name);
  const std::int64_t nanoseconds = job.machine.limits(axis).step_times.*machine::all_step_times[k].value;
  return fmt::format("{} ({} us)", name, base::text(static_cast<double>(nanoseconds) / 1e3));
}

/// Those of the slowest axis that are longer than a tick; and a faster clock, where rounding to ticks is a good part.
std::string hint_of_step_times(const Job& job) {
  constexpr std::int64_t fastest_clock = 10'000'000;
  const std::int64_t clock_hz = job.arguments.run.step_clock;
  const steps::LongestReversal slowest = steps::longest_reversal(job.machine, clock_hz);
  const machine::StepTimes& times = job.machine.limits(slowest.axis).step_times;
  std::string hint = "program a lower feed";
  std::vector<std::string> named;
  for (const std::size_t k : steps::in_ticks(times, clock_hz).limiting()) {
    const std::int64_t nanoseconds = times.*machine::all_step_times[k].value;
    if (nanoseconds * clock_hz > 1'000'000'000) named.push_back(time_text(k, slowest.axis, job));
  }
  if (!named.empty()) hint += fmt::format(", or shorten what sets it: {}", fmt::join(named, ", "));
  const auto finer = static_cast<double>(steps::in_ticks(times, fastest_clock).reversal()) / fastest_clock;
  if (1.5 * finer < static_cast<double>(slowest.ticks) / static_cast<double>(clock_hz))
    hint += ", or give a faster --step-clock, up to 10MHz";
  return hint;
}

}  // namespace

base::Diagnostic in_options(base::Diagnostic problem, const Job& job) {
  if (problem.code == "pulse-step-length") problem.hint = hint_of_step_times(job);
  return problem;
}

}  // namespace leadscrew::cli
