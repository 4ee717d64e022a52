#pragma once
// Rest where the program asks for it: at dwells, and at events that motion rests for. Events that travel with the path
// ask for none.
//
// Where motion rests at an instant between two words, no axis can be farther from one to the other than a·T²/2, a its
// limit of acceleration. In the order of the program, two words as near as that must lie at each place of rest; a
// train of words that only comes by there is told once.

#include <algorithm>
#include <cmath>
#include <deque>
#include <leadscrew/referee/matcher.hpp>
#include <leadscrew/referee/metric.hpp>
#include <limits>
#include <optional>

namespace leadscrew::referee {

class StopCheck {
 public:
  /// Of words so many seconds apart. The metric must outlive this.
  StopCheck(const Metric& metric, double period, bool is_of_tip)
      : metric_(metric), period_(period), is_of_tip_(is_of_tip) {
    double squares = 0;
    for (std::size_t i = 0; i < metric.dimensions(); ++i) squares += step(i) * step(i);
    greatest_step_ = std::sqrt(squares);
  }

  /// The next one of the program.
  void require(const RequiredStop& stop) {
    if (waiting_.size() < most_waiting) waiting_.push_back(stop);
  }
  /// The next word; motion rests before the first. `axes`: the same in the machine's axes, where the word is the tip's.
  void observe(const Point& word, const Point& axes) {
    const Point before = has_begun_ ? before_ : word;
    const bool rests = is_rest(has_begun_ ? axes_before_ : axes, axes);
    while (!waiting_.empty() && comes_by(before, word) && rests) {
      waiting_.pop_front();
      least_ = std::numeric_limits<double>::infinity();
    }
    before_ = word;
    axes_before_ = axes;
    has_begun_ = true;
  }
  /// Where motion rests at an instant between two words, in the machine's axes, they are as near as this says.
  bool is_rest(const Point& a, const Point& b) const {
    for (std::size_t i = 0; i < metric_.dimensions(); ++i) {
      if (!(std::abs(b[i] - a[i]) <= step(i))) return false;
    }
    return true;
  }
  /// mm; no word is farther from the other.
  double greatest_step() const { return greatest_step_; }
  /// After the last word: a place where motion should have rested and did not, the least speed there and the greatest
  /// that would be rest, mm/s.
  std::optional<Finding> conclude() const {
    if (waiting_.empty() || !std::isfinite(least_)) return std::nullopt;
    return Finding{waiting_.front().line, least_ / period_, greatest_step_ / period_};
  }

 private:
  static constexpr std::size_t most_waiting = 4096;  // so that memory is bounded where motion never rests
  static constexpr double kept = 1.001;              // of a limit of acceleration

  /// As far as an axis may go in a period in which it rests, mm.
  double step(std::size_t i) const { return kept * metric_.acceleration(i) * period_ * period_ / 2 + nanometre; }

  /// Do the two come by the place that waits?
  bool comes_by(const Point& a, const Point& b) {
    const RequiredStop& stop = waiting_.front();
    // The tip goes farther than the axes where rotary ones carry it round.
    const double reach = stop.tolerance + greatest_step_ + (is_of_tip_ ? metric_.distance(a, b) : 0);
    if (distance_to_chord(metric_, chord_between(metric_, a, b), stop.place) > reach) return false;
    least_ = std::min(least_, metric_.distance(a, b));
    return true;
  }

  const Metric& metric_;
  double period_;
  bool is_of_tip_;
  double greatest_step_ = 0;
  std::deque<RequiredStop> waiting_;
  double least_ = std::numeric_limits<double>::infinity();  ///< from word to word, at the place that waits
  Point before_{}, axes_before_{};
  bool has_begun_ = false;
};

}  // namespace leadscrew::referee
