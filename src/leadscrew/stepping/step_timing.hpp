#pragma once
// What drives ask of step and direction signals, and whether a step clock can give it.
//
//              length   space
//             ┌──────┐        ┌──────┐             ┌──────┐
//   step   ───┘      └────────┘      └─────────────┘      └───
//                                     hold │ setup
//   direction ─────────────────────────────┴──────────────────

#include <cstdint>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/machine/machine.hpp>
#include <vector>

namespace leadscrew::stepping {

struct StepTiming {
  std::int64_t clock_hz = 1'000'000;       ///< 10 kHz … 10 MHz; all edges lie on its ticks
  std::int64_t step_length_ns = 1000;      ///< at least; 1 … 10⁹
  std::int64_t step_space_ns = 1000;       ///< at least, between the steps of an axis; 1 … 10⁹
  std::int64_t direction_setup_ns = 1000;  ///< at least, from a change of direction to the next step; 0 … 10⁹
  std::int64_t direction_hold_ns = 1000;   ///< at least, from a step's end to a change of direction; 0 … 10⁹
};

/// The same in whole ticks, rounded up.
struct StepTicks {
  std::int64_t length = 1;
  std::int64_t space = 1;
  std::int64_t setup = 0;
  std::int64_t hold = 0;

  /// From step to step of an axis, at least.
  std::int64_t pitch() const { return length + space; }
  /// From a step to one the other way, at least.
  std::int64_t reversal() const { return pitch() > length + hold + setup ? pitch() : length + hold + setup; }
};

/// Timing must be valid.
StepTicks in_ticks(const StepTiming& timing);

/// Every way in which timing and machine contradict the ranges above or each other: an axis at its greatest velocity
/// must not need more steps a second than clock and times give. Codes: `step-clock`, `step-time`, `step-rate`,
/// `step-range`. The machine must be sound.
std::vector<base::Diagnostic> validate(const StepTiming& timing, const machine::Machine& machine);

}  // namespace leadscrew::stepping
