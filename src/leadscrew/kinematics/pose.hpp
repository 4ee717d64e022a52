#pragma once
// From the tool's tip to the machine's axes and back, for any scalar: double for positions, DoubleDouble for words that are
// differenced three times, jets for velocity, acceleration and jerk.
//
//     tip, in the workpiece ──(axes that carry the workpiece)──▶ tip, in the machine
//                                                    axes = tip in the machine − (H − g)
//     g − tool ──(axes that carry the tool)──▶ H = where the tip is, while the linear axes stand at g
//
// Rotary axes are the same on both sides, so there is neither a choice nor a singularity here. With all rotary axes at 0
// axes = tip + tool, as without kinematics: a program that turns nothing moves the same. X Y Z of the tip are coordinates of
// the workpiece as it lies with all rotary axes at 0, with every offset of the program applied but that of the tool.
//
// Turn(e, p, θ) x = p + e(e·(x − p)) + cos θ (x − p − e(e·(x − p))) + sin θ e×(x − p)        (Rodrigues)
//
// The forms for single machines agree with those of tutorials and of LinuxCNC's trtfuncs.c (its manual, "5-Axis Kinematics"),
// with conventional_directions = 0.

#include <array>
#include <cmath>
#include <cstddef>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/kinematics/chain.hpp>
#include <leadscrew/numeric/elementary.hpp>
#include <type_traits>

