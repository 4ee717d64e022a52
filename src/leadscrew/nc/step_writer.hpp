#pragma once
// Steps of pulse after pulse, written into a caller's buffer.

#include <algorithm>
#include <array>
#include <leadscrew/pulse/pulse.hpp>
#include <leadscrew/steps/step_event.hpp>
#include <span>

namespace leadscrew::nc {

class StepWriter {
 public:
  /// buffer.size() ≥ base::axis_count.
  constexpr StepWriter(std::span<steps::StepEvent> buffer, std::int64_t tick)
      : begin_(buffer.data()), at_(begin_), last_(begin_ + (buffer.size() - base::axis_count)), tick_(tick) {}

  /// Is there no space for a pulse of all axes?
  constexpr bool is_full() const { return at_ > last_; }
  constexpr void pass(std::int64_t ticks) { tick_ += ticks; }
  /// A step at this tick, or none; without a branch, which would be mispredicted. Not when full.
  [[gnu::always_inline]] constexpr void put(base::Axis axis, std::int8_t step) {
    *at_ = steps::StepEvent(tick_, axis, step);
    at_ += step & 1;
  }
  /// The last so many written, as far as they are of this tick, in the order of axes.
  constexpr void order(std::size_t most) {
    steps::StepEvent* first = at_;
    while (most-- > 0 && first != begin_ && (first - 1)->tick() == tick_) --first;
    std::sort(first, at_);
  }

  constexpr std::int64_t tick() const { return tick_; }
  constexpr std::span<const steps::StepEvent> written() const { return {begin_, at_}; }

 private:
  steps::StepEvent *begin_, *at_, *last_;
  std::int64_t tick_;
};

}  // namespace leadscrew::nc
