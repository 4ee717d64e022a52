#pragma once
// How fast a block's feed asks for its commands, and for its axes: by the programmed displacement, not by what rounding
// to the lattice makes of it.

#include <leadscrew/gcode/move.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/nc/block.hpp>
#include <leadscrew/nc/pulse_method.hpp>
#include <optional>

namespace leadscrew::nc {

/// What of its move a block travels.
struct Part {
  double share = 1;
  double length = 0;  ///< of an arc: of the programmed path that its feed is meant by, mm; of a chord: of its curve
  std::optional<base::AxisVector> bend{};  ///< of a chord: |d²q/ds²| of each axis along its curve, at most
};

/// Of each axis, in steps.
using StepVector = std::array<double, base::axis_count>;

/// From the start of a move to its end, steps, not rounded.
StepVector programmed_delta(const gcode::Move& move, const machine::Machine& machine);

/// Is the axis one of the two of an arc's plane?
bool in_plane(const Block& block, std::size_t axis);
/// Greatest steps of an axis a command.
double greatest_share(const Block& block, std::size_t axis);

struct AxisRate {
  double rate = 0;  ///< commands/s; infinite where no axis moves
  base::Axis axis = base::Axis::X;
};
/// At which the first of the axes comes to its greatest velocity.
AxisRate greatest_by_velocity(const Block& block, const machine::Machine& machine);

struct ProgrammedRate {
  double rate = 0;                     ///< commands/s, of the block on the lattice
  double least = 0;                    ///< commands/s that are asked for whatever rounding may have added
  double of_velocity = 0;              ///< the greatest share of an axis' velocity that is asked for, likewise
  base::Axis fastest = base::Axis::X;  ///< the axis of that
};

/// Of a block with counted commands, whose move has a feed.
ProgrammedRate programmed_rate(const Block& block, const gcode::Move& move, const Part& part,
                               const machine::Machine& machine, PulseMethod method);

/// That a move's feed takes for a share of it, s, which is `length` long, mm or degrees as the feed counts it.
double seconds_of(double share, double length, const gcode::Feed& feed);

}  // namespace leadscrew::nc
