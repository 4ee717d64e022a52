#pragma once
// Two rotary axes as formulas need them.
//
// From the workpiece to the tool there are always two turns, whichever of them belong to the table and whichever to the
// head. With ez the direction from the tip to the spindle while all rotary axes are at 0, a tool in machine coordinates,
// and O the same seen from the workpiece,
//
//     O = W₁ W₂ ez        W = R(θ) of an axis that carries the tool, R(θ)ᵀ of one that carries the workpiece
//
//     table-table   W₁: the axis that holds the part    W₂: the one at the bed
//     mixed         W₁: the table's                     W₂: the head's
//     head-head     W₁: the one at the ram              W₂: the one that holds the tool
//
// so that one solution serves all of them. R is the right-handed rotation about the axis' direction by sign·θ.

#include <array>
#include <cstddef>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/result.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <vector>

namespace leadscrew::kinematics {

using machine::Vector;

/// One rotary axis.
struct Turn {
  base::Axis axis = base::Axis::A;
  Vector direction{};  ///< a unit vector
  Vector point{};      ///< on the axis, mm
  double sign = 1;     ///< 1 or −1: of the angle by the right hand's rule about `direction`
  /// 0, 1 or 2 where the direction is that of x, y or z, to the last bit; 3 where it is another.
  std::size_t principal = 3;

  friend bool operator==(const Turn&, const Turn&) = default;
};

/// What solving for the two angles needs of the directions. η is the angle between the tool's direction and that of the first
/// turn, γ the one between the turns, κ the one between the second turn and ez; a tool is held at every η from |γ − κ| to the
/// lesser of γ + κ and 2π − γ − κ, and where one of these is 0 or π there is a pole.
struct Cones {
  Vector across{};  ///< the direction of the second turn less its part along the first, a unit vector
  Vector normal{};  ///< first × across
  double difference_sine = 0, difference_cosine = 1;  ///< of (γ − κ)/2; the sine exactly 0 where there is a pole
  double sum_sine = 1, sum_cosine = 0;                ///< of (γ + κ)/2; the cosine exactly 0 where there is a pole
  double tool_azimuth = 0;  ///< of ez about the second turn, from the direction of the first, degrees

  friend bool operator==(const Cones&, const Cones&) = default;
};

/// A chain that is sound, ready to be evaluated.
class Chain {
 public:
  /// Codes: those of machine::check_chain(), the first that it finds.
  static base::Result<Chain> of(const machine::RotaryChain& chain);

  /// From the workpiece to the tool.
  const std::array<Turn, 2>& turns() const { return turns_; }
  /// How many of them, from the first on, carry the workpiece.
  std::size_t table_count() const { return table_count_; }
  /// Where the gauge point is while the points of axes that carry the tool are as told, mm.
  const Vector& tool_zero() const { return tool_zero_; }
  /// For solutions().
  const Cones& cones() const { return cones_; }

  friend bool operator==(const Chain&, const Chain&) = default;

 private:
  Chain() = default;

  std::array<Turn, 2> turns_;
  std::size_t table_count_ = 0;
  Vector tool_zero_{};
  Cones cones_;
};

/// Of a machine that machine::validate() finds sound, and that has a chain.
Chain chain_of(const machine::Machine& machine);

/// The directions of the tool, unit vectors, at which the first turn may be any: none, one or both along it.
std::vector<Vector> poles_of(const Chain& chain);

/// Of a tool of this direction, a unit vector, to the nearest of them: degrees, 0 to 180; infinite where there is none.
double angle_to_pole(const Chain& chain, const Vector& direction);

/// The tool's direction turns by no more than so many times the root of the sum of squares of what both axes turn by: 1 where
/// one is across the other, and up to √2. |u₁ dθ₁ + u₂ dθ₂|² ≤ (1 + |u₁·u₂|)(dθ₁² + dθ₂²).
double most_turned(const Chain& chain);

}  // namespace leadscrew::kinematics
