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

/// Whether a dialect is Fanuc's, or what is common to it and Haas'.
constexpr bool is_of_fanuc_family(Dialect dialect) {
  return dialect == Dialect::fanuc || dialect == Dialect::fanuc_lathe || dialect == Dialect::haas;
}

/// Whether P of G10 with this L names one of the further systems, of G54.1 or G154.
constexpr bool is_further_system(double kind, Dialect dialect) {
  return kind == 20 && is_of_fanuc_family(dialect);
}

/// A set of dialects.
struct Dialects {
  std::uint8_t bits = 0;

  constexpr Dialects() = default;
  constexpr Dialects(std::initializer_list<Dialect> dialects) {
    for (const Dialect dialect : dialects) bits |= static_cast<std::uint8_t>(1u << index(dialect));
  }
  constexpr bool has(Dialect dialect) const { return (bits >> index(dialect)) & 1u; }
  constexpr bool empty() const { return bits == 0; }
  constexpr Dialects without(Dialect dialect) const {
    Dialects rest = *this;
    rest.bits = static_cast<std::uint8_t>(rest.bits & ~(1u << index(dialect)));
    return rest;
  }
  friend constexpr Dialects operator|(Dialects a, Dialects b) {
    a.bits |= b.bits;
    return a;
  }
};

}  // namespace leadscrew::gcode
