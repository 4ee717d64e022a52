#pragma once
// The line of the part program that something comes from.

#include <cstdint>

namespace leadscrew::base {

/// Line of the source text, counted from 1; 0 before the first.
enum class Line : std::int64_t {};

constexpr std::int64_t number(Line line) {
  return static_cast<std::int64_t>(line);
}

}  // namespace leadscrew::base
