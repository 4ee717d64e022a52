#include <bit>
#include <leadscrew/gcode/interpreter.hpp>
#include <leadscrew/gcode/number.hpp>
#include <utility>

namespace leadscrew::gcode {

namespace {

// Letters that mean something only beside a code that takes them.
constexpr std::uint32_t dependent_words = letter_bit('D') | letter_bit('E') | letter_bit('H') | letter_bit('I') |
                                          letter_bit('J') | letter_bit('K') | letter_bit('L') | letter_bit('P') |
                                          letter_bit('Q') | letter_bit('R');

constexpr std::uint32_t offset_letters = letter_bit('I') | letter_bit('J') | letter_bit('K');

constexpr std::uint32_t offset_letters_of(Plane plane) {
  return (plane == Plane::YZ ? 0 : letter_bit('I')) | (plane == Plane::ZX ? 0 : letter_bit('J')) |
         (plane == Plane::XY ? 0 : letter_bit('K'));
}

// Calls f(code) for each G code of the block but its motion.
template <class F>
void for_each_code(const Block& block, F&& f) {
  for (std::uint32_t rest = block.g_groups & ~bit(Group::motion); rest != 0; rest &= rest - 1) {
    f(block.g[static_cast<std::size_t>(std::countr_zero(rest))]);
  }
}

}  // namespace

Plane Interpreter::plane_after(const Block& block) const {
  switch (block.code(Group::plane)) {
    case 170:
      return Plane::XY;
    case 180:
      return Plane::ZX;
    case 190:
      return Plane::YZ;
    default:
      return plane_;
  }
}

Interpreter::Distance Interpreter::distance_after(const Block& block) const {
  if (!block.has(Group::distance)) return distance_;
  return block.code(Group::distance) == 900 ? Distance::absolute : Distance::incremental;
}

void Interpreter::check(const Block& block) {
  check_curve(block);
  to_do_ = motion_of(block);
  check_words(block);
  check_axes(block);
  check_presence(block);
}

// Axis words belong to the motion that stands in the block, or else to G10, G28, G30, G92 or G43.1, or else to the
// motion in force (NIST IR 6556, 3.3.4 and 3.5).
GCode Interpreter::motion_of(const Block& block) {
  const std::uint32_t axes = block.words & axis_letter_bits;
  GCode taker = -1;
  for_each_code(block, [&](GCode code) {
    if (taker < 0 && row_of(code).takes_axes) taker = code;
  });
  const auto first_axis_column = [&] { return block.column[static_cast<unsigned>(std::countr_zero(axes))]; };
  if (block.has(Group::motion)) {
    const GCode motion = block.code(Group::motion);
    if (motion == 800) {
      if (axes && taker < 0) {
        error("axis-without-motion", first_axis_column(), "G80 moves no axis", "give G0 or G1 instead");
      }
      return -1;
    }
    if (taker >= 0) {
      error("modal-conflict", block.column_of(Group::motion),
            g_name(motion) + " and " + g_name(taker) + " both take the axis words", "put them into two blocks");
      return -1;
    }
    return motion;
  }
  if (taker >= 0) return -1;
  if (!axes) return repeats_motion(block) ? motion_ : GCode{-1};
  if (motion_ == 800) {
    error("axis-without-motion", first_axis_column(), "no motion is in force for the axis words",
          "give G0, G1, G2 or G3 before or in this block");
    motion_ = 0;
  }
  return motion_;
}

/// Whether the block repeats the motion in force by other words than axes, which no other code of the block takes.
bool Interpreter::repeats_motion(const Block& block) const {
  std::uint32_t words = block.words & row_of(motion_).repeated_by.bits;
  if (is_arc(motion_)) words &= ~offset_letters | offset_letters_of(plane_after(block));
  for_each_code(block, [&](GCode code) { words &= ~row_of(code).words.bits; });
  if (block.has_m(5)) words &= ~Letters(letters_of_output(block.m[5])).bits;
  return words != 0;
}

// Between the first block of a curve and the last there is nothing but its points, their feed, and remarks.
void Interpreter::check_curve(const Block& block) {
  if (draft_.code < 0) return;
  const bool by_itself = draft_.code == nurbs_begin &&
                         (block.code(Group::motion) == nurbs_begin || block.code(Group::motion) == nurbs_end);
  const bool motion = block.has(Group::motion) && !by_itself;
  const bool other_words = block.words & (letter_bit('S') | letter_bit('T'));
  if (!motion && !other_words && !(block.g_groups & ~bit(Group::motion)) && !block.m_groups) return;
  curve_error("unfinished-curve", motion ? block.column_of(Group::motion) : block.first_column, unfinished_message(),
              unfinished_hint());
  if (motion || block.has_m(4)) abandon_curve();
}

/// The letters that the block's motion takes.
std::uint32_t Interpreter::motion_words(const Block& block) const {
  if (to_do_ < 0) return 0;
  const std::uint32_t words = row_of(to_do_).words.bits;
  if (is_arc(to_do_)) return words & (~offset_letters | offset_letters_of(plane_after(block)));
  // P of G6.2 stands where the curve begins.
  if (to_do_ == nurbs_with_knots && !block.has(Group::motion)) return words & ~letter_bit('P');
  return words;
}

void Interpreter::check_words(const Block& block) {
  const std::uint32_t dependent = block.words & dependent_words;
  if (dependent == 0) return;
  std::uint32_t used = motion_words(block), used_twice = 0;
  const auto use = [&](std::uint32_t words) {
    used_twice |= used & words;
    used |= words;
  };
  for_each_code(block, [&](GCode code) { use(row_of(code).words.bits); });
  if (block.has_m(5)) use(Letters(letters_of_output(block.m[5])).bits);
  for (std::uint32_t rest = dependent & ~used; rest != 0; rest &= rest - 1) {
    const auto letter = static_cast<unsigned>(std::countr_zero(rest));
    const char name = static_cast<char>('A' + letter);
    std::string message = "nothing in this block takes ";
    message += name;
    error("unused-word", block.column[letter], std::move(message), users_of(name));
  }
  for (std::uint32_t rest = dependent & used_twice; rest != 0; rest &= rest - 1) {
    const auto letter = static_cast<unsigned>(std::countr_zero(rest));
    std::string message = "more than one code of this block takes ";
    message += static_cast<char>('A' + letter);
    error("ambiguous-word", block.column[letter], std::move(message), "put them into two blocks");
  }
}

void Interpreter::check_axes(const Block& block) {
  for (std::uint32_t rest = block.words & axis_letter_bits & ~machine_letters_; rest != 0; rest &= rest - 1) {
    const auto letter = static_cast<unsigned>(std::countr_zero(rest));
    const base::Axis axis = axis_of_letter(letter);
    reporter_.fail();
    // One machine, one problem: not one in every block.
    if (reported_lacking_.contains(axis)) continue;
    if (!reporter_.muted()) reported_lacking_.insert(axis);
    std::string axes;
    for (const base::Axis present : base::all_axes) {
      if (machine_.has(present)) axes += std::string(axes.empty() ? "" : " ") + base::letter(present);
    }
    error("unknown-axis", block.column[letter], std::string("the machine has no axis ") + base::letter(axis),
          "its axes are " + axes);
  }
}

void Interpreter::check_presence(const Block& block) {
  const bool axes = block.words & axis_letter_bits;
  const GCode code = block.code(Group::nonmodal);
  const std::uint32_t column = block.column_of(Group::nonmodal);
  const auto missing = [&](std::uint32_t at, std::string message, std::string hint) {
    error("missing-word", at, std::move(message), std::move(hint));
  };
  if (code == 40 && !block.has('P')) missing(column, "G4 does not say how long", "give P, seconds");
  if (block.has_m(5)) {
    for (const char* letter = letters_of_output(block.m[5]); *letter != 0; ++letter) {
      if (!block.has(*letter)) {
        missing(block.m_column[5], "M" + std::to_string(block.m[5]) + " lacks " + *letter,
                block.m[5] <= 65 ? "M62 P0" : "M67 E0 Q0");
      }
    }
  }
  if (code == 100 && !(block.has('L') && block.has('P'))) missing(column, "G10 lacks L or P", "G10 L2 P1 X0 Y0 Z0");
  if (code == 920 && !axes) missing(column, "G92 lacks axis words", "G92 X0");
  if (code == 530) {
    if (to_do_ != 0 && to_do_ != 10) {
      error("bad-g53", column, "G53 stands without G0 or G1 in force", "G53 G0 X0");
    } else if (distance_after(block) == Distance::incremental) {
      error("bad-g53", column, "G53 cannot be incremental", "give G90");
    }
  }
  if (block.code(Group::tool_length) == 431 && !axes) {
    missing(block.column_of(Group::tool_length), "G43.1 lacks axis words", "G43.1 Z10");
  }
  if (is_drill_cycle(to_do_) && !(block.words & (letter_bit('X') | letter_bit('Y') | letter_bit('Z')))) {
    missing(motion_column(block), g_name(to_do_) + " lacks axis words", "X, Y or Z");
  }
}

}  // namespace leadscrew::gcode
