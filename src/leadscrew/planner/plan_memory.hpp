#pragma once
// Short sections that were planned last, for those that are planned of the very same numbers again: bores, arcs of a
// pattern. Where on the machine a path lies does not count, only its derivatives.
//
// Planning depends on nothing but the key, so a window that is found here is, to the last bit, the one that would be
// planned: words do not depend on what is remembered.

#include <cstddef>
#include <leadscrew/planner/section.hpp>
#include <leadscrew/planner/window.hpp>
#include <list>
#include <optional>
#include <vector>

namespace leadscrew::planner {

/// All that a window from rest to rest is planned of on one machine, number by number.
struct WindowKey {
  /// Of a whole section; none of one that goes on, that begins or ends in motion, or that has so many numbers (curves of
  /// many polynomials) that it is not worth it.
  static std::optional<WindowKey> of(const Section& section, const PlannedRange& range, Aim aim,
                                     std::size_t most_intervals);
  bool operator==(const WindowKey& other) const;

  std::vector<double> numbers;
};

/// The memory of one machine's limits.
class PlanMemory {
 public:
  struct Plan {
    WindowKey key;
    Window window;      ///< as it was before any of it was handed out
    double effort = 0;  ///< that planning it took
  };

  /// None if it is not remembered. Valid until the next call.
  const Plan* find(const WindowKey& key);
  /// Forgets those that have not been asked for the longest, to keep below tuning::look_ahead::remembered_bytes.
  void keep(WindowKey key, const Window& window, double effort);

 private:
  static std::size_t bytes(const Plan& plan);

  std::list<Plan> plans_;  ///< that was asked for last first
  std::size_t bytes_ = 0;
};

}  // namespace leadscrew::planner