namespace leadscrew::kinematics {

/// x, y and z.
template <typename T>
using Vector3 = std::array<T, 3>;

/// One for each axis of RS274/NGC: mm, and degrees of A, B and C.
template <typename T>
using Coordinates = std::array<T, base::axis_count>;

/// Degrees of both rotary axes, in the order of Chain::turns().
template <typename T>
using Angles = std::array<T, 2>;

namespace detail {

/// The number as any scalar.
template <typename T>
T constant(double value) {
  if constexpr (std::is_same_v<T, numeric::Jet<3, numeric::Pair>>) {
    return numeric::all<numeric::Pair>(value);
  } else {
    return T(value);
  }
}

template <typename T>
T scaled(const T& value, double factor) {
  return value * factor;
}
template <std::size_t N, typename T>
numeric::Jet<N, T> scaled(const numeric::Jet<N, T>& value, double factor) {
  numeric::Jet<N, T> result;
  for (std::size_t k = 0; k <= N; ++k) result[k] = scaled(value[k], factor);
  return result;
}

template <typename T>
void add(T& value, double constant) {
  value = value + T(constant);
}
template <std::size_t N, typename T>
void add(numeric::Jet<N, T>& value, double constant) {
  value[0] = value[0] + numeric::all<T>(constant);
}

template <typename T>
T dot(const Vector& fixed, const Vector3<T>& v) {
  return scaled(v[0], fixed[0]) + scaled(v[1], fixed[1]) + scaled(v[2], fixed[2]);
}

using numeric::Pair;

/// Turned about z, so to speak, with derivatives: (v_i, v_j) c + (−v_j, v_i) s. The bits are those of products of jets.
inline void rotate_principal(numeric::Jet<>& a, numeric::Jet<>& b, const numeric::Jet<>& c, const numeric::Jet<>& s) {
  const Pair v0 = {a.value, b.value}, v1 = {a.first, b.first}, v2 = {a.second, b.second}, v3 = {a.third, b.third};
  const Pair w0 = {-b.value, a.value}, w1 = {-b.first, a.first}, w2 = {-b.second, a.second}, w3 = {-b.third, a.third};
  const Pair value = c.value * v0 + s.value * w0;
  const Pair first = (c.first * v0 + c.value * v1) + (s.first * w0 + s.value * w1);
  const Pair second =
      (c.second * v0 + 2 * c.first * v1 + c.value * v2) + (s.second * w0 + 2 * s.first * w1 + s.value * w2);
  const Pair third = (c.third * v0 + 3 * c.second * v1 + 3 * c.first * v2 + c.value * v3) +
                     (s.third * w0 + 3 * s.second * w1 + 3 * s.first * w2 + s.value * w3);
  a = {value[0], first[0], second[0], third[0]};
  b = {value[1], first[1], second[1], third[1]};
}

/// v turned about an axis through 0, by an angle of this sine and cosine in the axis' own sense.
template <typename T>
void rotate(Vector3<T>& v, const Turn& turn, const numeric::SinePair<T>& sines) {
  const T& c = sines.cosine;
  const T s = turn.sign < 0 ? -sines.sine : sines.sine;
  if (turn.principal < 3) {
    const std::size_t i = (turn.principal + 1) % 3, j = (turn.principal + 2) % 3;
    if constexpr (std::is_same_v<T, numeric::Jet<>>) return rotate_principal(v[i], v[j], c, s);
    const T turned = c * v[i] - s * v[j];
    v[j] = s * v[i] + c * v[j];
    v[i] = turned;
    return;
  }
  const Vector& e = turn.direction;
  const T along = dot(e, v);
  const Vector3<T> cross = {scaled(v[2], e[1]) - scaled(v[1], e[2]), scaled(v[0], e[2]) - scaled(v[2], e[0]),
                            scaled(v[1], e[0]) - scaled(v[0], e[1])};
  for (std::size_t i = 0; i < 3; ++i) {
    const T part = scaled(along, e[i]);
    v[i] = part + c * (v[i] - part) + s * cross[i];
  }
}

/// The same about the axis where it lies.
template <typename T>
void rotate_about(Vector3<T>& v, const Turn& turn, const numeric::SinePair<T>& sines) {
  for (std::size_t i = 0; i < 3; ++i) add(v[i], -turn.point[i]);
  rotate(v, turn, sines);
  for (std::size_t i = 0; i < 3; ++i) add(v[i], turn.point[i]);
}

template <typename T>
numeric::SinePair<T> backwards(const numeric::SinePair<T>& sines) {
  return {-sines.sine, sines.cosine};
}

/// How far the tip is from where it is with all rotary axes at 0 and no tool, on the side of the head: H − g.
template <typename T>
Vector3<T> head_offset(const Chain& chain, const std::array<numeric::SinePair<T>, 2>& sines, const Vector& tool) {
  const Vector& zero = chain.tool_zero();
  if (chain.table_count() == 2) return {constant<T>(-tool[0]), constant<T>(-tool[1]), constant<T>(-tool[2])};
  Vector3<T> tip = {constant<T>(zero[0] - tool[0]), constant<T>(zero[1] - tool[1]), constant<T>(zero[2] - tool[2])};
  for (std::size_t i = 2; i-- > chain.table_count();) rotate_about(tip, chain.turns()[i], sines[i]);
  for (std::size_t i = 0; i < 3; ++i) tip[i] = tip[i] - constant<T>(zero[i]);
  return tip;
}

template <typename T>
std::array<numeric::SinePair<T>, 2> sines_of(const Chain& chain, const Coordinates<T>& coordinates) {
  return numeric::sines_of_both_degrees(coordinates[base::index(chain.turns()[0].axis)],
                                        coordinates[base::index(chain.turns()[1].axis)]);
}

}  // namespace detail

/// Of both rotary axes.
template <typename T>
Angles<T> angles_of(const Chain& chain, const Coordinates<T>& coordinates) {
  return {coordinates[base::index(chain.turns()[0].axis)], coordinates[base::index(chain.turns()[1].axis)]};
}

/// Where the axes are while the tip is at X Y Z of the workpiece and the rotary axes as they are: X, Y and Z become those of
/// the axes, all others stay. `tool`: offset of the tool in X, Y and Z, mm; its length is that in Z.
template <typename T>
Coordinates<T> machine_of(const Chain& chain, const Coordinates<T>& tip_and_rotary, const Vector& tool) {
  const auto sines = detail::sines_of(chain, tip_and_rotary);
  Coordinates<T> axes = tip_and_rotary;
  Vector3<T> tip = {axes[0], axes[1], axes[2]};
  for (std::size_t i = 0; i < chain.table_count(); ++i) detail::rotate_about(tip, chain.turns()[i], sines[i]);
  const Vector3<T> offset = detail::head_offset(chain, sines, tool);
  for (std::size_t i = 0; i < 3; ++i) axes[i] = tip[i] - offset[i];
  return axes;
}

/// The way back: where the tip is in the workpiece while the axes are there.
template <typename T>
Coordinates<T> pose_of(const Chain& chain, const Coordinates<T>& axes, const Vector& tool) {
  const auto sines = detail::sines_of(chain, axes);
  const Vector3<T> offset = detail::head_offset(chain, sines, tool);
  Vector3<T> tip = {axes[0] + offset[0], axes[1] + offset[1], axes[2] + offset[2]};
  for (std::size_t i = chain.table_count(); i-- > 0;) {
    detail::rotate_about(tip, chain.turns()[i], detail::backwards(sines[i]));
  }
  Coordinates<T> pose = axes;
  for (std::size_t i = 0; i < 3; ++i) pose[i] = tip[i];
  return pose;
}

/// The unit vector from the tip to the spindle, seen from the workpiece.
template <typename T>
Vector3<T> direction_of(const Chain& chain, const Angles<T>& degrees) {
  using numeric::sines_of_degrees;
  Vector3<T> direction = {T(0.0), T(0.0), T(1.0)};
  for (std::size_t i = 2; i-- > 0;) {
    const numeric::SinePair<T> sines = sines_of_degrees(degrees[i]);
    const bool is_table = i < chain.table_count();
    detail::rotate(direction, chain.turns()[i], is_table ? detail::backwards(sines) : sines);
  }
  return direction;
}

/// A vector of the workpiece as the machine sees it.
template <typename T>
Vector3<T> in_machine(const Chain& chain, const Angles<T>& degrees, Vector3<T> vector) {
  for (std::size_t i = 0; i < chain.table_count(); ++i)
    detail::rotate(vector, chain.turns()[i], numeric::sines_of_degrees(degrees[i]));
  return vector;
}

/// Compiled once, with the room; whoever is near to it may have it inline.
extern template Coordinates<double> machine_of(const Chain&, const Coordinates<double>&, const Vector&);
extern template Coordinates<double> pose_of(const Chain&, const Coordinates<double>&, const Vector&);
extern template Coordinates<numeric::Jet<>> machine_of(const Chain&, const Coordinates<numeric::Jet<>>&, const Vector&);
extern template Coordinates<numeric::Jet<3, numeric::Pair>> machine_of(
    const Chain&, const Coordinates<numeric::Jet<3, numeric::Pair>>&, const Vector&);
extern template Coordinates<numeric::Jet<>> pose_of(const Chain&, const Coordinates<numeric::Jet<>>&, const Vector&);

}  // namespace leadscrew::kinematics
