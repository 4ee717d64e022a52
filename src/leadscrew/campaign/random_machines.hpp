#pragma once
// Random machines, on which programs run. Draws as in random_program.hpp.

#include <cmath>
#include <cstddef>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/machine/rotary_chain.hpp>
#include <leadscrew/machine/tool_table.hpp>

namespace leadscrew::campaign {

inline constexpr double most_travel = 1e5;  // mm and degrees: wide enough for every program

/// Of velocity, acceleration and jerk: from the least to the greatest, in units and seconds.
struct LimitRange {
  double velocity[2], acceleration[2], jerk[2];
};

template <class Draws>
machine::AxisLimits random_limits(Draws& draws, const LimitRange& range) {
  const double velocity = draws.logarithmic(range.velocity[0], range.velocity[1]);
  const double acceleration = draws.logarithmic(range.acceleration[0], range.acceleration[1]);
  return {-most_travel, most_travel, velocity, acceleration, draws.logarithmic(range.jerk[0], range.jerk[1]), 0.001};
}

/// X, Y, Z and A, limits over three decades.
template <class Draws>
machine::Machine random_machine(Draws& draws) {
  machine::Machine machine;
  machine.name = "random";
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z, base::Axis::A})
    machine.axes[base::index(axis)] = random_limits(draws, {{5, 500}, {30, 3e4}, {500, 3e6}});
  return machine;
}

template <class Draws>
machine::Vector random_place(Draws& draws) {
  const double x = draws.between(-80, 80), y = draws.between(-80, 80);
  return {x, y, draws.between(-80, 80)};
}

/// A preset with its axes anywhere.
template <class Draws>
machine::RotaryChain random_chain(Draws& draws, machine::Machine& machine) {
  machine.name = "random five axes";
  const auto& presets = machine::kinematics_presets;
  const auto& preset = presets[static_cast<std::size_t>(draws.any(0, static_cast<int>(presets.size())))];
  machine::RotaryChain chain = *machine::preset_chain(preset.name);
  for (machine::RotaryAxis& axis : chain.axes) {
    axis.point = random_place(draws);
    axis.sign = draws.once_in(2) ? 1 : -1;
  }
  machine.kinematics = preset.name;
  return chain;
}

template <class Draws>
void give_limits(Draws& draws, machine::Machine& machine, const LimitRange& range) {
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z})
    machine.axes[base::index(axis)] = random_limits(draws, range);
  for (const machine::RotaryAxis& axis : machine.rotary_chain->axes)
    machine.axes[base::index(axis.axis)] = random_limits(draws, range);
  machine.period = {1'000'000};
}

/// A preset with its axes anywhere, or nutating; limits over three decades each. 1 ms.
template <class Draws>
machine::Machine five_axes(Draws& draws) {
  machine::Machine machine;
  machine::RotaryChain chain = random_chain(draws, machine);
  if (draws.once_in(4)) chain.axes[1].direction = {0, std::sqrt(0.5), std::sqrt(0.5)};
  chain.tool_zero = random_place(draws);
  machine.rotary_chain = chain;
  give_limits(draws, machine, {{10, 1e4}, {100, 1e5}, {2000, 2e6}});
  return machine;
}

/// The same where every plane that leans by 80 degrees can be reached; limits over two decades.
template <class Draws>
machine::Machine tilting_machine(Draws& draws) {
  machine::Machine machine;
  machine::RotaryChain chain = random_chain(draws, machine);
  const bool is_head = machine.kinematics == "head-head-bc";
  if ((is_head || machine.kinematics == "table-table-bc") && draws.once_in(2))
    chain.axes[is_head ? 1 : 0].direction = {0, std::sqrt(0.5), std::sqrt(0.5)};
  chain.tool_zero = random_place(draws);
  machine.rotary_chain = chain;
  give_limits(draws, machine, {{50, 500}, {400, 1e4}, {2000, 1e6}});
  return machine;
}

/// Two lengths.
inline machine::ToolTable two_tools() {
  machine::Tool first, second;
  first.number = 1;
  first.offset[2] = 73.25;
  second.number = 2;
  second.offset = {1.5, -2, 41};
  return machine::ToolTable({first, second});
}

}  // namespace leadscrew::campaign
