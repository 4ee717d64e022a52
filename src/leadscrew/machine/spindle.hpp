#pragma once
// A simulated spindle: how fast it takes up speed, and how its speed wanders.

#include <cstdint>
#include <leadscrew/base/diagnostic.hpp>
#include <vector>

namespace leadscrew::machine {

struct Spindle {
  double acceleration = 1000;  ///< revolutions per minute per second, 1 … 1e9
  double wander = 0;           ///< 0 … 0.2: by how large a share its speed leaves what S asks for, at most
  double wander_period = 1;    ///< s, 0.1 … 1000: of the slowest of the three waves that its speed wanders by
  std::uint64_t seed = 0;      ///< their sizes and phases

  friend bool operator==(const Spindle&, const Spindle&) = default;
};

/// Appends `machine-spindle` for each value outside its range.
void check_spindle(const Spindle& spindle, std::vector<base::Diagnostic>& problems);

}  // namespace leadscrew::machine
