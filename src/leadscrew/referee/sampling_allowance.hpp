#pragma once
// The sampling allowance: how far a motion may have been from the chord between two words without the words showing it.
//
// With |f″| ≤ a between two samples T apart, f departs from their chord by at most a·T²/8. The acceleration limits
// bound a, and so do the words themselves: the second difference of the last three is T² times the mean of the
// acceleration over the two periods before, weighted towards their middle, and with |f‴| ≤ j nothing within the last
// period differs from that mean by more than j·T. So, for each axis, a = min(limit, |Δ²q|/T² + jT).
//
// The tip of a tool that rotary axes turn has no limits of its own: there a = |Δ²q|/T², as much more as that has changed since
// the word before, and as that change has.

#include <algorithm>
#include <cmath>
#include <leadscrew/referee/metric.hpp>

namespace leadscrew::referee {

class SamplingAllowance {
 public:
  SamplingAllowance(const Metric& metric, double period, bool is_of_tip = false)
      : metric_(metric), period_(period), is_of_tip_(is_of_tip) {}

  /// The motion is at rest at this first word.
  void begin(const Point& word) {
    before_ = last_ = word;
    second_before_ = change_before_ = {};
  }

  /// For the chord from the word before to this one, mm.
  double observe(const Point& word) {
    double sum = 0;
    for (std::size_t i = 0; i < metric_.dimensions(); ++i) {
      const double signed_second = (word[i] - 2 * last_[i] + before_[i]) / (period_ * period_);
      const double second = std::abs(signed_second);
      const double change = signed_second - second_before_[i];
      const double acceleration = is_of_tip_ ? second + std::abs(change) + std::abs(change - change_before_[i])
                                             : std::min(metric_.acceleration(i), second + metric_.jerk(i) * period_);
      change_before_[i] = change;
      second_before_[i] = signed_second;
      sum += acceleration * acceleration;
    }
    before_ = last_;
    last_ = word;
    return std::sqrt(sum) * period_ * period_ / 8;
  }

 private:
  const Metric& metric_;
  double period_;
  bool is_of_tip_;
  Point before_{}, last_{}, second_before_{}, change_before_{};
};

}  // namespace leadscrew::referee
