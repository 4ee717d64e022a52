#pragma once
// Errors of lead screws, made good between words and steps.
//
//   real position                     A table says how far from its command an axis really is, at some commands and
//        │            ╱┈┈ nominal      straight between them. Its real position is then a rising broken line of the
//        │         ╱╱┈                 command, and the command that leads to a position is read from the same line
//        │      ╱─╱                    the other way: exactly, without iteration.
//        │   ╱╱┈
//        └──────────────▶ command      A screw has play: when its axis turns back, the nut stays until the command
//                                      has gone back by the backlash.
//
// Both depend on the way the axis runs. Where it turns, its command goes over from that of one way to that of the
// other, no faster than the axis may go, on top of what words ask, and as softly as it may accelerate.

#include <array>
#include <leadscrew/base/result.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/machine/machine.hpp>
#include <vector>

namespace leadscrew::stepping {

/// One line of a table: commanded to `position`, the axis is at position + error. mm or degrees.
struct PitchError {
  double position = 0;
  double error = 0;
};

/// Of one axis. Beyond its ends a table goes on with its first and last errors; an empty one has none.
struct ScrewErrors {
  std::vector<PitchError> table;  ///< positions rising; where the axis runs towards +, or both ways
  /// Where it runs towards −; empty: the same. Errors there are not below those of the table, but for the backlash.
  std::vector<PitchError> backward_table;
  double backlash = 0;         ///< mm or degrees; ≥ 0
  double takeup_velocity = 0;  ///< mm/s or degrees/s, at most, for going over; 0: the axis' greatest
};

using MachineErrors = std::array<ScrewErrors, base::axis_count>;

/// Errors may change by so much of the way from entry to entry: more is no screw, but a misprint.
inline constexpr double greatest_pitch_slope = 0.1;

/// Everything that is wrong with the errors. Codes: `pitch-value`, `pitch-order`, `pitch-slope`, `backlash`, each with
/// axis and entry (counted from 1), and `pitch-axis` for an axis that the machine lacks.
std::vector<base::Diagnostic> validate(const MachineErrors& errors, const machine::Machine& machine);

class Compensation {
 public:
  /// The first of the problems that validate() finds, if any.
  static base::Result<Compensation> create(const MachineErrors& errors, const machine::Machine& machine);

  /// The word with commands for positions. Words of successive periods; at the first, axes are taken to have come from
  /// below.
  base::Word apply(const base::Word& word);

  /// Has every axis gone over to its way? After the last word, apply it again and again until it is so.
  bool settled() const;

  /// The machine as the steps see it: an axis whose real position runs slower than its command has a greater velocity.
  machine::Machine stretched(const machine::Machine& machine) const;

 private:
  /// The broken line of real positions over commands.
  class Screw {
   public:
    Screw() = default;
    explicit Screw(const std::vector<PitchError>& table);
    double command_for(double position) const;
    double stretch() const;  ///< greatest speed of the command over that of the position

   private:
    std::vector<PitchError> table_;
    std::vector<double> real_;  ///< position + error
  };

  struct AxisState {
    base::Axis axis = base::Axis::X;
    Screw forward, backward;
    double backlash = 0;
    double velocity = 0;         ///< most of the command, units/s
    double takeup_velocity = 0;  ///< units/s
    double acceleration = 0;     ///< of going over, units/s²
    double band = 0;             ///< the axis has turned when it is so far back, units
    double farthest = 0;         ///< in the way it runs
    bool runs_backward = false;
    double over = 0;   ///< share of the way from the forward to the backward command, 0 … 1
    double speed = 0;  ///< of going over, towards 1, units/s
    double command = 0;

    double target() const { return runs_backward ? 1 : 0; }
    void turn(double position);
    void go_over(double forward_command, double lost, double period);
  };

  std::vector<AxisState> axes_;  ///< with errors
  double period_ = 0;            ///< seconds
  bool first_ = true;
};

}  // namespace leadscrew::stepping
