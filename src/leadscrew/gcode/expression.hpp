#pragma once
// Real values of RS274/NGC (NIST IR 6556, 3.3.2): numbers, parameters, expressions in brackets, and functions of them.
//
// The operators and functions are those of operations.hpp. Angles are degrees. A numbered parameter that was never set
// is 0 (LinuxCNC manual, "Parameters"), in Fanuc's macros vacant; a name that was never set is an error.

#include <leadscrew/gcode/number.hpp>
#include <leadscrew/gcode/operations.hpp>
#include <leadscrew/gcode/parameters.hpp>
#include <leadscrew/gcode/predefined.hpp>
#include <leadscrew/gcode/reporter.hpp>
#include <limits>
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

  /// A value that is none: of a variable of Fanuc's macros that was not set.
  static constexpr double vacant = std::numeric_limits<double>::quiet_NaN();

  ExpressionReader(const Parameters& parameters, const Predefined& predefined, Reporter& reporter,
                   const ReaderOptions& options)
      : parameters_(parameters),
        predefined_(predefined),
        reporter_(reporter),
        dialect_(options.dialect),
        warns_of_unset_(options.warns_of_unset) {}

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

  /// The value that a parameter is set to: but for LinuxCNC's an expression, which needs no brackets (Fanuc).
  bool assigned_value(const char*& p, double& value) {
    return dialect_ == Dialect::linuxcnc ? any_value(p, value, 0) : binary(p, value, 1, 0);
  }

  /// What follows '#'; p is behind it. Number 0 is Fanuc's vacant.
  bool parameter_name(const char*& p, ParameterName& name, int depth = 0);

 private:
  static constexpr double largest_ = 1.7976931348623157e308;

  [[gnu::noinline]] bool any_value(const char*& p, double& value, int depth);
  static bool plain_number(const char*& p, double& value);
  static bool plain_index(const char*& p, int& number);
  bool joined_number(const char*& p, double& value);
  bool bracketed(const char*& p, double& value, int depth);
  bool binary(const char*& p, double& value, int loosest, int depth);
  bool function(const char*& p, double& value, int depth);
  bool exists(const char*& p, double& value, int depth);
  bool parameter(const char*& p, double& value, int depth);

  bool numbered(int number, const char* begin, double& value);
  [[gnu::cold]] bool never_set(int number, const char* begin, double& value);
  bool named(const std::string& name, const char* begin, double& value);
  [[gnu::cold]] bool refuse_macro_number(int number, const char* begin);

  const Parameters& parameters_;
  const Predefined& predefined_;
  Reporter& reporter_;
  Dialect dialect_;
  bool warns_of_unset_;
  std::string joined_;  // a number written with blanks in it, without them
};

}  // namespace leadscrew::gcode
