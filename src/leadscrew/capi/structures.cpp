#include "structures.hpp"

#include <cmath>
#include <utility>

namespace leadscrew::capi {

namespace {

gcode::NurbsCurve curve_of(const leadscrew_move& move) {
  gcode::NurbsCurve curve;
  curve.degree = move.degree;
  for (std::size_t i = 0; i < move.points; ++i) {
    gcode::ControlPoint& point = curve.points.emplace_back();
    std::copy_n(move.positions + i * LEADSCREW_AXES, LEADSCREW_AXES, point.position.begin());
    if (move.weights != nullptr) point.weight = move.weights[i];
  }
  if (move.knots != nullptr)
    curve.knots.assign(move.knots, move.knots + move.points + static_cast<std::size_t>(move.degree) + 1);
  return curve;
}

host::SubprogramText subprograms_of(const leadscrew_options& given) {
  return [function = given.on_subprogram, user = given.user](const std::string& name) -> base::Result<std::string> {
    const char* text = nullptr;
    std::size_t length = 0;
    if (function(name.c_str(), &text, &length, user) != 0 || text == nullptr) {
      return base::failure(
          base::problem("missing-sub", "there is no subprogram " + name, "on_subprogram gives its text"));
    }
    return std::string(text, length);
  };
}

}  // namespace

leadscrew_event event_of(const base::PassedEvent& from) {
  leadscrew_event event{};
  event.size = sizeof event;
  event.tick = base::count(from.tick);
  event.path_length = from.path_length;
  event.value = from.value;
  event.line = base::number(from.line);
  event.file = base::file(from.line);
  event.visit = base::visit(from.line);
  event.output = from.output;
  event.q = from.q;
  event.waits = from.waits ? 1 : 0;
  copy_text(event.code, base::code_of(from));
  return event;
}

leadscrew_word word_of(const base::Word& from) {
  leadscrew_word word{};
  word.tick = base::count(from.tick);
  std::copy(from.position.begin(), from.position.end(), word.position);
  word.path_length = from.path_length;
  word.speed = from.speed;
  word.feed = from.feed;
  word.line = base::number(from.line);
  word.file = static_cast<std::uint16_t>(base::file(from.line));
  word.visit = static_cast<std::uint32_t>(base::visit(from.line));
  word.state = static_cast<std::uint8_t>(from.state);
  return word;
}

leadscrew_state state_of(const host::TrajectoryState& from) {
  leadscrew_state state{};
  state.size = sizeof state;
  std::copy(from.position.begin(), from.position.end(), state.position);
  std::copy(from.velocity.begin(), from.velocity.end(), state.velocity);
  std::copy(from.acceleration.begin(), from.acceleration.end(), state.acceleration);
  std::copy(from.jerk.begin(), from.jerk.end(), state.jerk);
  state.path_length = from.path_length;
  state.speed = from.speed;
  state.feed = from.feed;
  state.line = base::number(from.line);
  state.file = base::file(from.line);
  state.visit = base::visit(from.line);
  state.state = static_cast<std::int32_t>(from.state);
  return state;
}

leadscrew_hold hold_of(const leadscrew_state& state, const machine::Machine& machine, double feed_asked) {
  pipeline::Hold hold;
  if (state.state != static_cast<std::int32_t>(base::MotionState::rest)) {
    const auto near =
        pipeline::near_limits(machine, axes_of(state.velocity), axes_of(state.acceleration), axes_of(state.jerk));
    hold = pipeline::hold_of(near, state.feed, feed_asked);
  }
  return {sizeof(leadscrew_hold), static_cast<std::int32_t>(hold.kind),
          static_cast<std::int32_t>(base::index(hold.axis))};
}

leadscrew_limits limits_of(const machine::Machine& from) {
  leadscrew_limits limits{};
  limits.size = sizeof limits;
  for (const base::Axis axis : base::all_axes) {
    if (!from.has(axis)) continue;
    const std::size_t i = base::index(axis);
    const machine::AxisLimits& of = from.limits(axis);
    limits.axes |= 1 << i;
    limits.least[i] = of.travel_min;
    limits.greatest[i] = of.travel_max;
    limits.velocity[i] = of.velocity;
    limits.acceleration[i] = of.acceleration;
    limits.jerk[i] = of.jerk;
  }
  limits.tolerance = from.tolerance;
  limits.chord_error = from.chord_error;
  limits.period = from.period.seconds();
  return limits;
}

machine::Machine with_limits(machine::Machine machine, const leadscrew_limits& limits) {
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const std::size_t i = base::index(axis);
    machine::AxisLimits& of = *machine.axes[i];
    of.travel_min = limits.least[i];
    of.travel_max = limits.greatest[i];
    of.velocity = limits.velocity[i];
    of.acceleration = limits.acceleration[i];
    of.jerk = limits.jerk[i];
  }
  machine.tolerance = limits.tolerance;
  machine.chord_error = limits.chord_error;
  // Out of the range of a servo period, so that it is refused, where it would not fit a whole number of nanoseconds.
  if (limits.period != 0)
    machine.period.nanoseconds = std::fabs(limits.period) < 1 ? std::llround(limits.period * 1e9) : 0;
  return machine;
}

