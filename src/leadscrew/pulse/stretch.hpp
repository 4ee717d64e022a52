#pragma once
// Interpolators clock by clock, as fast as they can be run.

#include <leadscrew/pulse/pulse.hpp>

namespace leadscrew::pulse {

/// An interpolator most of whose way takes few registers: stretch() copies them, to be stepped by themselves as long as
/// they go on, and to be given back then. So few can be kept in the processor's.
template <typename State>
concept Stretched = Interpolator<State> && requires(State state) { state.give_back(state.stretch()); };

/// Steps it until it is done, or as long as take(state) says, which makes one clock of what it is given.
template <Interpolator State, typename Take>
[[gnu::always_inline]] constexpr void step_through(State& state, const Take& take) {
  while (!state.done()) {
    if constexpr (Stretched<State>) {
      auto stretch = state.stretch();
      bool goes_on = true;
      const bool has_begun = stretch.goes_on();
      while (goes_on && stretch.goes_on()) goes_on = take(stretch);
      if (has_begun) state.give_back(stretch);
      if (!goes_on) return;
      if (has_begun) continue;
    }
    if (!take(state)) return;
  }
}

}  // namespace leadscrew::pulse
