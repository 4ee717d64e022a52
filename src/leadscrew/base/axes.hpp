#pragma once
// The nine axes of RS274/NGC and arrays indexed by them.
//
// Axis coordinates are millimetres for the linear axes X Y Z U V W and degrees for the rotary axes A B C, in every door
// of the house: a programmed A45 is 45 in the word that leaves, bit for bit. Angles inside formulas are radians.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace leadscrew::base {

/// Linear axes X Y Z and, beside them, U V W; rotary axes A B C about X Y Z.
enum class Axis : std::uint8_t { X, Y, Z, A, B, C, U, V, W };

inline constexpr std::size_t axis_count = 9;  ///< of a machine, at most

/// In the order of an AxisVector.
inline constexpr std::array<Axis, axis_count> all_axes = {Axis::X, Axis::Y, Axis::Z, Axis::A, Axis::B,
                                                          Axis::C, Axis::U, Axis::V, Axis::W};

/// Its place in an AxisVector, 0 … 8.
constexpr std::size_t index(Axis axis) {
  return static_cast<std::size_t>(axis);
}

/// As programs and traces name it, such as 'X'.
constexpr char letter(Axis axis) {
  return "XYZABCUVW"[index(axis)];
}

/// Degrees, not mm?
constexpr bool is_rotary(Axis axis) {
  return axis == Axis::A || axis == Axis::B || axis == Axis::C;
}

/// One value for each axis; by default mm for linear and degrees for rotary axes.
using AxisVector = std::array<double, axis_count>;

/// A set of axes.
class AxisSet {
 public:
  constexpr AxisSet() = default;

  /// Is it one of them?
  constexpr bool contains(Axis axis) const { return (bits_ >> index(axis)) & 1u; }
  /// Adds one, or all of others.
  constexpr void insert(Axis axis) { bits_ = static_cast<std::uint16_t>(bits_ | (1u << index(axis))); }
  /// The same.
  constexpr void insert(AxisSet others) { bits_ = static_cast<std::uint16_t>(bits_ | others.bits_); }
  /// Takes one out.
  constexpr void erase(Axis axis) { bits_ = static_cast<std::uint16_t>(bits_ & ~(1u << index(axis))); }
  /// How many there are.
  constexpr int size() const { return std::popcount(bits_); }
  /// Is there none?
  constexpr bool empty() const { return bits_ == 0; }
  /// Bit index(axis) of each.
  constexpr std::uint16_t bits() const { return bits_; }

  friend constexpr bool operator==(AxisSet, AxisSet) = default;

 private:
  std::uint16_t bits_ = 0;
};

}  // namespace leadscrew::base
