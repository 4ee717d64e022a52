// Which part does what a code of group 0 or 1 says. What other codes say are modes, which Interpreter::set_modes() sets,
// or events.

#include <bit>
#include <leadscrew/gcode/interpreter.hpp>

namespace leadscrew::gcode {

void Interpreter::dispatch(Code code, const Block& block) {
  switch (code) {
    case Code::G0:
    case Code::G1:
      if (frame_.takes_vectors() && frame_.tip_control()) return vectors_.line(block);
      return motion_.straight(block);
    case Code::G2:
    case Code::G3:
      return motion_.arc(block);
    case Code::G5:
    case Code::G5_1:
    case Code::G5_2:
    case Code::G5_3:
    case Code::G6_2:
    case Code::G6_4:
    case Code::G6_5:
    case Code::G6_6:
      return dispatch_curve(code, block);
    case Code::G10:
      return offsets_.set_system(block);
    case Code::G12:
    case Code::G13:
      return circular_pockets_.mill(block);
    case Code::G47:
      return engraving_.engrave(block, remark_);
    case Code::G150:
      return pocket_cycle_.begin(block);
    case Code::G28:
    case Code::G30:
      curves_.forget_tangent();
      return offsets_.go_home(block);
    case Code::G28_1:
    case Code::G30_1:
      return offsets_.set_home(block);
    case Code::G31:
      curves_.forget_tangent();
      return probing_.skip(block);
    case Code::G38_2:
    case Code::G38_3:
    case Code::G38_4:
    case Code::G38_5:
      return probing_.probe(block);
    case Code::G52:
      return offsets_.set_local(block);
    case Code::G53:
      modal_.in_machine = modal_.line;
      return;
    case Code::G53_1:
    case Code::G253:
      curves_.forget_tangent();
      cycles_.end_series();
      return tilted_planes_.orient(block);
    case Code::G92:
    case Code::G92_1:
    case Code::G92_2:
    case Code::G92_3:
      return offsets_.set_shift(block);
    default:
      dispatch_cycle(code, block);
  }
}

void Interpreter::dispatch_curve(Code code, const Block& block) {
  switch (code) {
    case Code::G5:
    case Code::G5_1:
      return curves_.spline(block);
    case Code::G5_2:
      return curves_.nurbs(block);
    case Code::G5_3:
      return curves_.end_nurbs(block);
    case Code::G6_2:
      return curves_.add_to_nurbs_with_knots(block);
    case Code::G6_4:
      return surface_blocks_.begin(*surface_words_);
    case Code::G6_5:
      vectors_.forget_direction();
      return surface_moves_.begin(*surface_words_);
    case Code::G6_6:
      vectors_.forget_direction();
      return directed_curve_.begin(*surface_words_);
    default:
      return;
  }
}

void Interpreter::dispatch_cycle(Code code, const Block& block) {
  switch (code) {
    case Code::G33:
      return threading_.thread(block);
    case Code::G33_1:
      return threading_.tap(block);
    case Code::G76:
      return threading_.cycle(block);
    case Code::G90_turn:
    case Code::G94_face:
    case Code::G92_thread:
      return turning_cycles_.cut(block);
    case Code::G74_face:
    case Code::G75:
      return pecking_cycles_.peck(block);
    case Code::G76_profile:
      return threading_.cycle_of_two_blocks(block);
    case Code::G70_profile:
    case Code::G71_profile:
    case Code::G72_profile:
    case Code::G73_profile:
      return lathe_cycles_.begin_profile(block);
    case Code::G70:
    case Code::G71:
    case Code::G71_1:
    case Code::G71_2:
    case Code::G72:
    case Code::G72_1:
    case Code::G72_2:
      return lathe_cycles_.begin(block);
    case Code::G50_turn:
      if (block.words & axis_letter_bits) offsets_.set_shift(block);
      return;
    case Code::G70_bolts:
    case Code::G71_bolts:
    case Code::G72_bolts:
      return cycles_.drill_pattern(block);
    default:
      if (is_canned_cycle(code)) cycles_.drill(block);
  }
}

/// Words that elsewhere move axes, turn the spindle or select a tool are the surface's. Nothing else moves in its block.
void Interpreter::execute_surface(const Block& words) {
  const Code code = words.code(Group::nonmodal);
  const std::uint32_t own = row(code).words.bits & (axis_letter_bits | letter_bit('S') | letter_bit('T'));
  Block block = words;
  block.words &= ~own;
  for (std::uint32_t rest = block.words & (axis_letter_bits | polar_bits); rest != 0; rest &= rest - 1) {
    const auto letter = static_cast<unsigned>(std::countr_zero(rest));
    const char shown = word_marks[letter];
    error("unused-word", block.column[letter], name(code) + " does not take " + shown, "put it into another block");
  }
  if (block.has(Group::motion) && !block.is(Code::G80)) {
    error("modal-conflict", block.column_of(Group::motion),
          name(code) + " and " + name(block.code(Group::motion)) + " cannot stand in one block",
          "put them into two blocks");
    block.groups &= ~bit(Group::motion);
  }
  block.words &= ~(axis_letter_bits | polar_bits);
  for (const base::Axis axis : {base::Axis::X, base::Axis::Y, base::Axis::Z}) {
    if (code == Code::G6_4 || machine_.has(axis)) continue;
    error("unknown-axis", block.column_of(Group::nonmodal),
          name(code) + " moves axis " + base::letter(axis) + ", which the machine does not have",
          "surfaces and curves in space take X, Y and Z");
    break;
  }
  curves_.forget_tangent();
  cycles_.end_series();
  surface_words_ = &words;
  begin_block(block);
  finish_block(block);
}

/// A block of points or places; false where it is none.
bool Interpreter::add_to_surface(const Block& block) {
  const bool is_taken = surface_blocks_.is_open() ? surface_blocks_.add(block) : directed_curve_.add(block);
  if (is_taken) modal_.is_plain = is_plain();
  return is_taken;
}

bool Interpreter::next_of_surface(Move& move) {
  return surface_moves_.is_active() ? surface_moves_.next(move) : directed_curve_.next(move);
}

}  // namespace leadscrew::gcode
