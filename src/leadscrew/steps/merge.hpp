#pragma once
// Runs of events in order, made into one.

#include <cstddef>
#include <leadscrew/steps/step_event.hpp>
#include <span>

namespace leadscrew::steps {

/// Merges two runs without branches on what is in them; `out` has room for both. Returns their number.
inline std::size_t merge(std::span<const StepEvent> first, std::span<const StepEvent> second, StepEvent* out) {
  const std::size_t total = first.size() + second.size();
  const StepEvent* a = first.data();
  const StepEvent* b = second.data();
  const StepEvent* const a_end = a + first.size();
  const StepEvent* const b_end = b + second.size();
  while (a != a_end && b != b_end) {
    const StepEvent left = *a, right = *b;
    const bool later = right < left;
    *out++ = later ? right : left;
    a += later ? 0 : 1;
    b += later ? 1 : 0;
  }
  while (a != a_end) *out++ = *a++;
  while (b != b_end) *out++ = *b++;
  return total;
}

}  // namespace leadscrew::steps
