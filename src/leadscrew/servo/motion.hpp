#pragma once
// Motion under a constant pull, of which every loop of this room is made: between two changes of its command a drive
// obeys
//
//   x′ = v,   v′ = a − d·v
//
// whose matrix exponential is closed (zero-order hold, exact):
//
//   v(t) = v + (a − d·v)·φ₁      φ₁ = (1 − e^(−d·t))/d      → t     as d → 0
//   x(t) = x + v·φ₁ + a·φ₂       φ₂ = (t − φ₁)/d            → t²/2
//
// A drive with the transfer function K/(s(τs + 1)) has a = K·u/τ and d = 1/τ; a mass pushed by a force has d = 0.

#include <cmath>
#include <limits>

namespace leadscrew::servo {

/// mm and mm/s; degrees where the axis is rotary, encoder pulses in the pulse-driven loop.
struct Motion {
  double position = 0;
  double velocity = 0;
};

/// Constant for a while.
struct Pull {
  double acceleration = 0;  ///< a, at rest, units/s²
  double damping = 0;       ///< d, 1/s; ≥ 0
};

/// φ₁ and φ₂, seconds and seconds².
struct HoldIntegrals {
  double first = 0;
  double second = 0;
};

inline HoldIntegrals hold_integrals(double damping, double time) {
  const double z = damping * time;
  // φ₂/t² = Σ (−z)ᵏ/(k + 2)!: for small z the closed form is a difference of near equals.
  if (z < 0.25) {
    constexpr int terms = 12;
    double sum = 1;
    for (int k = terms; k > 2; --k) sum = 1 - z * sum / k;
    const double second = time * time * sum / 2;
    return {time - damping * second, second};
  }
  const double first = -std::expm1(-z) / damping;
  return {first, (time - first) / damping};
}

/// After `time` ≥ 0, seconds.
inline Motion after(const Motion& from, const Pull& pull, double time) {
  const auto [first, second] = hold_integrals(pull.damping, time);
  return {from.position + from.velocity * first + pull.acceleration * second,
          from.velocity + (pull.acceleration - pull.damping * from.velocity) * first};
}

/// When the velocity passes 0, seconds from now; infinite where it does not, or is 0 now.
///
///   v(t) = 0:   t = ln(1 − d·v/a)/d   → −v/a   as d → 0
inline double time_to_rest(double velocity, const Pull& pull) {
  const bool slows = (velocity > 0 && pull.acceleration < 0) || (velocity < 0 && pull.acceleration > 0);
  if (!slows) return std::numeric_limits<double>::infinity();
  const double undamped = -velocity / pull.acceleration;
  const double z = pull.damping * undamped;
  return z > 0 ? undamped * (std::log1p(z) / z) : undamped;
}

}  // namespace leadscrew::servo
