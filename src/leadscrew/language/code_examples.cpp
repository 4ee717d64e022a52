// One program for each code, of the first dialect that its row names.

#include <array>
#include <leadscrew/language/code_words.hpp>

namespace leadscrew::language {

namespace {

using gcode::Code;

struct Example {
  Code code;
  std::string_view text;
};

// clang-format off
constexpr Example examples[] = {
    {Code::G0, "G0 X10 Y5"},
    {Code::G1, "G1 X10 Y5 F600"},
    {Code::G2, "G0 X0 Y10\nG2 X10 Y0 I0 J-10 F600"},
    {Code::G3, "G0 X10 Y0\nG3 X0 Y10 R10 F600"},
    {Code::G5, "G0 X0 Y0\nG5 X10 Y0 I2 J5 P-2 Q5 F600"},
    {Code::G5_1, "G0 X0 Y0\nG5.1 X10 Y0 I5 J8 F600"},
    {Code::G5_2, "G0 X0 Y0 F600\nG5.2 P1 L3\nX5 Y10 P1\nX10 Y0 P1\nG5.3"},
    {Code::G5_3, "G0 X0 Y0 F600\nG5.2 X5 Y5 P1 L3\nX10 Y0 P1\nG5.3"},
    {Code::G6_2, "G0 X0 Y0\nG6.2 P3 K0 X0 Y0 F600\nK0 X5 Y10\nK0 X10 Y0\nK1\nK1\nK1"},
    {Code::G33, "S100 M3\nG33 Z-10 K1.25"},
    {Code::G33_1, "S100 M3\nG33.1 Z-10 K1.25"},
    {Code::G38_2, "G38.2 Z-10 F100"},
    {Code::G38_3, "G38.3 Z-10 F100"},
    {Code::G38_4, "G38.4 Z10 F100"},
    {Code::G38_5, "G38.5 Z10 F100"},
    {Code::G73, "G0 Z5\nG73 X10 Z-10 R1 Q3 F200"},
    {Code::G74, "S100 M4\nG0 Z5\nG74 X10 Z-10 R2 F125"},
    {Code::G76, "G18 S100 M3\nG0 X20 Z5\nG76 P1 Z-10 I-1 J0.2 K0.6"},
    {Code::G76_bore, "S500 M3\nG0 Z5\nG76 X10 Z-10 R1 Q0.3 F100"},
    {Code::G80, "G0 Z5\nG81 X10 Z-5 R1 F200\nG80"},
    {Code::G81, "G0 Z5\nG81 X10 Z-5 R1 F200\nX20"},
    {Code::G82, "G0 Z5\nG82 X10 Z-5 R1 P0.3 F200"},
    {Code::G83, "G0 Z5\nG83 X10 Z-20 R1 Q4 F200"},
    {Code::G84, "S100 M3\nG0 Z5\nG84 X10 Z-10 R2 F125"},
    {Code::G85, "G0 Z5\nG85 X10 Z-10 R1 F100"},
    {Code::G86, "S500 M3\nG0 Z5\nG86 X10 Z-10 R1 P0 F100"},
    {Code::G87, "S500 M3\nG0 Z5\nG87 X10 Z-10 R1 I2 J0 K-8 F100"},
    {Code::G88, "S500 M3\nG0 Z5\nG88 X10 Z-10 R1 P0 F100"},
    {Code::G89, "G0 Z5\nG89 X10 Z-10 R1 P0.3 F100"},
    {Code::G4, "G4 P0.5"},
    {Code::G9, "G9 G1 X10 F600"},
    {Code::G10, "G10 L2 P1 X100 Y50 R30"},
    {Code::G12, "G0 X10. Y5.\nG12 I4. Z-2. D0 F200."},
    {Code::G13, "G0 X10. Y5.\nG13 I4. Z-2. D0 F200."},
    {Code::G28, "G0 X10 Z5\nG91 G28 Z0\nG90"},
    {Code::G28_1, "G28.1"},
    {Code::G30, "G30"},
    {Code::G30_1, "G30.1"},
    {Code::G31, "G31 Z-10 F100"},
    {Code::G52, "G52 X5 Y5"},
    {Code::G53, "G53 G0 Z0"},
    {Code::G60, "G60 X10"},
    {Code::G70, "O100 sub\nG1 X10 Z0\nZ-10\nX20 Z-15\nO100 endsub\nG18 F200\nG0 X24 Z2\nG70 Q100"},
    {Code::G70_bolts, "G81 Z-5. R1. F200. L0\nG70 I20. J0. L6"},
    {Code::G71, "O100 sub\nG1 X10 Z0\nZ-10\nX20 Z-15\nO100 endsub\nG18 F200\nG0 X24 Z2\nG71 Q100 D0.2 I1 R0.5"},
    {Code::G71_bolts, "G81 Z-5. R1. F200. L0\nG71 I20. J30. K30. L4"},
    {Code::G71_1, "O100 sub\nG1 X10 Z0\nZ-10\nX20 Z-15\nO100 endsub\nG18 F200\nG0 X24 Z2\nG71.1 Q100 D0.2 I1 R0.5"},
    {Code::G71_2, "O100 sub\nG1 X10 Z0\nZ-10\nX20 Z-15\nO100 endsub\nG18 F200\nG0 X24 Z2\nG71.2 Q100 D0.2 I1 R0.5"},
    {Code::G72, "O100 sub\nG1 X20 Z-10\nX10\nX0 Z-2\nO100 endsub\nG18 F200\nG0 X24 Z2\nG72 Q100 D0.2 I1 R0.5"},
    {Code::G72_bolts, "G81 Z-5. R1. F200. L0\nG72 I10. J45. L5"},
    {Code::G72_1, "O100 sub\nG1 X20 Z-10\nX10\nX0 Z-2\nO100 endsub\nG18 F200\nG0 X24 Z2\nG72.1 Q100 D0.2 I1 R0.5"},
    {Code::G72_2, "O100 sub\nG1 X20 Z-10\nX10\nX0 Z-2\nO100 endsub\nG18 F200\nG0 X24 Z2\nG72.2 Q100 D0.2 I1 R0.5"},
    {Code::G92, "G0 X10\nG92 X0"},
    {Code::G92_1, "G92 X5\nG92.1"},
    {Code::G92_2, "G92 X5\nG92.2"},
    {Code::G92_3, "G92 X5\nG92.2\nG92.3"},
    {Code::G5_high_speed, "G5 P10000\nG1 X10. F600.\nG5 P0"},
    {Code::G5_1_high_speed, "G5.1 Q1\nG1 X10. F600.\nG5.1 Q0"},
    {Code::G8_high_speed, "G8 P1\nG1 X10. F600.\nG8 P0"},
    {Code::G103, "G103 P1\nG103"},
    {Code::G187, "G187 P3 E0.02\nG187"},
    {Code::G17, "G17 G2 X10 I5 F600"},
    {Code::G17_1, "G17.1 G2 U10 I5 F600"},
    {Code::G18, "G18 G2 X10 I5 F600"},
    {Code::G18_1, "G18.1 G2 U10 I5 F600"},
    {Code::G19, "G19 G2 Y10 J5 F600"},
    {Code::G19_1, "G19.1 G2 V10 J5 F600"},
    {Code::G90, "G90 G0 X10"},
    {Code::G91, "G91 G0 X10\nX10"},
    {Code::G90_1, "G90.1 G2 X10 I5 J0 F600"},
    {Code::G91_1, "G91.1 G2 X10 I5 F600"},
    {Code::G93, "G93 G1 X10 F2"},
    {Code::G94, "G94 G1 X10 F600"},
    {Code::G95, "S1000 M3\nG95 G1 X10 F0.2"},
    {Code::G20, "G20 G0 X1"},
    {Code::G21, "G21 G0 X10"},
    {Code::G40, "G40"},
    {Code::G41, "G41 D1"},
    {Code::G41_1, "G41.1 D3 L2"},
    {Code::G42, "G42 D1"},
    {Code::G42_1, "G42.1 D3"},
    {Code::G43, "T1 M6\nG43 H1\nG0 Z5"},
    {Code::G43_1, "G43.1 Z50"},
    {Code::G43_2, "G43 H1\nG43.2 H1"},
    {Code::G43_4, "G43.4 H1\nG1 X10 A15 C30 F600\nG49"},
    {Code::G43_5, "G43.5 H1\nG1 X10 I0.5 J0 K1 F600\nX20 I0.6\nG49"},
    {Code::G44, "G44 H1"},
    {Code::G49, "G43 H1\nG49"},
    {Code::G98, "G0 Z5\nG98 G81 X10 Z-5 R1 F200\nX20"},
    {Code::G99, "G0 Z5\nG99 G81 X10 Z-5 R1 F200\nX20"},
    {Code::G50, "G51 P2\nG0 X10\nG50"},
    {Code::G51, "G51 X0 Y0 P2\nG1 X10 F600\nG50"},
    {Code::G50_1, "G51.1 X0\nG0 X10\nG50.1 X0"},
    {Code::G51_1, "G51.1 X0\nG0 X10\nG50.1 X0"},
    {Code::G100, "G101 X0\nG0 X10.\nG100"},
    {Code::G101, "G101 X0\nG0 X10.\nG100"},
    {Code::G67, "G67"},
    {Code::G54, "G54 G0 X0"},
    {Code::G55, "G55 G0 X0"},
    {Code::G56, "G56 G0 X0"},
    {Code::G57, "G57 G0 X0"},
    {Code::G58, "G58 G0 X0"},
    {Code::G59, "G59 G0 X0"},
    {Code::G59_1, "G59.1 G0 X0"},
    {Code::G59_2, "G59.2 G0 X0"},
    {Code::G59_3, "G59.3 G0 X0"},
    {Code::G54_1, "G54.1 P1\nG0 X0"},
    {Code::G154, "G154 P1\nG0 X0"},
    {Code::G110, "G110\nG0 X0."},
    {Code::G61, "G61 G1 X10 F600\nY10"},
    {Code::G61_1, "G61.1 G1 X10 F600\nY10"},
    {Code::G62, "G62\nG1 X10. F600."},
    {Code::G63, "G63\nG1 Z-10. F600.\nG64"},
    {Code::G64, "G64 P0.02 Q0.01\nG1 X10 F600\nY10"},
    {Code::G96, "G96 D2000 S180\nM3"},
    {Code::G97, "G97 S1000 M3"},
    {Code::G7, "G7 G0 X20\nG8"},
    {Code::G8, "G8 G0 X20"},
    {Code::G68, "G68 X0 Y0 R30\nG0 X10\nG69"},
    {Code::G69, "G69"},
    {Code::G15, "G15"},
    {Code::G16, "G16\nG0 X10 Y30\nG15"},
    {Code::M0, "M0"},
    {Code::M1, "M1"},
    {Code::M2, "M2"},
    {Code::M30, "M30"},
    {Code::M60, "M60"},
    {Code::M62, "M62 P0\nG1 X10 F600"},
    {Code::M63, "M63 P0\nG1 X10 F600"},
    {Code::M64, "M64 P0"},
    {Code::M65, "M65 P0"},
    {Code::M66, "M66 P0 L0"},
    {Code::M67, "M67 E0 Q0.5\nG1 X10 F600"},
    {Code::M68, "M68 E0 Q0.5"},
    {Code::M6, "T1 M6"},
    {Code::M61, "M61 Q1"},
    {Code::M3, "S1000 M3"},
    {Code::M4, "S1000 M4"},
    {Code::M5, "M5"},
    {Code::M19, "M19 R90"},
    {Code::M29, "M29 S500"},
    {Code::M56, "M56 P0"},
    {Code::M7, "M7"},
    {Code::M8, "M8"},
    {Code::M9, "M9"},
    {Code::M48, "M48"},
    {Code::M49, "M49"},
    {Code::M50, "M50 P1"},
    {Code::M51, "M51 P1"},
    {Code::M52, "M52 P1"},
    {Code::M53, "M53 P1"},
    {Code::M70, "M70\nM72"},
    {Code::M71, "M70\nM71"},
    {Code::M72, "M70\nG91\nM72"},
    {Code::M73, "O100 sub\nM73\nG91\nO100 endsub\nO100 call"},
    {Code::M97, "M97 P100\nM30\nN100 G0 X10.\nM99"},
    {Code::M98, "M98 P1001\nM30\nO1001\nG0 X10\nM99"},
    {Code::M99, "M98 P1001 L2\nM30\nO1001\nG91 G0 X10\nM99"},
    {Code::G66, "G66 P1001 Z-5\nG0 X10\nX20\nG67\nM30\nO1001\nG91 G1 Z#26 F100\nG0 Z[0-#26]\nG90\nM99"},
    {Code::G65, "G65 P1001 A10\nM30\nO1001\nG0 X#1\nM99"},
    {Code::M100, "M100 P1 Q2"},
};
// clang-format on

constexpr bool every_code_has_one() {
  std::array<int, gcode::index(Code::count)> found{};
  for (const Example& each : examples) ++found[gcode::index(each.code)];
  for (const int count : found) {
    if (count != 1) return false;
  }
  return true;
}
static_assert(every_code_has_one());

}  // namespace

std::string_view example_of(Code code) {
  for (const Example& each : examples) {
    if (each.code == code) return each.text;
  }
  return {};
}

}  // namespace leadscrew::language
