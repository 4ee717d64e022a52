#pragma once
// Runs interpolators clock by clock, as fast as can be.

#include <leadscrew/pulse/pulse.hpp>

namespace leadscrew::pulse {

/// An interpolator that needs few of its registers along most of its path: stretch() copies these, to be stepped by
/// themselves as long as goes_on() says, and to be given back then. So few fit in the processor's registers.
template <typename State>
concept Stretched = Interpolator<State> && requires(State state) { state.give_back(state.stretch()); };

/// Steps it until it is done or take(state) returns false; take makes one clock of the state it is given.
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
