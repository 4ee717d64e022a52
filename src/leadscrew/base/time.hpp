#pragma once
// Time is counted, never accumulated: an integer number of servo periods, each an integer number of nanoseconds.

#include <cstdint>

namespace leadscrew::base {

/// Servo periods since the motion began.
enum class Tick : std::int64_t {};

/// Periods as a number, 0 where motion began.
constexpr std::int64_t count(Tick tick) {
  return static_cast<std::int64_t>(tick);
}
/// One period later.
constexpr Tick next(Tick tick) {
  return Tick{count(tick) + 1};
}

/// The servo period.
struct Period {
  std::int64_t nanoseconds = 1'000'000;  ///< 10 µs … 20 ms

  /// The same in seconds.
  constexpr double seconds() const { return static_cast<double>(nanoseconds) / 1e9; }
  friend constexpr bool operator==(Period, Period) = default;
};

inline constexpr Period shortest_period{10'000};     ///< 10 µs
inline constexpr Period longest_period{20'000'000};  ///< 20 ms

/// Is it one that words can have: from shortest_period to longest_period?
constexpr bool is_valid(Period period) {
  return shortest_period.nanoseconds <= period.nanoseconds && period.nanoseconds <= longest_period.nanoseconds;
}

/// Time of a tick in seconds: the double nearest to n·T as long as n·T in nanoseconds fits 53 bits (104 days).
constexpr double seconds(Tick tick, Period period) {
  return static_cast<double>(count(tick) * period.nanoseconds) / 1e9;
}

}  // namespace leadscrew::base
