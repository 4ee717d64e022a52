#pragma once
// Positions, one a period, beside the limits of a machine's axes X, Y and Z.

#include <algorithm>
#include <cmath>
#include <leadscrew/machine/machine.hpp>
#include <vector>

namespace leadscrew::testing_support {

/// The largest difference of the positions over a limit, of the first, second and third order, from `from` on.
inline double worst_ratio(const std::vector<base::AxisVector>& q, const machine::Machine& machine, std::size_t from) {
  const double T = machine.period.seconds();
  double worst = 0;
  for (std::size_t k = from; k < q.size(); ++k) {
    for (std::size_t i = 0; i < 3; ++i) {
      const machine::AxisLimits& limits = *machine.axes[i];
      const double a = q[k][i], b = q[k - 1][i], c = q[k - 2][i], d = q[k - 3][i];
      worst =
          std::max({worst, std::abs(a - b) / T / limits.velocity, std::abs(a - 2 * b + c) / T / T / limits.acceleration,
                    std::abs(a - 3 * b + 3 * c - d) / T / T / T / limits.jerk});
    }
  }
  return worst;
}

}  // namespace leadscrew::testing_support
