#pragma once
// Two rotary axes that turn the tool against the workpiece, as data: which they are, where each lies, and what it carries.
//
//   table-table-ac          head-head-bc            head-b-table-c
//     Z│                      ram                     ram
//      ▼ tool                  │ 1: C                  │ 1: B
//     ┌┴┐                      └┐ 2: B                 └▶ tool
//   1: A ╞═ 2: C ═╡ part        ▼ tool                ╞═ 1: C ═╡ part
//     bed                       part on the bed           bed
//
// Lengths are mm in machine coordinates, taken with all rotary axes at 0. What is made of these numbers, and the sources of
// the formulas, stand in kinematics/.

#include <array>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/diagnostic.hpp>
#include <optional>
#include <string_view>
#include <vector>

namespace leadscrew::machine {

struct Machine;

/// x, y and z.
using Vector = std::array<double, 3>;

/// What turns with a rotary axis.
enum class Carries : std::uint8_t { workpiece, tool };

/// One of the two.
struct RotaryAxis {
  base::Axis axis = base::Axis::A;  ///< A, B or C
  Carries carries = Carries::workpiece;
  Vector direction = {0, 0, 1};  ///< of the axis; a unit vector within 1e-6
  Vector point = {0, 0,
                  0};  ///< any point on the axis, mm; of one that carries the tool, with the linear axes at tool_zero
  /// 1: nearest the bed, of those that carry the workpiece, or nearest the ram, of those that carry the tool; 2: the next.
  std::int64_t order = 1;
  /// 1: a rising coordinate turns what the axis carries by the right hand's rule about its direction; −1: the other way, as
  /// ISO 841 has A′ and C′ of tables.
  std::int64_t sign = 1;

  friend bool operator==(const RotaryAxis&, const RotaryAxis&) = default;
};

/// Both, and what else there is to say of five axes.
struct RotaryChain {
  std::array<RotaryAxis, 2> axes;
  /// Where X, Y and Z stand while the points of axes that carry the tool are as told, mm: the place of the gauge point, which
  /// holds a tool of no length.
  Vector tool_zero = {0, 0, 0};
  double orientation_tolerance = 0.05;  ///< degrees; of the tool's direction, where paths are rounded; > 0
  double pole_cone = 0.1;               ///< degrees; so near a pole motion may lead straight through it; 0 … 10

  friend bool operator==(const RotaryChain&, const RotaryChain&) = default;
};

/// Two rotary axes of a kind that has a name; points are at 0.
struct KinematicsPreset {
  std::string_view name;
  std::array<RotaryAxis, 2> axes;
};

/// The first is that of the paper on real-time interpolation: a turns the part, b the tool.
inline constexpr std::array<KinematicsPreset, 6> kinematics_presets = [] {
  using enum Carries;
  constexpr Vector x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
  const auto axis = [](base::Axis letter, Carries carries, const Vector& direction, std::int64_t order) {
    return RotaryAxis{letter, carries, direction, {0, 0, 0}, order, 1};
  };
  using base::Axis;
  return std::array<KinematicsPreset, 6>{
      {{"head-b-table-a", {axis(Axis::A, workpiece, x, 1), axis(Axis::B, tool, y, 1)}},
       {"table-table-ac", {axis(Axis::A, workpiece, x, 1), axis(Axis::C, workpiece, z, 2)}},
       {"table-table-bc", {axis(Axis::B, workpiece, y, 1), axis(Axis::C, workpiece, z, 2)}},
       {"head-head-bc", {axis(Axis::C, tool, z, 1), axis(Axis::B, tool, y, 2)}},
       {"head-head-ac", {axis(Axis::C, tool, z, 1), axis(Axis::A, tool, x, 2)}},
       {"head-b-table-c", {axis(Axis::C, workpiece, z, 1), axis(Axis::B, tool, y, 1)}}}};
}();

/// "cartesian": each axis is one coordinate of the program.
inline constexpr std::string_view cartesian = "cartesian";

/// A chain of that name with its points at 0; empty of a name that is none.
std::optional<RotaryChain> preset_chain(std::string_view name);

/// Adds every way in which the machine's kinematics and chain contradict the ranges above, one another, or the axes that
/// the machine has. Codes: `machine-kinematics`; `rotary-axis`, `rotary-direction`, `rotary-point`, `rotary-order`, `rotary-sign`,
/// `rotary-parallel` (with one another, or the one that turns the tool's direction first with the tool, Z), `tool-zero`,
/// `orientation-tolerance`, `pole-cone`.
void check_kinematics(const Machine& machine, std::vector<base::Diagnostic>& problems);
/// The same of a chain alone, without `machine-kinematics`.
void check_chain(const RotaryChain& chain, std::vector<base::Diagnostic>& problems);

}  // namespace leadscrew::machine
