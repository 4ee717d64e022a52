#pragma once
// Reference pulses: steps of one basic length unit (BLU), and what makes them.
//
//   load ─▶ state ──step()──▶ Pulse, clock by clock, until done()
//
// Everything here is integers of bounded size, without memory from the heap: what a microcontroller or a gate array
// does, register by register. Coordinates are BLU on the machine's lattice, arcs about the origin.

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

namespace leadscrew::pulse {

/// −1, 0 or +1 for each axis, at one clock.
template <std::size_t axes>
struct Pulse {
  std::array<std::int8_t, axes> step{};

  friend constexpr bool operator==(const Pulse&, const Pulse&) = default;
};

/// A place on the lattice, BLU.
struct Point {
  std::int64_t x = 0, y = 0;

  friend constexpr bool operator==(const Point&, const Point&) = default;
};

/// As seen from the positive end of the third axis.
enum class Direction : std::int8_t { clockwise = -1, counterclockwise = 1 };  // G2, G3

/// Greatest |coordinate| that an interpolator takes, BLU: squares, and radii with 16 binary places, fit in its
/// registers.
inline constexpr std::int64_t greatest_coordinate = std::int64_t{1} << 30;

/// A state machine that makes one pulse a clock. Once it is done, further steps are none.
template <typename State>
concept Interpolator = requires(State state, const State looked_at) {
  { state.step() } -> std::same_as<Pulse<State::axes>>;
  { looked_at.done() } -> std::same_as<bool>;
};

constexpr std::int64_t absolute(std::int64_t value) {
  return value < 0 ? -value : value;
}
constexpr std::int8_t sign(std::int64_t value) {
  return static_cast<std::int8_t>((value > 0) - (value < 0));
}

/// √n with `places` binary places, rounded to the nearest; 0 ≤ n < 2⁶², places ≤ 16. Digit by digit.
constexpr std::int64_t root(std::int64_t n, int places) {
  std::int64_t digits = 0, rest = 0;
  // Two bits of n for each digit of its root; behind the point they are 0. One digit more says how to round.
  for (int pair = 30; pair >= -places - 1; --pair) {
    rest = 4 * rest + (pair >= 0 ? (n >> (2 * pair)) & 3 : 0);
    const std::int64_t tried = 4 * digits + 1;
    digits *= 2;
    if (rest >= tried) {
      rest -= tried;
      ++digits;
    }
  }
  return (digits + 1) / 2;
}

}  // namespace leadscrew::pulse
