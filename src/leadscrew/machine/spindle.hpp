#pragma once
// A simulated spindle: how fast it takes up speed, and how its speed wanders.

#include <cstdint>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/machine/derivatives.hpp>
#include <vector>

namespace leadscrew::machine {

struct Spindle {
  double acceleration = 1000;  ///< revolutions per minute per second, 1 … 1e9
  double wander = 0;           ///< 0 … 0.2: by how large a share its speed leaves what S asks for, at most
  double wander_period = 1;    ///< s, 0.1 … 1000: of the slowest of the three waves that its speed wanders by
  std::uint64_t seed = 0;      ///< their sizes and phases

  friend bool operator==(const Spindle&, const Spindle&) = default;
};

/// In a tap, by its own time, revolutions per s²: no more than its own, and no more than what motion along a line with these
/// limits (its units, s) and this lead (units, > 0) takes up in step: within the tolerance (units, > 0) of the place that it
/// asks for, even where the spindle brakes before it has taken up its speed. Where its acceleration along the line changes by
/// D at once, it is followed with an error of
///
///     e ≤ D (1.2 T/k + 6 T²) + 2.4 D³/J²,   k = min(J/A, 0.1/T),
///
/// as interpolator::Follower was measured to (tests/pipeline/test_taps.cpp).
double tap_acceleration(const Spindle& spindle, const Derivatives& limits, double lead, double tolerance,
                        base::Period period);

/// Appends `machine-spindle` for each value outside its range.
void check_spindle(const Spindle& spindle, std::vector<base::Diagnostic>& problems);

}  // namespace leadscrew::machine
