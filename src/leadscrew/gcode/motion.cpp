// Where the axis words of a block lead, at which feed; G0 and G1.

#include <bit>
#include <leadscrew/gcode/motion.hpp>

namespace leadscrew::gcode {

base::AxisVector Motion::target_of(const Block& block, const base::AxisVector& from) const {
  base::AxisVector target = from;
  const std::uint32_t axes = block.words & axis_letter_bits & machine_letters_;
  const bool in_machine = block.is(Code::G53);
  constexpr std::uint32_t xyz = letter_bit('X') | letter_bit('Y') | letter_bit('Z');
  const bool transforms = !frame_.is_offset_only() && !in_machine && (axes & xyz);
  base::AxisVector program{};
  if (transforms) program = frame_.to_program(from);
  for (std::uint32_t rest = axes; rest != 0; rest &= rest - 1) {
    const auto letter = static_cast<unsigned>(std::countr_zero(rest));
    const base::Axis axis = axis_of_letter(letter);
    const std::size_t i = base::index(axis);
    const double along = block.value[letter] * frame_.unit(axis);
    if (in_machine) {
      // Under M428 they are those of the point that holds the tool, in the workpiece (LinuxCNC's kinematics add the tool).
      target[i] = frame_.tip_control() && i < 3 ? along - frame_.tool()[i] : along;
    } else if (modal_.distance == Distance::absolute) {
      target[i] = along + frame_.offset()[i];
      program[i] = along;
    } else {
      target[i] += along;
      program[i] += along;
    }
  }
  if (transforms) {
    const base::AxisVector placed = frame_.to_machine(program);
    for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z}) {
      // An axis that goes by itself, and that the block does not name, stays exactly where it is.
      const bool stays = frame_.is_separate(axis) && !block.has(base::letter(axis));
      if (machine_.has(axis) && !stays) target[base::index(axis)] = placed[base::index(axis)];
    }
  }
  return target;
}

void Motion::straight(const Block& block) {
  const base::AxisVector target = target_of(block);
  Feed feed;
  // Where the tool is yet to come back to where the program stands, X and Y move.
  const bool is_aside = modal_.tool_is_aside;
  if (modal_.to_do == Code::G1 && (is_aside || (block.words & axis_letter_bits)))
    feed_of(block, is_aside || is_linear(target), block.has('F'), feed);
  line_to(block, target, feed);
}

bool Motion::is_linear(const base::AxisVector& target) const {
  for (const base::Axis axis : base::all_axes) {
    if (!base::is_rotary(axis) && target[base::index(axis)] != frame_.position[base::index(axis)]) return true;
  }
  return false;
}

void Motion::set_feed(const Block& block) {
  if (block.has(Group::feed_mode)) {
    const FeedMode mode = block.is(Code::G93)   ? FeedMode::inverse_time
                          : block.is(Code::G95) ? FeedMode::per_revolution
                                                : FeedMode::per_minute;
    // A number that was a duration is no speed.
    if (mode != modal_.feed_mode) modal_.feed_known = false;
    if (mode != modal_.feed_mode && mode != FeedMode::inverse_time) modal_.feed_word = 0;
    if (mode != modal_.feed_mode) told_standing_ = false;
    modal_.feed_mode = mode;
  }
  if (!block.has('F')) return;
  const double value = block['F'];
  constexpr double least = 1e-6;  // a millimetre in two years
  if (value == 0 && modal_.feed_mode != FeedMode::inverse_time) {
    modal_.feed_known = false;  // a motion that needs one says that there is none
    return;
  }
  if (!(value >= least)) {
    error("bad-value", block.column_of('F'), "the feed is " + text(value), "F must be 0.000001 or more");
    assume_feed();
    return;
  }
  modal_.feed_known = true;
  if (modal_.feed_mode != FeedMode::inverse_time) modal_.feed_word = value;
  modal_.linear_feed = value * frame_.length_unit / seconds_per_minute;
  modal_.angular_feed = value / seconds_per_minute;
  if (block.has(Group::units) && (block.code(Group::units) == Code::G20) != (frame_.length_unit != 1)) {
    reporter_.warning("feed-before-units", block.column_of('F'),
                      "F" + text(value) + " is read in the units that held before " + name(block.code(Group::units)),
                      "put the units into a block before");
  }
}

// Said once that there is none, what follows is read as if there were one.
void Motion::assume_feed() {
  if (!modal_.feed_known) modal_.linear_feed = modal_.angular_feed = 1;
  modal_.feed_known = true;
}

bool Motion::feed_of(const Block& block, bool linear, bool given, Feed& feed) {
  if (modal_.feed_mode == FeedMode::inverse_time) {
    // F in any units is a reciprocal of minutes, as it is in degrees a minute.
    feed = {Feed::Mode::per_second, given ? modal_.angular_feed : 1 / seconds_per_minute};
    if (given) return true;
    return error("missing-feed", motion_column(block), "a block of G93 lacks F", "give the reciprocal of its minutes");
  }
  if (!modal_.feed_known) {
    error("missing-feed", motion_column(block), "no feed has been set", "give F before or in this block");
    assume_feed();
  }
  feed = {Feed::Mode::units_per_second, linear ? modal_.linear_feed : modal_.angular_feed};
  return modal_.feed_mode != FeedMode::per_revolution || feed_per_revolution(block, feed);
}

// Of G95: as the spindle is to turn while the block begins (LinuxCNC manual, G Codes, "G93, G94, G95").
bool Motion::feed_per_revolution(const Block& block, Feed& feed) {
  if (modal_.spindle_speed > 0) {
    if (machine_.threads_follow()) tell_standing(block);
    feed.per_revolution = feed.value;
    feed.value *= modal_.spindle_speed;
    return true;
  }
  return error("spindle-stands", motion_column(block), "a feed per revolution while the spindle has no speed",
               "give S before, or G94");
}

// LinuxCNC's motion waits there until somebody turns the spindle. Tapping cycles turn one that stands. Once, where such feed
// begins.
void Motion::tell_standing(const Block& block) {
  const bool taps = modal_.to_do == Code::G84 || modal_.to_do == Code::G74;
  const bool stands = modal_.spindle == Code::M5 && !taps;
  if (stands && !told_standing_) {
    reporter_.warning("spindle-stands", motion_column(block), "a feed per revolution while the spindle stands",
                      "give M3 or M4 before, or G94: motion creeps until the spindle turns");
  }
  told_standing_ = stands;
}

void Motion::line_to(const Block& block, const base::AxisVector& target, const Feed& feed) {
  travel_.inside_travel(block, target);
  if (target == frame_.position && !modal_.tool_is_aside) return;
  modal_.tool_is_aside = false;
  Move& line = outbox_.emit(Move::Kind::line);
  line.end = target;
  line.feed = feed;
  frame_.position = target;
  if (frame_.is_tilted()) frame_.follow_rotary_axes();
}

}  // namespace leadscrew::gcode
