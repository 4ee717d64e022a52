#pragma once
// Sine and cosine of an angle, the same bits on every processor and with every C library: for positions along arcs, which
// are made one by one and, in vectors, many at a time (sine.inl, where the method stands).

#include <leadscrew/numeric/double_double.hpp>
#include <leadscrew/numeric/pair.hpp>

namespace leadscrew::numeric {

struct Sines {
  double sine = 0, cosine = 0;
  double cosine_less_one = 0;  ///< for |angle| ≤ π/4; elsewhere without meaning
};

/// Up to so many radians the operations are those of sine.inl alone.
inline constexpr double greatest_near_angle = 0x1p20;

/// Of angle.hi + angle.lo radians, |angle.lo| ≤ 1/64. Errors are below 0.75 units in the last place for every finite angle,
/// those of cosine_less_one below 1.7; NaN of what is not finite. The sine of −0 is 0.
Sines sines(DoubleDouble angle);

struct SinesOfPair {
  Pair sine{}, cosine{};
};
/// Of two angles, each to the last bit as sines({angle, low}). |angle| ≤ greatest_near_angle, or NaN of it.
SinesOfPair near_sines(Pair angle, Pair low);

}  // namespace leadscrew::numeric
