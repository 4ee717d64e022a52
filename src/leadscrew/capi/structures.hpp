#pragma once
// What structures of leadscrew.h say in the words of the rooms.

#include <leadscrew/host/motion.hpp>
#include <leadscrew/pipeline/lost_time.hpp>
#include <optional>

#include "calls.hpp"

namespace leadscrew::capi {

/// A structure that begins with its size and tells of a line: nothing else is set.
template <class Struct>
Struct of_line(base::Line line) {
  Struct made{};
  made.size = sizeof made;
  made.line = base::number(line);
  made.file = base::file(line);
  return made;
}

leadscrew_event event_of(const base::PassedEvent& from);
leadscrew_word word_of(const base::Word& from);
leadscrew_state state_of(const host::TrajectoryState& from);
leadscrew_hold hold_of(const leadscrew_state& state, const machine::Machine& machine, double feed_asked);

leadscrew_limits limits_of(const machine::Machine& from);
/// The machine with these limits, sound or not.
machine::Machine with_limits(machine::Machine machine, const leadscrew_limits& limits);
leadscrew_figures figures_of(const pipeline::Summary& from);
leadscrew_block block_of(const pipeline::BlockTime& from);

base::AxisVector axes_of(const double* from);
/// Empty where a field is out of its range.
std::optional<gcode::Move> move_of(const leadscrew_move& given);
/// What options ask for, without tools. Errors: the slice or the start is not sound.
base::Result<host::MotionOptions> options_of(const leadscrew_options& given, const machine::Machine& machine);
gcode::DiagnosticSink sink_of(const leadscrew_options& options);

}  // namespace leadscrew::capi
