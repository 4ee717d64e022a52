#pragma once
// The axes of a machine under their loops, of either kind, and how far each may be from where words want it.
//
//   words ─┬─▶ Servo: position loops on words ─────┬─▶ Followed
//          └─▶ PulseServo: steps through counters ─┘

#include <leadscrew/base/result.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/servo/contour_matcher.hpp>
#include <leadscrew/servo/pulse_servo.hpp>
#include <leadscrew/servo/servo.hpp>
#include <optional>
#include <variant>

namespace leadscrew::servo {

enum class LoopKind : std::uint8_t { words, pulses };

class Follower {
 public:
  /// The machine is sound (machine::validate). Errors: those of Servo and PulseServo, and of loops on words
  /// `servo-unstable` (check_stable).
  static base::Result<Follower> create(const machine::Machine& machine, LoopKind kind);

  /// The next word: what came of the word before the last, or of the last under pulses; nothing for the first ones.
  std::optional<Followed> follow(const base::Word& word) {
    return std::visit([&](auto& loops) { return loops.follow(word); }, loops_);
  }

  /// How far back in time a slide may be at the longest, seconds.
  double lag() const { return lag_; }
  /// Null of loops on words.
  const PulseServo* pulses() const { return std::get_if<PulseServo>(&loops_); }

 private:
  Follower(std::variant<Servo, PulseServo> loops, double lag) : loops_(std::move(loops)), lag_(lag) {}

  std::variant<Servo, PulseServo> loops_;
  double lag_;
};

/// A slide that is off by more than its whole travel is not followed any more. Errors: `servo-unstable`.
base::Result<void> check_followed(const Followed& followed, const machine::Machine& machine);

/// So many periods, one at least; what is longer than a minute counts as one.
std::int64_t periods_in(double seconds, base::Period period);

/// That the contour of axes with this lag, seconds, is looked for in: six time constants behind, e⁻⁶ of a step is left.
ContourWindow window_of(double lag, base::Period period);

}  // namespace leadscrew::servo
