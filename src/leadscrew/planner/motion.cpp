#include <cmath>
#include <leadscrew/numeric/bisection.hpp>
#include <leadscrew/planner/motion.hpp>

namespace leadscrew::planner {

numeric::DoubleDouble Chunk::end() const {
  if (segments.empty()) return begin + duration;
  const numeric::DoubleDouble end = segments.back().begin + segments.back().duration;
  const bool is_cut = !stop_tail.empty() && stop_tail.front().begin < end;
  return is_cut ? begin + duration : end;
}

PathState Chunk::first_state() const {
  if (segments.empty()) return {};
  const Segment& first = segments.front();
  return evaluate(first, (begin - first.begin).value());
}

bool is_rest(const PathState& state) {
  return std::abs(state.speed) <= rest_speed && std::abs(state.acceleration) <= rest_acceleration;
}

bool Chunk::begins_at_rest() const {
  if (segments.empty() || segments.front().state == base::MotionState::rest) return true;
  return is_rest(first_state());
}

base::PassedEvent passed_at(base::Tick tick, const PlacedEvent& event) {
  base::PassedEvent passed;
  static_cast<base::Event&>(passed) = event;
  passed.tick = tick;
  passed.path_length = event.path_length;
  return passed;
}

namespace {

template <typename T>
PathStateOf<T> state_after(const Segment& segment, T tau) {
  const double c0 = segment.s0.value(), c1 = segment.v0.value();
  const double c2 = segment.c2, c3 = segment.c3, c4 = segment.c4, c5 = segment.c5;
  return {
      .s = c0 + tau * (c1 + tau * (c2 + tau * (c3 + tau * (c4 + tau * c5)))),
      .speed = c1 + tau * (2 * c2 + tau * (3 * c3 + tau * (4 * c4 + tau * 5 * c5))),
      .acceleration = 2 * c2 + tau * (6 * c3 + tau * (12 * c4 + tau * 20 * c5)),
      .jerk = 6 * c3 + tau * (24 * c4 + tau * 60 * c5),
  };
}

}  // namespace

PathState evaluate(const Segment& segment, double tau) {
  return state_after(segment, tau);
}

PathStateOf<numeric::Pair> evaluate(const Segment& segment, numeric::Pair tau) {
  return state_after(segment, tau);
}

double time_at(const Segment& segment, double s) {
  const auto is_before = [&](double t) { return evaluate(segment, t).s < s; };
  return numeric::bisect(0, segment.duration.value(), 200, is_before, 1e-16).to;
}

}  // namespace leadscrew::planner
