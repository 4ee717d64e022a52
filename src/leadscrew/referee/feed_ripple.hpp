#pragma once
// How evenly a motion goes where its plan says that feed is constant: the travel of each servo period over feed · period,
// from the positions of words alone.
//
//        q1 ──c── q2        travel = c·asin(x)/x,  x = κc/2     (an arc of curvature κ over its chord c)
//       ╱           ╲
//     q0             q3     κ = (κ(q0 q1 q2) + κ(q1 q2 q3))/2,  κ(a b c) = 2 |ab × bc| / (|ab| |bc| |ca|)
//
// On lines and arcs that is exact. On a curve whose curvature changes evenly it is short of the fourth power of κc. The
// plan says so where it has the same feed at all four words.

#include <array>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/referee/piece.hpp>
#include <optional>

namespace leadscrew::referee {

class FeedRipple {
 public:
  explicit FeedRipple(base::Period period) : period_(period.seconds()) {}

  /// The next word, the feed that the plan has there, mm/s or degrees/s, where that is known, and what the program asks
  /// for between the word before and this one.
  void observe(const base::AxisVector& position, std::optional<double> planned, const ProgrammedFeed& programmed);

  /// Largest |travel/(feed · period) − 1|, less what rounding of words may make of it; 0 where feed is nowhere constant.
  /// None where no word came with a feed. Rapids do not count.
  std::optional<double> greatest() const { return greatest_; }

 private:
  using Vector = std::array<double, 3>;
  /// From one word to the next, in the axes of its feed.
  struct Step {
    Vector along{};
    double length = 0;
    double bend = 0;  ///< curvature where it begins, 1/mm or 1/degree
    ProgrammedFeed programmed;
  };

  static double curvature_of(const Step& first, const Step& second);
  void account(const Step& step, double bend_behind);
  void note(const base::AxisVector& position);

  double period_;
  base::AxisVector position_{};  ///< of the last word
  Step step_;                    ///< to it
  double feed_ = 0;              ///< planned at it, and
  int words_of_feed_ = 0;        ///< at so many words, the last of them it; no more than four are counted
  double largest_ = 0;           ///< |q| so far, mm or degrees
  double rounding_ = 0;
  std::optional<double> greatest_;
};

}  // namespace leadscrew::referee
