#pragma once
// Interpolators at work, side by side: their registers over time, and their steps beside the true curve.

#include <leadscrew/base/sink.hpp>
#include <leadscrew/nc/pulse_figures.hpp>
#include <vector>

namespace leadscrew::waves {

/// One interpolator, loaded, and what measure() makes of it.
struct MeasuredPulses {
  nc::PulseRun run;
  nc::PulseFigures figures;
};

/// A value-change dump: a scope for each method, with dx and dy (−1, 0, 1) and its signals_of(), at each clock, under
/// the paper's name too where there is one; X and Y, where the curve's coordinates are not the registers' own. A
/// microsecond of it is a clock.
///
/// As the waveforms of "FPGA-based implementation of circular interpolation" have them: clk, whose rising edges are the
/// clocks; rst and Syn, high at the clock that loads; Start_X0 … End_Y1, as loaded; Busy until the end is reached;
/// X_Pwm_Out and Y_Pwm_Out, a pulse of half a clock for each step. The paper's second axis is Z: what it has of that is
/// under both letters, Z_Pwm_Out beside Y_Pwm_Out. Comments at the dump's head say which name is which.
base::Result<void> write_pulse_dump(const nc::PulseCurve& curve, const std::vector<MeasuredPulses>& pulses,
                                    const base::ByteSink& sink);

/// A picture: a panel for each method, with its steps, the true curve and the worst place. Of a curve too large to see
/// its steps the surroundings of the worst place are shown.
base::Result<void> write_pulse_picture(const nc::PulseCurve& curve, const std::vector<MeasuredPulses>& pulses,
                                       const base::ByteSink& sink);

/// "arc from (5, 0) to (0, 5) about (0, 0), counterclockwise", "line from (0, 0) to (7, 3)".
std::string title_of(const nc::PulseCurve& curve);

}  // namespace leadscrew::waves
