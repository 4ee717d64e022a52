#pragma once
// The text of a machine file, before and beside parsing: where it nests too deep for parsers that recurse, and the
// parts of it that messages show.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace leadscrew::config {

/// Brackets and braces that are open at once, and dots of one key or table header.
inline constexpr int deepest_nesting = 16;

/// The byte at which the text first nests deeper; empty where it never does. Of text that is no TOML this holds up to
/// the first error of its syntax.
std::optional<std::size_t> find_deep_nesting(std::string_view text);

/// Both from 1; columns in bytes.
struct TextPosition {
  std::uint32_t line = 0, column = 0;
};
TextPosition position_of(std::string_view text, std::size_t byte);

/// Line `number`, from 1, or the first 4096 bytes of it; empty where there is none.
std::string line_of(std::string_view text, std::int64_t number);

/// A key or a word of the file as messages have it: not more than 64 bytes of it.
std::string shown(std::string_view text);

}  // namespace leadscrew::config
