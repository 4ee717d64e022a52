#pragma once
// The G and M codes: what each is called, its modal group, the words it takes, the dialects that have it. One table,
// codes.cpp, from which the reader, its hints and the documentation take what they know of a code.

#include <array>
#include <cstdint>
#include <leadscrew/gcode/dialect.hpp>
#include <span>
#include <string>
#include <string_view>

namespace leadscrew::gcode {

/// What begins a word, in the order of the bits of Letters: letters, `@` and `^` of polar words, `$` of a spindle's number.
inline constexpr std::string_view word_marks = "ABCDEFGHIJKLMNOPQRSTUVWXYZ@^$";

/// Where one of them stands.
constexpr std::size_t mark_index(char mark) {
  if ('A' <= mark && mark <= 'Z') return static_cast<std::size_t>(mark - 'A');
  return mark == '@' ? 26 : mark == '^' ? 27 : 28;
}
static_assert(word_marks[mark_index('Z')] == 'Z' && word_marks[mark_index('@')] == '@');
static_assert(word_marks[mark_index('^')] == '^' && word_marks[mark_index('$')] == '$');

constexpr std::uint32_t letter_bit(char letter) {
  return std::uint32_t{1} << mark_index(letter);
}

/// A set of letters, and of '$', written as text: "IJK$".
struct Letters {
  std::uint32_t bits = 0;

  constexpr Letters(const char* text) {
    for (; *text != 0; ++text) bits |= letter_bit(*text);
  }
  constexpr bool has(char letter) const { return bits & letter_bit(letter); }
};

/// Modal groups: two codes of one group cannot stand in one block (NIST IR 6556, table 4, and LinuxCNC's and Fanuc's
/// additions).
enum class Group : std::uint8_t {
  nonmodal,
  motion,
  plane,
  distance,
  arc_distance,
  feed_mode,
  units,
  cutter_radius,
  tool_length,
  retract,
  scaling,
  system,
  path,
  spindle_mode,
  lathe,  ///< diameters or radii
  rotation,
  polar,
  mirror,
  modal_call,  ///< G67, which ends what G66 begins
  stop,        ///< M0, M1, M2, M30, M60
  output,      ///< outputs and inputs: M62 … M68
  tool,        ///< M6, M61
  spindle,     ///< M3, M4, M5, M19
  coolant,     ///< M7, M8, M9
  overrides,   ///< M48 … M53
  modes,       ///< M70 … M73, which keep the modes and bring them back
  call,        ///< M97, M98, M99, G65, G66: subprograms
  user,        ///< M100 … M199, and what a machine's builder adds
  count,
  unknown = 0xFF,
};

constexpr std::size_t index(Group group) {
  return static_cast<std::size_t>(group);
}
constexpr std::uint32_t bit(Group group) {
  return std::uint32_t{1} << index(group);
}
/// As messages call it: "modal group 1", "M group 7".
std::string name(Group group);

/// A code by its meaning: where a number means several things, each is a code of its own. The order is that of the
/// table; the first two are the commonest motions.
enum class Code : std::uint8_t {
  // clang-format off
  G0, G1, G2, G3, G5, G5_1, G5_2, G5_3, G6_2, G33, G33_1, G38_2, G38_3, G38_4, G38_5, G73, G74, G76, G76_bore, G80, G81,
  G82, G83, G84, G85, G86, G87, G88, G89,
  G4, G9, G10, G12, G13, G28, G28_1, G30, G30_1, G31, G52, G53, G53_1, G53_6, G253, G60, G70, G70_bolts, G71,
  G71_bolts, G71_1, G71_2, G72, G72_bolts, G72_1, G72_2, G92, G92_1, G92_2, G92_3, G5_high_speed, G5_1_high_speed,
  G8_high_speed, G47, G103, G150, G187, G6_4, G6_5, G6_6,
  G17, G17_1, G18, G18_1, G19, G19_1, G90, G91, G90_1, G91_1, G93, G94, G95, G20, G21,
  G40, G41, G41_1, G42, G42_1, G43, G43_1, G43_2, G43_4, G43_5, G44, G49, G98, G99, G50, G51, G50_1, G51_1,
  G54, G55, G56, G57, G58, G59, G59_1, G59_2, G59_3, G54_1, G154, G61, G61_1, G64, G96, G97,
  G90_turn, G92_thread, G94_face, G50_turn, G70_profile, G71_profile, G72_profile, G73_profile, G76_profile,
  G74_face, G75,
  G7, G8, G68, G68_2, G68_4, G68_3, G268, G69, G269, G15, G16, G62, G63, G100, G101, G110, G67,
  M0, M1, M2, M30, M60, M62, M63, M64, M65, M66, M67, M68, M6, M61, M3, M4, M5, M19, M29, M56, M7, M8, M9,
  M48, M49, M50, M51, M52, M53, M70, M71, M72, M73, M97, M98, M99, G65, G66, M100, M428, M429,
  count,
  none = 0xFF,  ///< no code
  // clang-format on
};

constexpr std::size_t index(Code code) {
  return static_cast<std::size_t>(code);
}

/// What is known of a code.
struct CodeRow {
  Code code = Code::none;
  char letter = 'G';        ///< G or M
  std::int16_t tenths = 0;  ///< its number times ten: G38.2 is 382
  Group group = Group::unknown;
  Letters words = "";        ///< letters it takes, but for axes and F
  Letters needs = "";        ///< those of them that must be there
  Letters repeated_by = "";  ///< a motion: while it is in force these letters repeat it, without axis words
  bool takes_axes = false;   ///< other than a motion: the axis words of its block are its own
  bool read = true;          ///< false: a code that is known and not read
  Dialects dialects;
  const char* summary = "";  ///< what it does, in a few words
  const char* source = "";   ///< where it is defined
  Letters more_words = "";   ///< letters it takes besides in dialects other than LinuxCNC's

