#pragma once
// A simulated touch probe: in contact wherever the controlled point is at or below a plane of an axis.

#include <array>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/diagnostic.hpp>
#include <optional>
#include <vector>

namespace leadscrew::machine {

struct Machine;

/// Where it trips. Of several planes each is enough.
struct Probe {
  /// Coordinates of the machine of the controlled point, which is where the axes stand less the tool's offset (G43); mm.
  /// An axis without a plane touches nothing.
  std::array<std::optional<double>, base::axis_count> planes{};

  friend bool operator==(const Probe&, const Probe&) = default;
};

/// Appends `machine-probe` for each plane that is none: it is not finite, or its axis is rotary or not there.
void check_probe(const Machine& machine, std::vector<base::Diagnostic>& problems);

}  // namespace leadscrew::machine
