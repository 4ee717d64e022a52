#pragma once
// The block of the part program that something comes from.
//
//     63        44 43      32 31                     0
//     ┌───────────┬──────────┬────────────────────────┐
//     │   visit   │   file   │          line          │
//     └───────────┴──────────┴────────────────────────┘
//
// A line is executed more than once where a program has loops and subprograms, which may be files of their own. So the
// identity of a block, by which == compares, is its file, its line and its visit: how many times control had gone back
// or to another place of the text before. In a program without loops and subprograms it is the line alone.

#include <algorithm>
#include <cstdint>

namespace leadscrew::base {

/// Line of the source text, counted from 1; 0 before the first. With file and visit where the text has more than one.
enum class Line : std::int64_t {};

inline constexpr int line_bits = 32;                                           ///< of its number in the text
inline constexpr int file_bits = 12;                                           ///< of its text
inline constexpr int visit_bits = 20;                                          ///< of its visit
inline constexpr std::int64_t last_line = (std::int64_t{1} << line_bits) - 1;  ///< lines beyond count as this one
inline constexpr int last_file = (1 << file_bits) - 1;                         ///< of the texts of a program
inline constexpr int last_visit = (1 << visit_bits) - 1;                       ///< 0 follows it

/// Of the line in its text, as people count: 1 …
constexpr std::int64_t number(Line line) {
  return static_cast<std::int64_t>(line) & last_line;
}

/// Of the text: 0 is the program's own, others are those of its subprograms, by the order in which they were opened.
constexpr int file(Line line) {
  return static_cast<int>(static_cast<std::int64_t>(line) >> line_bits) & last_file;
}

/// 0 … last_visit.
constexpr int visit(Line line) {
  return static_cast<int>(static_cast<std::int64_t>(line) >> (line_bits + file_bits)) & last_visit;
}

/// number ≥ 0, file 0 … last_file; of the visit its last 20 bits.
constexpr Line line_at(std::int64_t number, int file = 0, std::int64_t visit = 0) {
  const auto bits = static_cast<std::uint64_t>(visit & last_visit) << (line_bits + file_bits) |
                    static_cast<std::uint64_t>(file) << line_bits;
  return Line{static_cast<std::int64_t>(bits) | std::min(number, last_line)};
}

/// Where it stands in the text, whichever visit it is.
constexpr Line place_of(Line line) {
  return line_at(number(line), file(line));
}

/// Is a executed before b? Where they are less than half a million visits apart.
constexpr bool is_before(Line a, Line b) {
  const int visits = (visit(b) - visit(a)) & last_visit;
  return visits == 0 ? number(a) < number(b) : visits <= last_visit / 2;
}

}  // namespace leadscrew::base
