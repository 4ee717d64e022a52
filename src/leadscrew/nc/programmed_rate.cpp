#include <algorithm>
#include <cmath>
#include <leadscrew/nc/lattice_arc.hpp>
#include <leadscrew/nc/programmed_rate.hpp>
#include <leadscrew/numeric/rounded_up.hpp>
#include <leadscrew/numeric/vectors.hpp>
#include <limits>

namespace leadscrew::nc {

namespace {

using numeric::real;

StepVector in_steps(const LatticeVector& delta) {
  StepVector steps{};
  for (std::size_t i = 0; i < delta.size(); ++i) steps[i] = real(delta[i]);
  return steps;
}

/// Length of a displacement by its components in three axes from `first` on, mm or degrees.
double length_of(const StepVector& delta, std::size_t first, const machine::Machine& machine) {
  double square = 0;
  for (std::size_t i = first; i < first + 3; ++i) {
    if (delta[i] == 0) continue;
    const double length = delta[i] * machine.limits(base::all_axes[i]).blu;
    square += length * length;
  }
  return std::sqrt(square);
}

/// Length of a straight displacement, as the feed counts it.
double feed_length(const StepVector& delta, const machine::Machine& machine) {
  double length = 0;
  for (const base::Axis first : {base::Axis::X, base::Axis::U, base::Axis::A}) {
    if (length == 0) length = length_of(delta, base::index(first), machine);
  }
  return length;
}

/// Of the lattice's path, as the feed counts it.
double feed_length(const Block& block, const machine::Machine& machine) {
  if (block.kind != Block::Kind::arc) return feed_length(in_steps(block.delta), machine);
  const double radius = std::sqrt(real(block.arc.squared_radius()));
  const double blu = machine.limits(base::all_axes[block.first_axis]).blu;
  return std::hypot(length_of(in_steps(block.delta), base::index(base::Axis::X), machine),
                    radius * sweep(block.arc) * blu);
}

/// Of a line, were the lattice as fine as can be.
double commands_of(const StepVector& delta, PulseMethod method) {
  const CommandRate rate = rate_of(method);
  if (rate == CommandRate::path_length) return numeric::norm(delta);
  double sum = 0, longest = 0;
  for (const double of_axis : delta) {
    sum += std::abs(of_axis);
    longest = std::max(longest, std::abs(of_axis));
  }
  return rate == CommandRate::every_step ? sum : longest;
}

/// Steps/s of each axis at most, of what is programmed: of a line, and of an arc that is interpolated by length.
void ask_velocity(ProgrammedRate& asked, const StepVector& velocity, const machine::Machine& machine) {
  for (const base::Axis axis : base::all_axes) {
    const double of_axis = std::abs(velocity[base::index(axis)]);
    if (of_axis == 0) continue;
    const double share = of_axis * machine.limits(axis).blu / machine.limits(axis).velocity;
    if (share <= asked.of_velocity) continue;
    asked.of_velocity = share;
    asked.fastest = axis;
  }
}

ProgrammedRate rate_of_line(const Block& block, const gcode::Move& move, const machine::Machine& machine,
                            PulseMethod method) {
  StepVector delta = programmed_delta(move, machine);
  const double seconds = seconds_of(1, feed_length(delta, machine), move.feed);
  ProgrammedRate asked;
  asked.rate = real(block.commands) / seconds_of(1, feed_length(block, machine), move.feed);
  asked.least = commands_of(delta, method) / seconds * (1 - numeric::quotient_rounding);
  for (double& of_axis : delta) of_axis /= seconds;
  ask_velocity(asked, delta, machine);
  return asked;
}

/// Steps/s along an arc's circle, and of the axes beside it.
StepVector velocity_on_arc(const Block& block, const gcode::Move& move, const Part& part,
                           const machine::Machine& machine, double seconds) {
  StepVector velocity = programmed_delta(move, machine);
  double beside = 0;  // mm
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    if (velocity[i] == 0) continue;
    velocity[i] *= part.share / seconds;
    const double travel = velocity[i] * seconds * machine.limits(base::all_axes[i]).blu;
    if (i < 3 && !in_plane(block, i)) beside = travel;
  }
  const double around = std::sqrt(std::max(0.0, part.length * part.length - beside * beside));
  for (const std::size_t i : {block.first_axis, block.second_axis})
    velocity[i] = around / machine.limits(base::all_axes[i]).blu / seconds;
  return velocity;
}

}  // namespace

StepVector programmed_delta(const gcode::Move& move, const machine::Machine& machine) {
  StepVector delta{};
  for (const base::Axis axis : base::all_axes) {
    const std::size_t i = base::index(axis);
    if (machine.has(axis)) delta[i] = (move.end[i] - move.start[i]) / machine.limits(axis).blu;
  }
  return delta;
}

bool in_plane(const Block& block, std::size_t axis) {
  return block.kind == Block::Kind::arc && (axis == block.first_axis || axis == block.second_axis);
}

double greatest_share(const Block& block, std::size_t axis) {
  if (in_plane(block, axis)) return real(block.circle_commands) / real(block.commands);
  return std::abs(real(block.delta[axis])) / real(block.commands);
}

AxisRate greatest_by_velocity(const Block& block, const machine::Machine& machine) {
  AxisRate greatest{std::numeric_limits<double>::infinity()};
  for (const base::Axis axis : base::all_axes) {
    const double share = greatest_share(block, base::index(axis));
    if (share == 0) continue;
    const machine::AxisLimits& limits = machine.limits(axis);
    const double rate = limits.velocity / limits.blu / share;
    if (rate < greatest.rate) greatest = {rate, axis};
  }
  return greatest;
}

double seconds_of(double share, double length, const gcode::Feed& feed) {
  return feed.mode == gcode::Feed::Mode::per_second ? share / feed.value : length / feed.value;
}

ProgrammedRate programmed_rate(const Block& block, const gcode::Move& move, const Part& part,
                               const machine::Machine& machine, PulseMethod method) {
  const bool is_arc = block.kind == Block::Kind::arc;
  if (!is_arc && move.kind == gcode::Move::Kind::line) return rate_of_line(block, move, machine, method);
  const double on_lattice = seconds_of(part.share, feed_length(block, machine), move.feed);
  const double seconds = is_arc ? seconds_of(part.share, part.length, move.feed) : on_lattice;
  ProgrammedRate asked;
  asked.rate = real(block.commands) / seconds;
  // Rounding to the lattice may have made the path longer by a step, of arcs by two, and their radius too.
  asked.least =
      real(block.commands - (is_arc ? 2 : 1)) / std::max(seconds, on_lattice) * (1 - numeric::quotient_rounding);
  const AxisRate by_velocity = greatest_by_velocity(block, machine);
  asked.of_velocity = asked.least / by_velocity.rate;
  asked.fastest = by_velocity.axis;
  if (!is_arc || rate_of(method) != CommandRate::path_length) return asked;
  StepVector velocity = velocity_on_arc(block, move, part, machine, seconds);
  ask_velocity(asked, velocity, machine);
  velocity[block.second_axis] = 0;  // the circle's, once
  asked.least = std::max(asked.least, numeric::norm(velocity) * (1 - numeric::quotient_rounding));
  return asked;
}

}  // namespace leadscrew::nc
