#pragma once
// From the end of one pass to the beginning of the next: off the surface, without a step of direction or curvature.

#include <leadscrew/surfaces/pass_nodes.hpp>

namespace leadscrew::surfaces {

/// None where the log has a failure.
std::optional<Pass> link_between(PassLog& log, const PassNode& from, const PassNode& to);

}  // namespace leadscrew::surfaces
