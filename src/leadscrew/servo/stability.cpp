#include <algorithm>
#include <cmath>
#include <leadscrew/servo/stability.hpp>
#include <limits>
#include <string>

namespace leadscrew::servo {

namespace {

constexpr double observed = 10;                            // s of each loop
constexpr std::int64_t fewest = 40'000, most = 1'000'000;  // periods

LoopOptions linear(LoopOptions loop) {
  constexpr double none = std::numeric_limits<double>::infinity();
  loop.axis = {.drive = loop.axis.drive};
  std::visit([](auto& controller) { controller.limit = none; }, loop.controller);
  return loop;
}

/// The greatest error over so many periods; infinite where it overflows.
double greatest_error(AxisLoop& loop, double reference, std::int64_t count) {
  double greatest = 0;
  for (std::int64_t n = 0; n < count; ++n) {
    loop.follow({.position = reference});
    const double error = std::abs(reference - loop.axis().screw().position);
    if (!std::isfinite(error)) return std::numeric_limits<double>::infinity();
    greatest = std::max(greatest, error);
  }
  return greatest;
}

}  // namespace

base::Result<void> check_stable(const ServoOptions& options, base::Period period) {
  const std::int64_t periods = std::clamp<std::int64_t>(std::llround(observed / period.seconds()), fewest, most);
  constexpr double step = 1;  // mm or degrees; the loop is linear, so its size does not matter
  ServoOptions linear_loops;
  for (std::size_t i = 0; i < options.size(); ++i) {
    if (options[i]) linear_loops[i] = linear(*options[i]);
  }
  const auto servo = Servo::create(linear_loops, period);
  if (!servo) return base::failure(servo.error());
  for (const base::Axis axis : base::all_axes) {
    if (servo->loop(axis) == nullptr) continue;
    AxisLoop loop = *servo->loop(axis);
    const double before = greatest_error(loop, step, periods / 4);
    greatest_error(loop, step, periods / 2);
    if (std::isfinite(before) && greatest_error(loop, step, periods / 4) <= before) continue;
    return base::failure(base::problem(
        "servo-unstable",
        std::string("axis ") + base::letter(axis) + ": its loop is not stable: it swings ever wider behind a step",
        "lower the gains, or shorten the period"));
  }
  return {};
}

}  // namespace leadscrew::servo
