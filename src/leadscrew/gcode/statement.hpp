#pragma once
// Lines that say which block comes next: O words (LinuxCNC manual, "O Codes"), program numbers, and the statements of
// custom macros (Fanuc's "Custom Macro B": IF, WHILE, DO, END, GOTO).
//
//     N10 o<name> while [#1 LT 5]  (remark)            IF [#1 EQ 2] GOTO 100
//         │ └name └keyword └rest                       └keyword └rest

#include <array>
#include <cstdint>
#include <leadscrew/gcode/codes.hpp>
#include <leadscrew/gcode/expression.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace leadscrew::gcode {

/// What a statement does.
enum class Keyword : std::uint8_t {
  none,     ///< no statement
  program,  ///< O1000 alone: the number of a program, which begins here
  sub,
  endsub,
  call,
  return_,
  if_,
  elseif,
  else_,
  endif,
  while_,
  endwhile,
  do_,
  repeat,
  endrepeat,
  break_,
  continue_,
  unknown,  ///< an O word with something else behind it
  // of macros
  macro_if,
  macro_while,
  macro_do,
  macro_end,
  go_to,
  macro_call,  ///< G65
  modal_call,  ///< G66
};

/// As messages call it: "endwhile".
std::string_view name(Keyword keyword);

/// The name of an O word: o100 and o[99+1] are numbers, o<name> others.
using StatementName = std::uint64_t;

struct Statement {
  Keyword keyword = Keyword::none;
  StatementName name = 0;      ///< of an O word; the number of DO and END
  std::int64_t column = 0;     ///< where it begins
  const char* rest = nullptr;  ///< what stands behind the keyword
};

namespace detail {
/// What a line's first character says of it: block, perhaps GOTO, G65 or G66, or look on.
enum class LineStart : std::uint8_t { block, g, number, other };

constexpr std::array<LineStart, 256> make_line_starts() {
  std::array<LineStart, 256> made{};
  for (const char c : std::string_view(" \t\r/oO:iIwWdDeE")) made[static_cast<unsigned char>(c)] = LineStart::other;
  made['G'] = made['g'] = LineStart::g;
  made['N'] = made['n'] = LineStart::number;
  return made;
}
inline constexpr std::array<LineStart, 256> line_starts = make_line_starts();
}  // namespace detail

/// Reads statements, and knows the names in them.
class StatementReader {
 public:
  static constexpr std::size_t most_names = 10'000;

  StatementReader(ExpressionReader& values, Reporter& reporter, Dialect dialect, bool block_delete)
      : values_(values),
        reporter_(reporter),
        macros_(is_of_fanuc_family(dialect)),
        has_macro_calls_(g_code(dialect, 650) == Code::G65),
        has_modal_calls_(g_code(dialect, 660) == Code::G66),
        block_delete_(block_delete) {}

  /// Whether the line may be a statement: lines of words are told by a look at their first letter.
  bool may_be(const TextLine& line) const {
    const char* p = line.text;
    detail::LineStart start = detail::line_starts[static_cast<unsigned char>(*p)];
    if (start == detail::LineStart::number) {
      do ++p;
      while (is_digit(*p) || is_blank(*p));
      start = detail::line_starts[static_cast<unsigned char>(*p)];
    }
    if (start == detail::LineStart::block) return false;
    if (start == detail::LineStart::g) return (p[1] | 0x20) == 'o' || p[1] == '6';
    return is_likely(line.text);
  }

  /// Reads what the line says, up to behind its keyword. False where it has reported an error; keyword `none` where the
  /// line is a block.
  bool read(const TextLine& line, Statement& statement);
  /// The number of the block, where the line begins with one; −1 where it does not.
  std::int64_t block_number(const TextLine& line) const;

  /// Reads a number that stands for a name: `o100`, `P100`. Reports a value that is none.
  bool number(double value, std::int64_t column, StatementName& name);
  /// Behind a '/' and the number of the block.
  const char* behind_number(const char* p) const;
  /// "o100", "o<name>"
  std::string text(StatementName name) const;
  /// The name alone: "100", "name".
  std::string file_name(StatementName name) const;
  bool has_macros() const { return macros_; }

 private:
  bool is_likely(const char* p) const;
  bool read_o_word(const char* p, Statement& statement);
  bool read_program_number(const char* p, Statement& statement);
  bool read_name(const char*& p, StatementName& name);
  bool read_bracketed_name(const char*& p, StatementName& name);
  bool read_macro_call(const char* p, Statement& statement) const;
  void read_macro(const char* p, Statement& statement) const;

  ExpressionReader& values_;
  Reporter& reporter_;
  bool macros_;           // IF, WHILE, DO, END, GOTO
  bool has_macro_calls_;  // G65
  bool has_modal_calls_;  // G66
  bool block_delete_;
  std::unordered_map<std::string, StatementName> numbers_;  // of names, from first_named on
  std::vector<std::string> names_;
};

}  // namespace leadscrew::gcode
