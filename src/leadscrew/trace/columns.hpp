#pragma once
// What the columns of a trace mean, and how a trace says what is wrong with it: shared by its two formats.

#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/diagnostic.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace leadscrew::trace {

/// What one column holds.
struct Column {
  enum class Kind : std::uint8_t { time, line, axis, other };
  Kind kind = Kind::other;
  base::Axis axis{};  ///< of Kind::axis

  friend bool operator==(const Column&, const Column&) = default;
};

/// By the column's name, in any case: `t`, `line`, an axis letter, or another.
Column column_named(std::string_view name);

/// Which of these columns tells the planned feed, mm/s or degrees/s: `feed`, where path length `s` stands beside it, as in
/// our traces. What other controllers call so may be anything.
std::optional<std::size_t> feed_column(std::span<const std::string> names);

/// Whole numbers up to here are exact as float64: the range of a line number.
inline constexpr double greatest_line = 9007199254740992.0;

base::Diagnostic problem(std::string_view code, std::string message, std::string hint, std::string_view file,
                         std::int64_t line = 0, std::int64_t column = 0, std::string_view source = {});

}  // namespace leadscrew::trace
