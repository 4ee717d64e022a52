#pragma once
// motion_core.sv with three axes under Verilator, the commands it takes, and the steps that pulse/ makes of the same.

#include <leadscrew/pulse/circular_search.hpp>
#include <leadscrew/pulse/integrator.hpp>
#include <leadscrew/pulse/linear.hpp>
#include <octants.hpp>
#include <vector>

#include "clocked.hpp"

namespace leadscrew::hardware {

using driver::along_line, driver::Cut, driver::Decision, driver::Octant, driver::Octants, driver::Pace;

inline constexpr std::size_t core_axes = 3, core_units = core_axes - 1;
using CorePulse = pulse::Pulse<core_axes>;
using CoreVector = std::array<std::int64_t, core_axes>;

/// Fields of motion_core.sv's command.
struct CoreCommand {
  std::int64_t count = 0;
  bool dwell = false, final = false;
  std::uint16_t tag = 0;
  std::uint64_t feed = 0, feed_straight = 0;
  std::array<std::uint8_t, core_axes> source{};
  std::array<bool, core_axes> backward{};
  std::int8_t curve = 0;
  std::array<Decision, core_units> unit{};
};

inline CoreCommand line_command(const CoreVector& delta) {
  CoreCommand command;
  std::uint8_t unit = 0;
  bool drives = false;
  for (const std::int64_t each : delta) command.count = std::max(command.count, pulse::absolute(each));
  for (std::size_t axis = 0; axis < core_axes; ++axis) {
    const std::int64_t steps = pulse::absolute(delta[axis]);
    command.backward[axis] = delta[axis] < 0;
    if (steps == 0) continue;
    if (steps == command.count && !drives) {
      drives = true;
      command.source[axis] = 1;
    } else {
      command.unit[unit] = along_line(steps, command.count);
      command.source[axis] = static_cast<std::uint8_t>(2 + unit++);
    }
  }
  return command;
}

/// In the plane of two axes.
inline CoreCommand octant_command(const Octant& octant, std::size_t x, std::size_t y) {
  CoreCommand command;
  command.count = octant.count;
  command.source[x] = octant.x_drives ? 1 : 2;
  command.source[y] = octant.x_drives ? 2 : 1;
  command.backward[x] = octant.sign_x < 0;
  command.backward[y] = octant.sign_y < 0;
  command.curve = octant.other.curve;
  command.unit[0] = octant.other;
  return command;
}

inline void push_arc(std::vector<CoreCommand>& commands, const pulse::Arc& arc, std::size_t x, std::size_t y) {
  for (Octants octants(arc); !octants.done();) commands.push_back(octant_command(octants.next(), x, y));
}

/// As `run --pulses --pulse-method bresenham` makes a line of three axes.
inline pulse::LinearDda<core_axes> line_of_pulse(const CoreVector& delta) {
  std::int64_t longest = 1;
  for (const std::int64_t each : delta) longest = std::max(longest, pulse::absolute(each));
  return {delta, longest, (longest - 1) / 2};
}
using CircleOfPulse = pulse::CircularSearch<pulse::Search::least_error>;

/// Of any model of motion_core.sv with these widths, that passes a tick at each clock and never waits for drives.
template <typename Model, int width, int feed_width>
class Core {
 public:
  static constexpr std::uint64_t every_tick = std::uint64_t{1} << feed_width;

  Core() {
    model_->rst = 1;
    model_.clock();
    model_->rst = 0;
    for_all_times(1, 0, 0, 0);
  }

  Model* operator->() { return model_.operator->(); }
  void clock() { model_.clock(); }

  /// Clocks, the same for all axes.
  void for_all_times(std::uint64_t length, std::uint64_t space, std::uint64_t setup, std::uint64_t hold) {
    constexpr std::uint64_t each = 1 | std::uint64_t{1} << 16 | std::uint64_t{1} << 32;
    model_->step_length = length * each;
    model_->step_space = space * each;
    model_->direction_setup = setup * each;
    model_->direction_hold = hold * each;
  }

  /// What the core is to be given at the next clock.
  void offer(const CoreCommand& command) {
    constexpr int unit_width = width + 2;
    std::uint64_t source = 0, backward = 0, decision = 0, straight = 0, diagonal = 0;
    for (std::size_t axis = 0; axis < core_axes; ++axis) {
      source |= std::uint64_t{command.source[axis]} << (4 * axis);
      backward |= std::uint64_t{command.backward[axis]} << axis;
    }
    for (std::size_t unit = 0; unit < core_units; ++unit) {
      const int at = static_cast<int>(unit) * unit_width;
      decision |= bits_of(command.unit[unit].decision, unit_width) << at;
      straight |= bits_of(command.unit[unit].straight, unit_width) << at;
      diagonal |= bits_of(command.unit[unit].diagonal, unit_width) << at;
    }
    model_->command_push = 1;
    put(model_->command_count, static_cast<std::uint64_t>(command.count));
    put(model_->command_dwell, command.dwell);
    put(model_->command_final, command.final);
    put(model_->command_tag, command.tag);
    put(model_->command_feed, command.feed);
    put(model_->command_feed_straight, command.feed_straight);
    put(model_->command_source, source);
    put(model_->command_backward, backward);
    put(model_->command_curve, bits_of(command.curve, 2));
    put(model_->command_decision, decision);
    put(model_->command_straight, straight);
    put(model_->command_diagonal, diagonal);
  }
  void offer_nothing() { model_->command_push = 0; }

  /// Steps that are decided at the coming clock.
  CorePulse pulse() {
    model_->eval();
    CorePulse pulse;
    for (std::size_t axis = 0; axis < core_axes; ++axis) {
      const int steps = (model_->step_strobe >> axis) & 1, backward = (model_->step_backward >> axis) & 1;
      pulse.step[axis] = static_cast<std::int8_t>(steps * (1 - 2 * backward));
    }
    return pulse;
  }

  std::int64_t position(std::size_t axis) { return signed_of(model_->position[axis], 32); }
  std::int64_t latched_position(std::size_t axis) { return signed_of(model_->latched_position[axis], 32); }

  /// Makes the commands, as many queued as there is space for, from rest to rest; `see(pulse)` of each clock at which a
  /// command runs, the first is tick 1. Ends after `most` clocks in any case.
  template <typename See>
  void run(const std::vector<CoreCommand>& commands, std::int64_t most, const See& see) {
    std::size_t pushed = 0;
    while (most-- > 0) {
      offer_nothing();
      if (pushed < commands.size()) {
        if (!model_->fifo_full) offer(commands[pushed++]);
      } else if (!model_->busy) {
        return;
      }
      const CorePulse pulse = this->pulse();
      if (model_->running) see(pulse);
      clock();
    }
  }

 private:
  template <typename Port>
  static void put(Port& port, std::uint64_t value) {
    port = static_cast<Port>(value);
  }

  Clocked<Model> model_;
};

}  // namespace leadscrew::hardware
