#pragma once
// The registers of a circular DDA in one quadrant: nothing else is needed from clock to clock while both counters hold
// something.
//
// An integrator is kept as r + p − q, which is negative where the next clock gives no overflow: all but that sign, and
// what a step changes, is known a clock before.

#include <leadscrew/pulse/integrator.hpp>

namespace leadscrew::pulse {

template <typename Register>
struct BasicQuadrantRegisters {
  /// Registers of the integrator of one axis.
  struct AxisIntegrator {
    Register beyond = -1;    ///< r + p − q
    Register integrand = 0;  ///< p: |coordinate of the other axis|, with the capacity's binary places
    Register change = 0;     ///< what a step of the other axis adds to it
    Register left = 0;       ///< the counter
    std::int8_t sign = 0;
  };
  AxisIntegrator first, second;  ///< in the order in which they are clocked
  Register capacity = 1;
  Register sees_new = -1;  ///< a mask: does the second integrator see the first axis' new coordinate?
  bool x_is_first = true;

  constexpr const AxisIntegrator& x() const { return x_is_first ? first : second; }
  constexpr const AxisIntegrator& y() const { return x_is_first ? second : first; }
  constexpr AxisIntegrator& x() { return x_is_first ? first : second; }
  constexpr AxisIntegrator& y() { return x_is_first ? second : first; }

  constexpr bool goes_on() const { return first.left > 0 && second.left > 0; }

  /// One clock of both integrators; while it goes on.
  [[gnu::always_inline]] constexpr Pulse<2> step() {
    if constexpr (prefers_branches<Register>) {
      return step_by_branches();
    } else {
      const Register first_waits = where_negative(first.beyond), change = second.change & ~first_waits;
      const Register seen = second.beyond + (change & sees_new);
      const Register second_waits = where_negative(seen);
      second.integrand += change;
      second.beyond = (seen + (second.integrand - capacity)) + (capacity & second_waits);
      const Register follows = first.change & ~second_waits;
      first.beyond = ((first.beyond + (first.integrand - capacity)) + (capacity & first_waits)) + follows;
      first.integrand += follows;
      first.left += ~first_waits;
      second.left += ~second_waits;
      return pulse_of(static_cast<std::int8_t>(first.sign & ~first_waits),
                      static_cast<std::int8_t>(second.sign & ~second_waits));
    }
  }

  /// One clock of the integrator of one axis alone, whose counter is not 0: does it overflow?
  constexpr bool step(AxisIntegrator& alone) const {
    const bool overflows = alone.beyond >= 0;
    alone.beyond = static_cast<Register>(alone.beyond + alone.integrand - (overflows ? capacity : 0));
    return overflows;
  }

  constexpr BasicIntegrator<Register> integrator(const AxisIntegrator& side) const {
    return {capacity, static_cast<Register>(side.beyond - side.integrand + capacity)};
  }

 private:
  constexpr Pulse<2> pulse_of(std::int8_t one, std::int8_t other) const {
    return x_is_first ? Pulse<2>{{one, other}} : Pulse<2>{{other, one}};
  }

  [[gnu::always_inline]] constexpr Pulse<2> step_by_branches() {
    std::int8_t one = 0, other = 0;
    auto first_beyond = static_cast<Register>(first.beyond + first.integrand);
    if (first.beyond >= 0) {
      one = first.sign;
      --first.left;
      first_beyond = static_cast<Register>(first_beyond - capacity);
      second.integrand = static_cast<Register>(second.integrand + second.change);
      if (sees_new) second.beyond = static_cast<Register>(second.beyond + second.change);
    }
    auto second_beyond = static_cast<Register>(second.beyond + second.integrand);
    if (second.beyond >= 0) {
      other = second.sign;
      --second.left;
      second_beyond = static_cast<Register>(second_beyond - capacity);
      first.integrand = static_cast<Register>(first.integrand + first.change);
      first_beyond = static_cast<Register>(first_beyond + first.change);
    }
    first.beyond = first_beyond;
    second.beyond = second_beyond;
    return pulse_of(one, other);
  }
};
using QuadrantRegisters = BasicQuadrantRegisters<std::int64_t>;

}  // namespace leadscrew::pulse
