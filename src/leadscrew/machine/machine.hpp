#pragma once
// The machine as data: which axes it has, how far, how fast and how abruptly each may move, its basic length unit, the
// errors of its screws, its servo period and its tolerances. Nothing here reads a file; config/ turns machine files
// into this.

#include <array>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/diagnostic.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/machine/dialect.hpp>
#include <leadscrew/machine/drive.hpp>
#include <leadscrew/machine/laser.hpp>
#include <leadscrew/machine/probe.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <leadscrew/machine/screw_errors.hpp>
#include <leadscrew/machine/spindle.hpp>
#include <leadscrew/machine/step_times.hpp>
#include <optional>
#include <string>
#include <vector>

namespace leadscrew::machine {

/// What one axis can do. Linear axes in mm, rotary axes in degrees; time in seconds.
struct AxisLimits {
  double travel_min = 0;    ///< mm or degrees, machine coordinates
  double travel_max = 0;    ///< mm or degrees, machine coordinates; > travel_min
  double velocity = 0;      ///< mm/s or degrees/s; > 0
  double acceleration = 0;  ///< mm/s² or degrees/s²; > 0
  double jerk = 0;          ///< mm/s³ or degrees/s³; > 0
  double blu = 0;           ///< basic length unit, mm or degrees; > 0
  StepTimes step_times{};   ///< of its signals, where it is moved by steps

  friend bool operator==(const AxisLimits&, const AxisLimits&) = default;
};

/// How moves in X, Y and Z are smoothed within their tolerance (G64).
enum class Smoothing : std::uint8_t {
  splines,  ///< by blends of corners and splines along short lines, whatever the machine
  /// Along the path that the machine travels in the least time: faster, and more to plan. Only at periods so short that
  /// chords between words keep the chord error whatever the acceleration; else splines.
  least_time,
};

/// What it can do. Sound where validate() finds nothing.
struct Machine {
  std::string name;  ///< for people
  /// "cartesian": each axis is one coordinate of the program; or a name of kinematics_presets.
  std::string kinematics = std::string(cartesian);
  base::Period period;                                           ///< a word each
  double tolerance = 0.01;                                       ///< mm; of G64 without P; ≥ 0
  double chord_error = 0.001;                                    ///< mm; > 0
  std::array<std::optional<AxisLimits>, base::axis_count> axes;  ///< an axis the machine lacks is empty
  std::array<ScrewErrors, base::axis_count> screws;  ///< no motion knows of them; steps::Compensation makes them good
  std::array<AxisDrive, base::axis_count> drives;    ///< for simulation

  Smoothing smoothing = Smoothing::splines;  ///< under G64
  /// Does motion rest for M3, M4 and M5?
  bool spindle_waits = true;
  Dialect dialect = Dialect::leadscrew;     ///< of its programs
  std::optional<Laser> laser;               ///< empty where there is none
  std::optional<RotaryChain> rotary_chain;  ///< empty where it is cartesian
  std::optional<Probe> probe;               ///< for simulation; empty where none is simulated
  std::optional<Spindle> spindle;           ///< for simulation; empty: it is taken to turn at S

  /// Do threads and taps follow a simulated spindle?
  bool threads_follow() const { return spindle.has_value(); }
  /// Is there this axis?
  bool has(base::Axis axis) const { return axes[base::index(axis)].has_value(); }
  /// All there are.
  base::AxisSet axis_set() const {
    base::AxisSet set;
    for (const base::Axis axis : base::all_axes) {
      if (has(axis)) set.insert(axis);
    }
    return set;
  }
  /// Limits of an axis the machine has.
  const AxisLimits& limits(base::Axis axis) const { return *axes[base::index(axis)]; }
  /// Errors of its screw.
  const ScrewErrors& screw(base::Axis axis) const { return screws[base::index(axis)]; }
  /// What drives it, in simulation.
  const AxisDrive& drive(base::Axis axis) const { return drives[base::index(axis)]; }
};

/// The built-in three-axis mill.
Machine mill3();

/// Every way in which the values contradict the ranges above; empty when the machine is sound. Codes: `machine-…`,
/// those of check_step_times(), check_screw(), check_drive(), check_laser(), check_probe(), check_spindle() and
/// check_kinematics(), and `pitch-axis` for screws of axes that the machine lacks.
std::vector<base::Diagnostic> validate(const Machine& machine);

}  // namespace leadscrew::machine