leadscrew_figures figures_of(const pipeline::Summary& from) {
  leadscrew_figures figures{};
  figures.size = sizeof figures;
  figures.time = from.time_s;
  figures.bound = from.bound_s;
  figures.dwell = from.dwell_s;
  figures.length = from.length_mm;
  figures.feed_programmed = from.feed_programmed_max;
  figures.tolerance = from.tolerance_mm;
  for (const base::Axis axis : base::all_axes) {
    const machine::Derivatives ratios = from.plan.of_axis(axis);
    const std::size_t i = base::index(axis);
    figures.velocity[i] = ratios.velocity;
    figures.acceleration[i] = ratios.acceleration;
    figures.jerk[i] = ratios.jerk;
  }
  figures.words = from.words;
  figures.blocks = from.blocks;
  figures.moves = from.moves;
  return figures;
}

leadscrew_block block_of(const pipeline::BlockTime& from) {
  auto block = of_line<leadscrew_block>(from.line);
  block.visit = base::visit(from.line);
  block.begin = from.begin;
  block.seconds = from.seconds;
  block.least_seconds = from.least_seconds;
  block.length = from.length;
  block.feed_asked = from.feed_asked;
  block.feed_reached = from.feed_reached;
  std::copy(from.middle.begin(), from.middle.end(), block.middle);
  copy_text(block.cause, pipeline::name(from.cause));
  return block;
}

base::AxisVector axes_of(const double* from) {
  base::AxisVector position;
  std::copy_n(from, LEADSCREW_AXES, position.begin());
  return position;
}

std::optional<gcode::Move> move_of(const leadscrew_move& given) {
  std::optional<gcode::Move> move;
  if (given.line < 0) return move;
  switch (given.kind) {
    case LEADSCREW_LINE:
      move = host::line(axes_of(given.end), given.feed);
      break;
    case LEADSCREW_ARC:
      if (given.plane < LEADSCREW_XY || given.plane > LEADSCREW_YZ) return move;
      move = host::arc(axes_of(given.end), static_cast<gcode::Plane>(given.plane), given.center[0], given.center[1],
                       given.turns, given.feed);
      break;
    case LEADSCREW_CURVE:
      if (given.degree < 1 || given.degree > gcode::highest_degree || given.positions == nullptr ||
          given.points > gcode::most_control_points)
        return move;
      move = host::curve(curve_of(given), given.feed);
      break;
    case LEADSCREW_DWELL:
      move = host::dwell(given.seconds);
      break;
    default:
      return move;
  }
  move->line = base::Line{given.line};
  return move;
}

/// How moves are joined in place of what the program says.
base::Result<void> take_joining(const leadscrew_options& given, host::MotionOptions& options) {
  if (given.path_mode < LEADSCREW_AS_PROGRAMMED || given.path_mode > LEADSCREW_BLEND)
    return base::failure(base::problem("path-mode", "no way to join moves has this number",
                                       "LEADSCREW_AS_PROGRAMMED to LEADSCREW_BLEND", {.field = "path_mode"}));
  if (given.path_mode == LEADSCREW_EXACT_STOP) options.path_mode = gcode::PathMode::exact_stop;
  if (given.path_mode == LEADSCREW_BLEND) options.path_mode = gcode::PathMode::blend;
  if (given.has_tolerance == 0) return {};
  if (!(given.tolerance >= 0 && std::isfinite(given.tolerance)))
    return base::failure(
        base::problem("path-tolerance", "a tolerance of less than nothing", "mm, 0 or more", {.field = "tolerance"}));
  options.tolerance = given.tolerance;
  return {};
}

base::Result<host::MotionOptions> options_of(const leadscrew_options& given, const machine::Machine& machine) {
  host::MotionOptions options;
  options.start = axes_of(given.start);
  if (auto inside = host::check_position(options.start, machine); !inside) return base::failure(inside.error());
  if (!(given.slice >= 0 && std::isfinite(given.slice)))
    return base::failure(base::problem("slice", "a slice of less than nothing", "seconds, more than 0; 0 for 0.05"));
  if (given.slice > 0) options.slice = given.slice;
  if (given.file != nullptr) options.file = given.file;
  if (given.fuel < 0)
    return base::failure(base::problem("fuel", "fuel for less than no line", "lines, 1 or more; 0 for 100 million"));
  if (given.fuel > 0) options.fuel = given.fuel;
  options.has_inputs = given.has_inputs != 0;
  options.has_probe = given.has_probe != 0;
  options.allows_gouging = given.allow_gouging != 0;
  if (given.step_rule < 0 || given.step_rule > LEADSCREW_UNIFORM)
    return base::failure(base::problem("step-rule", "no rule by which words step along curves has this number",
                                       "LEADSCREW_ARC_LENGTH to LEADSCREW_UNIFORM", {.field = "step_rule"}));
  options.step_rule = interpolator::all_step_rules[static_cast<std::size_t>(given.step_rule)];
  if (auto joined = take_joining(given, options); !joined) return base::failure(joined.error());
  if (given.on_subprogram != nullptr) options.subprogram = subprograms_of(given);
  if (given.on_event != nullptr) {
    options.on_event = [function = given.on_event, user = given.user](const base::PassedEvent& passed) {
      const leadscrew_event event = event_of(passed);
      function(&event, user);
    };
  }
  if (given.on_progress != nullptr) {
    options.goes_on = [function = given.on_progress, user = given.user](double share) {
      return function(share, user) == 0;
    };
  }
  return options;
}

gcode::DiagnosticSink sink_of(const leadscrew_options& options) {
  if (options.on_diagnostic == nullptr) return {};
  return [function = options.on_diagnostic, user = options.user](const base::Diagnostic& diagnostic) {
    const leadscrew_error error = error_of(diagnostic);
    function(&error, user);
  };
}

}  // namespace leadscrew::capi
