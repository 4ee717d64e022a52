#pragma once
// Speed along the path against the programmed feed.
//
// The travel from word to word is their chord c in the axes that the feed counts. Where both words lie on one arc, to a
// thousandth of its radius, and θ apart about the centre, it is c·(θ/2)/sin(θ/2) in the plane. Where both lie on one
// curve to a nanometre, it is longer than the chord as the curve between them is (curve_travel.hpp). Between words on
// different blocks only the chord is known; there the greatest feed of the blocks counts, and none if one is a rapid.

#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/referee/matcher.hpp>
#include <leadscrew/referee/violation_log.hpp>

namespace leadscrew::referee {

class FeedCheck {
 public:
  FeedCheck(const Metric& metric, base::Period period) : metric_(metric), period_(period.seconds()) {}

  /// The word at time t, and how it was reached.
  void observe(const base::AxisVector& position, const Passage& passage, double t, ViolationLog& log);

  double greatest_ratio() const { return greatest_ratio_; }

 private:
  double travel(const base::AxisVector& position, const Passage& passage) const;

  const Metric& metric_;
  double period_;
  bool first_ = true;
  base::AxisVector last_{};
  double largest_ = 0;  // |q| so far, mm or degrees
  double rounding_ = 0;
  double greatest_ratio_ = 0;
};

}  // namespace leadscrew::referee
