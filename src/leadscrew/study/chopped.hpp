#pragma once
// Binary floating point of 27 bits that cuts off what does not fit, as in the computers of the 1960s and 70s.

#include <bit>
#include <cmath>
#include <cstdint>

namespace leadscrew::study {

class Chopped {
 public:
  static constexpr int bits = 27;

  Chopped() = default;
  /// The 27 leading bits.
  Chopped(double value) : value_(cut(value)) {}  // NOLINT(google-explicit-constructor): a number is a number

  double value() const { return value_; }

  friend Chopped operator+(Chopped a, Chopped b) {
    // The sum and what rounding has left of it (Knuth's two-sum).
    const double sum = a.value_ + b.value_, from_b = sum - a.value_;
    return exactly(sum, (a.value_ - (sum - from_b)) + (b.value_ - from_b));
  }
  friend Chopped operator-(Chopped a, Chopped b) { return a + Chopped(-b.value_); }
  friend Chopped operator*(Chopped a, Chopped b) {
    const double product = a.value_ * b.value_;
    return exactly(product, std::fma(a.value_, b.value_, -product));
  }

  /// The leading bits of near + rest, |rest| at most half a unit in the last place of `near`.
  static Chopped exactly(double near, double rest) {
    Chopped result(near);
    // Rounding went up to a number of 27 bits that the exact value is below of.
    if (result.value_ == near && rest != 0 && std::signbit(rest) != std::signbit(near))
      result.value_ = cut(std::nextafter(near, 0.0));
    return result;
  }

 private:
  static double cut(double value) {
    constexpr std::uint64_t below = (std::uint64_t{1} << (53 - bits)) - 1;
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) & ~below);
  }

  double value_ = 0;
};

}  // namespace leadscrew::study
