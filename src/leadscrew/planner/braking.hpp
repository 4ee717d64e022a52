#pragma once
// A stop of several segments, for where the path bends too much for one cubic: down to a creep in the least time over a
// short part of the window, and from there to rest by one cubic.
//
//   speed  ----.   .-----.              The window's motion is a start strictly inside every limit, as it is for a feed
//               \'.__.'    '            hold. What lies ahead is cut off where motion would long be at rest: the speed
//                \_                     there is free, for it is never travelled.
//                  '-._

#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/planner/section.hpp>
#include <leadscrew/planner/window.hpp>
#include <optional>
#include <vector>

namespace leadscrew::planner {

/// From motion along a window to rest.
struct Tail {
  std::vector<Segment> segments;  ///< on the section
  double end = 0;                 ///< where they come to rest
};

/// From where segment `from` of the window begins, within every limit and within `feed_factor` times the programmed
/// feed, proven between the window's knots as the window is. None if none is found that ends before `farthest`, a place
/// on the section.
std::optional<Tail> brake(const Window& window, std::size_t from, double farthest, const Section& section,
                          const constraints::Constraints& constraints, double feed_factor);

/// Does the stop exceed a limit at one of a few samples? Most that do are seen to by the first.
bool is_seen_to_fail(const Segment& stop, const Section& section, const constraints::Constraints& constraints,
                     double feed_factor);

}  // namespace leadscrew::planner
