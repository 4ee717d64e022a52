#include <array>
#include <cmath>
#include <iterator>
#include <leadscrew/gcode/expression.hpp>
#include <numbers>
#include <string_view>

namespace leadscrew::gcode {

namespace {

constexpr int deepest = 64;            // brackets within brackets
constexpr double equal_within = 1e-4;  // EQ and NE, as LinuxCNC has it
constexpr std::size_t longest_name = 255;
constexpr double degrees_per_radian = 180 / std::numbers::pi;

// Whether the word stands at p, in any case and with blanks between its letters; p then moves behind it.
bool take(const char*& p, std::string_view word) {
  const char* q = p;
  for (const char c : word) {
    skip_blanks(q);
    if (upper(*q) != c) return false;
    ++q;
  }
  p = q;
  skip_blanks(p);
  return true;
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
  int level;  // how tightly it binds
};

// A name that begins another stands behind it.
constexpr OperatorName operators[] = {
    {"**", Operator::power, 5},         {"*", Operator::times, 4},      {"/", Operator::divide, 4},
    {"MOD", Operator::modulo, 4},       {"+", Operator::plus, 3},       {"-", Operator::minus, 3},
    {"EQ", Operator::equal, 2},         {"NE", Operator::not_equal, 2}, {"GT", Operator::greater, 2},
    {"GE", Operator::greater_equal, 2}, {"LT", Operator::less, 2},      {"LE", Operator::less_equal, 2},
    {"AND", Operator::both, 1},         {"OR", Operator::either, 1},    {"XOR", Operator::one, 1},
};

const OperatorName* operator_at(const char*& p, int loosest) {
  for (const OperatorName& candidate : operators) {
    const char* q = p;
    if (!take(q, candidate.name)) continue;
    if (candidate.level < loosest) return nullptr;
    p = q;
    return &candidate;
  }
  return nullptr;
}

double apply(Operator operation, double a, double b) {
  switch (operation) {
    case Operator::power:
      return std::pow(a, b);
    case Operator::times:
      return a * b;
    case Operator::divide:
      return a / b;
    case Operator::modulo: {
      const double rest = std::fmod(a, b);
      return rest < 0 ? rest + std::fabs(b) : rest;
    }
    case Operator::plus:
      return a + b;
    case Operator::minus:
      return a - b;
    case Operator::equal:
      return std::fabs(a - b) < equal_within;
    case Operator::not_equal:
      return std::fabs(a - b) >= equal_within;
    case Operator::greater:
      return a > b;
    case Operator::greater_equal:
      return a >= b;
    case Operator::less:
      return a < b;
    case Operator::less_equal:
      return a <= b;
    case Operator::both:
      return a != 0 && b != 0;
    case Operator::either:
      return a != 0 || b != 0;
    case Operator::one:
      return (a != 0) != (b != 0);
  }
  return 0;
}

enum class Function : std::uint8_t { abs, acos, asin, cos, exp, fix, fup, ln, round, sin, sqrt, tan, atan, exists };

struct FunctionName {
  std::string_view name;
  Function function;
};

constexpr FunctionName functions[] = {
    {"ABS", Function::abs},   {"ACOS", Function::acos},     {"ASIN", Function::asin},   {"ATAN", Function::atan},
    {"COS", Function::cos},   {"EXISTS", Function::exists}, {"EXP", Function::exp},     {"FIX", Function::fix},
    {"FUP", Function::fup},   {"LN", Function::ln},         {"ROUND", Function::round}, {"SIN", Function::sin},
    {"SQRT", Function::sqrt}, {"TAN", Function::tan},
};

double apply(Function function, double x) {
  switch (function) {
    case Function::abs:
      return std::fabs(x);
    case Function::acos:
      return std::acos(x) * degrees_per_radian;
    case Function::asin:
      return std::asin(x) * degrees_per_radian;
    case Function::cos:
      return cosine_of_degrees(x);
    case Function::exp:
      return std::exp(x);
    case Function::fix:
      return std::floor(x);
    case Function::fup:
      return std::ceil(x);
    case Function::ln:
      return std::log(x);
    case Function::round:
      return std::round(x);
    case Function::sin:
      return sine_of_degrees(x);
    case Function::sqrt:
      return std::sqrt(x);
    case Function::tan:
      return sine_of_degrees(x) / cosine_of_degrees(x);
    case Function::atan:
    case Function::exists:
      break;  // read apart: their arguments are not one value
  }
  return x;
}

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
    read = joined_number(p, value);
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
  if (negative) value = -value;
  skip_blanks(p);
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
    const OperatorName* const found = operator_at(p, loosest);
    if (!found) return true;
    double right = 0;
    if (!binary(p, right, found->level + 1, depth)) return false;
    if (right == 0 && (found->operation == Operator::divide || found->operation == Operator::modulo)) {
      return reporter_.error("division-by-zero", reporter_.column(at), text(value) + " is divided by 0",
                             "the divisor must not be 0");
    }
    const double result = apply(found->operation, value, right);
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
  const FunctionName* found = nullptr;
  for (const FunctionName& candidate : functions) {
    const char* q = p;
    if (!take(q, candidate.name) || *q != '[') continue;
    found = &candidate;
    p = q;
    break;
  }
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
    value = std::atan2(value, x) * degrees_per_radian;
    return true;
  }
  const double result = apply(found->function, value);
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
  ParameterName name;
  if (!parameter_name(++p, name, depth)) return false;
  if (*p != ']') {
    return reporter_.error("unclosed-bracket", reporter_.column(open), "this bracket is not closed", "add ']'");
  }
  skip_blanks(++p);
  value = name.name.empty() ? parameters_.get(name.number).has_value() : parameters_.get(name.name).has_value();
  return true;
}

bool ExpressionReader::parameter_name(const char*& p, ParameterName& name, int depth) {
  const char* const begin = p;
  skip_blanks(p);
  if (*p != '<') {
    double number = 0;
    if (!any_value(p, number, depth + 1)) return false;
    const std::optional<int> index = as_integer(number);
    if (!index || *index < 1 || *index > Parameters::last) {
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
  ParameterName name;
  if (!parameter_name(p, name, depth)) return false;
  const int nth_axis = name.name.empty() ? name.number - Parameters::current_position : -1;
  if (nth_axis >= 0 && nth_axis < static_cast<int>(base::axis_count)) {
    const auto axis = static_cast<base::Axis>(nth_axis);
    value = frame_.to_program(frame_.position)[base::index(axis)] / frame_.unit(axis);
    return true;
  }
  const std::optional<double> found = name.name.empty() ? parameters_.get(name.number) : parameters_.get(name.name);
  if (found) {
    value = *found;
    return true;
  }
  const std::string shown_name = name.name.empty() ? "#" + std::to_string(name.number) : "#<" + name.name + ">";
  return reporter_.error("unset-parameter", reporter_.column(begin), shown_name + " has no value",
                         "assign it in a block before this one: " + shown_name + "=...");
}

}  // namespace leadscrew::gcode
