#pragma once
// Real values of RS274/NGC (NIST IR 6556, 3.3.2): numbers, parameters, expressions in brackets, and functions of them.
//
// Operators bind, from tight to loose: `**`, then `* / MOD`, then `+ -`, then `EQ NE GT GE LT LE`, then `AND OR XOR`;
// equals from the left (2**3**2 is 64), as in LinuxCNC. Angles are degrees. Numbers closer than 10⁻⁶ are EQ. MOD is
// never negative.

#include <leadscrew/gcode/frame.hpp>
#include <leadscrew/gcode/number.hpp>
#include <leadscrew/gcode/parameters.hpp>
#include <leadscrew/gcode/reporter.hpp>
#include <string>

namespace leadscrew::gcode {

/// Reads values from a line that ends in a line feed. Every function moves `p` behind what it has read and the blanks
/// after it, and returns false when it has reported an error.
class ExpressionReader {
 public:
  /// A parameter as it is named in the text: by number, or by name where the name is not empty.
  struct ParameterName {
    int number = 0;
    std::string name;
  };

  ExpressionReader(const Parameters& parameters, const Frame& frame, Reporter& reporter)
      : parameters_(parameters), frame_(frame), reporter_(reporter) {}

  /// Any real value. Plain numbers, nearly all there is, are read in place.
  [[gnu::always_inline]] bool value(const char*& p, double& value) {
    const char* q = p;
    while (is_blank(*q)) ++q;
    const bool negative = *q == '-';
    if (negative || *q == '+') ++q;
    const char* const end = scan_decimal(q, value);
    if (end != q) {
      q = end;
      while (is_blank(*q)) ++q;
      if (!is_digit(*q) && *q != '.' && value <= largest_) {
        if (negative) value = -value;
        p = q;
        return true;
      }
    }
    return any_value(p, value, 0);
  }

  /// What follows '#'; p is behind it.
  bool parameter_name(const char*& p, ParameterName& name, int depth = 0);

 private:
  static constexpr double largest_ = 1.7976931348623157e308;

  [[gnu::noinline]] bool any_value(const char*& p, double& value, int depth);
  bool joined_number(const char*& p, double& value);
  bool bracketed(const char*& p, double& value, int depth);
  bool binary(const char*& p, double& value, int loosest, int depth);
  bool function(const char*& p, double& value, int depth);
  bool exists(const char*& p, double& value, int depth);
  bool parameter(const char*& p, double& value, int depth);

  const Parameters& parameters_;
  const Frame& frame_;
  Reporter& reporter_;
  std::string joined_;  // a number written with blanks in it, without them
};

inline void skip_blanks(const char*& p) {
  while (is_blank(*p)) ++p;
}

constexpr char upper(char c) {
  return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

}  // namespace leadscrew::gcode
