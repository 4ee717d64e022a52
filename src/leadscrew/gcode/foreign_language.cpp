#include <algorithm>
#include <array>
#include <leadscrew/gcode/foreign_language.hpp>
#include <string>

namespace leadscrew::gcode {

namespace {

constexpr std::string_view by_cam = "let the CAM write ISO G-code: its post-processor for Fanuc, Haas or LinuxCNC",
                           by_surfaces = "leadscrew surfaces FILE writes its faces as blocks (G6.4)";
constexpr ForeignLanguage heidenhain = {"Heidenhain Klartext", by_cam}, siemens = {"Siemens Sinumerik", by_cam},
                          step = {"a STEP file", by_surfaces}, iges = {"an IGES file", by_surfaces};

struct Sign {
  std::string_view text;  ///< in capitals; '#' stands for one or more digits
  ForeignLanguage language;
};

// What stands at the beginning of a word of such a program and cannot be G-code.
constexpr std::array<Sign, 49> signs = {{
    {"BEGIN PGM", heidenhain},
    {"END PGM", heidenhain},
    {"BLK FORM", heidenhain},
    {"TOOL CALL", heidenhain},
    {"TOOL DEF", heidenhain},
    {"CYCL DEF", heidenhain},
    {"CYCL CALL", heidenhain},
    {"FMAX", heidenhain},
    {"CALL PGM", heidenhain},
    {"CALL LBL", heidenhain},
    {"LBL #", heidenhain},
    {"FN #:", heidenhain},
    {"PLANE RESET", heidenhain},
    {"PLANE SPATIAL", heidenhain},
    {"%_N_", siemens},
    {";$PATH=", siemens},
    {"CYCLE#(", siemens},
    {"MCALL", siemens},
    {"MSG(", siemens},
    {"WORKPIECE(", siemens},
    {"DEF REAL", siemens},
    {"DEF INT", siemens},
    {"DEF BOOL", siemens},
    {"DEF STRING", siemens},
    {"TRAORI", siemens},
    {"TRAFOOF", siemens},
    {"SUPA", siemens},
    {"GROUP_BEGIN(", siemens},
    {"SETMS", siemens},
    {"LIMS=", siemens},
    {"DIAMON", siemens},
    {"DIAMOF", siemens},
    {"CFTCP", siemens},
    {"ORIWKS", siemens},
    {"COMPCAD", siemens},
    {"COMPOF", siemens},
    {"FFWON", siemens},
    {"T=\"", siemens},
    {"POCKET#(", siemens},
    {"HOLES#(", siemens},
    {"SLOT#(", siemens},
    {"ATRANS", siemens},
    {"AROT", siemens},
    {"TRANS X", siemens},
    {"GOTOF", siemens},
    {"GOTOB", siemens},
    {"CR=", siemens},
    {"R#=", siemens},
    {"ISO-#-#", step},
}};

constexpr bool is_digit_of_sign(char c) {
  return '0' <= c && c <= '9';
}
constexpr bool is_letter_of_sign(char c) {
  return ('A' <= c && c <= 'Z') || c == '_';
}

bool begins_with_sign(std::string_view text, std::string_view sign) {
  std::size_t at = 0;
  for (const char c : sign) {
    if (c != '#') {
      if (at >= text.size() || text[at] != c) return false;
      ++at;
      continue;
    }
    const std::size_t first = at;
    while (at < text.size() && is_digit_of_sign(text[at])) ++at;
    if (at == first) return false;
  }
  // A whole word: DIAMON, not DIAMONDS.
  return sign.back() == '_' || !is_letter_of_sign(sign.back()) || at >= text.size() || !is_letter_of_sign(text[at]);
}

// What a remark says is no sign, but for the first line of a Siemens program.
void hide_remarks(std::string& text) {
  if (text.starts_with(";$PATH=")) return;
  text.resize(std::min(text.find(';'), text.size()));
  bool inside = false;
  for (char& c : text) {
    if (c == ')' || c == '>') inside = false;
    const bool opens = c == '(' || c == '<';
    if (inside) c = ' ';
    inside = inside || opens;
  }
}

/// A line of its first two sections: 72 columns of text, the section's letter, the line's number to the right of seven columns.
bool is_iges(std::string_view line) {
  constexpr std::size_t letter = 72, width = 80;
  if (line.size() != width || (line[letter] != 'S' && line[letter] != 'G')) return false;
  const std::string_view number = line.substr(letter + 1);
  const std::size_t digits = std::min(number.find_first_not_of(" 0"), number.size());
  return digits < number.size() && number.find_first_not_of("0123456789", digits) == std::string_view::npos;
}

}  // namespace

std::optional<ForeignLanguage> foreign_language(std::string_view line) {
  if (is_iges(line)) return iges;
  constexpr std::size_t most_looked_at = 300;
  std::string text(line.substr(0, most_looked_at));
  std::ranges::transform(text, text.begin(),
                         [](char c) { return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  hide_remarks(text);
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i > 0 && (is_letter_of_sign(text[i - 1]) || text[i - 1] == '[' || text[i - 1] == '#')) continue;
    for (const Sign& sign : signs) {
      if (begins_with_sign(std::string_view(text).substr(i), sign.text)) return sign.language;
    }
  }
  return std::nullopt;
}

}  // namespace leadscrew::gcode
