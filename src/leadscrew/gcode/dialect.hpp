#pragma once
// The dialects of G-code that are read, and sets of them.

#include <cstdint>
#include <initializer_list>
#include <leadscrew/machine/dialect.hpp>

namespace leadscrew::gcode {

using machine::Dialect;
using machine::dialect_of;
using machine::index;
using machine::name;

/// A set of dialects.
struct Dialects {
  std::uint8_t bits = 0;

  constexpr Dialects() = default;
  constexpr Dialects(std::initializer_list<Dialect> dialects) {
    for (const Dialect dialect : dialects) bits |= static_cast<std::uint8_t>(1u << index(dialect));
  }
  constexpr bool has(Dialect dialect) const { return (bits >> index(dialect)) & 1u; }
  constexpr bool empty() const { return bits == 0; }
  friend constexpr Dialects operator|(Dialects a, Dialects b) {
    a.bits |= b.bits;
    return a;
  }
};

}  // namespace leadscrew::gcode
