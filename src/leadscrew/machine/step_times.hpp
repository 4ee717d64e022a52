#pragma once
// What the drive of an axis asks of its step and direction signals.
//
//              length   space
//             ┌──────┐        ┌──────┐             ┌──────┐
//   step   ───┘      └────────┘      └─────────────┘      └───
//                                     hold │ setup
//   direction ─────────────────────────────┴──────────────────

#include <array>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/diagnostic.hpp>
#include <string_view>
#include <vector>

namespace leadscrew::machine {

/// Nanoseconds, each at least.
struct StepTimes {
  std::int64_t step_length = 1000;      ///< 1 … 10⁹
  std::int64_t step_space = 1000;       ///< between steps; 1 … 10⁹
  std::int64_t direction_setup = 1000;  ///< from a change of direction to the next step; 0 … 10⁹
  std::int64_t direction_hold = 1000;   ///< from a step's end to a change of direction; 0 … 10⁹

  friend bool operator==(const StepTimes&, const StepTimes&) = default;
};

/// One of them: as problems name it, and the least it may be.
struct StepTime {
  std::string_view name;            ///< as problems have it
  std::int64_t StepTimes::* value;  ///< which field
  std::int64_t least;               ///< ns
};

/// Each with the least that it may be.
inline constexpr std::array<StepTime, 4> all_step_times = {{{"step length", &StepTimes::step_length, 1},
                                                            {"step space", &StepTimes::step_space, 1},
                                                            {"direction setup", &StepTimes::direction_setup, 0},
                                                            {"direction hold", &StepTimes::direction_hold, 0}}};
inline constexpr std::int64_t longest_step_time = 1'000'000'000;  ///< ns, of each

/// Adds every way in which they contradict the ranges above. Code: `step-time`.
void check_step_times(base::Axis axis, const StepTimes& times, std::vector<base::Diagnostic>& problems);

}  // namespace leadscrew::machine
