#pragma once
// How far two polylines are apart, travelled in order: Fréchet's distance.

#include <leadscrew/geometry/point.hpp>
#include <span>

namespace leadscrew::toolpath {

/// Can both be travelled from end to end, never backwards, at speeds of their own, so that the two are never farther
/// apart than `distance`? (Alt and Godau, "Computing the Fréchet distance between two polygonal curves", 1995.) Each
/// has a point at least. The work is the product of their lengths.
bool is_frechet_within(std::span<const geometry::Point> a, std::span<const geometry::Point> b, double distance);

}  // namespace leadscrew::toolpath
