#pragma once
// Sums of logarithms, as barriers are made of.

#include <leadscrew/numeric/functions.hpp>

namespace leadscrew::numeric {

/// Σ log of many factors > 0. They are multiplied, and a logarithm is taken only where the product leaves 1e±200.
class LogSum {
 public:
  /// Only factors above `least` are taken; it is 1e-100 or more, and no factor is above 1e100.
  explicit constexpr LogSum(double least) : least_(least) {}

  /// Returns false where the factor is not above the least, or is no number: then the sum stays as it was.
  bool add(double factor) {
    if (!(factor > least_)) return false;
    product_ *= factor;
    if (product_ < 1e-200 || product_ > 1e200) {
      sum_ += log(product_);
      product_ = 1;
    }
    return true;
  }
  /// Of what was added; 0 of nothing.
  double value() const { return sum_ + log(product_); }

 private:
  double least_, sum_ = 0, product_ = 1;
};

}  // namespace leadscrew::numeric
