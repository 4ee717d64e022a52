#pragma once
// One block as it was written: its words with their values and columns, before any of them has a meaning.

#include <array>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/gcode/codes.hpp>

namespace leadscrew::gcode {

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
  std::uint32_t words = 0;   ///< bits of the letters that stand in the block, other than G and M, and of @ ^ $
  std::uint32_t groups = 0;  ///< bits of the groups of its codes
  std::array<double, word_marks.size()> value;          ///< of each word; meaningless without its bit
  std::array<std::uint32_t, word_marks.size()> column;  ///< of each word
  std::array<Code, index(Group::count)> codes;
  std::array<std::uint32_t, index(Group::count)> code_columns;
  std::int16_t user_code =
      0;  ///< which number of Code::M100: 100 … 199, of Fanuc and Haas 10 … 199; of Code::G150 41, 42 or 0
  std::int16_t further_system = 0;  ///< of Code::G110: 1 … 20
  std::uint32_t first_column = 1;   ///< of the first word
  bool complete = true;             ///< the line was read to its end; otherwise words may be missing

  bool has(char letter) const { return words & letter_bit(letter); }
  double operator[](char letter) const { return value[mark_index(letter)]; }
  double value_or(char letter, double otherwise) const { return has(letter) ? (*this)[letter] : otherwise; }
  std::uint32_t column_of(char letter) const { return column[mark_index(letter)]; }
  bool has(Group group) const { return groups & bit(group); }
  /// The code of a group, or Code::none.
  Code code(Group group) const { return has(group) ? codes[index(group)] : Code::none; }
  bool is(Code one) const { return code(row(one).group) == one; }
  std::uint32_t column_of(Group group) const { return code_columns[index(group)]; }

  void clear() {
    words = groups = 0;
    complete = true;
  }
};

}  // namespace leadscrew::gcode
