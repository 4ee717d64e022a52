#pragma once
// The last look at words before drives get them. Whatever made them, a word outside the travel of an axis, or further
// from the last ones than its limits allow, is not published, nor are those made with it: drives that find no word come
// to rest along the stop path that came with the last slice, on the path.

#include <cmath>
#include <leadscrew/base/word.hpp>
#include <leadscrew/machine/machine.hpp>
#include <optional>

namespace leadscrew::drive {

/// What a refused word would have done.
struct RefusedWord {
  enum class Reason { travel, velocity, acceleration };
  Reason reason = Reason::travel;
  base::Axis axis = base::Axis::X;
  double position = 0;  ///< where the word would have led it, mm or degrees
};

class WordGuard {
 public:
  /// The axes stand at `position`, mm or degrees. The machine must outlive this.
  WordGuard(const machine::Machine& machine, const base::AxisVector& position)
      : machine_(&machine), period_(machine.period.seconds()), last_(position), before_(position) {}

  /// The position of the next period. Neither allocates nor locks.
  void observe(const base::AxisVector& position) noexcept {
    for (const base::Axis axis : base::all_axes) {
      if (!refused_) check(axis, position[base::index(axis)]);
    }
    before_ = last_;
    last_ = position;
  }

  /// The first that may not be followed.
  const std::optional<RefusedWord>& refused() const noexcept { return refused_; }

 private:
  static constexpr double at_rest =
      1e-3;  // mm or degrees; axes may stand by rounding or their counts beyond their travel
  static constexpr double tolerated = 1.01;  // of a limit; the planner keeps 1.001
  static constexpr double rounding = 1e-9;   // mm or degrees

  void check(base::Axis axis, double position) noexcept {
    const double last = last_[base::index(axis)], before = before_[base::index(axis)];
    if (!machine_->has(axis)) {
      if (position != last) refuse(RefusedWord::Reason::travel, axis, position);
      return;
    }
    const machine::AxisLimits& limits = machine_->limits(axis);
    const double greatest_step = tolerated * limits.velocity * period_ + rounding;
    const double greatest_change = tolerated * limits.acceleration * period_ * period_ + rounding;
    // NaN is within nothing.
    if (!(position >= limits.travel_min - at_rest && position <= limits.travel_max + at_rest))
      return refuse(RefusedWord::Reason::travel, axis, position);
    if (!(std::abs(position - last) <= greatest_step)) return refuse(RefusedWord::Reason::velocity, axis, position);
    if (!(std::abs(position - 2 * last + before) <= greatest_change))
      refuse(RefusedWord::Reason::acceleration, axis, position);
  }
  void refuse(RefusedWord::Reason reason, base::Axis axis, double position) noexcept {
    refused_ = RefusedWord{reason, axis, position};
  }

  const machine::Machine* machine_;
  double period_;                   // s
  base::AxisVector last_, before_;  // positions, of the last period and the one before it
  std::optional<RefusedWord> refused_;
};

}  // namespace leadscrew::drive
