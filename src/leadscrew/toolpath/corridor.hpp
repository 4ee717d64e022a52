#pragma once
// The corridor around programmed lines and arcs: every point within each leg's margin of it. And a motion in it as a
// uniform cubic B-spline in time, whose differences of control points are its jerk, acceleration and velocity:
//
//     |Δ³c| ≤ j h³     |Δ²c| ≤ a h²     |Δc| ≤ v h     h: the interval, s
//
// Times are counted in intervals; knot k is at time k. Only its path is of use: how fast that is travelled in the end,
// the planner finds anew.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace leadscrew::toolpath {

inline constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Of two coordinates or three, mm.
template <std::size_t D>
using Vector = std::array<double, D>;

template <std::size_t D>
Vector<D> along(const Vector<D>& a, double factor, const Vector<D>& b) {
  Vector<D> sum;
  for (std::size_t i = 0; i < D; ++i) sum[i] = a[i] + factor * b[i];
  return sum;
}
template <std::size_t D>
Vector<D> between(const Vector<D>& from, const Vector<D>& to) {
  return along(to, -1, from);
}
template <std::size_t D>
double inner(const Vector<D>& a, const Vector<D>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < D; ++i) sum += a[i] * b[i];
  return sum;
}
template <std::size_t D>
double size(const Vector<D>& a) {
  return std::sqrt(inner(a, a));
}

/// A line, or an arc of at most half a turn in the plane of two coordinates.
template <std::size_t D>
struct CorridorLeg {
  Vector<D> from{}, to{};
  double length = 0;
  double margin = 0;  ///< > 0, mm
  double feed = 0;    ///< greatest speed, mm/s; infinite for a rapid
  bool is_arc = false;
  std::size_t first = 0, second = 1;  ///< coordinates of the plane
  Vector<D> center{};                 ///< in that plane
  double turn = 0;                    ///< radians, from first to second positive
  double radius = 0;
  Vector<D> direction{};  ///< of a line

  /// s from 0 to length.
  Vector<D> at(double s) const;
  /// Direction there, length 1.
  Vector<D> tangent(double s) const;

  struct Nearest {
    Vector<D> offset{};      ///< from the nearest place of the leg
    Vector<D> tangent{};     ///< there, length 1
    bool is_beyond = false;  ///< that place is an end, and the offset no normal of the leg
  };
  Nearest nearest(const Vector<D>& x) const;
  /// How far along the leg the nearest place is, mm.
  double advance(const Vector<D>& x) const;
};

template <std::size_t D>
CorridorLeg<D> line_leg(const Vector<D>& from, const Vector<D>& to, double margin, double feed);
template <std::size_t D>
CorridorLeg<D> arc_leg(const Vector<D>& from, const Vector<D>& to, std::size_t first, std::size_t second,
                       const Vector<D>& center, double turn, double margin, double feed);

/// Of the machine, by coordinate: mm/s, mm/s², mm/s³.
template <std::size_t D>
struct CorridorLimits {
  Vector<D> velocity{}, acceleration{}, jerk{};
};

/// Where a motion begins or ends.
enum class CorridorEnd : unsigned char {
  rest,
  moving,  ///< with the three control points that it has there, as fast as h then makes it
};

template <std::size_t D>
struct Corridor {
  std::vector<CorridorLeg<D>> legs;  ///< each begins where the one before ends
  CorridorLimits<D> limits;
  CorridorEnd begin = CorridorEnd::rest, end = CorridorEnd::rest;

  /// How near the motion passes the end of a leg.
  double margin_at(std::size_t joint) const { return std::min(legs[joint].margin, legs[joint + 1].margin); }
};

template <std::size_t D>
struct TimeSpline {
  std::vector<Vector<D>> points;  ///< intervals() + 3
  std::vector<double> passes;     ///< when it passes the end of each leg but the last
  double interval = 0;            ///< h, s

  std::size_t intervals() const { return points.size() - 3; }
  double seconds() const { return static_cast<double>(intervals()) * interval; }
  Vector<D> at(double time) const;
};

}  // namespace leadscrew::toolpath
