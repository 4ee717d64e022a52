#pragma once
// Step and direction signals that follow words.
//
//   words ──▶ cubic of each axis, period by period ──▶ crossings of half BLUs ──▶ events in order of time ──▶ sink
//
// A period's steps are made when the word after it is known, so the generator is one word behind (reference.hpp says
// why it looks ahead). Steps lie on the ticks of a clock: the first tick at which the reference has crossed, so within
// one tick of the crossing. At a word, steps are within half a BLU of it, and for a moment within one where a drive
// must be given time to turn. Nothing is allocated; events reach the sink in blocks, in order of their ticks, also from
// block to block; axes that step at the same tick do so in no certain order.
//
// validate() refuses what clock, step length or machine cannot give. Words that are faster than the machine all the
// same lose nothing: their steps come when the one before allows it. How many did, and how far steps ever were from
// words, stands in the report.

#include <array>
#include <cmath>
#include <cstdint>
#include <leadscrew/base/result.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/steps/axis_steps.hpp>
#include <leadscrew/steps/merge.hpp>
#include <leadscrew/steps/step_timing.hpp>
#include <limits>
#include <optional>
#include <span>

namespace leadscrew::steps {

/// What was made so far.
struct StepReport {
  std::int64_t steps = 0;            ///< of all axes
  std::int64_t postponed = 0;        ///< steps that were due before the one before, or the direction, allowed them
  std::int64_t greatest_delay = 0;   ///< of those, ticks
  double greatest_error = 0;         ///< largest distance between a word and the steps made until it, BLU
  base::Axis worst = base::Axis::X;  ///< the axis that had it
};

/// A sink is called with a std::span<const StepEvent>, never empty, that is gone when it returns.
class StepGenerator {
 public:
  /// The first of the problems that validate() finds, if any.
  static base::Result<StepGenerator> create(const machine::Machine& machine, std::int64_t clock_hz);

  /// Words of successive periods, positions finite. The first says where the axes stand.
  template <class Sink>
  void follow(const base::Word& word, Sink&& sink) {
    accept(word);
    if (words_ > 2) make_period(sink);
  }

  /// The words have ended: makes the steps up to the last, and those that are still late. Nothing may follow.
  template <class Sink>
  void finish(Sink&& sink) {
    if (!last_) return;
    const base::Word rest = *last_;
    do {
      follow(rest, sink);
    } while (!settled());
  }

  std::int64_t count(base::Axis axis) const { return steps_[base::index(axis)].count(); }  ///< where steps lead, BLU
  /// Of all steps so far.
  StepReport report() const;
  /// What the report says of steps that left their words by a BLU or more; nothing where none did. Code: `step-late`.
  std::optional<base::Diagnostic> complaint() const;

 private:
  StepGenerator(const machine::Machine& machine, std::int64_t clock_hz);

  void accept(const base::Word& word);
  void begin_period();
  void end_period();
  bool settled() const;
  std::span<const StepEvent> merged_until(std::int64_t tick);

  template <class Sink>
  void make_period(Sink& sink) {
    begin_period();
    for (bool more = true; more;) {
      more = false;
      std::int64_t horizon = std::numeric_limits<std::int64_t>::max();
      for (std::size_t k = 0; k < axes_; ++k) {
        AxisSteps& axis = steps_[order_[k]];
        axis.fill();
        if (!axis.has_more()) continue;
        more = true;
        horizon = std::min(horizon, axis.known().back().tick());
      }
      const auto events = merged_until(horizon);
      if (!events.empty()) sink(events);
    }
    end_period();
  }

  /// The last three words of an axis, BLU.
  struct Track {
    double before = 0, now = 0, next = 0;
    double speed = 0;  ///< at `before`
    double blu = 1;
    double sharpest = 0;  ///< reference.hpp
  };

  std::array<AxisSteps, base::axis_count> steps_;
  std::array<Track, base::axis_count> tracks_;
  std::array<std::size_t, base::axis_count> order_{};  ///< of the axes the machine has
  std::size_t axes_ = 0;
  std::array<std::array<StepEvent, AxisSteps::capacity * base::axis_count>, 2> merged_;

  TickSpan ticks_;
  std::int64_t ticks_whole_ = 0, ticks_rest_ = 0;  ///< of a period, the rest in 10⁻⁹ ticks
  std::int64_t offset_ = 0;                        ///< of ticks_, 10⁻⁹ ticks
  std::optional<base::Word> last_;
  std::int64_t words_ = 0;
  double greatest_error_ = 0;
  base::Axis worst_ = base::Axis::X;
};

}  // namespace leadscrew::steps
