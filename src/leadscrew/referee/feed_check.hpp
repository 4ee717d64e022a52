#pragma once
// Speed along the path against the programmed feed.
//
// The way from word to word is their chord in the axes the feed is told in. Where both words lie on one arc the way is
// longer than the chord: turned by θ about the centre, it is c·(θ/2)/sin(θ/2) in the plane, whichever radius the words
// keep within a thousandth of the arc's. Where both lie on one curve to a nanometre, the chord is stretched to the
// length of the curve between their matches (matcher.hpp). Between words on different blocks the chord is all that
// words can tell; the greatest feed of the blocks counts there, and none if one is a rapid.

#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/referee/docket.hpp>
#include <leadscrew/referee/matcher.hpp>

namespace leadscrew::referee {

class FeedCheck {
 public:
  FeedCheck(const Metric& metric, base::Period period) : metric_(metric), period_(period.seconds()) {}

  /// The word at time t, and how it was reached.
  void observe(const base::AxisVector& position, const Passage& passage, double t, Docket& docket);

  double greatest_ratio() const { return greatest_ratio_; }

 private:
  double way(const base::AxisVector& position, const Passage& passage) const;

  const Metric& metric_;
  double period_;
  bool first_ = true;
  base::AxisVector last_{};
  double largest_ = 0;  // |q| so far, mm or degrees
  double rounding_ = 0;
  double greatest_ratio_ = 0;
};

}  // namespace leadscrew::referee
