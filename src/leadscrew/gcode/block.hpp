#pragma once
// One block as it was written: its words with their values and columns, before any of them has a meaning.

#include <array>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/gcode/codes.hpp>

namespace leadscrew::gcode {

constexpr std::uint32_t letter_bit(char letter) {
  return std::uint32_t{1} << (letter - 'A');
}

/// A set of letters, written as text: "IJK".
struct Letters {
  std::uint32_t bits = 0;

  constexpr Letters(const char* text) {
    for (; *text != 0; ++text) bits |= letter_bit(*text);
  }
  constexpr bool has(char letter) const { return bits & letter_bit(letter); }
};

namespace detail {
constexpr std::array<base::Axis, 26> make_axis_letters() {
  std::array<base::Axis, 26> axes{};
  for (const base::Axis axis : base::all_axes) axes[static_cast<std::size_t>(base::letter(axis) - 'A')] = axis;
  return axes;
}
inline constexpr std::array<base::Axis, 26> axis_letters = make_axis_letters();
}  // namespace detail

/// The axis of a letter that names one, by the letter's place in the alphabet.
constexpr base::Axis axis_of_letter(unsigned letter) {
  return detail::axis_letters[letter];
}

inline constexpr std::uint32_t axis_letter_bits = letter_bit('X') | letter_bit('Y') | letter_bit('Z') |
                                                  letter_bit('A') | letter_bit('B') | letter_bit('C') |
                                                  letter_bit('U') | letter_bit('V') | letter_bit('W');

struct Block {
  std::uint32_t words = 0;               ///< bits of the letters that stand in the block, other than G and M
  std::uint32_t g_groups = 0;            ///< bits of the groups of its G codes
  std::uint32_t m_groups = 0;            ///< bits of the groups of its M codes
  std::array<double, 26> value;          ///< of each word; meaningless without its bit
  std::array<std::uint32_t, 26> column;  ///< of each word
  std::array<GCode, index(Group::count)> g;
  std::array<std::uint32_t, index(Group::count)> g_column;
  std::array<std::uint8_t, 10> m;
  std::array<std::uint32_t, 10> m_column;
  std::uint32_t first_column = 1;  ///< of the first word
  bool complete = true;            ///< the line was read to its end; otherwise words may be missing

  bool has(char letter) const { return words & letter_bit(letter); }
  double operator[](char letter) const { return value[static_cast<std::size_t>(letter - 'A')]; }
  double value_or(char letter, double otherwise) const { return has(letter) ? (*this)[letter] : otherwise; }
  std::uint32_t column_of(char letter) const { return column[static_cast<std::size_t>(letter - 'A')]; }
  bool has(Group group) const { return g_groups & bit(group); }
  /// The code of a group, or -1.
  GCode code(Group group) const { return has(group) ? g[index(group)] : GCode{-1}; }
  std::uint32_t column_of(Group group) const { return g_column[index(group)]; }
  bool has_m(int group) const { return (m_groups >> group) & 1u; }

  void clear() {
    words = g_groups = m_groups = 0;
    complete = true;
  }
};

}  // namespace leadscrew::gcode
