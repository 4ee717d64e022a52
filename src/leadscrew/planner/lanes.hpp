#pragma once
// Four numbers that are worked on together, as vectors of the processor hold them.

#include <array>

namespace leadscrew::planner {

struct alignas(32) Lanes : std::array<double, 4> {};

}  // namespace leadscrew::planner
