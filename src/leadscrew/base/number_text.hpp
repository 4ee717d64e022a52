#pragma once
// Numbers in messages.

#include <charconv>
#include <string>

namespace leadscrew::base {

/// The fewest digits that are read back as the same number.
inline std::string text(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value);
  return {buffer, end.ptr};
}

/// At most so many digits, 1 … 17, as printf's %g.
inline std::string text(double value, int digits) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits);
  return {buffer, end.ptr};
}

/// Four digits.
inline std::string rounded_text(double value) {
  return text(value, 4);
}

/// With so many decimals, 0 … 17.
inline std::string fixed_text(double value, int decimals) {
  char buffer[400];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals);
  return {buffer, end.ptr};
}

}  // namespace leadscrew::base
