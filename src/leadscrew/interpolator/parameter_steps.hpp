#pragma once
// The published rules by which real-time interpolators step along a parametric curve: given the parameter u of this
// word and the distance VT to travel until the next, the parameter of the next. Kept for comparison; what the cycle
// uses otherwise is the curve's own map from arc length to parameter, which needs no rule.
//
//   uniform     Δu = (u_end − u_begin) · VT / length
//   taylor1     Δu = VT / |C′|
//   taylor2     Δu = VT / |C′| − (C′·C″)(VT)² / (2|C′|⁴)
//   newton      Δu of taylor2, then twice   Δu ← Δu + (VT − |d|) / (d·C′(u + Δu)/|d|),   d = C(u + Δu) − C(u)
//   arc_length  u(s + VT)
//
// (Koren and Lin's real-time interpolators for taylor1; Taylor's series of u(t) to second order with constant V for
// taylor2; newton makes the chord between the words VT long, as a feed is measured.)
//
// C and its derivatives are taken over the coordinates by which the length of the piece is told (geometry::Nurbs).

#include <array>
#include <cstdint>
#include <leadscrew/geometry/nurbs.hpp>
#include <string_view>

namespace leadscrew::interpolator {

enum class StepRule : std::uint8_t { uniform, taylor1, taylor2, newton, arc_length };

inline constexpr std::array<StepRule, 5> all_step_rules = {StepRule::arc_length, StepRule::taylor1, StepRule::taylor2,
                                                           StepRule::newton, StepRule::uniform};

/// As the command line spells it: "arc-length", "taylor1", …
constexpr std::string_view name(StepRule rule) {
  switch (rule) {
    case StepRule::uniform:
      return "uniform";
    case StepRule::taylor1:
      return "taylor1";
    case StepRule::taylor2:
      return "taylor2";
    case StepRule::newton:
      return "newton";
    case StepRule::arc_length:
      return "arc-length";
  }
  return "";
}

/// The parameter of the next word, at most last_parameter(): a step that would pass the end stops there.
///
/// u         parameter of this word, in [first_parameter(), last_parameter()]
/// s         path length that the time law gives for this word, from the piece's start, units of the piece's length;
///           only arc_length uses it
/// distance  what the time law travels until the next word (VT where the speed is constant), same units, ≥ 0
///
/// arc_length is parameter(s + distance): it does not use u, so no error accumulates. All others march: u is where
/// the words are, s where they ought to be, and the two part by the errors of the steps. A march knows its end only by
/// u: it may arrive before the time law does (then it stands there) or after (then what is missing falls into the
/// caller's last step, to the end of the piece). The caller keeps u from word to word and begins each piece at
/// first_parameter().
///
/// Where a rule gives no step forward, the simpler one does: taylor2 falls back to taylor1, newton keeps what it has,
/// and where C′ = 0 the step is uniform. Near a cusp a Taylor step may end anywhere: one that leads farther away than
/// ten times the distance is halved until it does not. At most five evaluations of the curve, and two for each of at
/// most 60 halvings; no allocation, no unbounded loop.
double next_parameter(const geometry::Nurbs& curve, StepRule rule, double u, double s, double distance);

}  // namespace leadscrew::interpolator
