#include <algorithm>
#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/servo/follower.hpp>
#include <leadscrew/servo/machine_loops.hpp>
#include <leadscrew/servo/stability.hpp>
#include <string>
#include <utility>

namespace leadscrew::servo {

base::Result<Follower> Follower::create(const machine::Machine& machine, LoopKind kind) {
  if (kind == LoopKind::pulses) {
    auto servo = PulseServo::create(machine);
    if (!servo) return base::failure(std::move(servo.error()));
    const double lag = servo->longest_lag();
    return Follower(std::move(*servo), lag);
  }
  const ServoOptions options = loops_of(machine);
  if (auto stable = check_stable(options, machine.period); !stable) return base::failure(std::move(stable.error()));
  auto servo = Servo::create(options, machine.period);
  if (!servo) return base::failure(std::move(servo.error()));
  return Follower(std::move(*servo), longest_lag(options));
}

base::Result<void> check_followed(const Followed& followed, const machine::Machine& machine) {
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const machine::AxisLimits& limits = machine.limits(axis);
    const double error = followed.word.position[base::index(axis)] - followed.position[base::index(axis)];
    if (std::fabs(error) <= limits.travel_max - limits.travel_min) continue;
    base::Diagnostic problem;
    problem.code = "servo-unstable";
    problem.message = std::string("axis ") + base::letter(axis) + ": the slide is off by " + base::text(error, 3) +
                      (base::is_rotary(axis) ? " degrees" : " mm") +
                      " at t = " + base::fixed_text(base::seconds(followed.word.tick, machine.period), 3) + " s";
    problem.hint = "its loop is not stable; lower the gains, or shorten the period";
    return base::failure(std::move(problem));
  }
  return {};
}

std::int64_t periods_in(double seconds, base::Period period) {
  return std::max<std::int64_t>(1, std::llround(std::min(seconds, 60.0) / period.seconds()));
}

ContourWindow window_of(double lag, base::Period period) {
  const auto behind = static_cast<int>(std::max<std::int64_t>(16, periods_in(6 * lag, period)));
  return {behind, std::max(8, behind / 3)};
}

}  // namespace leadscrew::servo
