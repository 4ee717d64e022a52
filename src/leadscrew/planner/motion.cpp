#include <cmath>
#include <leadscrew/planner/motion.hpp>

namespace leadscrew::planner {

bool Chunk::begins_at_rest() const {
  if (segments.empty()) return true;
  const Segment& first = segments.front();
  if (first.state == base::MotionState::rest) return true;
  return std::abs(first.v0.value()) <= rest_speed && std::abs(2 * first.c2) <= rest_acceleration;
}

PathState evaluate(const Segment& segment, double tau) {
  const double c0 = segment.s0.value(), c1 = segment.v0.value();
  const double c2 = segment.c2, c3 = segment.c3, c4 = segment.c4, c5 = segment.c5;
  return {
      .s = c0 + tau * (c1 + tau * (c2 + tau * (c3 + tau * (c4 + tau * c5)))),
      .speed = c1 + tau * (2 * c2 + tau * (3 * c3 + tau * (4 * c4 + tau * 5 * c5))),
      .acceleration = 2 * c2 + tau * (6 * c3 + tau * (12 * c4 + tau * 20 * c5)),
      .jerk = 6 * c3 + tau * (24 * c4 + tau * 60 * c5),
  };
}

}  // namespace leadscrew::planner
