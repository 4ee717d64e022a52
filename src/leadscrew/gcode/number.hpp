#pragma once
// Decimal numbers of RS274/NGC (digits with at most one point, no exponent) to doubles and back.

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

namespace leadscrew::gcode {

constexpr bool is_digit(char c) {
  return static_cast<unsigned char>(c - '0') < 10;
}
constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

/// Reads the digits and the point that begin at `first`, correctly rounded, whatever their number. The text must end in
/// a character that is neither.
[[gnu::noinline]] double long_decimal(const char* first, const char* last);

/// The powers of ten that are doubles.
inline constexpr double powers_of_ten[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                           1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// Reads an unsigned decimal number and returns where it ends: `first` where there is no digit. Infinite beyond the
/// range of doubles. The text must end in a character that is neither digit nor point.
///
/// Up to 2⁵³ with up to 22 decimals, numerator and denominator are doubles and their quotient is correctly rounded
/// (Clinger 1990); longer numbers go to fast_float.
inline const char* scan_decimal(const char* first, double& value) {
  const char* p = first;
  std::uint64_t digits = 0;
  while (is_digit(*p)) digits = digits * 10 + static_cast<std::uint64_t>(*p++ - '0');
  std::ptrdiff_t count = p - first;
  std::ptrdiff_t decimals = 0;
  if (*p == '.') {
    const char* const fraction = ++p;
    while (is_digit(*p)) digits = digits * 10 + static_cast<std::uint64_t>(*p++ - '0');
    decimals = p - fraction;
    count += decimals;
  }
  if (count == 0) return first;
  constexpr std::uint64_t exact = std::uint64_t{1} << std::numeric_limits<double>::digits;
  if (count <= 19 && digits <= exact) {
    value = static_cast<double>(digits) / powers_of_ten[decimals];
  } else {
    value = long_decimal(first, p);
  }
  return p;
}

/// The integer within 0.0001 of the value, as LinuxCNC reads integers; std::nullopt if there is none below 10⁹ in
/// magnitude.
inline std::optional<int> as_integer(double value) {
  if (!(std::fabs(value) < 1e9)) return std::nullopt;
  const double nearest = std::round(value);
  if (std::fabs(value - nearest) > 1e-4) return std::nullopt;
  return static_cast<int>(nearest);
}

/// The number with up to nine significant digits, for messages.
std::string text(double value);

}  // namespace leadscrew::gcode
