#pragma once
// The axes of a machine under pulse-driven loops: steps that follow words count each axis' up-down counter up, and the
// pulses of its encoder, one a BLU, down.
//
//   words ──▶ StepGenerator ──steps, one by one──▶ PulseLoop of each axis ──▶ where the slides were at the word
//
// Of a machine's drives, the position gain is Kv [40/s] and the time constant that of motor and tachogenerator
// [1/(4·Kv), with which the loop is critically damped]. Slides stand half a BLU past an encoder's edge at first, so
// that a step has the same margin in both directions. Play and friction are left out.

#include <array>
#include <cstdint>
#include <leadscrew/base/result.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/servo/pulse_loop.hpp>
#include <leadscrew/servo/servo.hpp>
#include <leadscrew/steps/step_generator.hpp>
#include <optional>
#include <span>

namespace leadscrew::servo {

class PulseServo {
 public:
  static constexpr std::int64_t step_clock = 1'000'000;  ///< Hz

  /// For each axis the machine has, at its period. Codes: `servo-pulse-loop`, and those of
  /// steps::validate().
  static base::Result<PulseServo> create(const machine::Machine& machine);

  /// Words of successive periods; positions and velocities at the word before. Empty for the first word; after the
  /// last, repeat it for as long as the axes should come closer.
  std::optional<Followed> follow(const base::Word& word);

  /// 1/Kv of the slowest axis, seconds.
  double longest_lag() const { return longest_lag_; }
  /// Null where the machine has no such axis.
  const PulseLoop* loop(base::Axis axis) const {
    const auto& held = axes_[base::index(axis)];
    return held ? &held->loop : nullptr;
  }

 private:
  struct OfAxis {
    PulseLoop loop;
    double blu = 1;
    double time = 0;  // s, since the first word, that the loop has run
  };

  PulseServo(steps::StepGenerator generator, double period) : generator_(std::move(generator)), period_(period) {}
  void take(std::span<const steps::StepEvent> events);
  static void run_until(OfAxis& axis, double time);

  steps::StepGenerator generator_;
  double period_;
  std::array<std::optional<OfAxis>, base::axis_count> axes_;
  double longest_lag_ = 0;
  base::AxisVector origin_{};
  std::optional<base::Word> before_;
  std::int64_t words_ = 0;
};

}  // namespace leadscrew::servo
