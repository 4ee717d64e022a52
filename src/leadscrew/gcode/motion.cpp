// What the motion and the nonmodal code of a block execute; where its axis words lead, at which feed; G0 and G1.

#include <bit>
#include <leadscrew/gcode/interpreter.hpp>

namespace leadscrew::gcode {

std::uint32_t Interpreter::motion_column(const Block& block) const {
  return block.has(Group::motion) ? block.column_of(Group::motion) : block.first_column;
}

base::AxisVector Interpreter::target_of(const Block& block, const base::AxisVector& from) const {
  base::AxisVector target = from;
  const std::uint32_t axes = block.words & axis_letter_bits & machine_letters_;
  const bool in_machine = block.code(Group::nonmodal) == 530;
  const bool rotated = frame_.is_rotated() && !in_machine && (axes & (letter_bit('X') | letter_bit('Y')));
  base::AxisVector program{};
  if (rotated) program = frame_.to_program(from);
  for (std::uint32_t rest = axes; rest != 0; rest &= rest - 1) {
    const auto letter = static_cast<unsigned>(std::countr_zero(rest));
    const base::Axis axis = axis_of_letter(letter);
    const std::size_t i = base::index(axis);
    const double along = block.value[letter] * frame_.unit(axis);
    if (in_machine) {
      target[i] = along;
    } else if (distance_ == Distance::absolute) {
      target[i] = along + frame_.sum()[i];
      program[i] = along;
    } else {
      target[i] += along;
      program[i] += along;
    }
  }
  if (rotated) {
    const base::AxisVector turned = frame_.to_machine(program);
    for (const base::Axis axis : {base::Axis::X, base::Axis::Y}) {
      if (machine_.has(axis)) target[base::index(axis)] = turned[base::index(axis)];
    }
  }
  return target;
}

void Interpreter::execute_nonmodal(const Block& block) {
  if (!block.has(Group::nonmodal)) return;
  const Code& code = row_of(block.code(Group::nonmodal));
  if (code.execute) (this->*code.execute)(block);
}

void Interpreter::execute_motion(const Block& block) {
  // A motion that could not be told keeps the one in force.
  if (block.has(Group::motion)) {
    if (block.code(Group::motion) != motion_) tangent_.reset();
    motion_ = block.code(Group::motion);
  }
  if (motion_ == 800 || (to_do_ >= 0 && !is_drill_cycle(to_do_))) series_.reset();
  if (to_do_ >= 0) (this->*row_of(to_do_).execute)(block);
}

void Interpreter::straight(const Block& block) {
  const base::AxisVector target = target_of(block);
  Feed feed;
  if (to_do_ == 10 && (block.words & axis_letter_bits)) feed_of(block, is_linear(target), block.has('F'), feed);
  line_to(block, target, feed);
}

bool Interpreter::is_linear(const base::AxisVector& target) const {
  for (const base::Axis axis : base::all_axes) {
    if (!base::is_rotary(axis) && target[base::index(axis)] != frame_.position[base::index(axis)]) return true;
  }
  return false;
}

bool Interpreter::feed_of(const Block& block, bool linear, bool given, Feed& feed) {
  if (feed_mode_ == FeedMode::inverse_time) {
    // F in any units is a reciprocal of minutes, as it is in degrees a minute.
    feed = {Feed::Mode::per_second, given ? angular_feed_ : 1 / seconds_per_minute};
    if (given) return true;
    return error("missing-feed", motion_column(block), "a block of G93 lacks F", "give the reciprocal of its minutes");
  }
  if (!feed_known_) {
    error("missing-feed", motion_column(block), "no feed has been set", "give F before or in this block");
    assume_feed();
  }
  feed = {Feed::Mode::units_per_second, linear ? linear_feed_ : angular_feed_};
  return true;
}

void Interpreter::line_to(const Block& block, const base::AxisVector& target, const Feed& feed) {
  inside_travel(block, target);
  if (target == frame_.position) return;
  Move& line = emit(Move::Kind::line);
  line.end = target;
  line.feed = feed;
  frame_.position = target;
}

}  // namespace leadscrew::gcode
