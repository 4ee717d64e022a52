#pragma once
// How far each interpolator of pulse/ strays from its curve at worst, and what it takes: by trying all curves there are
// up to some size.

#include <leadscrew/study/host.hpp>
#include <leadscrew/study/row.hpp>

namespace leadscrew::study {

/// Full circles of R = 1 … `radius` BLU, counterclockwise from (R, 0).
Rows circle_bounds(const Host& host, std::int64_t radius);
/// Every arc between lattice points of one circle, R² ≤ 900, both ways.
Rows arc_bounds(const Host& host);
/// Every line of the first quadrant to 256 BLU, or as far as the published bound goes.
Rows line_bounds(const Host& host);
/// Turns of the circle generators that have neither quadrants nor counters, R = 1 … 2000.
Rows free_circle_bounds(const Host& host);

/// All of them.
Rows bounds_to(const Host& host, std::int64_t radius);

}  // namespace leadscrew::study
