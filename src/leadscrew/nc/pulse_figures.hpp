#pragma once
// What one interpolator makes of one curve, in figures.

#include <leadscrew/nc/pulse_signals.hpp>
#include <vector>

namespace leadscrew::nc {

/// The least and the greatest value of a register, or of what is worked out from some.
struct RegisterRange {
  std::string_view name;
  std::int64_t least = 0, greatest = 0;

  int width() const;  ///< bits that hold both in two's complement
};

struct PulseFigures {
  std::int64_t clocks = 0;
  std::int64_t pulses = 0;  ///< clocks with a step
  double max_error = 0;     ///< greatest distance of a place from the curve, BLU
  double rms_error = 0;     ///< over the places after each pulse, BLU
  pulse::Point worst;       ///< where it is greatest first; the start where it is 0
  std::int64_t worst_clock = 0;
  pulse::Point end;                      ///< where it comes to stand
  std::vector<RegisterRange> registers;  ///< of signals_of(), over all clocks, as loaded among them
};

/// Takes them clock by clock.
class PulseMeasurement {
 public:
  PulseMeasurement(const PulseRun& run, const PulseCurve& curve);

  const PulseRun& run() const { return run_; }
  bool done() const { return run_.done(); }
  void step();
  /// Of the clocks until now.
  PulseFigures figures() const;

 private:
  PulseRun run_;
  PulseCurve curve_;
  PulseError error_;
  PulseFigures figures_;
  double squares_ = 0;
};

/// Runs it to its end.
PulseFigures measure(const PulseRun& run, const PulseCurve& curve);

}  // namespace leadscrew::nc
