#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/number.hpp>
#include <leadscrew/nc/feed_words.hpp>
#include <leadscrew/nc/programmed_rate.hpp>
#include <leadscrew/numeric/rounded_up.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <limits>
#include <numbers>
#include <string>

namespace leadscrew::nc {

namespace {

using numeric::real;

// Of an axis' acceleration, along the path; the rest is for what changes by steps: words, and directions where blocks
// meet. In curves the two below are used at a right angle.
constexpr double along_path = 0.8, along_curve = 0.6 * along_path, across_curve = 0.8 * along_path;

// Chords follow their curve. Nothing says in which axis the two below meet: their sum is along_path.
constexpr double along_chords = 0.6 * along_path, across_chords = 0.4 * along_path;

constexpr double longest_braking = 0x1p21;  // commands: the feed register counts them times its capacity

base::Diagnostic refused(const Block& block, std::string_view code, std::string message, std::string hint,
                         std::optional<base::Axis> axis = {}) {
  base::Diagnostic problem =
      base::problem(code, std::move(message), std::move(hint), {.axis = axis, .field = pulses_field});
  problem.place.line = base::number(block.line);
  return problem;
}

/// How much an axis' acceleration in a curve exceeds the square of the command rate over the radius: DDAs go at one
/// speed; where one axis steps at every command the other one's rate is the tangent, whose second derivative is 2√2 at
/// an eighth of a turn.
double curving(PulseMethod method) {
  return rate_of(method) == CommandRate::longest_axis ? 2 * std::numbers::sqrt2 : 1;
}

/// Steps of the arc's axes a command, where it passes `at`.
void set_tangent(const Block& block, pulse::Point at, PulseMethod method, std::array<double, base::axis_count>& steps) {
  const double radius = std::hypot(real(at.x), real(at.y)), sense = static_cast<double>(block.arc.direction);
  const double x = -sense * real(at.y) / radius, y = sense * real(at.x) / radius;
  double scale = real(block.circle_commands) / real(block.commands);
  const CommandRate rate = rate_of(method);
  if (rate == CommandRate::every_step) scale /= std::abs(x) + std::abs(y);
  if (rate == CommandRate::longest_axis) scale /= std::max(std::abs(x), std::abs(y));
  steps[block.first_axis] = x * scale;
  steps[block.second_axis] = y * scale;
}

std::array<double, base::axis_count> course_of(std::array<double, base::axis_count> steps) {
  const double length = numeric::norm(steps);
  for (double& of_axis : steps) of_axis /= length;
  return steps;
}

void set_directions(PlannedBlock& planned, PulseMethod method) {
  const Block& block = planned.block;
  for (std::size_t axis = 0; axis < base::axis_count; ++axis) {
    planned.entry[axis] = planned.exit[axis] = real(block.delta[axis]) / real(block.commands);
  }
  if (block.kind == Block::Kind::arc) {
    set_tangent(block, block.arc.start, method, planned.entry);
    set_tangent(block, block.arc.end, method, planned.exit);
  }
  planned.entry_course = course_of(planned.entry);
  planned.exit_course = course_of(planned.exit);
}

/// A line of a step or two runs in another direction on the lattice than programmed; a path of many such lines runs as
/// programmed.
void set_programmed_course(PlannedBlock& planned, const gcode::Move& move, const machine::Machine& machine) {
  if (move.kind != gcode::Move::Kind::line) return;
  const auto delta = programmed_delta(move, machine);
  if (numeric::norm(delta) > 0) planned.entry_course = planned.exit_course = course_of(delta);
}

void limit_acceleration(PlannedBlock& planned, const machine::Machine& machine, PulseMethod method) {
  const Block& block = planned.block;
  const bool is_arc = block.kind == Block::Kind::arc;
  planned.acceleration = std::numeric_limits<double>::infinity();
  for (const base::Axis axis : base::all_axes) {
    const double share = greatest_share(block, base::index(axis));
    if (share == 0) continue;
    const machine::AxisLimits& limits = machine.limits(axis);
    const double acceleration = limits.acceleration / limits.blu;  // steps/s²
    planned.acceleration = std::min(planned.acceleration, (is_arc ? along_curve : along_path) * acceleration / share);
    if (!in_plane(block, base::index(axis))) continue;
    const double radius = std::sqrt(real(block.arc.squared_radius()));
    const double rate = std::sqrt(across_curve * acceleration * radius / curving(method)) / share;
    planned.greatest_rate = std::min(planned.greatest_rate, rate);
  }
  planned.greatest_rate = std::min(planned.greatest_rate, std::sqrt(2 * planned.acceleration * longest_braking));
}

/// Of a chord's block besides: v² |d²q/ds²| of each axis.
void limit_bend(PlannedBlock& planned, const machine::Machine& machine, const Part& part) {
  planned.acceleration *= along_chords / along_path;
  const double rates = real(planned.block.commands) / part.length;  // commands/s by mm/s
  for (const base::Axis axis : base::all_axes) {
    const double bend = (*part.bend)[base::index(axis)];
    if (!machine.has(axis) || bend == 0) continue;
    const double speed = std::sqrt(across_chords * machine.limits(axis).acceleration / bend);
    planned.greatest_rate = std::min(planned.greatest_rate, speed * rates);
  }
}

std::string per_second(double rate) {
  return gcode::text(rate) + " a second";
}

/// What clock, steps or an axis cannot give. A shaped feed is never beyond the axes' velocity.
std::optional<base::Diagnostic> rate_problem(const Block& block, const ProgrammedRate& programmed,
                                             const AxisRate& by_velocity, const PulseOptions& options) {
  const double by_clock = real(options.clock_pps), by_step = by_clock / real(options.step_clocks);
  const bool is_shaped = options.shape == Shape::accelerate;
  const double rate = is_shaped ? std::min(programmed.least, by_velocity.rate) : programmed.least;
  const std::string asked = "the feed asks for " + per_second(programmed.rate);
  if (rate > by_clock) {
    return refused(block, "pulse-rate", "pulses: " + asked + ", the clock gives " + per_second(by_clock),
                   "program a lower feed or take a faster clock");
  }
  if (rate > by_step) {
    return refused(block, "pulse-step-length",
                   "pulses: " + asked + ", axis " + base::letter(options.slowest_steps) + " allows " +
                       per_second(by_step) + ": " + std::to_string(options.step_clocks) +
                       " clocks from a step to its next",
                   "program a lower feed or shorten the times of its steps", options.slowest_steps);
  }
  if (is_shaped || programmed.of_velocity * (1 - numeric::quotient_rounding) <= 1) return std::nullopt;
  return refused(block, "pulse-velocity",
                 "pulses: " + asked + ", axis " + base::letter(programmed.fastest) + " allows " +
                     per_second(programmed.rate / programmed.of_velocity),
                 "program a lower feed, or have the feed shaped to what the axes can do", programmed.fastest);
}

}  // namespace

std::int64_t word_of(double rate, const PulseOptions& options) {
  const double word = rate / real(options.clock_pps) * real(options.feed_capacity);
  return word < real(options.feed_capacity) ? std::llround(word) : options.feed_capacity;
}

std::int64_t acceleration_word(double acceleration, const PulseOptions& options) {
  const double word = acceleration / real(options.clock_pps) / real(options.clock_pps) * real(options.feed_capacity);
  return static_cast<std::int64_t>(std::min(word, real(options.feed_capacity)));
}

base::Result<PlannedBlock> with_words(const Block& block, const gcode::Move& move, const Part& part,
                                      const machine::Machine& machine, const PulseOptions& options) {
  PlannedBlock planned;
  planned.block = block;
  set_directions(planned, options.method);
  set_programmed_course(planned, move, machine);
  const AxisRate by_velocity = greatest_by_velocity(block, machine);
  // A word f is a command every ⌊q0/f⌋ or ⌈q0/f⌉ clocks.
  const std::int64_t greatest_word = options.feed_capacity / options.step_clocks;
  planned.greatest_rate = std::min(by_velocity.rate, real(options.clock_pps) / real(options.step_clocks));
  planned.rate = planned.greatest_rate;

  if (move.feed.mode != gcode::Feed::Mode::rapid) {
    const ProgrammedRate asked = programmed_rate(block, move, part, machine, options.method);
    if (auto found = rate_problem(block, asked, by_velocity, options)) return base::failure(std::move(*found));
    planned.rate = std::min(asked.rate, planned.greatest_rate);
  }
  if (options.shape == Shape::accelerate) {
    limit_acceleration(planned, machine, options.method);
    if (part.bend) limit_bend(planned, machine, part);
    planned.rate = std::min(planned.rate, planned.greatest_rate);
    if (acceleration_word(planned.acceleration, options) == 0) {
      return base::failure(refused(block, "pulse-feed-word",
                                   "pulses: an acceleration of " + gcode::text(planned.acceleration) +
                                       " pulses/s2 adds no unit to the feed register at a clock",
                                   "widen the feed register or take a slower clock"));
    }
  }
  planned.block.greatest_word = std::min(word_of(planned.greatest_rate, options), greatest_word);
  planned.block.feed_word = std::min(word_of(planned.rate, options), planned.block.greatest_word);
  if (planned.block.feed_word == 0) {
    return base::failure(refused(block, "pulse-feed-word",
                                 "pulses: " + per_second(planned.rate) + " are no unit of the feed register",
                                 "program a higher feed, widen the feed register or take a slower clock"));
  }
  return planned;
}

}  // namespace leadscrew::nc
