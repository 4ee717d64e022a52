#pragma once
// Errors of lead screws (machine/screw_errors.hpp), made good between words and steps.
//
// The real position of an axis is a rising broken line of its command. The command that leads to a position is read
// from the inverse of that line: exactly, without iteration. Where the axis turns back, its command goes further back
// by the backlash.
//
// Both depend on the direction in which the axis runs. Where it turns, its command goes over from that of one direction
// to that of the other, no faster than the axis may go, on top of what words ask, and with no more than its
// acceleration.
//
// Words are compensated, not what lies between them: where the error of a table changes its slope by d, steps that
// follow the words round the bend off by at most d·v·T/4, at velocity v and period T.

#include <leadscrew/base/result.hpp>
#include <leadscrew/base/word.hpp>
#include <leadscrew/machine/machine.hpp>
#include <vector>

namespace leadscrew::steps {

class Compensation {
 public:
  /// The first of the problems that machine::validate() finds, if any.
  static base::Result<Compensation> create(const machine::Machine& machine);

  /// The word with commands for positions. Words of successive periods; at the first, axes are taken to have come from
  /// below.
  base::Word apply(const base::Word& word);

  /// Has every axis gone over to the command of its direction? After the last word, apply it again and again until it
  /// is so.
  bool settled() const;

  /// How far commands have been from their positions, at most; mm or degrees.
  base::AxisVector greatest_corrections() const;

  /// The machine as the steps see it: an axis whose real position runs slower than its command has a greater velocity.
  machine::Machine stretched(const machine::Machine& machine) const;

 private:
  /// The broken line of real positions over commands.
  class Screw {
   public:
    Screw() = default;
    explicit Screw(const std::vector<machine::PitchError>& table);
    double command_for(double position) const;
    double stretch() const;  ///< greatest speed of the command over that of the position

   private:
    std::vector<machine::PitchError> table_;
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
    double farthest = 0;         ///< in the direction in which it runs
    bool runs_backward = false;
    double over = 0;   ///< share of the difference between forward and backward command, 0 … 1
    double speed = 0;  ///< of going over, towards 1, units/s
    double command = 0;
    double greatest_correction = 0;  ///< of all words so far

    double target() const { return runs_backward ? 1 : 0; }
    void turn(double position);
    void go_over(double forward_command, double lost, double period);
  };

  std::vector<AxisState> axes_;  ///< with errors
  double period_ = 0;            ///< seconds
  bool first_ = true;
};

}  // namespace leadscrew::steps
