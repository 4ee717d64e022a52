#include <algorithm>
#include <cmath>
#include <leadscrew/measuring/swept_tool.hpp>
#include <leadscrew/numeric/vectors.hpp>

namespace leadscrew::measuring {

using numeric::dot;
using numeric::sum;

Distance distance_to(const ToolBody& body, const ToolPose& pose, const Vector& point) {
  const Vector from_tip = numeric::difference(point, pose.tip);
  const double z = dot(from_tip, pose.axis);
  const Vector aside = sum(from_tip, -z, pose.axis);
  const double radial = numeric::norm(aside);
  // From the edge of the cylinder that the rest lies about: outwards and upwards.
  const double out = radial - (body.radius - body.corner_radius), up = z - body.corner_radius;
  double by_out = 0, by_up = 0;  // the gradient along the two
  Distance distance;
  if (up < 0 && out > 0) {
    const double far = std::sqrt(out * out + up * up);
    distance.value = far - body.corner_radius;
    by_out = out / far, by_up = up / far;
  } else if (out > -up) {
    distance.value = out - body.corner_radius;
    by_out = 1;
  } else {
    distance.value = -up - body.corner_radius;
    by_up = -1;
  }
  if (z - body.length > distance.value) {
    distance.value = z - body.length;
    by_out = 0, by_up = 1;
  }
  const double share = radial > 0 ? by_out / radial : 0;
  for (std::size_t k = 0; k < 3; ++k) distance.gradient[k] = share * aside[k] + by_up * pose.axis[k];
  return distance;
}

SweptTool::SweptTool(const ToolBody& body, const ToolPose& from, const ToolPose& to)
    : body_(body),
      from_(from),
      travel_(numeric::difference(to.tip, from.tip)),
      turn_(numeric::difference(to.axis, from.axis)) {
  turns_ = dot(turn_, turn_) > 0;
}

ToolPose SweptTool::pose_at(double share) const {
  if (share == 0) return from_;
  ToolPose pose{sum(from_.tip, share, travel_), from_.axis};
  if (!turns_) return pose;
  pose.axis = sum(from_.axis, share, turn_);
  const double length = numeric::norm(pose.axis);
  for (double& coordinate : pose.axis) coordinate /= length;
  return pose;
}

/// How much the tool's surface comes towards `point` of it, along the gradient there, on the whole way.
double SweptTool::approach(const ToolPose& pose, const Vector& point, const Vector& gradient) const {
  double along = dot(travel_, gradient);
  if (!turns_) return along;
  // The point goes with the tool: ω × q, ω = O × dO, is dO (q·O) − O (q·dO).
  const Vector q = numeric::difference(point, pose.tip);
  along += dot(turn_, gradient) * dot(q, pose.axis) - dot(pose.axis, gradient) * dot(q, turn_);
  return along;
}

Distance SweptTool::least_distance(const Vector& point) const {
  Distance distance = distance_to(body_, from_, point);
  distance.value -= std::max(0.0, approach(from_, point, distance.gradient));
  return distance;
}

SweptTool::Entry SweptTool::entry_at(double share, const Vector& s, const Vector& n, double below, double above) const {
  constexpr int most_steps = 60;
  constexpr double enough = 1e-12;  // mm
  const ToolPose pose = pose_at(share);
  double t = 0;
  Distance distance = distance_to(body_, pose, s);
  if (distance.value <= 0) {
    t = below;
    distance = distance_to(body_, pose, sum(s, t, n));
    if (distance.value <= 0) return {below, 0, true};
  }
  for (int step = 0; step < most_steps; ++step) {
    const double fall = -dot(distance.gradient, n);
    if (fall <= 0) return {};
    if (distance.value <= enough) return {t, -approach(pose, sum(s, t, n), distance.gradient) / fall, true};
    t += distance.value / fall;
    if (t >= above + 1) return {};
    distance = distance_to(body_, pose, sum(s, t, n));
  }
  return {};
}

double SweptTool::entry(const Vector& s, const Vector& n, double below, double above) const {
  if (!may_enter(s, n, above)) return above;
  const Entry begin = entry_at(0, s, n, below, above);
  if (begin.exists && begin.slope >= 0) return std::min(above, begin.t);
  // Convex: no entry on the way is before the tangent.
  if (begin.exists && begin.t + begin.slope >= above) return above;
  const Entry end = entry_at(1, s, n, below, above);
  double least = begin.exists ? std::min(above, begin.t) : above;
  if (!end.exists) return least;
  least = std::min(least, end.t);
  if (!begin.exists || end.slope <= 0) return least;
  return least_between({begin, 0}, {end, 1}, s, n, below, least);
}

/// By the slope, until the tangents at both ends leave no more to be found.
double SweptTool::least_between(Place from, Place to, const Vector& s, const Vector& n, double below,
                                double least) const {
  constexpr int most_steps = 12;
  constexpr double enough = 1e-9;  // mm
  for (int step = 0; step < most_steps; ++step) {
    const double steeper = to.entry.slope - from.entry.slope;
    const double crossing = (from.entry.t - to.entry.t + to.entry.slope * (to.share - from.share)) / steeper;
    if (from.entry.t + from.entry.slope * crossing >= least - enough) break;
    // The secant's zero, exact where the entry is a parabola; at every other step where the tangents cross.
    const double at = step % 2 == 0 ? -from.entry.slope / steeper * (to.share - from.share) : crossing;
    const Place middle{entry_at(from.share + at, s, n, below, least), from.share + at};
    if (!middle.entry.exists) break;
    least = std::min(least, middle.entry.t);
    (middle.entry.slope < 0 ? from : to) = middle;
  }
  return least;
}

}  // namespace leadscrew::measuring
