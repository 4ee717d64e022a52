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

const char* users_of(char letter) {
  switch (letter) {
    case 'H':
      return "H belongs to G43";
    case 'I':
      return "I belongs to G2 and G3 in G17 and G18, G5 and G5.1";
    case 'J':
      return "J belongs to G2 and G3 in G17 and G19, G5 and G5.1";
    case 'K':
      return "K belongs to G2 and G3 in G18 and G19, and G6.2";
    case 'L':
      return "L belongs to G5.2, G10 and the canned cycles";
    case 'P':
      return "P belongs to G2 to G5, G5.2, G6.2, G10, G64 and G82";
    case 'Q':
      return "Q belongs to G5, G64 and G83";
    case 'R':
      return "R belongs to G2, G3, G6.2, G10 L2 and the canned cycles";
    default:
      return "no supported code takes it";
  }
}

// G codes other than motions that take the axis words of their block.
bool takes_axes(const Block& block) {
  const GCode code = block.code(Group::nonmodal);
  return code == 100 || code == 280 || code == 300 || code == 920 || block.code(Group::tool_length) == 431;
}

constexpr std::uint32_t offset_letters(Plane plane) {
  return (plane == Plane::YZ ? 0 : letter_bit('I')) | (plane == Plane::ZX ? 0 : letter_bit('J')) |
         (plane == Plane::XY ? 0 : letter_bit('K'));
}

// The letters of curves that are not axes. P of G6.2 stands where the curve begins.
constexpr std::uint32_t curve_letters(GCode motion, bool begins) {
  switch (motion) {
    case cubic_spline:
      return letter_bit('I') | letter_bit('J') | letter_bit('P') | letter_bit('Q');
    case quadratic_spline:
      return letter_bit('I') | letter_bit('J');
    case nurbs_begin:
      return letter_bit('P') | letter_bit('L');
    case nurbs_with_knots:
      return letter_bit('K') | letter_bit('R') | (begins ? letter_bit('P') : 0);
    default:
      return 0;
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
  const bool axes_taken = takes_axes(block);
  if (block.has(Group::motion)) {
    const GCode motion = block.code(Group::motion);
    if (motion == 800) {
      if (axes && !axes_taken) {
        const auto letter = static_cast<unsigned>(std::countr_zero(axes));
        error("axis-without-motion", block.column[letter], "G80 moves no axis", "give G0 or G1 instead");
      }
      return -1;
    }
    if (axes_taken) {
      const Group other = takes_axes(block) && block.has(Group::nonmodal) ? Group::nonmodal : Group::tool_length;
      error("modal-conflict", block.column_of(Group::motion),
            g_name(motion) + " and " + g_name(block.code(other)) + " both take the axis words",
            "put them into two blocks");
      return -1;
    }
    return motion;
  }
  if (axes_taken) return -1;
  if (axes) {
    if (motion_ == 800) {
      const auto letter = static_cast<unsigned>(std::countr_zero(axes));
      error("axis-without-motion", block.column[letter], "no motion is in force for the axis words",
            "give G0, G1, G2 or G3 before or in this block");
      motion_ = 0;
    }
    return motion_;
  }
  return moves_without_axes(block) && block.code(Group::nonmodal) != 100 ? motion_ : GCode{-1};
}

bool Interpreter::moves_without_axes(const Block& block) const {
  if (is_arc(motion_)) return block.words & (offset_letters(plane_after(block)) | letter_bit('R'));
  if (motion_ == cubic_spline || motion_ == quadratic_spline) return block.has('I') || block.has('J');
  return motion_ == nurbs_with_knots && (block.has('K') || block.has('R'));
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

std::uint32_t Interpreter::words_used(const Block& block) const {
  std::uint32_t used = 0;
  const GCode code = block.code(Group::nonmodal);
  if (code == 40) used |= letter_bit('P');
  if (code == 100) used |= letter_bit('P') | letter_bit('L') | letter_bit('R');
  if (block.code(Group::tool_length) == 430) used |= letter_bit('H');
  if (block.code(Group::path) == 640) used |= letter_bit('P') | letter_bit('Q');
  if (is_arc(to_do_)) used |= letter_bit('P') | letter_bit('R') | offset_letters(plane_after(block));
  if (is_drill_cycle(to_do_)) used |= letter_bit('R') | letter_bit('L');
  if (is_curve(to_do_)) used |= curve_letters(to_do_, block.has(Group::motion));
  if (to_do_ == 820) used |= letter_bit('P');
  if (to_do_ == 830) used |= letter_bit('Q');
  return used;
}

void Interpreter::check_words(const Block& block) {
  const std::uint32_t dependent = block.words & dependent_words;
  if (dependent == 0) return;
  for (std::uint32_t rest = dependent & ~words_used(block); rest != 0; rest &= rest - 1) {
    const auto letter = static_cast<unsigned>(std::countr_zero(rest));
    const char name = static_cast<char>('A' + letter);
    std::string message = "nothing in this block takes ";
    message += name;
    error("unused-word", block.column[letter], std::move(message), users_of(name));
  }
  if (!block.has('P')) return;
  const int takers = (block.code(Group::nonmodal) == 40) + (block.code(Group::nonmodal) == 100) +
                     (block.code(Group::path) == 640) + is_arc(to_do_) + (to_do_ == 820) +
                     ((curve_letters(to_do_, block.has(Group::motion)) & letter_bit('P')) != 0);
  if (takers > 1) {
    error("ambiguous-word", block.column_of('P'), "more than one code of this block takes P",
          "put them into two blocks");
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
