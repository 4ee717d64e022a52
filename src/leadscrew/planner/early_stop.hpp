#pragma once
// The tail of a slice: the rest of a window may go on for long before it comes to rest where the window ends.
//
//   speed  ----.         .-----.         So a stop by one cubic (emission.hpp) is looked for, from the slice's end or
//               \ '.___.'       '.       from one of the next places where segments meet; the motion up to there stays
//                \.              '--.    as it is. Each place is tried once a window, a few a slice. Where none of
// them comes to rest near enough, the stop has several segments (braking.hpp).

#include <cstddef>
#include <leadscrew/constraints/constraints.hpp>
#include <leadscrew/planner/braking.hpp>
#include <leadscrew/planner/section.hpp>
#include <leadscrew/planner/window.hpp>

namespace leadscrew::planner {

/// From segment `after` of the window on, to rest as early as is known: within every limit, and within `feed_factor`
/// times the programmed feed, or as much more as there is.
Tail tail_of(Window& window, std::size_t after, const Section& section, const constraints::Constraints& constraints,
             double feed_factor);

}  // namespace leadscrew::planner
