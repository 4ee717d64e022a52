#pragma once
// A tool as a solid, at a pose and swept from one to the next, and where a line enters it.
//
// The solid is a cylinder of radius R − r, from r above the tip upwards, with all that is within r of it: ball, bull nose and flat
// alike. It is convex, and so is the distance from it along any line: Newton's method from outside comes to the place where the
// line enters without overshooting. What a convex solid sweeps while it goes straight ahead is convex too, so that the place of
// entry, as a function of how far the tool has gone, has one minimum: where the line enters with a normal across the travel.

#include <algorithm>
#include <cmath>
#include <leadscrew/measuring/net.hpp>
#include <limits>

namespace leadscrew::measuring {

/// What cuts of a tool.
struct ToolBody {
  double radius = 0;                                        ///< R, mm; > 0
  double corner_radius = 0;                                 ///< r, mm; 0 … R
  double length = std::numeric_limits<double>::infinity();  ///< above the tip, mm; ≥ r

  friend bool operator==(const ToolBody&, const ToolBody&) = default;
};

struct ToolPose {
  Vector tip{};             ///< mm
  Vector axis = {0, 0, 1};  ///< from the tip to the spindle, a unit vector
};

/// How far a point is from the tool, mm, negative inside, and the gradient of that: a unit vector, 0 on the axis.
struct Distance {
  double value = 0;
  Vector gradient{};
};
Distance distance_to(const ToolBody& body, const ToolPose& pose, const Vector& point);

/// A tool on its way from one pose to another near by: a part of a millimetre, a part of a degree.
class SweptTool {
 public:
  SweptTool(const ToolBody& body, const ToolPose& from, const ToolPose& to);

  const ToolBody& body() const { return body_; }
  const ToolPose& from() const { return from_; }

  /// A distance that no point of the sweep is nearer to `point` than, and its gradient where the tool begins.
  Distance least_distance(const Vector& point) const;

  /// False only where entry() would be `above`.
  bool may_enter(const Vector& s, const Vector& n, double above) const;

  /// The least t < `above` at which the line s + t n enters the sweep: 0 or more where the tool leaves something on s, negative,
  /// and not below `below`, where it has cut into it; `above` where it does neither. A tool that lies behind s altogether is passed
  /// over: it leaves s as it is.
  double entry(const Vector& s, const Vector& n, double below, double above) const;

 private:
  /// Where the line enters the tool at a share of the way, and the derivative of that by the share.
  struct Entry {
    double t = 0, slope = 0;
    bool exists = false;
  };
  struct Place {
    Entry entry;
    double share = 0;
  };
  ToolPose pose_at(double share) const;
  double approach(const ToolPose& pose, const Vector& point, const Vector& gradient) const;
  Entry entry_at(double share, const Vector& s, const Vector& n, double below, double above) const;

  double least_between(Place from, Place to, const Vector& s, const Vector& n, double below, double least) const;

  ToolBody body_;
  ToolPose from_;
  Vector travel_{};  ///< of the tip
  Vector turn_{};    ///< of the axis
  bool turns_ = false;
};

// A first look at very many places, most of which go no further.
inline bool SweptTool::may_enter(const Vector& s, const Vector& n, double above) const {
  const Vector q = {s[0] + above * n[0] - from_.tip[0], s[1] + above * n[1] - from_.tip[1],
                    s[2] + above * n[2] - from_.tip[2]};
  const auto dot = [](const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
  const double z = dot(q, from_.axis), radial = std::sqrt(std::max(0.0, dot(q, q) - z * z));
  const double out = std::max(0.0, radial - (body_.radius - body_.corner_radius));
  const double up = std::min(0.0, z - body_.corner_radius);
  const double far = std::sqrt(out * out + up * up);
  if (far <= body_.corner_radius) return true;
  // The gradient is (out (q − z O)/radial + up O)/far.
  const double by_q = out > 0 ? out / radial : 0, by_axis = up - by_q * z;
  if (above > 0 && by_q * dot(q, n) + by_axis * dot(from_.axis, n) >= 0) return true;
  double nearer = by_q * dot(q, travel_) + by_axis * dot(from_.axis, travel_);
  if (turns_) {
    const double turned = dot(q, turn_), tilted = dot(from_.axis, turn_);
    nearer += (by_q * turned + by_axis * tilted) * z - (by_q * z + by_axis) * turned;
  }
  constexpr double rounding = 1e-10;  // mm
  return (far - body_.corner_radius - rounding) * far <= nearer;
}

}  // namespace leadscrew::measuring
