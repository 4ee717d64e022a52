#pragma once
// The sampling allowance: how far a motion may have been from the chord between two words without the words showing it.
//
// With |f″| ≤ a between two samples T apart, f departs from their chord by at most a·T²/8. The acceleration limits
// bound a, and so do the words themselves: the second difference of the last three is T² times the mean of the
// acceleration over the two periods before, weighted towards their middle, and with |f‴| ≤ j nothing within the last
// period differs from that mean by more than j·T. So, for each axis, a = min(limit, |Δ²q|/T² + jT).
//
// The tip of a tool that rotary axes turn has no limits of its own: it is as far off as these departures of the axes move it,
// and as the way on which the axes take it straight from word to word is from its own chord (TipAllowance).

#include <algorithm>
#include <cmath>
#include <leadscrew/referee/metric.hpp>
#include <leadscrew/referee/pose.hpp>

namespace leadscrew::referee {

/// Of each coordinate, for the chord from `last` to `word`, mm; three words in a row.
inline Point departures(const Metric& metric, double period, const Point& before, const Point& last,
                        const Point& word) {
  Point result{};
  for (std::size_t i = 0; i < metric.dimensions(); ++i) {
    const double second = std::abs(word[i] - 2 * last[i] + before[i]) / (period * period);
    result[i] = std::min(metric.acceleration(i), second + metric.jerk(i) * period) * period * period / 8;
  }
  return result;
}

class SamplingAllowance {
 public:
  SamplingAllowance(const Metric& metric, double period) : metric_(metric), period_(period) {}

  /// The motion is at rest at this first word.
  void begin(const Point& word) { before_ = last_ = word; }

  /// For the chord from the word before to this one, mm.
  double observe(const Point& word) {
    const Point each = departures(metric_, period_, before_, last_, word);
    before_ = last_;
    last_ = word;
    return std::sqrt(metric_.dot(each, each));
  }

 private:
  const Metric& metric_;
  double period_;
  Point before_{}, last_{};
};

/// Under tool centre point control, from words of the axes.
class TipAllowance {
 public:
  TipAllowance(const machine::Machine& machine, const Pose& pose, double period)
      : pose_(pose), metric_(machine), period_(period) {}

  /// How far from the chord from `last` to `word`, in the metric of a space, the tip of this tool and the rotary axes may have
  /// been, mm; three words in a row.
  double of(const base::AxisVector& before, const base::AxisVector& last, const base::AxisVector& word,
            const Metric& space, const std::array<double, 3>& tool) const;

 private:
  const Pose& pose_;
  Metric metric_;
  double period_;
};

}  // namespace leadscrew::referee
