#include <bit>
#include <cmath>
#include <leadscrew/gcode/block_check.hpp>
#include <string>
#include <vector>

namespace leadscrew::gcode {

namespace {

// Letters that mean something only beside a code that takes them.
constexpr std::uint32_t dependent_words = letter_bit('D') | letter_bit('E') | letter_bit('H') | letter_bit('I') |
                                          letter_bit('J') | letter_bit('K') | letter_bit('L') | letter_bit('P') |
                                          letter_bit('Q') | letter_bit('R') | letter_bit('$');

constexpr std::uint32_t offset_letters = letter_bit('I') | letter_bit('J') | letter_bit('K');

constexpr std::uint32_t offset_letters_of(Plane plane) {
  return (plane == Plane::YZ ? 0 : letter_bit('I')) | (plane == Plane::ZX ? 0 : letter_bit('J')) |
         (plane == Plane::XY ? 0 : letter_bit('K'));
}

// How a code is written whose words are missing.
std::string example_of(Code code, Dialect dialect) {
  switch (code) {
    case Code::G4:
      return "give P, seconds: G4 P0.5";
    case Code::G10:
      if (dialect == Dialect::fanuc_lathe)
        return "G10 P10004 R0.4 Q3 for a tool, G10 P4 X0.1 for its wear, G10 L2 P1 X0 Z0 for coordinates";
      if (is_of_fanuc_family(dialect))
        return "G10 L10 P1 R50. for a tool's length, G10 L12 P1 R5. for its radius, G10 L2 P1 X0 Y0 Z0 for coordinates";
      return "G10 L2 P1 X0 Y0 Z0";
    case Code::G31:
      return "G31 Z-10 F100";
    case Code::G33:
    case Code::G33_1:
      return name(code, dialect) + (dialect == Dialect::fanuc_lathe ? " Z-10 F1" : " Z-10 K1");
    case Code::G70_profile:
      return "G70 P100 Q200";
    case Code::G70_bolts:
      return "G70 I20 L6";
    case Code::G71_bolts:
      return "G71 I20 K30 L6";
    case Code::G72_bolts:
      return "G72 I20 L6";
    case Code::G76:
      return "G76 P1 Z-10 I-1 J0.3 K0.9";
    case Code::G52:
      return "G52 X0";
    case Code::G92:
      return "G92 X0";
    case Code::G96:
      return "give S, in metres (G20: feet) a minute: G96 S120";
    case Code::G43_1:
      return "G43.1 Z10";
    default: {
      std::string example = name(code);
      for (char letter = 'A'; letter <= 'Z'; ++letter) {
        if (row(code).needs.has(letter)) example += std::string(" ") + letter + "0";
      }
      return example;
    }
  }
}

// Calls f(code) for each G code of the block but its motion.
template <class F>
void for_each_code(const Block& block, F&& f) {
  for (std::uint32_t rest = block.groups & ~bit(Group::motion); rest != 0; rest &= rest - 1) {
    f(block.codes[static_cast<std::size_t>(std::countr_zero(rest))]);
  }
}

}  // namespace

Plane plane_after(const Block& block, const ModalState& modal) {
  switch (block.code(Group::plane)) {
    case Code::G17:
      return Plane::XY;
    case Code::G18:
      return Plane::ZX;
    case Code::G19:
      return Plane::YZ;
    case Code::G17_1:
      return Plane::UV;
    case Code::G18_1:
      return Plane::WU;
    case Code::G19_1:
      return Plane::VW;
    default:
      return modal.plane;
  }
}

bool has_vectors(const Block& block, const Frame& frame) {
  return block.has(Group::tool_length) ? block.is(Code::G43_5) : frame.takes_vectors();
}

// Of G43.4 and G43.5.
bool ends_tip_control(const Block& block) {
  return block.has(Group::tool_length) && !block.is(Code::G43_4) && !block.is(Code::G43_5);
}

Distance distance_after(const Block& block, const ModalState& modal) {
  if (!block.has(Group::distance)) return modal.distance;
  return block.code(Group::distance) == Code::G90 ? Distance::absolute : Distance::incremental;
}

void BlockCheck::check(const Block& block) {
  check_words(block);
  check_axes(block);
  check_presence(block);
}

// Axis words belong to the motion that stands in the block, or else to G10, G28, G30, G92 or G43.1, or else to the
// motion in force (NIST IR 6556, 3.3.4 and 3.5).
Code BlockCheck::motion_of(const Block& block) {
  const std::uint32_t axes = block.words & axis_letter_bits;
  Code taker = Code::none;
  for_each_code(block, [&](Code code) {
    if (taker == Code::none && row(code).takes_axes) taker = code;
  });
  const auto first_axis_column = [&] { return block.column[static_cast<unsigned>(std::countr_zero(axes))]; };
  if (block.has(Group::motion)) {
    const Code motion = block.code(Group::motion);
    if (motion == Code::G80) {
      if (axes && taker == Code::none) {
        error("axis-without-motion", first_axis_column(), "G80 moves no axis", "give G0 or G1 instead");
      }
      return Code::none;
    }
    if (taker != Code::none) {
      error("modal-conflict", block.column_of(Group::motion),
            name(motion) + " and " + name(taker) + " both take the axis words", "put them into two blocks");
      return Code::none;
    }
    return motion;
  }
  if (taker != Code::none) return Code::none;
  if (!axes) return repeats_motion(block) ? modal_.motion : Code::none;
  if (modal_.motion == Code::G80) {
    error("axis-without-motion", first_axis_column(), "no motion is in force for the axis words",
          "give G0, G1, G2 or G3 before or in this block");
    modal_.motion = Code::G0;
  }
  return modal_.motion;
}

/// Whether the block repeats the motion in force by other words than axes, which no other code of the block takes.
bool BlockCheck::repeats_motion(const Block& block) const {
  std::uint32_t words = block.words & row(modal_.motion).repeated_by.bits;
  if (is_arc(modal_.motion)) words &= ~offset_letters | offset_letters_of(plane_after(block, modal_));
  if (is_line(modal_.motion)) words |= block.words & vector_words(block);
  for_each_code(block, [&](Code code) {
    if (code != Code::G43_5) words &= ~row(code).words_in(options_.dialect).bits;
  });
  return words != 0;
}

/// The letters of the tool's direction where lines have one.
std::uint32_t BlockCheck::vector_words(const Block& block) const {
  return has_vectors(block, frame_) ? offset_letters : 0;
}

/// The letters that the block's motion takes.
std::uint32_t BlockCheck::motion_words(const Block& block) const {
  if (modal_.to_do == Code::none) return 0;
  const std::uint32_t words = row(modal_.to_do).words_in(options_.dialect).bits;
  // Beside G43.5 they are its own.
  if (is_line(modal_.to_do) && !block.is(Code::G43_5)) return words | vector_words(block);
  if (is_arc(modal_.to_do)) return words & (~offset_letters | offset_letters_of(plane_after(block, modal_)));
  // P of G6.2 stands where the curve begins.
  if (modal_.to_do == Code::G6_2 && !block.has(Group::motion)) return words & ~letter_bit('P');
  return words;
}

void BlockCheck::check_words(const Block& block) {
  const std::uint32_t dependent = block.words & dependent_words;
  if (dependent == 0) return;
  std::uint32_t used = motion_words(block), used_twice = 0;
  const auto use = [&](std::uint32_t words) {
    used_twice |= used & words;
    used |= words;
  };
  for_each_code(block, [&](Code code) { use(row(code).words_in(options_.dialect).bits); });
  if (block.has('$')) {
    if (block.has('S')) use(letter_bit('$'));
    used_twice &= ~letter_bit('$');  // the spindle is one
    if (used & letter_bit('$')) check_spindle(block);
  }
  for (std::uint32_t rest = dependent & ~used; rest != 0; rest &= rest - 1) {
    const auto letter = static_cast<unsigned>(std::countr_zero(rest));
    const char name = word_marks[letter];
    std::string message = "nothing in this block takes ";
    message += name;
    const bool is_exponent = name == 'E' && follows_digit(block.column[letter]);
    error("unused-word", block.column[letter], std::move(message),
          is_exponent ? "numbers have no exponents: 1e-3 is written 0.001" : users_of(name));
  }
  for (std::uint32_t rest = dependent & used_twice; rest != 0; rest &= rest - 1) {
    const auto letter = static_cast<unsigned>(std::countr_zero(rest));
    std::string message = "more than one code of this block takes ";
    message += word_marks[letter];
    error("ambiguous-word", block.column[letter], std::move(message), "put them into two blocks");
  }
}

/// Which spindle it is (LinuxCNC): the machine has one, number 0. -1 is all of them, for S and what turns and stops them.
void BlockCheck::check_spindle(const Block& block) {
  const double number = std::trunc(block['$']);  // as rs274 reads it
  if (number == 0) return;
  bool is_of_one = modal_.to_do != Code::none && row(modal_.to_do).words.has('$');
  for_each_code(block, [&](Code code) {
    is_of_one |= row(code).words.has('$') && row(code).group != Group::spindle;
    is_of_one |= code == Code::M19;
  });
  if (number == -1 && !is_of_one) return;
  error("spindle-number", block.column_of('$'),
        number == -1 ? "$-1 is all spindles, and this is done by one" : "there is no spindle $" + text(block['$']),
        "the machine has one spindle: $0, or no $");
}

void BlockCheck::check_axes(const Block& block) {
  std::uint32_t lacking = block.words & axis_letter_bits & ~machine_letters_;
  // U and W of Fanuc's lathe cycles are no axes.
  if (lacking != 0 && block.has(Group::nonmodal)) lacking &= ~row(block.code(Group::nonmodal)).words.bits;
  for (std::uint32_t rest = lacking; rest != 0; rest &= rest - 1) {
    const auto letter = static_cast<unsigned>(std::countr_zero(rest));
    const base::Axis axis = axis_of_letter(letter);
    if (!travel_.lacks(axis)) continue;
    std::string axes;
    for (const base::Axis present : base::all_axes) {
      if (machine_.has(present)) axes += std::string(axes.empty() ? "" : " ") + base::letter(present);
    }
    error("unknown-axis", block.column[letter], std::string("the machine has no axis ") + base::letter(axis),
          "its axes are " + axes);
  }
}

// Reports the first of the words that a code needs and the block lacks.
void BlockCheck::check_needs(const Block& block, Code code, std::uint32_t column) {
  std::uint32_t lacking = row(code).needs.bits & ~block.words;
  // Without L it sets an offset of a lathe.
  const bool needs_l = code == Code::G10 && options_.dialect != Dialect::fanuc_lathe;
  if (needs_l) lacking |= letter_bit('L') & ~block.words;
  const bool is_of_linuxcnc = options_.dialect == Dialect::linuxcnc || options_.dialect == Dialect::leadscrew;
  // The table of tools, which has no P.
  const bool reloads = code == Code::G10 && is_of_linuxcnc && block.has('L') && block['L'] == 0;
  if (lacking == 0 || reloads) return;
  const char letter = word_marks[static_cast<std::size_t>(std::countr_zero(lacking))];
  error("missing-word", column, name(code) + " lacks " + letter, example_of(code, options_.dialect));
}

void BlockCheck::check_presence(const Block& block) {
  const bool axes = block.words & axis_letter_bits;
  for_each_code(block, [&](Code code) {
    const std::uint32_t column = block.column_of(row(code).group);
    check_needs(block, code, column);
    if (axes) return;
    if (code == Code::G31 || code == Code::G52 || code == Code::G92 || code == Code::G43_1) {
      error("missing-word", column, name(code) + " lacks axis words", example_of(code, options_.dialect));
    }
  });
  if (block.is(Code::G53)) {
    const std::uint32_t column = block.column_of(Group::nonmodal);
    if (modal_.to_do != Code::G0 && modal_.to_do != Code::G1) {
      error("bad-g53", column, "G53 stands without G0 or G1 in force", "G53 G0 X0");
    } else if (distance_after(block, modal_) == Distance::incremental) {
      error("bad-g53", column, "G53 cannot be incremental", "give G90");
    } else if (frame_.tip_control() && !modal_.tip_by_m && !ends_tip_control(block)) {
      error("tip-control", column, "G53 while tool centre point control is on", "G49 before it");
    }
  }
  if (has_vectors(block, frame_)) check_vectors(block);
  check_threading(block);
  if (is_probing(modal_.to_do) && !axes)
    error("missing-word", motion_column(block), name(modal_.to_do) + " lacks axis words", "G38.2 Z-10 F100");
  const bool is_of_uvw = is_secondary(plane_after(block, modal_));
  const std::uint32_t letters = is_of_uvw ? letter_bit('U') | letter_bit('V') | letter_bit('W')
                                          : letter_bit('X') | letter_bit('Y') | letter_bit('Z');
  if (is_canned_cycle(modal_.to_do) && !(block.words & letters)) {
    error("missing-word", motion_column(block), name(modal_.to_do) + " lacks axis words",
          is_of_uvw ? "U, V or W" : "X, Y or Z");
  }
}

// Under G43.5 rotary axes follow the tool's direction, which lines alone change: no other motion takes I, J or K.
void BlockCheck::check_vectors(const Block& block) {
  if (modal_.to_do == Code::none) return;
  for (const char letter : {'A', 'B', 'C'}) {
    if (!block.has(letter) || !machine_.has(axis_of_letter(static_cast<unsigned>(letter - 'A')))) continue;
    error("tool-vector", block.column_of(letter), "a rotary axis where I, J and K tell the tool's direction",
          "I, J and K instead, or G43.4, under which rotary axes are told");
    return;
  }
  const std::uint32_t words = block.words & offset_letters;
  if (is_line(modal_.to_do) || words == 0) return;
  error("tool-vector", block.column[static_cast<unsigned>(std::countr_zero(words))],
        "I, J or K of " + name(modal_.to_do) + " where they tell the tool's direction",
        is_arc(modal_.to_do) ? "R instead: the tool keeps its direction along the arc" : "G43.4 or G49 before it");
}

// What G33, G33.1 and G76 need, which no other motion does.
void BlockCheck::check_threading(const Block& block) {
  const Code motion = modal_.to_do;
  if (motion != Code::G33 && motion != Code::G33_1 && motion != Code::G76) return;
  check_needs(block, motion, motion_column(block));
  if (block.words & axis_letter_bits) return;
  error("missing-word", motion_column(block), name(motion) + " lacks axis words", example_of(motion, options_.dialect));
}

bool BlockCheck::follows_digit(std::uint32_t column) const {
  if (column <= 1) return false;
  const char before = reporter_.byte(column - 1);
  return before == '.' || ('0' <= before && before <= '9');
}

/// "P belongs to G2, G3 and G4"
std::string BlockCheck::users_of(char letter) const {
  std::vector<std::string> users;
  for (const CodeRow& each : code_rows()) {
    if (each.read && each.words_in(options_.dialect).has(letter) && each.dialects.has(options_.dialect))
      users.push_back(name(each.code));
  }
  if (letter == '$') users.push_back("S");
  if (users.empty()) return "no supported code takes it";
  std::string text = std::string(1, letter) + " belongs to " + users.front();
  for (std::size_t i = 1; i < users.size(); ++i) text += (i + 1 < users.size() ? ", " : " and ") + users[i];
  return text;
}

}  // namespace leadscrew::gcode
