#pragma once
// The axes of a machine under their loops, following reference words.
//
//   words ──▶ two are kept ──▶ Setpoint of each axis ──▶ AxisLoop ──▶ where the slides were when the word was due
//
// What is fed forward belongs to the period that begins with a word and is read from the words after it; so what comes
// out belongs to the word before the last. Axes without a loop are where the words want them.

#include <array>
#include <leadscrew/base/word.hpp>
#include <leadscrew/servo/axis_loop.hpp>
#include <optional>
#include <variant>

namespace leadscrew::servo {

struct LoopOptions {
  AxisOptions axis;
  std::variant<PidOptions, CascadeOptions> controller;
};

/// Of each axis; empty: without a loop.
using ServoOptions = std::array<std::optional<LoopOptions>, base::axis_count>;

/// A word, and where the axes were at its tick.
struct Followed {
  base::Word word;
  base::AxisVector position{};  ///< of the slides, mm or degrees
  base::AxisVector velocity{};  ///< of the screws, as tachogenerators tell it, mm/s or degrees/s
  /// What the controllers give the drives from there to the next tick: units of their converters (mm/s² of a cascade),
  /// counts of the up-down counter of a pulse-driven loop.
  base::AxisVector control{};
  base::AxisVector current{};  ///< of the motors at its tick, as the acceleration that it gives, mm/s² or degrees/s²
};

class Servo {
 public:
  /// Codes: `servo-axis`, `servo-controller`; the message names the axis.
  static base::Result<Servo> create(const ServoOptions& options, base::Period period);

  /// Words of successive periods. The axes rest where the first word is. Empty for the first two words; after the last,
  /// repeat it, twice for what is kept and on for as long as the axes should come closer. No allocation.
  std::optional<Followed> follow(const base::Word& word);

  /// The loop of an axis, with positions counted from its first word; null where it has none.
  const AxisLoop* loop(base::Axis axis) const {
    const auto& held = loops_[base::index(axis)];
    return held ? &*held : nullptr;
  }

 private:
  explicit Servo(double period) : period_(period) {}

  double period_;
  std::array<std::optional<AxisLoop>, base::axis_count> loops_;
  base::AxisVector origin_{};
  std::optional<base::Word> due_, next_;
};

}  // namespace leadscrew::servo
