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

/// Four digits.
inline std::string rounded_text(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 4);
  return {buffer, end.ptr};
}

}  // namespace leadscrew::base
