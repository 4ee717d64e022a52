// A double is m·2^e with a whole m < 2⁵³. Where 10⁻⁴ ≤ |x| < 10¹⁶ its first 17 digits are the whole number nearest to
//
//     m·10^k / 2^(−e),   k = 16 − ⌊log₁₀|x|⌋ ≤ 21,
//
// whose numerator fits 128 bits: one multiplication, one shift and an exact decision about rounding. That is several
// times as fast as the general algorithm, which stands in for all other values.

#include <leadscrew/base/digits.hpp>

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

namespace leadscrew::base {
namespace {

char* write_any(char* at, double value) {
  return std::to_chars(at, at + digits_room, value, std::chars_format::general, 17).ptr;
}

#ifdef __SIZEOF_INT128__

__extension__ using Wide = unsigned __int128;

constexpr std::uint64_t least_of_17_digits = 10'000'000'000'000'000;

constexpr auto powers_of_ten = [] {
  std::array<Wide, 23> powers{};
  powers[0] = 1;
  for (std::size_t k = 1; k < powers.size(); ++k) powers[k] = powers[k - 1] * 10;
  return powers;
}();

/// Whole part and rounding of m·10^k / 2^shift.
struct Scaled {
  std::uint64_t whole;
  bool rounds_up;
};

Scaled scaled(std::uint64_t mantissa, int power, int shift) {
  const Wide product = powers_of_ten[static_cast<std::size_t>(power)] * mantissa;
  const auto whole = static_cast<std::uint64_t>(product >> shift);
  const Wide rest = product & ((Wide{1} << shift) - 1);
  const Wide half = Wide{1} << (shift - 1);
  return {whole, rest > half || (rest == half && (whole & 1))};
}

/// Digits d₀d₁… with the decimal point behind d_exponent; zeros at the end are left out.
char* write_fixed(char* at, std::uint64_t digits, int exponent) {
  std::array<char, digits_room> text;
  char* const begin = text.data();
  char* end = std::to_chars(begin, begin + text.size(), digits).ptr;
  while (end[-1] == '0') --end;
  const auto count = static_cast<int>(end - begin);
  if (exponent < 0) {
    *at++ = '0';
    *at++ = '.';
    for (int zero = exponent + 1; zero < 0; ++zero) *at++ = '0';
    std::memcpy(at, begin, static_cast<std::size_t>(count));
    return at + count;
  }
  const int whole = exponent + 1;  // the value is no whole number, so that digits follow the point
  std::memcpy(at, begin, static_cast<std::size_t>(whole));
  at += whole;
  *at++ = '.';
  std::memcpy(at, begin + whole, static_cast<std::size_t>(count - whole));
  return at + (count - whole);
}

/// For fractions of 10⁻⁴ ≤ value < 2⁵²; null where rounding to 17 digits makes a whole number.
char* write_fraction(char* at, double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto mantissa = (bits & ((std::uint64_t{1} << 52) - 1)) | (std::uint64_t{1} << 52);
  const int binary = static_cast<int>(bits >> 52) - 1023;
  const int shift = 52 - binary;
  int exponent = (binary * 1233) >> 12;  // ⌊binary·log₁₀2⌋, never above ⌊log₁₀ value⌋ and at most one below it
  Scaled digits = scaled(mantissa, 16 - exponent, shift);
  if (digits.whole >= 10 * least_of_17_digits) {
    ++exponent;
    digits = scaled(mantissa, 16 - exponent, shift);
  }
  std::uint64_t rounded = digits.whole + (digits.rounds_up ? 1 : 0);
  if (rounded == 10 * least_of_17_digits) {
    rounded = least_of_17_digits;
    ++exponent;
  }
  if (exponent >= 0) {
    const auto unit = static_cast<std::uint64_t>(powers_of_ten[static_cast<std::size_t>(16 - exponent)]);
    if (rounded % unit == 0) return nullptr;
  }
  return write_fixed(at, rounded, exponent);
}

#endif

}  // namespace

char* write_integer(char* at, std::int64_t value) {
  return std::to_chars(at, at + digits_room, value).ptr;
}

char* write_digits(char* at, double value) {
  constexpr double whole_below = 4503599627370496.0;  // 2⁵²
  if (!(std::fabs(value) < whole_below) || (value == 0 && std::signbit(value))) return write_any(at, value);
  const auto whole = static_cast<std::int64_t>(value);
  if (static_cast<double>(whole) == value) return write_integer(at, whole);
#ifdef __SIZEOF_INT128__
  if (std::fabs(value) >= 1e-4) {
    char* begin = at;
    if (value < 0) *begin++ = '-';
    if (char* end = write_fraction(begin, std::fabs(value))) return end;
  }
#endif
  return write_any(at, value);
}

}  // namespace leadscrew::base
