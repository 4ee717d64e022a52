#include <array>
#include <leadscrew/gcode/stroke_font.hpp>

namespace leadscrew::gcode {

namespace {

constexpr double grid = 12;  // of which a character is one high
constexpr double small_letter = 0.75;
constexpr char first_glyph = ' ', last_glyph = '~';

constexpr std::array<std::string_view, '`' - first_glyph + 1> glyphs = {
    "",                            // blank
    "4c44 4041",                   // !
    "3c39 5c59",                   // "
    "202c 606c 0484 0888",         // #
    "8c3c(3656)5000 404c",         // $
    "2c(28(2c 64(60(64 008c",      // %
    "80292b4c6b691412305085",      // &
    "4c49",                        // '
    "6c(60",                       // (
    "2c)20",                       // )
    "4349 1478 1874",              // *
    "1676 4349",                   // +
    "4130",                        // ,
    "1676",                        // -
    "4041",                        // .
    "008c",                        // /
    "4c<0804<40<8488<4c 2468",     // 0
    "294c40 2060",                 // 1
    "08>4c>880080",                // 2
    "0c5c)56 2656)5000",           // 3
    "606c0484",                    // 4
    "8c0c0747)4000",               // 5
    "8c4c<0804<40<84<48<04",       // 6
    "0c8c30",                      // 7
    "46(4c(46 46)40)46",           // 8
    "0040<8488<4c<08<44<88",       // 9
    "4344 4849",                   // :
    "4130 4849",                   // ;
    "7a0672",                      // <
    "1474 1878",                   // =
    "1a8612",                      // >
    "08>4c>88>4443 4041",          // ?
    "66(26(66 8688<4c<0804<4080",  // @
    "004c80 1373",                 // A
    "000c5c)5606 56)5000",         // B
    "8c4c<0804<4080",              // C
    "000c4c>8884>4000",            // D
    "8c0c0080 0666",               // E
    "8c0c00 0666",                 // F
    "8c4c<0804<40808656",          // G
    "000c 808c 0686",              // H
    "404c 2060 2c6c",              // I
    "8c84>40>04",                  // J
    "000c 8c0680",                 // K
    "0c0080",                      // L
    "000c468c80",                  // M
    "000c808c",                    // N
    "4c<0804<40<8488<4c",          // O
    "000c5c)5606",                 // P
    "4c<0804<40<8488<4c 5380",     // Q
    "000c5c)5606 5680",            // R
    "8c3c(3656)5000",              // S
    "404c 0c8c",                   // T
    "0c04<40<848c",                // U
    "0c408c",                      // V
    "0c2048608c",                  // W
    "008c 0c80",                   // X
    "0c468c 4640",                 // Y
    "0c8c0080",                    // Z
    "6c2c2060",                    // [
    "0c80",                        // backslash
    "2c6c6020",                    // ]
    "094c89",                      // ^
    "0080",                        // _
    "3c59",                        // `
};
constexpr std::array<std::string_view, last_glyph - '{' + 1> last_glyphs = {
    "6c4c4826444060",  // {
    "404c",            // |
    "2c4c4866444020",  // }
    "15375577",        // ~
};

constexpr double on_grid(char digit) {
  return (digit <= '9' ? digit - '0' : digit - 'a' + 10) / grid;
}

// The quarter's centre is beside one end and above or below the other: where it turns the right way.
Stroke::Step arc_step(PlanePoint from, PlanePoint to, char kind) {
  const int turn = kind == '(' || kind == '<' ? 1 : -1;
  if (kind == '(' || kind == ')') return {to, {(from.first + to.first) / 2, (from.second + to.second) / 2}, turn};
  const PlanePoint one{from.first, to.second}, other{to.first, from.second};
  const double cross =
      (from.first - one.first) * (to.second - one.second) - (from.second - one.second) * (to.first - one.first);
  return {to, cross * turn > 0 ? one : other, turn};
}

std::vector<Stroke> read_glyph(std::string_view glyph, double scale) {
  std::vector<Stroke> strokes;
  bool begins = true;
  for (std::size_t i = 0; i < glyph.size();) {
    if (glyph[i] == ' ') {
      begins = true;
      ++i;
      continue;
    }
    const bool is_place = ('0' <= glyph[i] && glyph[i] <= '9') || ('a' <= glyph[i] && glyph[i] <= 'c');
    const char kind = is_place ? '\0' : glyph[i++];
    const PlanePoint to{scale * on_grid(glyph[i]), scale * on_grid(glyph[i + 1])};
    i += 2;
    if (begins) {
      strokes.push_back({to, {}});
    } else {
      Stroke& stroke = strokes.back();
      const PlanePoint from = stroke.steps.empty() ? stroke.start : stroke.steps.back().to;
      stroke.steps.push_back(kind == '\0' ? Stroke::Step{to, {}, 0} : arc_step(from, to, kind));
    }
    begins = false;
  }
  return strokes;
}

}  // namespace

std::optional<std::vector<Stroke>> strokes_of(char character) {
  if (character < first_glyph || character > last_glyph) return std::nullopt;
  if (character >= '{') return read_glyph(last_glyphs[static_cast<std::size_t>(character - '{')], 1);
  const bool is_small = 'a' <= character && character <= 'z';
  const char shape = is_small ? static_cast<char>(character - 'a' + 'A') : character;
  return read_glyph(glyphs[static_cast<std::size_t>(shape - first_glyph)], is_small ? small_letter : 1);
}

}  // namespace leadscrew::gcode
