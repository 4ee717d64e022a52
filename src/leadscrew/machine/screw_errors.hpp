#pragma once
// How far lead screws are from their ideal, as measured: errors of pitch in tables, and play.
//
//   real position                     A table says how far from its command an axis really is, at some commands and
//        │            ╱┈┈ nominal      straight between them. Its real position is then a rising broken line of the
//        │         ╱╱┈                 command.
//        │      ╱─╱
//        │   ╱╱┈                       A screw has play: when its axis turns back, the nut stays until the command
//        └──────────────▶ command      has gone back by the backlash.

#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/diagnostic.hpp>
#include <vector>

namespace leadscrew::machine {

/// One line of a table: commanded to `position`, the axis is at position + error. mm or degrees.
struct PitchError {
  double position = 0;  ///< commanded
  double error = 0;     ///< what is added to it
};

/// Of one axis. Beyond its ends a table goes on with its first and last errors; an empty one has none.
struct ScrewErrors {
  std::vector<PitchError> table;  ///< positions rising; where the axis runs towards +, or in both directions
  /// Where it runs towards −; empty: the same. What was measured in that direction holds the backlash already; what is
  /// given as backlash comes on top.
  std::vector<PitchError> backward_table;
  double backlash = 0;         ///< mm or degrees; ≥ 0
  double takeup_velocity = 0;  ///< mm/s or degrees/s, at most, for taking it up; ≥ 0, and 0: the axis' greatest

  /// Is it a screw without errors?
  bool none() const { return table.empty() && backward_table.empty() && backlash == 0; }
};

/// Errors may change by this share of the distance from entry to entry; more is taken for a misprint.
inline constexpr double greatest_pitch_slope = 0.1;

/// Adds every way in which they contradict the ranges above. Codes: `pitch-value`, `pitch-order`, `pitch-slope`, each
/// with its entry, counted from 1; `backlash`, `backlash-takeup`.
void check_screw(base::Axis axis, const ScrewErrors& errors, std::vector<base::Diagnostic>& problems);

}  // namespace leadscrew::machine
