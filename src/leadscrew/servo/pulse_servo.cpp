#include <algorithm>
#include <leadscrew/servo/pulse_servo.hpp>
#include <limits>
#include <utility>

namespace leadscrew::servo {

namespace {

constexpr double usual_gain = 40;  // Kv, 1/s
constexpr double start = 0.5;      // past an edge, pulses

PulseLoopOptions options_of(const machine::AxisDrive& drive) {
  const double gain = drive.position_gain.value_or(usual_gain);
  const double time_constant = drive.time_constant ? *drive.time_constant / 1000 : 1 / (4 * gain);
  return {.converter = 1,
          .amplifier = 1,
          .motor = gain,
          .holes = 1,
          .time_constant = time_constant,
          .counter_bits = 32,
          .start = start};
}

}  // namespace

base::Result<PulseServo> PulseServo::create(const machine::Machine& machine) {
  auto generator = steps::StepGenerator::create(machine, step_clock);
  if (!generator) return base::failure(std::move(generator.error()));
  PulseServo made(std::move(*generator), machine.period.seconds());
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const PulseLoopOptions options = options_of(machine.drive(axis));
    auto loop = PulseLoop::create(options);
    if (!loop) return base::failure(std::move(loop.error()));
    loop->load(std::numeric_limits<std::int64_t>::max());
    made.axes_[base::index(axis)] = OfAxis{std::move(*loop), machine.limits(axis).blu, 0};
    made.longest_lag_ = std::max(made.longest_lag_, 1 / options.gain());
  }
  return made;
}

std::optional<Followed> PulseServo::follow(const base::Word& word) {
  if (!before_) origin_ = word.position;
  // The steps of the period that ends with the word before.
  generator_.follow(word, [this](std::span<const steps::StepEvent> events) { take(events); });
  const std::optional<base::Word> due = std::exchange(before_, word);
  if (!due) return std::nullopt;
  Followed followed{*due, due->position};
  const double now = static_cast<double>(words_++) * period_;
  for (std::size_t k = 0; k < axes_.size(); ++k) {
    if (!axes_[k]) continue;
    run_until(*axes_[k], now);
    followed.position[k] = origin_[k] + (axes_[k]->loop.position() - start) * axes_[k]->blu;
    followed.velocity[k] = axes_[k]->loop.velocity() * axes_[k]->blu;
    followed.control[k] = static_cast<double>(axes_[k]->loop.following_error());
    followed.current[k] = axes_[k]->loop.acceleration() * axes_[k]->blu;
  }
  return followed;
}

void PulseServo::take(std::span<const steps::StepEvent> events) {
  for (const steps::StepEvent& event : events) {
    auto& axis = axes_[base::index(event.axis())];
    if (!axis) continue;
    run_until(*axis, static_cast<double>(event.tick()) / static_cast<double>(step_clock));
    axis->loop.pulse(event.direction());
  }
}

void PulseServo::run_until(OfAxis& axis, double time) {
  if (!(time > axis.time)) return;
  axis.loop.run_through(time - axis.time);
  axis.time = time;
}

}  // namespace leadscrew::servo
