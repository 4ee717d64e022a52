#include <cmath>
#include <leadscrew/gcode/frame.hpp>
#include <leadscrew/gcode/operations.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <limits>
#include <numbers>

namespace leadscrew::gcode {

namespace {

constexpr double equal_within = 1e-4;  // EQ and NE, as LinuxCNC has it
constexpr double degrees_of_radian = 180 / std::numbers::pi;
constexpr double no_result = std::numeric_limits<double>::quiet_NaN();

// A name that begins another stands behind it.
constexpr OperatorName operator_names[] = {
    {"**", Operator::power, 5, 0},         {"*", Operator::times, 4, 3},      {"/", Operator::divide, 4, 3},
    {"MOD", Operator::modulo, 4, 3},       {"+", Operator::plus, 3, 2},       {"-", Operator::minus, 3, 2},
    {"EQ", Operator::equal, 2, 1},         {"NE", Operator::not_equal, 2, 1}, {"GT", Operator::greater, 2, 1},
    {"GE", Operator::greater_equal, 2, 1}, {"LT", Operator::less, 2, 1},      {"LE", Operator::less_equal, 2, 1},
    {"AND", Operator::both, 1, 3},         {"OR", Operator::either, 1, 2},    {"XOR", Operator::one, 1, 2},
};

constexpr FunctionName function_names[] = {
    {"ABS", Function::abs},   {"ACOS", Function::acos},     {"ASIN", Function::asin},
    {"ATAN", Function::atan}, {"COS", Function::cos},       {"EXISTS", Function::exists},
    {"EXP", Function::exp},   {"FIX", Function::fix},       {"FUP", Function::fup},
    {"LN", Function::ln},     {"ROUND", Function::round},   {"RND", Function::round, true},
    {"SIN", Function::sin},   {"SQRT", Function::sqrt},     {"SQR", Function::sqrt, true},
    {"TAN", Function::tan},   {"BIN", Function::bin, true}, {"BCD", Function::bcd, true},
};

double remainder_of(double a, double b) {
  const double rest = std::fmod(a, b);
  return rest < 0 ? rest + std::fabs(b) : rest;
}

// Of whole numbers below 2³¹.
double of_bits(Operator operation, double a, double b) {
  constexpr double most = 2147483648.0;
  if (!(std::fabs(a) < most && std::fabs(b) < most)) return no_result;
  const auto x = static_cast<std::int64_t>(std::round(a)), y = static_cast<std::int64_t>(std::round(b));
  return static_cast<double>(operation == Operator::both ? x & y : operation == Operator::either ? x | y : x ^ y);
}

bool is_logical(Operator operation) {
  return operation == Operator::both || operation == Operator::either || operation == Operator::one;
}

// From decimal digits that stand in four bits each to the number, and back; of whole numbers below 10⁸.
double from_digits(double digits) {
  if (!(digits >= 0 && digits < 4294967296.0)) return no_result;
  double value = 0, place = 1;
  for (auto rest = static_cast<std::uint64_t>(digits); rest != 0; rest >>= 4, place *= 10) {
    if ((rest & 15u) > 9) return no_result;
    value += static_cast<double>(rest & 15u) * place;
  }
  return value;
}

double to_digits(double value) {
  if (!(value >= 0 && value < 1e8)) return no_result;
  double digits = 0, place = 1;
  for (auto rest = static_cast<std::uint64_t>(value); rest != 0; rest /= 10, place *= 16) {
    digits += static_cast<double>(rest % 10) * place;
  }
  return digits;
}

double or_zero(double value) {
  return std::isnan(value) ? 0 : value;
}

}  // namespace

const OperatorName* operator_at(const char*& p, int loosest, Dialect dialect) {
  const char first = upper(*p);
  if (first == ']' || first == '\n') return nullptr;
  for (const OperatorName& candidate : operator_names) {
    if (candidate.name.front() != first) continue;
    const int level = level_of(candidate, dialect);
    const char* q = p;
    if (level == 0 || !take_letters(q, candidate.name)) continue;
    if (level < loosest) return nullptr;
    p = q;
    return &candidate;
  }
  return nullptr;
}

const FunctionName* function_at(const char*& p, Dialect dialect) {
  for (const FunctionName& candidate : function_names) {
    const char* q = p;
    if ((candidate.of_macros_only && !has_macros(dialect)) || !take_letters(q, candidate.name) || *q != '[') continue;
    p = q;
    return &candidate;
  }
  return nullptr;
}

double apply(Operator operation, double a, double b, Dialect dialect) {
  if (std::isnan(a) || std::isnan(b)) {
    const bool both_vacant = std::isnan(a) && std::isnan(b);
    if (operation == Operator::equal) return both_vacant;
    if (operation == Operator::not_equal) return !both_vacant;
    a = or_zero(a);
    b = or_zero(b);
  }
  if (has_macros(dialect) && is_logical(operation)) return of_bits(operation, a, b);
  switch (operation) {
    case Operator::power:
      return std::pow(a, b);
    case Operator::times:
      return a * b;
    case Operator::divide:
      return a / b;
    case Operator::modulo:
      return remainder_of(a, b);
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

double apply(Function function, double x, Dialect dialect) {
  x = or_zero(x);
  switch (function) {
    case Function::abs:
      return std::fabs(x);
    case Function::acos:
      return numeric::acos(x) * degrees_of_radian;
    case Function::asin:
      return numeric::asin(x) * degrees_of_radian;
    case Function::cos:
      return cosine_of_degrees(x);
    case Function::exp:
      return std::exp(x);
    case Function::fix:
      return has_macros(dialect) ? std::trunc(x) : std::floor(x);
    case Function::fup:
      return has_macros(dialect) && x < 0 ? std::floor(x) : std::ceil(x);
    case Function::ln:
      return numeric::log(x);
    case Function::round:
      return std::round(x);
    case Function::sin:
      return sine_of_degrees(x);
    case Function::sqrt:
      return std::sqrt(x);
    case Function::tan:
      return sine_of_degrees(x) / cosine_of_degrees(x);
    case Function::bin:
      return from_digits(x);
    case Function::bcd:
      return to_digits(x);
    case Function::atan:
    case Function::exists:
      break;  // read apart: their arguments are not one value
  }
  return x;
}

}  // namespace leadscrew::gcode
