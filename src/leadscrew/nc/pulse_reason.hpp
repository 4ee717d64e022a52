#pragma once
// What happens between registers at one clock, and why the interpolator steps as it does.
//
//   integrators       J ──▶ (+) ──▶ S ──▶ S ≥ q? ──yes──▶ pulse, r = S − q
//                     r ────┘               └────no────▶ r = S
//   searches          the candidates of signals_of() are compared, or the sign of F is looked at

#include <leadscrew/nc/pulse_signals.hpp>
#include <string>

namespace leadscrew::nc {

/// What the next clock of an integrator of one axis adds.
struct Addition {
  std::int64_t integrand = 0;  ///< J, as it is seen: of an axis that comes second, with the first one's new coordinate
  std::int64_t remainder = 0;  ///< r before
  std::int64_t capacity = 1;   ///< q
  std::int64_t left = 0;       ///< steps of the axis before; where there is none it is not clocked
  bool drains = false;         ///< it steps without an overflow: its integrand is 0 and the other axis has arrived
  pulse::Accumulation accumulation =
      pulse::Accumulation::sign_magnitude;  ///< the integrand has a sign but by magnitudes

  std::int64_t sum() const { return remainder + integrand; }
  bool is_clocked() const { return left > 0; }
  /// 1, or −1 where a sum falls below what a remainder may be.
  std::int8_t carry() const { return is_clocked() ? pulse::carry_of(accumulation, sum(), capacity) : std::int8_t{0}; }
  bool overflows() const { return carry() != 0; }
};

/// Of x and of y at the next clock of a run that is not done; empty where the method has no integrators.
std::vector<Addition> next_additions(const PulseRun& run);

/// The last clock, which led from `before` to the run, as numbers: quadrant (0 … 3, from which an arc goes on); of
/// integrators Jx Jy (of arcs, for lines have them as registers), Sx Sy the sums (of an axis that was not clocked r) and
/// ox oy whether they overflowed. The same ones in the same order at every clock, also before the first, where `before`
/// is the run itself.
Registers flow_of(const PulseRun& before, const PulseRun& run, const PulseCurve& curve);

/// A sentence an axis, or one of both, with the numbers that decided, each on a line of its own. Empty before the first
/// clock. "Jx 11 + rx 14 = 25 ≥ 16: overflow, X +1, rx 9"
std::string reason_of(const PulseRun& before, const PulseRun& run, const PulseCurve& curve);

}  // namespace leadscrew::nc
