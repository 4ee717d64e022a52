#include <fmt/format.h>

#include <cmath>
#include <leadscrew/drive/checks.hpp>
#include <leadscrew/drive/link.hpp>
#include <leadscrew/servo/machine_loops.hpp>
#include <leadscrew/servo/stability.hpp>

namespace leadscrew::drive {

namespace {

constexpr std::int64_t least_period = 50'000;  // ns: below, two processes cannot wake each other up in time

/// What is longer still ends motion when it comes (`stop-too-long`).
base::Result<void> check_stops(const Setup& setup) {
  const double periods = setup.periods_to_stop();
  if (periods <= Link::longest_stop_path) return {};
  return base::failure(base::problem(
      "stop-too-long",
      fmt::format("the machine may need {:.0f} periods to stop, drives hold {}", periods, Link::longest_stop_path),
      fmt::format("a --period of {:.0f}us or more", std::ceil(setup.machine.period.seconds() * 1e6 * periods /
                                                              static_cast<double>(Link::longest_stop_path)))));
}

base::Result<void> check_period(const Setup& setup) {
  if (setup.machine.period.nanoseconds >= least_period) return {};
  return base::failure(base::problem("period-too-short",
                                     fmt::format("a period of {:g}us is too short for words to be on time",
                                                 static_cast<double>(setup.machine.period.nanoseconds) / 1e3),
                                     "a --period of 50us or more; run and simulate take shorter ones"));
}

}  // namespace

base::Result<void> check_machine(const Setup& setup) {
  if (auto sound = check_period(setup); !sound) return sound;
  if (auto sound = check_stops(setup); !sound) return sound;
  if (setup.options.sink) return {};
  return servo::check_stable(servo::loops_of(setup.machine), setup.machine.period);
}

}  // namespace leadscrew::drive
