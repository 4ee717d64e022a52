#include <array>
#include <cmath>
#include <iterator>
#include <leadscrew/gcode/expression.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <numbers>
#include <string_view>

namespace leadscrew::gcode {

namespace {

constexpr int deepest = 64;  // brackets within brackets
constexpr std::size_t longest_name = 255;
constexpr double degrees_per_radian = 180 / std::numbers::pi;

}  // namespace

bool ExpressionReader::any_value(const char*& p, double& value, int depth) {
  skip_blanks(p);
  if (depth > deepest) {
    return reporter_.error("nested-too-deep", reporter_.column(p),
                           "values are nested more than " + std::to_string(deepest) + " deep", "compute it in steps");
  }
  bool negative = false;
  const char* const begin = p;
  for (; *p == '+' || *p == '-'; skip_blanks(p)) negative ^= *p++ == '-';
  bool read = false;
  if (is_digit(*p) || *p == '.') {
    read = plain_number(p, value) || joined_number(p, value);
  } else if (*p == '[') {
    read = bracketed(p, value, depth + 1);
  } else if (*p == '#') {
    read = parameter(p, value, depth + 1);
  } else if ('A' <= upper(*p) && upper(*p) <= 'Z') {
    read = function(p, value, depth + 1);
  } else {
    const std::string found = *p == '\n' ? "the end of the line" : shown(*p);
    return reporter_.error("bad-number", reporter_.column(*p == '\n' ? begin : p),
                           found + " stands where a number should", "write a number, [an expression], or #a parameter");
  }
  if (!read) return false;
  if (negative) value = std::isnan(value) ? 0 : -value;
  skip_blanks(p);
  return true;
}

/// A number without blanks in it; false where it is none.
bool ExpressionReader::plain_number(const char*& p, double& value) {
  const char* q = scan_decimal(p, value);
  if (q == p) return false;
  skip_blanks(q);
  if (is_digit(*q) || *q == '.' || !(value <= largest_)) return false;
  p = q;
  return true;
}

/// The number of a parameter that is written as digits without blanks; false where it is not.
bool ExpressionReader::plain_index(const char*& p, int& number) {
  const char* q = p;
  int digits = 0;
  for (; is_digit(*q) && q - p < 5; ++q) digits = digits * 10 + (*q - '0');
  if (q == p) return false;
  skip_blanks(q);
  if (is_digit(*q) || *q == '.' || digits < 1 || digits > Parameters::last) return false;
  number = digits;
  p = q;
  return true;
}

bool ExpressionReader::joined_number(const char*& p, double& value) {
  const char* const begin = p;
  int points = 0;
  joined_.clear();
  for (; is_digit(*p) || *p == '.' || is_blank(*p); ++p) {
    if (is_blank(*p)) continue;
    points += *p == '.';
    joined_ += *p;
  }
  joined_ += '\n';
  const char* const last = joined_.data() + joined_.size() - 1;
  if (points > 1 || scan_decimal(joined_.data(), value) != last) {
    return reporter_.error("bad-number", reporter_.column(begin), "this is not a number",
                           "digits with at most one decimal point");
  }
  if (!(value <= largest_)) {
    return reporter_.error("bad-number", reporter_.column(begin), "this number is too large", "at most 1.79e308");
  }
  return true;
}

bool ExpressionReader::bracketed(const char*& p, double& value, int depth) {
  const char* const open = p++;
  if (!binary(p, value, 1, depth)) return false;
  if (*p == ']') {
    skip_blanks(++p);
    return true;
  }
  if (*p == '\n' || *p == ';' || *p == '(') {
    return reporter_.error("unclosed-bracket", reporter_.column(open), "this bracket is not closed", "add ']'");
  }
  return reporter_.error("bad-operator", reporter_.column(p), shown(*p) + " stands where an operator or ']' should",
                         "operators: ** * / MOD + - EQ NE GT GE LT LE AND OR XOR");
}

bool ExpressionReader::binary(const char*& p, double& value, int loosest, int depth) {
  if (!any_value(p, value, depth)) return false;
  for (;;) {
    const char* const at = p;
    const OperatorName* const found = operator_at(p, loosest, dialect_);
    if (!found) return true;
    double right = 0;
    if (!binary(p, right, level_of(*found, dialect_) + 1, depth)) return false;
    if (!(right != 0 && !std::isnan(right)) &&
        (found->operation == Operator::divide || found->operation == Operator::modulo)) {
      return reporter_.error("division-by-zero", reporter_.column(at), text(value) + " is divided by 0",
                             "the divisor must not be 0");
    }
    const double result = apply(found->operation, value, right, dialect_);
    if (!std::isfinite(result)) {
      return reporter_.error("expression-domain", reporter_.column(at),
                             text(value) + " " + std::string(found->name) + " " + text(right) + " is not a number",
                             "the result must be real and below 1.79e308");
    }
    value = result;
  }
}

bool ExpressionReader::function(const char*& p, double& value, int depth) {
  const char* const begin = p;
  const FunctionName* const found = function_at(p, dialect_);
  if (!found) {
    return reporter_.error("bad-number", reporter_.column(begin), shown(*begin) + " stands where a number should",
                           "write a number, [an expression], or a function of one such as SIN[30]");
  }
  if (found->function == Function::exists) return exists(p, value, depth);
  if (!bracketed(p, value, depth)) return false;
  if (found->function == Function::atan) {
    const bool has_slash = *p == '/';
    if (has_slash) skip_blanks(++p);
    if (!has_slash || *p != '[') {
      return reporter_.error("bad-operator", reporter_.column(begin), "ATAN[y] is not followed by /[x]",
                             "write ATAN[y]/[x]");
    }
    double x = 0;
    if (!bracketed(p, x, depth)) return false;
    value = numeric::atan2(std::isnan(value) ? 0 : value, std::isnan(x) ? 0 : x) * degrees_per_radian;
    return true;
  }
  const double result = apply(found->function, value, dialect_);
  // LN[0] and TAN[90] are infinite, the others not a number, where they are not defined.
  if (!std::isfinite(result)) {
    return reporter_.error("expression-domain", reporter_.column(begin),
                           std::string(found->name) + "[" + text(value) + "] is not a number",
                           "the argument must lie where the function is defined");
  }
  value = result;
  return true;
}

bool ExpressionReader::exists(const char*& p, double& value, int depth) {
  const char* const open = p;
  skip_blanks(++p);
  if (*p != '#') {
    return reporter_.error("bad-parameter", reporter_.column(p), shown(*p) + " stands where a parameter should",
                           "write EXISTS[#<name>]");
  }
  // Numbers exist where there are so many; that there are not is no error here (LinuxCNC).
  const char* q = p + 1;
  double number = 0;
  ParameterName name;
  skip_blanks(q);
  bool is_there = true;
  if (*q != '<') {
    if (!any_value(q, number, depth + 1)) return false;
    const std::optional<int> index = as_integer(number);
    is_there = index && 0 < *index && *index <= Parameters::last;
    p = q;
  } else {
    if (!parameter_name(++p, name, depth)) return false;
    is_there = parameters_.get(name.name) || predefined_.get(name.name);
  }
  if (*p != ']') {
    return reporter_.error("unclosed-bracket", reporter_.column(open), "this bracket is not closed", "add ']'");
  }
  skip_blanks(++p);
  value = is_there;
  return true;
}

bool ExpressionReader::parameter_name(const char*& p, ParameterName& name, int depth) {
  const char* const begin = p;
  skip_blanks(p);
  if (plain_index(p, name.number)) {
    name.name.clear();
    return true;
  }
  if (*p != '<') {
    double number = 0;
    if (!any_value(p, number, depth + 1)) return false;
    const std::optional<int> index = as_integer(number);
    const int first = has_macros(dialect_) ? 0 : 1;
    if (!index || *index < first || *index > Parameters::last) {
      return reporter_.error("bad-parameter", reporter_.column(begin - 1), "there is no parameter #" + text(number),
                             "an integer from 1 to " + std::to_string(Parameters::last) + ", or a <name>");
    }
    name.number = *index;
    name.name.clear();
    return true;
  }
  name.name.clear();
  for (++p; *p != '>'; ++p) {
    if (is_blank(*p)) continue;
    if (*p < ' ' || *p > '~' || name.name.size() == longest_name) {
      return reporter_.error("bad-parameter", reporter_.column(begin - 1), "the name of this parameter does not end",
                             "'<', up to " + std::to_string(longest_name) + " printable characters, '>'");
    }
    name.name += upper(*p);
  }
  if (name.name.empty()) {
    return reporter_.error("bad-parameter", reporter_.column(begin - 1), "the name of this parameter is empty",
                           "#<name>");
  }
  skip_blanks(++p);
  return true;
}

bool ExpressionReader::parameter(const char*& p, double& value, int depth) {
  const char* const begin = p++;
  int index = 0;
  if (plain_index(p, index)) return numbered(index, begin, value);
  ParameterName name;
  if (!parameter_name(p, name, depth)) return false;
  return name.name.empty() ? numbered(name.number, begin, value) : named(name.name, begin, value);
}

bool ExpressionReader::numbered(int number, const char* begin, double& value) {
  if (number == 0) {
    value = vacant;
    return true;
  }
  if (number < Predefined::first_macro_number) {
    if (!parameters_.has(number)) return never_set(number, begin, value);
    value = parameters_.value_or(number, 0);
    return true;
  }
  if (has_macros(dialect_)) {
    const std::optional<double> found = predefined_.of_macro(number);
    if (found) {
      value = *found;
      return true;
    }
    return refuse_macro_number(number, begin);
  }
  const int axis = number - Parameters::current_position;
  const bool is_place = 0 <= axis && axis < static_cast<int>(base::axis_count);
  if (is_place && predefined_.modal().cutter_side != Code::G40) {
    return reporter_.error("cutter-compensation", reporter_.column(begin),
                           "#" + std::to_string(number) + " is read while cutter compensation is on",
                           "G40 before it: where the tool goes depends on what follows");
  }
  const std::optional<double> predefined = predefined_.get(number);
  if (!predefined && !parameters_.has(number)) return never_set(number, begin, value);
  value = predefined ? *predefined : parameters_.value_or(number, 0);
  return true;
}

// Macros ask whether a variable is vacant; elsewhere it is 0, which is seldom meant.
bool ExpressionReader::never_set(int number, const char* begin, double& value) {
  value = has_macros(dialect_) ? vacant : 0;
  if (warns_of_unset_ && !has_macros(dialect_)) {
    reporter_.warning("lint-unset-parameter", reporter_.column(begin),
                      "#" + std::to_string(number) + " was never set, and is 0",
                      "set it in a block before this one: #" + std::to_string(number) + "=...");
  }
  return true;
}

bool ExpressionReader::refuse_macro_number(int number, const char* begin) {
  return reporter_.error(
      "unsupported-parameter", reporter_.column(begin),
      "#" + std::to_string(number) + " is a system variable that is not read",
      "#1 to #999 are variables; of the system's are read #4001 to #4014, #5001 to #5069 and offsets");
}

bool ExpressionReader::named(const std::string& name, const char* begin, double& value) {
  const std::optional<double> found = parameters_.get(name);
  if (const auto present = found ? found : predefined_.get(name)) {
    value = *present;
    return true;
  }
  const bool of_host = Predefined::is_of_host(name);
  return reporter_.error("unset-parameter", reporter_.column(begin), "#<" + name + "> has no value",
                         of_host
                             ? "settings and pins of LinuxCNC are not here: test it with EXISTS, or set a name instead"
                             : "assign it in a block before this one: #<" + name + ">=...");
}

}  // namespace leadscrew::gcode
