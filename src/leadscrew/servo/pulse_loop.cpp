#include <cmath>
#include <leadscrew/servo/pulse_loop.hpp>
#include <leadscrew/servo/refusal.hpp>
#include <limits>

namespace leadscrew::servo {

namespace {

/// When a motion in one direction passes `edge`, which it does before the time `last`, at which it has gone by
/// `travel`: Newton's method, kept between the ends of a bracket.
double passing_time(const Motion& from, const Pull& pull, double edge, double last, double travel) {
  double low = 0, high = last;
  double time = last * ((edge - from.position) / travel);
  for (int k = 0; k < 80; ++k) {
    const Motion now = after(from, pull, time);
    const double beyond = now.position - edge;
    const bool passed = (beyond > 0) == (travel > 0);
    (passed ? high : low) = time;
    double next = time - beyond / now.velocity;
    if (!(low <= next && next <= high)) next = low + (high - low) / 2;
    if (std::fabs(next - time) <= 2 * std::numeric_limits<double>::epsilon() * time) return next;
    time = next;
  }
  return time;
}

}  // namespace

base::Result<PulseLoop> PulseLoop::create(const PulseLoopOptions& options) {
  Refusal refusal("servo-pulse-loop");
  refusal.unless_positive("the gain of the converter", options.converter);
  refusal.unless_positive("the gain of the amplifier", options.amplifier);
  refusal.unless_positive("the gain of the motor", options.motor);
  refusal.unless_positive("the number of holes", options.holes);
  refusal.unless_positive("the time constant", options.time_constant);
  refusal.unless_within("the number of bits of the up-down counter", options.counter_bits, 2, 32);
  refusal.unless_within("the start", options.start, 0, 1);
  if (refusal.found()) return base::failure(*refusal.found());
  return PulseLoop(options);
}

PulseLoop::PulseLoop(const PulseLoopOptions& options)
    : gain_(options.gain()),
      damping_(1 / options.time_constant),
      least_(-(std::int64_t{1} << (options.counter_bits - 1))),
      most_(-least_ - 1),
      motion_{options.start, 0} {}

bool PulseLoop::pulse(int direction) {
  if (to_come_ <= 0) return false;
  --to_come_;
  commanded_ += direction;
  ++passed_;
  count(direction);
  return true;
}

void PulseLoop::count(int step) {
  const std::int64_t next = difference_ + step;
  const bool fits = least_ <= next && next <= most_;
  if (fits) difference_ = next;
  overflows_ += fits ? 0 : 1;
}

PulseLoop::Passed PulseLoop::run(double at_most) {
  const double turn = time_to_rest(motion_.velocity, {gain_ * damping_ * static_cast<double>(difference_), damping_});
  if (!(turn < at_most)) return run_one_direction(at_most);
  const Passed before = run_one_direction(turn);
  if (before.encoder_pulse != 0) return before;
  motion_.velocity = 0;
  const Passed behind = run_one_direction(at_most - turn);
  return {turn + behind.seconds, behind.encoder_pulse};
}

/// As run(), where the screw does not turn back.
PulseLoop::Passed PulseLoop::run_one_direction(double at_most) {
  const Pull pull{gain_ * damping_ * static_cast<double>(difference_), damping_};
  const Motion end = after(motion_, pull, at_most);
  const bool forward = motion_.velocity != 0 ? motion_.velocity > 0 : pull.acceleration > 0;
  const double edge = forward ? 1 : 0;
  if (forward ? end.position < edge : end.position >= edge) {
    motion_ = end;
    return {at_most, 0};
  }
  const double seconds = passing_time(motion_, pull, edge, at_most, end.position - motion_.position);
  const int direction = forward ? 1 : -1;
  // On the edge, seen from the pulse that begins there.
  motion_ = {1 - edge, after(motion_, pull, seconds).velocity};
  count_ += direction;
  ++edges_;
  count(-direction);
  return {seconds, direction};
}

bool PulseLoop::comes_to_rest() const {
  const double rest = motion_.position + motion_.velocity / damping_;
  return difference_ == 0 && 0 <= rest && rest < 1;
}

}  // namespace leadscrew::servo
