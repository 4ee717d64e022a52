#pragma once
// Samples of a section that say how far knots may lie apart, and knots placed by them: as many between two places as
// ∫ ds/h asks for, h straight between samples.

#include <cstddef>
#include <leadscrew/planner/knots.hpp>
#include <span>

namespace leadscrew::planner {

struct KnotSample {
  double s = 0;             ///< on the section
  double greatest = 0;      ///< greatest x here by every limit taken alone
  double cap = 0;           ///< and by the distance from rest
  double reach = 0;         ///< the same, and reachable within the tangent acceleration
  double h_curve = 0;       ///< bound of h by the curve
  double a = 0, j = 0;      ///< what the tangent allows of acceleration and jerk
  double h = 0;             ///< how far knots may lie apart
  bool is_by_feed = false;  ///< is it feed that says the greatest?
};

/// At s on a section, `from_rest` before or behind the nearest place of rest: all but h, and reach no farther than the cap.
/// is_of_tip: are axes moved by a transformation there? Then degrees and millimetres are beside one another, and a unit of
/// path length may be many of either: in what the curve asks each axis counts as its limit has it beside the one that binds
/// the tangent.
KnotSample sample_of(const constraints::Place& place, double s, double from_rest, bool is_of_tip,
                     const constraints::Constraints& constraints);

/// Lowers h until it grows along the section, forwards and backwards, by no more than `grading` of the distance.
void grade(std::span<KnotSample> samples, double grading);

/// Appends knots behind `from` up to `to`, a break: equal quantiles of ∫ ds/h. `first` is the sample at or before
/// `from`; returns that of `to`. Ends where there are more than `most` knots, before `to`.
std::size_t place_quantiles(std::span<const KnotSample> samples, double from, double to, std::size_t first,
                            std::size_t most, Knots& knots);

}  // namespace leadscrew::planner
