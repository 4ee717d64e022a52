#include "cutter.hpp"

#include "registers.hpp"

namespace leadscrew::driver {

namespace {

constexpr std::uint32_t source_drives = 1, source_of_units = 2;  // + u: the axis follows unit u
constexpr int source_bits = 4;

std::uint32_t magnitude(std::int32_t value) {
  const auto bits = static_cast<std::uint32_t>(value);
  return value < 0 ? 0 - bits : bits;
}

void set_unit(Command& command, int unit, const Decision& of) {
  command.decision[unit] = static_cast<std::int32_t>(of.decision);
  command.straight[unit] = static_cast<std::int32_t>(of.straight);
  command.diagonal[unit] = static_cast<std::int32_t>(of.diagonal);
}

void set_source(Command& command, int axis, std::uint32_t source) {
  command.source |= source << (source_bits * axis);
}

void set_sense(Command& command, int axis, bool is_backward) {
  command.push |= static_cast<std::uint32_t>(is_backward) << (registers::command_push_backward_bit + axis);
}

}  // namespace

Refusal Cutter::problem_of(const Move& move) const {
  if (move.kind == Move::Kind::dwell) return Refusal::none;
  if (move.feed == 0 || move.feed > std::uint64_t{1} << core_.feed_width) return Refusal::feed;
  if (move.kind == Move::Kind::line) {
    for (int axis = 0; axis < most_axes; ++axis) {
      if (move.delta[axis] != 0 && axis >= core_.axes) return Refusal::axis;
      if (magnitude(move.delta[axis]) >> core_.width != 0) return Refusal::too_long;
    }
    return Refusal::none;
  }
  if (move.first_axis >= core_.axes || move.second_axis >= core_.axes || move.first_axis == move.second_axis)
    return Refusal::axis;
  const pulse::Point from = move.arc.start, to = move.arc.end;
  if (from == pulse::Point{} || to == pulse::Point{}) return Refusal::no_arc;
  // The radius: |coordinates| ≤ R < 2^(width − 1), with a step beside the circle
  const std::int64_t most = (std::int64_t{1} << (core_.width - 1)) - 2;
  const std::int64_t of_coordinates[] = {from.x, from.y, to.x, to.y};
  for (const std::int64_t coordinate : of_coordinates) {
    if (pulse::absolute(coordinate) > most) return Refusal::too_long;
  }
  return move.arc.squared_radius() > most * most ? Refusal::too_long : Refusal::none;
}

Refusal Cutter::take(const Move& move) {
  if (!done()) return Refusal::busy;
  const Refusal problem = problem_of(move);
  if (problem != Refusal::none) return problem;
  move_ = move;
  switch (move.kind) {
    case Move::Kind::line:
      for (const std::int32_t delta : move.delta) left_ |= magnitude(delta);
      left_ = left_ != 0;
      break;
    case Move::Kind::arc:
      octants_ = Octants(move.arc, move.speed == Move::Speed::even_path ? Cut::pieces : Cut::octants);
      left_ = octants_.done() ? 0 : 1;
      break;
    case Move::Kind::dwell:
      left_ = move.ticks;
      break;
  }
  return Refusal::none;
}

Command Cutter::next() {
  Command command;
  switch (move_.kind) {
    case Move::Kind::line:
      command = line();
      break;
    case Move::Kind::arc:
      command = octant();
      break;
    case Move::Kind::dwell:
      command = dwell();
      break;
  }
  command.push |= static_cast<std::uint32_t>(move_.tag) << registers::command_push_tag_bit;
  command.push |= static_cast<std::uint32_t>(move_.is_last && done()) << registers::command_push_final_bit;
  return command;
}

/// At least 1, at most a step a tick.
void Cutter::set_feed(Command& command, const Pace& pace) const {
  const std::uint64_t most = std::uint64_t{1} << core_.feed_width, low = move_.feed & (Pace::one - 1);
  const std::uint64_t word = (move_.feed >> 30) * pace.feed + (low * pace.feed >> 30);
  const std::uint64_t straight = word + (std::uint64_t{pace.head_start} << (core_.feed_width - 30));
  command.feed = word == 0 ? 1 : word;
  command.straight_feed = straight < command.feed ? command.feed : straight < most ? straight : most;
}

/// Steps of the driving axis over the length of the line.
std::uint32_t Cutter::share_of_driving(std::uint32_t count) const {
  std::int64_t square = 0;
  for (const std::int32_t delta : move_.delta) square += std::int64_t{delta} * delta;
  const ScaledRoot length(square);
  return static_cast<std::uint32_t>((std::int64_t{count} << length.places << 30) / length.root);
}

/// The longest axes drive, all others follow them.
Command Cutter::line() {
  Command command;
  for (const std::int32_t delta : move_.delta) {
    if (magnitude(delta) > command.count) command.count = magnitude(delta);
  }
  int unit = 0;
  for (int axis = 0; axis < core_.axes; ++axis) {
    const std::uint32_t steps = magnitude(move_.delta[axis]);
    if (steps == 0) continue;
    set_sense(command, axis, move_.delta[axis] < 0);
    if (steps == command.count) {
      set_source(command, axis, source_drives);
      continue;
    }
    set_source(command, axis, source_of_units + static_cast<std::uint32_t>(unit));
    set_unit(command, unit++, along_line(steps, command.count));
  }
  const std::uint32_t speed = move_.speed == Move::Speed::even_path ? share_of_driving(command.count) : Pace::one;
  set_feed(command, {speed, 0});
  left_ = 0;
  return command;
}

Command Cutter::octant() {
  const Octant octant = octants_.next();
  left_ = octants_.done() ? 0 : 1;
  Command command;
  set_feed(command, octant.pace);
  command.count = static_cast<std::uint32_t>(octant.count);
  const int drives = octant.x_drives ? move_.first_axis : move_.second_axis;
  const int follows = octant.x_drives ? move_.second_axis : move_.first_axis;
  set_source(command, drives, source_drives);
  set_source(command, follows, source_of_units);
  set_unit(command, 0, octant.other);
  command.push = (static_cast<std::uint32_t>(octant.other.curve) & 3) << registers::command_push_curve_bit;
  set_sense(command, move_.first_axis, octant.sign_x < 0);
  set_sense(command, move_.second_axis, octant.sign_y < 0);
  return command;
}

/// As long as the counter allows.
Command Cutter::dwell() {
  const std::uint32_t most = (std::uint32_t{1} << core_.width) - 1;
  Command command;
  command.count = left_ < most ? static_cast<std::uint32_t>(left_) : most;
  command.push = std::uint32_t{1} << registers::command_push_dwell_bit;
  left_ -= command.count;
  return command;
}

}  // namespace leadscrew::driver
