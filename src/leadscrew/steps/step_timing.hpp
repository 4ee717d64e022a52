#pragma once
// Whether a step clock can give what the drives of a machine ask of step and direction signals.

#include <cstddef>
#include <cstdint>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/machine/machine.hpp>
#include <vector>

namespace leadscrew::steps {

/// A drive's times in whole ticks, rounded up: all edges lie on ticks.
struct StepTicks {
  std::int64_t length = 1;
  std::int64_t space = 1;
  std::int64_t setup = 0;
  std::int64_t hold = 0;

  /// From step to step of an axis, at least.
  std::int64_t pitch() const { return length + space; }
  /// From a step to one in the other direction, at least.
  std::int64_t reversal() const { return pitch() > length + hold + setup ? pitch() : length + hold + setup; }
  /// Which times reversal() is made of, by their place in machine::all_step_times; all of them where both ways are as long.
  std::vector<std::size_t> limiting() const;
};

/// Times and clock must be valid.
StepTicks in_ticks(const machine::StepTimes& times, std::int64_t clock_hz);

/// The axis of the greatest reversal(), and that.
struct LongestReversal {
  std::int64_t ticks = 1;
  base::Axis axis = base::Axis::X;
};
LongestReversal longest_reversal(const machine::Machine& machine, std::int64_t clock_hz);

/// Every way in which a step clock, 10 kHz … 10 MHz, and the machine contradict each other: an axis at its greatest
/// velocity must not need more steps a second than clock and times give, and while its drive is given time to turn, it
/// must not leave its words by a BLU. Codes: `step-clock`, `step-rate`, `step-turn`, `step-range`. The machine must be
/// sound.
std::vector<base::Diagnostic> validate(std::int64_t clock_hz, const machine::Machine& machine);

}  // namespace leadscrew::steps
