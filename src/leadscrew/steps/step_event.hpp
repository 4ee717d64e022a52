#pragma once
// One step of one axis, as it leaves for a drive: at which tick of the step clock, and in which direction.

#include <compare>
#include <cstdint>
#include <leadscrew/base/axes.hpp>

namespace leadscrew::steps {

/// Packed so that events compare by tick, then by axis. Ticks: 0 … 2⁵⁵ − 1, a century at 10 MHz.
class StepEvent {
 public:
  constexpr StepEvent() = default;
  /// direction: 1 or −1.
  constexpr StepEvent(std::int64_t tick, base::Axis axis, int direction)
      : bits_(tick * 256 + static_cast<std::int64_t>(base::index(axis)) * 2 + (direction > 0 ? 1 : 0)) {}

  constexpr std::int64_t tick() const { return bits_ >> 8; }  ///< of the step's leading edge
  constexpr base::Axis axis() const { return static_cast<base::Axis>((bits_ >> 1) & 127); }  ///< that steps
  constexpr int direction() const { return (bits_ & 1) != 0 ? 1 : -1; }                      ///< 1 or −1
  /// The same so many ticks later.
  constexpr StepEvent later(std::int64_t ticks) const {
    StepEvent event = *this;
    event.bits_ += ticks * 256;
    return event;
  }

  friend constexpr auto operator<=>(StepEvent, StepEvent) = default;

 private:
  std::int64_t bits_ = 0;
};

}  // namespace leadscrew::steps
