#pragma once
// The shortest turn from one direction to another, at a constant rate about one axis: the directions between lie on a great
// circle of the unit sphere.

#include <cmath>
#include <leadscrew/kinematics/chain.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <leadscrew/numeric/vectors.hpp>

namespace leadscrew::kinematics {

inline Vector cross_product(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline Vector unit_vector(const Vector& v) {
  const double length = numeric::hypot(v[0], v[1], v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

/// Radians, 0 … π, exact however small or large; neither need be a unit vector.
inline double angle_between(const Vector& a, const Vector& b) {
  const Vector cross = cross_product(a, b);
  return numeric::atan2(numeric::hypot(cross[0], cross[1], cross[2]), numeric::dot(a, b));
}

/// Are two unit vectors no farther apart than an angle below a right one, of this sine?
inline bool is_within(const Vector& a, const Vector& b, double sine) {
  const Vector cross = cross_product(a, b);
  return numeric::dot(cross, cross) <= sine * sine && numeric::dot(a, b) > 0;
}

/// v turned about a unit vector by an angle in radians, right-handed.
inline Vector turned(const Vector& v, const Vector& axis, double angle) {
  const double along = numeric::dot(axis, v), half = numeric::sin(angle / 2), sine = numeric::sin(angle);
  const Vector cross = cross_product(axis, v);
  Vector result = v;
  for (std::size_t i = 0; i < 3; ++i) result[i] += sine * cross[i] - 2 * half * half * (v[i] - along * axis[i]);
  return result;
}

/// Between two unit vectors that are not opposite.
class GreatCircle {
 public:
  /// Nearer to opposite than this, radians, no plane is told.
  static constexpr double least_opening = 1e-6;

  GreatCircle(const Vector& from, const Vector& to) : from_(from), to_(to), angle_(angle_between(from, to)) {
    const Vector cross = cross_product(from, to);
    const double length = numeric::hypot(cross[0], cross[1], cross[2]);
    if (length > 0) axis_ = {cross[0] / length, cross[1] / length, cross[2] / length};
  }

  /// Radians, 0 … π.
  double angle() const { return angle_; }
  /// Of the turn, a unit vector; 0 where there is none.
  const Vector& axis() const { return axis_; }
  /// The direction at a share of the turn, 0 … 1; the ends exactly.
  Vector at(double share) const {
    if (share <= 0) return from_;
    if (share >= 1) return to_;
    return unit_vector(share < 0.5 ? turned(from_, axis_, share * angle_) : turned(to_, axis_, (share - 1) * angle_));
  }
  /// May it come so near, radians, to a unit vector or its opposite? Quickly, and never false where it does.
  bool may_come_near(const Vector& line, double distance) const {
    const Vector cross = cross_product(line, to_);
    const double reach = angle_ + distance;
    return numeric::dot(cross, cross) <= reach * reach;
  }
  /// The share at which it is nearest to a direction or its opposite, inside 0 … 1; where that is at an end, the end.
  double nearest_to_axis(const Vector& line) const;

 private:
  Vector from_, to_;
  double angle_;
  Vector axis_{};
};

inline double GreatCircle::nearest_to_axis(const Vector& line) const {
  if (!(angle_ > 0)) return 0;
  // cos of the distance is that to the plane times cos(φ − φ₀): its greatest size lies at φ₀ or half a turn from there.
  const Vector ahead = cross_product(axis_, from_);
  const double half_turn = 3.14159265358979323846;
  double place = numeric::atan2(numeric::dot(line, ahead), numeric::dot(line, from_));
  if (place < 0) place += half_turn;  // that of the opposite
  if (place <= angle_) return place / angle_;
  // Outside: the nearer end, of places half a turn apart.
  return place - angle_ < half_turn - place ? 1 : 0;
}

}  // namespace leadscrew::kinematics
