#pragma once
// Reference pulses: steps of one basic length unit (BLU), and what makes them.
//
//   load ─▶ state ──step()──▶ Pulse, clock by clock, until done()
//
// Everything here is integers of bounded size, without memory from the heap: what a microcontroller or a gate array
// does, register by register. Coordinates are BLU on the machine's lattice, arcs about the origin.
//
// `Register` is the type of those registers: std::int64_t in this program, std::int16_t or std::int32_t on a
// microcontroller, where each byte of a register costs time (embedded/). The steps are the same where the coordinates
// are within greatest_coordinate_of<Register>. Names without `Basic` are those of 64 bits.

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
template <typename Register>
struct BasicPoint {
  Register x = 0, y = 0;

  friend constexpr bool operator==(const BasicPoint&, const BasicPoint&) = default;
};
using Point = BasicPoint<std::int64_t>;

/// As seen from the positive end of the third axis.
enum class Direction : std::int8_t { clockwise = -1, counterclockwise = 1 };  // G2, G3

/// What holds squares of coordinates.
template <typename Register>
struct SquareOf {
  using Type = std::int64_t;
};
template <>
struct SquareOf<std::int16_t> {
  using Type = std::int32_t;
};
template <typename Register>
using Square = typename SquareOf<Register>::Type;

/// Does a branch cost less than a mask? On a microcontroller, which predicts none and masks byte by byte; elsewhere one
/// that depends on the path would be mispredicted every third clock.
template <typename Register>
inline constexpr bool prefers_branches = sizeof(Register) < sizeof(std::int64_t);

/// Greatest |coordinate| that an interpolator with such registers takes, BLU: sums of six coordinates fit in a register
/// (CircularSearch compares F + 2|x| + 2|y|), squares in a Square. With 64 bits: squares, and radii with 16 binary
/// places. 2¹² for 16 bits, 2²⁸ for 32, 2³⁰ for 64.
template <typename Register>
inline constexpr Register greatest_coordinate_of =
    Register(Register{1} << (sizeof(Register) == 8 ? 30 : 8 * sizeof(Register) - 4));
inline constexpr std::int64_t greatest_coordinate = greatest_coordinate_of<std::int64_t>;

/// A state machine that makes one pulse a clock. Once it is done, further steps are none.
template <typename State>
concept Interpolator = requires(State state, const State looked_at) {
  { state.step() } -> std::same_as<Pulse<State::axes>>;
  { looked_at.done() } -> std::same_as<bool>;
};

template <std::signed_integral Number>
constexpr Number absolute(Number value) {
  return value < 0 ? static_cast<Number>(-value) : value;
}
template <std::signed_integral Number>
constexpr std::int8_t sign(Number value) {
  return static_cast<std::int8_t>((value > 0) - (value < 0));
}
/// −1 where it is negative, else 0.
template <std::signed_integral Number>
constexpr Number where_negative(Number value) {
  return static_cast<Number>(value >> (8 * sizeof(Number) - 1));
}

/// √n with `places` binary places, rounded to the nearest; 0 ≤ n < 2⁶² (2³⁰ for 32 bits), places ≤ 16 (0). Digit by
/// digit.
template <std::signed_integral Number>
constexpr Number root(Number n, int places) {
  constexpr int top = 8 * static_cast<int>(sizeof(Number)) - 4;  // the first two bits of n
  constexpr auto below = static_cast<Number>((Number{1} << top) - 1);
  Number digits = 0, rest = 0;
  // Two bits of n for each digit of its root; behind the point they are 0. One digit more says how to round.
  for (int left = top / 2 + 2 + places; left > 0; --left) {
    rest = 4 * rest + ((n >> top) & 3);
    n = 4 * (n & below);
    const Number tried = 4 * digits + 1;
    digits *= 2;
    if (rest >= tried) {
      rest -= tried;
      ++digits;
    }
  }
  return (digits + 1) / 2;
}

}  // namespace leadscrew::pulse
