#pragma once
// Steps as files: CSV, a row for each step, and a value-change dump (VCD, IEEE 1364-2005, clause 18) of the signals
// that drives see.
//
// Both take events as steps::StepGenerator gives them, in order of their ticks. Text is gathered in blocks. Once the
// sink has failed, every later call fails with the same diagnostic.

#include <array>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/block_sink.hpp>
#include <leadscrew/steps/step_event.hpp>
#include <leadscrew/steps/step_timing.hpp>
#include <span>
#include <string>
#include <vector>

namespace leadscrew::waves {

/// Columns `tick t axis direction`: ticks of the step clock, seconds, a letter, 1 or -1.
class StepCsvWriter {
 public:
  StepCsvWriter(base::ByteSink sink, std::int64_t clock_hz);
  base::Result<void> write(std::span<const steps::StepEvent> events);
  /// Writes what is still gathered.
  base::Result<void> finish() { return rows_.flush(); }

 private:
  base::BlockSink rows_;
  double clock_hz_;
};

/// Signals `X_step` and `X_dir` of each axis, in nanoseconds. Directions change as late as their setup allows; 1 is
/// towards +, and before the first step of an axis they are unknown.
class StepVcdWriter {
 public:
  /// The machine says which axes there are, and the times of their signals.
  StepVcdWriter(base::ByteSink sink, const machine::Machine& machine, std::int64_t clock_hz);
  base::Result<void> write(std::span<const steps::StepEvent> events);
  /// Writes what is still to come, to the end of the last step.
  base::Result<void> finish();

 private:
  /// Of a signal: two for each axis, steps even and directions odd.
  struct Change {
    std::int64_t tick;
    std::uint8_t signal;
    char value;
  };

  static bool is_later(const Change& a, const Change& b) {
    return a.tick != b.tick ? a.tick > b.tick : a.signal > b.signal;
  }
  void add(std::int64_t tick, std::uint8_t signal, char value);
  void put_before(std::int64_t tick);
  void put_time(std::int64_t tick);

  base::BlockSink text_;
  std::int64_t clock_hz_;
  std::array<steps::StepTicks, base::axis_count> ticks_{};
  std::int64_t longest_setup_ = 0;
  std::vector<Change> to_come_;  ///< a heap, the first on top; as many as fit into the longest setup and a step
  std::array<int, base::axis_count> directions_{};  ///< 0: not known
  std::int64_t now_ = 0;                            ///< the last tick that was written
};

}  // namespace leadscrew::waves
