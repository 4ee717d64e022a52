#pragma once
// How a program's pulses are made.

#include <leadscrew/nc/block_interpolator.hpp>

namespace leadscrew::nc {

enum class Shape : std::uint8_t {
  constant,    ///< every block at its feed from its first command to its last
  accelerate,  ///< the feed word rises and falls so that no axis exceeds its acceleration
};

struct PulseOptions {
  PulseMethod method = PulseMethod::koren;
  InterpolationOptions interpolation{};
  std::int64_t clock_pps = 1'000'000;                  ///< 1 … 10⁹; Koren's is 5000
  std::int64_t feed_capacity = std::int64_t{1} << 40;  ///< q0, 1 … 2⁴⁰; Koren's is 3000
  std::int64_t step_clocks = 1;                        ///< least clocks from one step of an axis to its next; ≥ 1
  base::Axis slowest_steps = base::Axis::X;            ///< whose clocks those are
  Shape shape = Shape::constant;
};

}  // namespace leadscrew::nc