  Letters words_in(Dialect dialect) const {
    Letters all = words;
    if (dialect != Dialect::linuxcnc) all.bits |= more_words.bits;
    return all;
  }
};

namespace detail {
extern const std::array<CodeRow, index(Code::count)> code_rows;  // codes.cpp
inline constexpr std::size_t most_g = 2700;                      // G codes below G270
inline constexpr std::size_t most_m = 430;
extern const std::array<std::array<Code, most_g>, index(Dialect::count)> g_codes;
extern const std::array<std::array<Code, most_m>, index(Dialect::count)> m_codes;
}  // namespace detail

/// All codes.
inline std::span<const CodeRow> code_rows() {
  return detail::code_rows;
}

inline const CodeRow& row(Code code) {
  return detail::code_rows[index(code)];
}

/// The code that a number, times ten, of 0 to 2699, means in a dialect; Code::none where it has no meaning there.
inline Code g_code(Dialect dialect, int tenths) {
  return detail::g_codes[index(dialect)][static_cast<std::size_t>(tenths)];
}
/// The code that an M number of 0 to 429 means in a dialect. All of M100 … M199 are Code::M100.
inline Code m_code(Dialect dialect, int number) {
  return detail::m_codes[index(dialect)][static_cast<std::size_t>(number)];
}

/// The dialects in which a number means something.
Dialects dialects_of(char letter, int tenths);

/// What to write in place of a code that is not read, for people.
const char* instead_of(Code code);

/// "G38.2"
std::string name(Code code);
/// As a dialect that reads it calls it: G32 of lathes for G33.
std::string name(Code code, Dialect dialect);
std::string name(char letter, int tenths);

constexpr bool is_canned_cycle(Code code) {
  return (Code::G81 <= code && code <= Code::G89) || code == Code::G73 || code == Code::G74 || code == Code::G76_bore;
}
constexpr bool is_probing(Code code) {
  return Code::G38_2 <= code && code <= Code::G38_5;
}
constexpr bool is_of_surface(Code code) {
  return Code::G6_4 <= code && code <= Code::G6_6;
}
constexpr bool is_line(Code code) {
  return code == Code::G0 || code == Code::G1;
}
constexpr bool is_arc(Code code) {
  return code == Code::G2 || code == Code::G3;
}

}  // namespace leadscrew::gcode
