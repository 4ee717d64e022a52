#pragma once
// The bounds in force while a speed profile is sought: those of its problem, tightened where the proof of its motion
// has failed and relaxed where a window takes over what it cannot change.

#include <algorithm>
#include <cstddef>
#include <leadscrew/planner/continuation.hpp>
#include <leadscrew/planner/speed_problem.hpp>
#include <span>
#include <vector>

namespace leadscrew::planner {

/// Intervals before an end in motion whose rows are tightened for the stop that follows.
inline constexpr std::size_t stopping_tail = 16;

/// How much of the limits a motion uses, or the factors by which limits are lowered.
struct Ratios {
  double speed = 1;  ///< of what bounds speed: the feed, axis velocities
  double rows = 1;   ///< of acceleration and jerk
  bool turns_back = false;
  double worst() const { return std::max(speed, rows); }
  /// Those above 1 by so much greater.
  Ratios raised(double by) const { return {speed > 1 ? speed + by : speed, rows > 1 ? rows + by : rows, turns_back}; }
};

class SpeedBounds {
 public:
  /// Where rows had to be tightened in the window before, they are again, when there may be less margin for it.
  SpeedBounds(const SpeedProblem& problem, const Continuation& before);

  const SquareCaps& caps() const { return caps_; }
  double tightened(std::size_t interval) const { return tightened_[interval]; }
  std::span<const double> tightened() const { return tightened_; }
  /// What the rows of a site count for, by its index.
  double factor(const SpeedProblem::Site& site, std::size_t index) const {
    return tightened_[site.interval] * relaxed_[index];
  }

  /// The largest ratio of caps and rows from an interval on: below 1 strictly inside. Given coefficients count only
  /// where others bear upon the same limit.
  double greatest_ratio(const SpeedProblem& problem, std::span<const double> c, std::size_t from = 0) const;
  /// Lowers the limits of the interval by these factors.
  void tighten(std::size_t interval, const Ratios& factors);
  /// How far they can be lowered for these coefficients to lie on what is left.
  Ratios margin(const SpeedProblem& problem, std::span<const double> c, std::size_t interval) const;

  /// Raises the greatest speeds to those of these coefficients where these are above, with a margin of their square.
  /// Was any?
  bool relax_caps(const SpeedProblem& problem, std::span<const double> c, double margin);
  /// Back to what is asked, but for these coefficients.
  void restore_caps(const SpeedProblem& problem, std::span<const double> c, double margin);
  /// Relaxes rows that these coefficients pass a little, until they are inside.
  void relax_rows(const SpeedProblem& problem, std::span<const double> c);
  /// Takes back what was relaxed of rows and these coefficients do not need.
  void restore_rows(const SpeedProblem& problem, std::span<const double> c);

  void settle() { relaxed_.shrink_to_fit(); }

 private:
  SquareCaps caps_;
  std::vector<double> tightened_;  ///< of each interval, ≥ 1
  std::vector<double> relaxed_;    ///< of each site, ≤ 1
};

}  // namespace leadscrew::planner
