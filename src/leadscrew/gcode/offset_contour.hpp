#pragma once
// The way of the tool's middle beside a contour, piece by piece, for cutter compensation.
//
//                   . ─ ─ ╮              ╎
//     way ─ ─ ─ ─ ´        ╎             ╎ way
//                 outer    ╎     ─ ─ ─ ─ ┘
//     ────────────┐        ╎        inner    │
//       contour   │        ╎     ────────────┘ contour
//
// Beside a line it is a parallel line, beside an arc an arc about the same centre. At an outer corner an arc about the
// corner joins two of them; at an inner corner both end where they meet, which is where the tool touches both pieces.

#include <leadscrew/gcode/contour.hpp>
#include <optional>

namespace leadscrew::gcode {

/// By how much the tool's middle may be nearer to the contour than its radius: rounding. mm
inline constexpr double clearance_rounding = 5e-7;
/// Ends of ways that are no farther apart are joined without a corner. mm
inline constexpr double joined = 1e-8;

/// A piece of a contour and the way beside it. Lengths are mm, in a plane of the machine.
struct OffsetPiece {
  ContourPiece contour;  ///< as it was programmed; of an arc of more than a whole turn, one whole turn
  ContourPiece way;      ///< of the tool's middle
  double turned = 0;     ///< by which `way` turns where it is an arc: radians, ≥ 0, more than 2π of more than one turn
};

/// A line or an arc that moves in its plane, and the way to its left at the distance `aside`, mm; to its right where that is
/// negative. Nothing where an arc of the contour is no larger than the tool, which is inside it.
std::optional<OffsetPiece> offset_of(const Move& move, double aside);

enum class CornerKind : std::uint8_t {
  none,   ///< the ways meet, but for a rounding that a line between them can make good
  inner,  ///< the tool touches both pieces before it is at the corner
  outer,  ///< the tool goes round the corner
};
CornerKind corner_of(const OffsetPiece& one, const OffsetPiece& two, double aside);

/// At an inner corner: ends the first way and begins the second where they meet. False where they do not, or not within
/// what is left of them.
bool cut_inner_corner(OffsetPiece& one, OffsetPiece& two);

/// Whether the tool's middle keeps the distance `radius`, mm, from a piece of the contour along all of a way.
bool keeps_clear(const OffsetPiece& way, const ContourPiece& contour, double radius);

/// Of an arc whose ends were moved: turns as in Move, 0 where nothing is left of it.
int turns_of(const OffsetPiece& arc);

}  // namespace leadscrew::gcode
