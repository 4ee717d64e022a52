#pragma once
// The operators and functions of expressions (LinuxCNC manual, "Binary Operators" and "Functions"; Fanuc custom macro
// B, "Arithmetic and Logic Operation").
//
// Operators bind, from tight to loose, equals from the left (2**3**2 is 64):
//
//     LinuxCNC       **    * / MOD    + -    EQ NE GT GE LT LE    AND OR XOR
//     Fanuc, Haas    * / MOD AND    + - OR XOR    EQ NE GT GE LT LE
//
// LinuxCNC's AND, OR and XOR are of truth values, FIX and FUP round down and up. Fanuc's are of the bits of whole numbers
// and round towards zero and away from it. A variable without a value, "vacant", is NaN here: it counts as 0, but for EQ
// and NE, which tell it from 0 (Fanuc).

#include <cstdint>
#include <leadscrew/gcode/dialect.hpp>
#include <leadscrew/gcode/number.hpp>
#include <string_view>

namespace leadscrew::gcode {

/// Whether a dialect has Fanuc's macros.
constexpr bool has_macros(Dialect dialect) {
  return is_of_fanuc_family(dialect);
}

enum class Operator : std::uint8_t {
  power,
  times,
  divide,
  modulo,
  plus,
  minus,
  equal,
  not_equal,
  greater,
  greater_equal,
  less,
  less_equal,
  both,
  either,
  one
};

struct OperatorName {
  std::string_view name;
  Operator operation;
  int level;        ///< how tightly it binds: 1 is loosest
  int macro_level;  ///< in Fanuc's macros; 0 where they lack it
};

enum class Function : std::uint8_t {
  abs,
  acos,
  asin,
  cos,
  exp,
  fix,
  fup,
  ln,
  round,
  sin,
  sqrt,
  tan,
  bin,
  bcd,
  atan,
  exists
};

struct FunctionName {
  std::string_view name;
  Function function;
  bool of_macros_only = false;
};

inline void skip_blanks(const char*& p) {
  while (is_blank(*p)) ++p;
}

constexpr char upper(char c) {
  return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

/// Whether the letters stand at p, in any case and with blanks between; p then moves behind them and the blanks there.
inline bool take_letters(const char*& p, std::string_view letters) {
  const char* q = p;
  for (const char c : letters) {
    skip_blanks(q);
    if (upper(*q) != c) return false;
    ++q;
  }
  p = q;
  skip_blanks(p);
  return true;
}

/// The operator that stands at p and binds as tightly as `loosest` or tighter, or nullptr; p then stands behind it.
const OperatorName* operator_at(const char*& p, int loosest, Dialect dialect);
/// How tightly it binds.
inline int level_of(const OperatorName& name, Dialect dialect) {
  return has_macros(dialect) ? name.macro_level : name.level;
}
/// The function whose name stands at p before '[', or nullptr; p then stands at the bracket.
const FunctionName* function_at(const char*& p, Dialect dialect);

/// Infinite or NaN where there is no result.
double apply(Operator operation, double a, double b, Dialect dialect);
/// The same; of all functions but ATAN and EXISTS, whose arguments are not one value.
double apply(Function function, double x, Dialect dialect);

}  // namespace leadscrew::gcode
