#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <leadscrew/numeric/sine.hpp>

namespace leadscrew::numeric {

namespace {

using Vector = double;
using Mask = std::int64_t;
#include <leadscrew/numeric/sine.inl>

namespace side_by_side {
using Vector = Pair;
using Mask = PairBits;
#include <leadscrew/numeric/sine.inl>
}  // namespace side_by_side

/// 2/π · 2⁻³² in binary, 32 bits in each.
constexpr std::array<std::uint32_t, 40> two_over_pi = {
    0x00000000, 0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab,
    0xdebbc561, 0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e, 0xe88235f5,
    0x2ebb4484, 0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff,
    0xde05980f, 0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7,
    0xebe5f17b, 0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab, 0xf0cfbc20};

constexpr std::size_t digit_count = 7;  // of 32 bits, behind the point

/// Quarter turns modulo 4: whole ones, and what is behind the point, the least digit first.
struct QuarterTurns {
  std::uint32_t whole = 0;
  std::array<std::uint32_t, digit_count> digits{};
};

/// Of an angle of 2²⁰ and above, after Payne and Hanek ("Radian reduction for trigonometric functions", SIGNUM Newsletter
/// 18, 1983): with angle = m 2ᵉ, digits of 2/π that count whole turns are left out, and those that count below 2⁻¹³⁸.
QuarterTurns quarter_turns(double angle) {
  const auto bits = std::bit_cast<std::uint64_t>(angle);
  const int exponent = static_cast<int>(bits >> 52) - 1075;  // ≥ −32
  const int skipped = exponent < 2 ? 0 : (exponent + 30) / 32;
  const int shift = exponent + 32 - 32 * skipped;  // 0 to 33
  const std::uint64_t whole_number = (bits & ((std::uint64_t{1} << 52) - 1)) | (std::uint64_t{1} << 52);
  const std::uint64_t low = (whole_number & 0xffffffff) << (shift & 31), high = (whole_number >> 32) << (shift & 31);
  std::array<std::uint64_t, 4> factor{};  // m · 2^shift
  const std::size_t first = static_cast<std::size_t>(shift) / 32;
  factor[first] = low & 0xffffffff;
  factor[first + 1] = (low >> 32) + (high & 0xffffffff);
  factor[first + 2] = high >> 32;
  factor[first + 2] += factor[first + 1] >> 32;
  factor[first + 1] &= 0xffffffff;
  std::array<std::uint64_t, digit_count + 1> product{};
  for (std::size_t j = 0; j < digit_count; ++j) {
    const std::uint64_t digit = two_over_pi[static_cast<std::size_t>(skipped) + digit_count - 1 - j];
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < factor.size() && i + j < product.size(); ++i) {
      carry += product[i + j] + digit * factor[i];
      product[i + j] = carry & 0xffffffff;
      carry >>= 32;
    }
  }
  QuarterTurns turns;
  for (std::size_t k = 0; k < digit_count; ++k) turns.digits[k] = static_cast<std::uint32_t>(product[k]);
  turns.whole = static_cast<std::uint32_t>(product[digit_count]);
  return turns;
}

/// |angle.hi| ≥ 2²⁰
ReducedAngle reduce_far(DoubleDouble angle) {
  if (!std::isfinite(angle.hi)) return {angle.hi - angle.hi, 0, 0};
  const QuarterTurns turns = quarter_turns(std::abs(angle.hi));
  const bool is_up = turns.digits.back() >> 31 != 0;  // nearer to the next quarter: the rest is negative, from there
  DoubleDouble rest;
  double unit = 0x1p-32;
  for (std::size_t k = digit_count; k-- > 0; unit *= 0x1p-32) {
    rest = rest + static_cast<double>(is_up ? ~turns.digits[k] : turns.digits[k]) * unit;
  }
  Mask quadrant = turns.whole;
  quadrant += is_up ? 1 : 0;
  const bool is_negative = angle.hi < 0;
  rest = rest * (two_pi * 0.25);
  if (is_up != is_negative) rest = -rest;
  const DoubleDouble reduced = two_sum(rest.hi, rest.lo + angle.lo);
  return {reduced.hi, reduced.lo, is_negative ? -quadrant : quadrant};
}

}  // namespace

Sines sines(DoubleDouble angle) {
  const bool is_near = std::abs(angle.hi) <= greatest_near_angle;
  const auto [sine, cosine, cosine_less_one] = sines_of(is_near ? reduce(angle.hi, angle.lo) : reduce_far(angle));
  return {sine, cosine, cosine_less_one};
}

SinesOfPair near_sines(Pair angle, Pair low) {
  const side_by_side::VectorSines both = side_by_side::sines_of(side_by_side::reduce(angle, low));
  return {both.sine, both.cosine};
}

}  // namespace leadscrew::numeric
