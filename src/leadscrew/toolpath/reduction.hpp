#pragma once
// Fewer legs that say the same: lines that run straight on within the same tolerances are one, and so is what happens
// within a small part of the least tolerance of those that it happens to.

#include <leadscrew/toolpath/leg.hpp>
#include <optional>

namespace leadscrew::toolpath {

class Reduction {
 public:
  /// Returns what is no longer to grow.
  std::optional<Leg> push(Leg leg);
  std::optional<Leg> finish();

 private:
  bool join(const Leg& leg);

  std::optional<Leg> open_;
  geometry::Point start_{}, end_{};  ///< of the open leg, mm
  double seconds_ = 0;               ///< that feed lets its legs take, one by one
  double radius_ = 0;                ///< of the ball about its start in which all its inner vertices lie
};

}  // namespace leadscrew::toolpath
