#pragma once
// The registers of a circular DDA in one quadrant: nothing else is needed from clock to clock while both counters hold
// something.
//
// An integrator is kept as r + p − q, which is negative where the next clock gives no overflow: all but that sign, and
// what a step changes, is known a clock before. There are no branches: the processor would mispredict them.

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
    const Register first_waits = where_negative(first.beyond);
    const auto change = static_cast<Register>(second.change & ~first_waits);
    const auto seen = static_cast<Register>(second.beyond + (change & sees_new));
    const Register second_waits = where_negative(seen);
    second.integrand = static_cast<Register>(second.integrand + change);
    second.beyond = static_cast<Register>((seen + (second.integrand - capacity)) + (capacity & second_waits));
    const auto follows = static_cast<Register>(first.change & ~second_waits);
    first.beyond =
        static_cast<Register>(((first.beyond + (first.integrand - capacity)) + (capacity & first_waits)) + follows);
    first.integrand = static_cast<Register>(first.integrand + follows);
    first.left = static_cast<Register>(first.left + ~first_waits);
    second.left = static_cast<Register>(second.left + ~second_waits);
    const auto one = static_cast<std::int8_t>(first.sign & ~first_waits);
    const auto other = static_cast<std::int8_t>(second.sign & ~second_waits);
    return x_is_first ? Pulse<2>{{one, other}} : Pulse<2>{{other, one}};
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
};
using QuadrantRegisters = BasicQuadrantRegisters<std::int64_t>;

}  // namespace leadscrew::pulse
