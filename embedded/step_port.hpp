#pragma once
// A port with the pins of a grbl shield: X step 2, Y step 3, X direction 5, Y direction 6; a direction pin is high
// where the axis steps to the negative side.

#include <leadscrew/pulse/pulse.hpp>

namespace leadscrew::embedded {

inline constexpr std::uint8_t step_pins = 0b0000'1100, direction_pins = 0b0110'0000;

/// What the port shows for a pulse.
[[gnu::always_inline]] constexpr std::uint8_t port_of(const pulse::Pulse<2>& pulse) {
  const auto x = static_cast<std::uint8_t>(pulse.step[0]), y = static_cast<std::uint8_t>(pulse.step[1]);
  return static_cast<std::uint8_t>((x & 1) << 2 | (y & 1) << 3 | (x & 0x20) | (y & 0x40));  // −1 is 0xFF
}

/// The pulse that the port shows.
constexpr pulse::Pulse<2> pulse_of(std::uint8_t port) {
  const auto step = [=](int step_pin, int direction_pin) {
    if ((port >> step_pin & 1) == 0) return std::int8_t{0};
    return (port >> direction_pin & 1) != 0 ? std::int8_t{-1} : std::int8_t{1};
  };
  return {{step(2, 5), step(3, 6)}};
}

}  // namespace leadscrew::embedded
