#pragma once
// Numbers for files: 17 significant digits, which give every double back bit for bit.

#include <cstddef>
#include <cstdint>

namespace leadscrew::base {

/// Room that write_digits and write_integer need at most.
inline constexpr std::size_t digits_room = 32;

/// Writes `value` as printf's %.17g would in the C locale and returns the end. `at` has digits_room bytes.
char* write_digits(char* at, double value);

/// Writes an integer and returns the end.
char* write_integer(char* at, std::int64_t value);

}  // namespace leadscrew::base
