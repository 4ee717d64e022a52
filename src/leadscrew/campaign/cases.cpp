#include <algorithm>
#include <cstdio>
#include <leadscrew/campaign/cases.hpp>
#include <leadscrew/campaign/draws.hpp>
#include <leadscrew/campaign/five_axis_program.hpp>
#include <leadscrew/campaign/random_machines.hpp>
#include <leadscrew/campaign/random_program.hpp>
#include <leadscrew/campaign/tilted_program.hpp>
#include <leadscrew/campaign/vector_program.hpp>

namespace leadscrew::campaign {

namespace {

/// Those of two lengths; and a ball, for surfaces.
void give_tools(Case& given) {
  const machine::ToolTable tools = two_tools();
  machine::Tool ball;
  ball.number = 3;
  ball.diameter = 4;
  ball.corner_radius = 2;
  given.tools = machine::ToolTable({*tools.find(1), *tools.find(2), ball});
  given.tools_text = "T1 Z73.25\nT2 X1.5 Y-2 Z41\nT3 D4 R2\n";
}

std::string text_of(const char* format, auto... values) {
  std::array<char, 160> line{};
  std::snprintf(line.data(), line.size(), format, values...);
  return line.data();
}

/// A patch that is nowhere bent as much as the ball, machined in lines along u or v.
std::string surface_program(Draws& draws) {
  const int u = draws.any(2, 4), v = draws.any(2, 4);
  const double side = draws.between(2, 5);
  std::string text = "G21 G90 G94 G17 T3 M6\nG64 P" + text_of("%.4f", draws.logarithmic(1e-3, 0.05)) + "\n";
  text += text_of("G6.4 D1 P%d Q%d I%d J%d\n", u, v, u, v);
  for (int j = 0; j < v; ++j) {
    for (int i = 0; i < u; ++i)
      text += text_of("X%.3f Y%.3f Z%.3f\n", side * i / (u - 1), side * j / (v - 1), draws.between(-0.03, 0.03) * side);
  }
  const double step = draws.between(0.3, 0.6) * side;
  const int along = draws.any(1, 3);
  text += text_of("G6.5 D1 Q%.3f L%d Z10 F%d\n", step, along, draws.any(300, 6000));
  return text + "G0 Z30\nM2\n";
}

/// Some within so many words and behind them.
std::vector<FeedChange> feed_changes(Draws& draws, int words) {
  std::vector<FeedChange> changes;
  std::int64_t at = 0;
  const int count = draws.any(1, 8);
  for (int k = 0; k < count; ++k) {
    at += draws.any(0, 1 + 2 * words / count);
    changes.push_back({at, draws.one_of({0.0, 0.0, 0.01, 0.3, 0.5, 0.9, 1.0, 1.3, 2.0})});
  }
  changes.push_back({at + draws.any(0, 300), 1.0});
  return changes;
}

/// The tool's orientation by the angles of its axes, by vectors, or by the plane it stands on.
void give_five_axes(Draws& draws, int most_blocks, Case& made) {
  const int blocks = draws.any(1, most_blocks + 1);
  switch (draws.any(0, 4)) {
    case 0: {
      made.machine = five_axes(draws);
      VectorProgram program(draws, made.machine);
      program.make(blocks);
      made.text = program.text;
      return;
    }
    case 1:
      made.machine = tilting_machine(draws);
      made.text = TiltedProgram(draws).make(blocks);
      return;
    default:
      made.machine = five_axes(draws);
      made.text = FiveAxisProgram(draws, made.machine).make(blocks);
  }
}

base::Period period_of(Draws& draws) {
  constexpr double shortest = 10e3, longest = 20e6;  // ns
  return {std::clamp<std::int64_t>(static_cast<std::int64_t>(draws.logarithmic(shortest, longest)),
                                   base::shortest_period.nanoseconds, base::longest_period.nanoseconds)};
}

}  // namespace

Kind kind_of(std::int64_t number) {
  using enum Kind;
  constexpr std::array<Kind, kinds_in_turn> turn = {
      lines, arcs, corners, five_axes, interventions, arcs,  lines, corners, arcs,          nurbs,
      lines, arcs, corners, five_axes, interventions, arcs,  lines, corners, interventions, corners,
      lines, arcs, corners, five_axes, interventions, arcs,  lines, corners, arcs,          nurbs,
      lines, arcs, corners, five_axes, interventions, nurbs, lines, corners, interventions, surfaces};
  return turn[static_cast<std::size_t>(number % kinds_in_turn)];
}

Case case_of(std::uint64_t seed, std::int64_t number, Size size, int attempt) {
  constexpr int words_with_changes = 1000, attempts = 64;
  const int most_blocks = size == Size::small ? 4 : 10;
  Draws draws(seed, static_cast<std::uint64_t>(number * attempts + attempt));
  Case made;
  made.kind = kind_of(number);
  give_tools(made);
  if (made.kind != Kind::five_axes) made.machine = random_machine(draws);
  if (made.kind == Kind::five_axes) {
    give_five_axes(draws, most_blocks, made);
  } else if (made.kind == Kind::surfaces) {
    made.text = surface_program(draws);
  } else {
    made.text = RandomProgram(draws, made.kind).make(most_blocks);
  }
  made.machine.period = period_of(draws);
  if (made.kind == Kind::interventions) made.changes = feed_changes(draws, words_with_changes);
  return made;
}

std::string machine_text(const machine::Machine& machine) {
  std::string text = "name = \"" + machine.name + "\"\nkinematics = \"" + machine.kinematics + "\"\n";
  text += text_of("period_us = %.17g\n", static_cast<double>(machine.period.nanoseconds) / 1e3);
  text += text_of("tolerance_mm = %.17g\nchord_error_mm = %.17g\n", machine.tolerance, machine.chord_error);
  const auto list = [](const char* key, const machine::Vector& vector) {
    return text_of("%s = [%.17g, %.17g, %.17g]\n", key, vector[0], vector[1], vector[2]);
  };
  if (machine.rotary_chain) {
    text += text_of("orientation_tolerance_deg = %.17g\npole_cone_deg = %.17g\n\n[kinematics_geometry]\n",
                    machine.rotary_chain->orientation_tolerance, machine.rotary_chain->pole_cone);
    text += list("tool_zero_mm", machine.rotary_chain->tool_zero);
  }
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const machine::AxisLimits& limits = machine.limits(axis);
    const char* const unit = base::is_rotary(axis) ? "deg" : "mm";
    text += text_of("\n[axis.%c]\ntravel_%s = [%.17g, %.17g]\n", base::letter(axis), unit, limits.travel_min,
                    limits.travel_max);
    text += text_of("max_velocity_%s_s = %.17g\nmax_acceleration_%s_s2 = %.17g\n", unit, limits.velocity, unit,
                    limits.acceleration);
    text += text_of("max_jerk_%s_s3 = %.17g\nblu_%s = %.17g\n", unit, limits.jerk, unit, limits.blu);
    if (!machine.rotary_chain) continue;
    for (const machine::RotaryAxis& rotary : machine.rotary_chain->axes) {
      if (rotary.axis == axis)
        text += list("point_mm", rotary.point) + list("direction", rotary.direction) +
                text_of("sign = %d\n", static_cast<int>(rotary.sign));
    }
  }
  return text;
}

}  // namespace leadscrew::campaign
