// The table of codes: one row a code. What a code does is in dispatch.cpp.

#include <leadscrew/gcode/codes.hpp>

namespace leadscrew::gcode {

namespace {

constexpr Dialect L = Dialect::leadscrew, C = Dialect::linuxcnc, F = Dialect::fanuc, H = Dialect::haas,
                  B = Dialect::grbl, M = Dialect::mach3, R = Dialect::marlin, T = Dialect::fanuc_lathe;
constexpr Dialects all{L, C, F, H, B, M, R, T};
constexpr Dialects no_marlin{L, C, F, H, B, M, T};  // what every controller of machine tools has
constexpr Dialects no_small{L, C, F, H, M, T};      // neither grbl nor Marlin
constexpr Dialects linuxcnc{L, C};
constexpr Dialects fanuc{L, F, H};  // Fanuc's and Haas', where LinuxCNC leaves the number free

constexpr bool takes_axes = true;
constexpr bool not_read = false;

// Where a code is defined: NIST IR 6556 by its sections, LinuxCNC's manual by the code's own section of "G Codes" or "M
// Codes".
constexpr const char* const manual = "LinuxCNC manual, G Codes";
constexpr const char* const manual_m = "LinuxCNC manual, M Codes";
constexpr const char* const kinematics_manual = "LinuxCNC manual, Switchable Kinematics";
constexpr const char* const fanuc_manual = "Fanuc 0i operator's manual";
constexpr const char* const haas_manual = "Haas mill operator's manual";
constexpr const char* const leadscrew_manual = "docs/surfaces.md";
constexpr const char* const nist_cycles = "NIST IR 6556, 3.5.16";

constexpr CodeRow g(Code code, int tenths, Group group, Dialects dialects, const char* summary, const char* source,
                    Letters words = "", Letters needs = "", Letters repeated_by = "") {
  return {code,    'G',   static_cast<std::int16_t>(tenths), group, words, needs, repeated_by, false, true, dialects,
          summary, source};
}
constexpr CodeRow with_axes(CodeRow row) {
  row.takes_axes = true;
  return row;
}
constexpr CodeRow also(CodeRow row, Letters more_words) {
  row.more_words = more_words;
  return row;
}
constexpr CodeRow unread(CodeRow row) {
  row.read = false;
  return row;
}
constexpr CodeRow m(Code code, int number, Group group, Dialects dialects, const char* summary, const char* source,
                    Letters words = "", Letters needs = "") {
  return {code,    'M',   static_cast<std::int16_t>(number * 10), group, words, needs, "", false, true, dialects,
          summary, source};
}

// clang-format off
constexpr std::array<CodeRow, index(Code::count)> rows = {{
  // code, number times ten, group, dialects, summary, source, words, needed, repeated by
  g(Code::G0, 0, Group::motion, all, "rapid line", "NIST IR 6556, 3.5.1"),
  g(Code::G1, 10, Group::motion, all, "line at feed", "NIST IR 6556, 3.5.2"),
  g(Code::G2, 20, Group::motion, all, "clockwise arc or helix", "NIST IR 6556, 3.5.3", "IJKRP", "", "IJKR"),
  g(Code::G3, 30, Group::motion, all, "counterclockwise arc or helix", "NIST IR 6556, 3.5.3", "IJKRP", "", "IJKR"),
  g(Code::G5, 50, Group::motion, {L, C, R}, "cubic spline", manual, "IJPQ", "", "IJ"),
  g(Code::G5_1, 51, Group::motion, {L, C}, "quadratic spline", manual, "IJ", "", "IJ"),
  g(Code::G5_2, 52, Group::motion, linuxcnc, "NURBS with uniform knots: begins, or a control point", manual, "PL"),
  g(Code::G5_3, 53, Group::motion, linuxcnc, "NURBS with uniform knots: ends", manual),
  g(Code::G6_2, 62, Group::motion, {L, F}, "NURBS with knots", fanuc_manual, "PKR", "", "KR"),
  g(Code::G33, 330, Group::motion, no_small.without(T), "line in step with the spindle, which is taken to turn at S where none is simulated", manual, "K$"),
  g(Code::G33_1, 331, Group::motion, linuxcnc, "rigid tapping in step with the spindle", manual, "KI$", "K"),
  g(Code::G38_2, 382, Group::motion, {L, C, B, R}, "probes to contact, which must come", manual),
  g(Code::G38_3, 383, Group::motion, {L, C, B, R}, "probes to contact", manual),
  g(Code::G38_4, 384, Group::motion, {L, C, B, R}, "probes to loss of contact, which must come", manual),
  g(Code::G38_5, 385, Group::motion, {L, C, B, R}, "probes to loss of contact", manual),
  also(g(Code::G73, 730, Group::motion, no_small.without(T), "drilling cycle that breaks chips", manual, "RLQ"), "PIJK"),
  also(g(Code::G74, 740, Group::motion, no_small.without(T), "left-hand tapping cycle", manual, "RLP"), "QJ"),
  g(Code::G76, 760, Group::motion, linuxcnc, "threading cycle", manual, "PIJKRQHLE$", "PIJK"),
  g(Code::G76_bore, 760, Group::motion, {F, H, M}, "fine boring cycle: the tool leaves the wall before it retracts", fanuc_manual, "RLPQIJ"),
  g(Code::G80, 800, Group::motion, all, "no motion is in force", "NIST IR 6556, 3.5.15"),
  g(Code::G81, 810, Group::motion, no_small.without(T), "drilling cycle", nist_cycles, "RL"),
  g(Code::G82, 820, Group::motion, no_small.without(T), "drilling cycle with a dwell at the bottom", nist_cycles, "RLP"),
  also(g(Code::G83, 830, Group::motion, no_small.without(T), "deep-hole drilling cycle: retracts to R after each peck", nist_cycles, "RLQ"), "PIJK"),
  also(g(Code::G84, 840, Group::motion, no_small.without(T), "right-hand tapping cycle", manual, "RLP"), "QJ"),
  g(Code::G85, 850, Group::motion, no_small.without(T), "boring cycle: out at feed", nist_cycles, "RL"),
  g(Code::G86, 860, Group::motion, no_small.without(T), "boring cycle: spindle stops, out at rapid", nist_cycles, "RLP"),
  also(g(Code::G87, 870, Group::motion, no_small.without(T), "back-boring cycle", nist_cycles, "RLIJK"), "QP"),
  g(Code::G88, 880, Group::motion, no_small.without(T), "boring cycle: spindle stops, out by hand", nist_cycles, "RLP"),
  g(Code::G89, 890, Group::motion, no_small.without(T), "boring cycle with a dwell at the bottom: out at feed", nist_cycles, "RLP"),

  g(Code::G4, 40, Group::nonmodal, all, "dwell", "NIST IR 6556, 3.5.4", "P", "P"),
  g(Code::G9, 90, Group::nonmodal, fanuc, "exact stop at the end of this block", fanuc_manual),
  with_axes(g(Code::G10, 100, Group::nonmodal, no_marlin, "sets a coordinate system or a tool", manual, "PLRIJQ", "P")),
  with_axes(g(Code::G12, 120, Group::nonmodal, {H, M}, "circular pocket, clockwise; in mach3 a circle", haas_manual, "IKQLD", "I")),
  with_axes(g(Code::G13, 130, Group::nonmodal, {H, M}, "circular pocket, counterclockwise; in mach3 a circle", haas_manual, "IKQLD", "I")),
  with_axes(g(Code::G28, 280, Group::nonmodal, all, "goes home, by the point given", "NIST IR 6556, 3.5.8")),
  g(Code::G28_1, 281, Group::nonmodal, {L, C, B}, "home of G28 is where the tool stands", manual),
  with_axes(g(Code::G30, 300, Group::nonmodal, no_marlin, "goes to the second home, by the point given", "NIST IR 6556, 3.5.8", "")),
  g(Code::G30_1, 301, Group::nonmodal, {L, C, B}, "home of G30 is where the tool stands", manual),
  with_axes(g(Code::G31, 310, Group::nonmodal, {L, F, H, M, T}, "skip: a line that contact of the probe ends", fanuc_manual, "P")),
  with_axes(g(Code::G52, 520, Group::nonmodal, no_small, "local coordinate system", manual)),
  g(Code::G53, 530, Group::nonmodal, no_marlin, "axis words are machine coordinates", "NIST IR 6556, 3.5.12"),
  g(Code::G53_1, 531, Group::nonmodal, {L, F}, "turns the rotary axes until the tool is along the normal of the tilted plane; X, Y and Z stand still", fanuc_manual, "P"),
  unread(g(Code::G53_6, 536, Group::nonmodal, {L, F}, "turns the rotary axes until the tool is along the normal of the tilted plane, about the tool's tip", fanuc_manual)),
  g(Code::G253, 2530, Group::nonmodal, {L, H}, "turns the rotary axes until the tool is along the normal of the tilted plane; X, Y and Z stand still", haas_manual),
  unread(g(Code::G60, 600, Group::nonmodal, fanuc, "approach from one side", fanuc_manual)),
  with_axes(g(Code::G70, 700, Group::nonmodal, linuxcnc, "lathe finishing cycle", manual, "QEDP", "Q")),
  g(Code::G70_bolts, 700, Group::nonmodal, {H}, "the cycle in force on a circle", haas_manual, "IJL", "IL"),
  with_axes(g(Code::G71, 710, Group::nonmodal, linuxcnc, "lathe roughing cycle along Z", manual, "QDIR", "Q")),
  g(Code::G71_bolts, 710, Group::nonmodal, {H}, "the cycle in force on an arc", haas_manual, "IJKL", "IKL"),
  with_axes(g(Code::G71_1, 711, Group::nonmodal, linuxcnc, "lathe roughing cycle along Z with pockets, method 1", manual, "QDIR", "Q")),
  with_axes(g(Code::G71_2, 712, Group::nonmodal, linuxcnc, "lathe roughing cycle along Z with pockets, method 2", manual, "QDIR", "Q")),
  with_axes(g(Code::G72, 720, Group::nonmodal, linuxcnc, "lathe roughing cycle along X", manual, "QDIR", "Q")),
  g(Code::G72_bolts, 720, Group::nonmodal, {H}, "the cycle in force along a line", haas_manual, "IJL", "IL"),
  with_axes(g(Code::G72_1, 721, Group::nonmodal, linuxcnc, "lathe roughing cycle along X with pockets, method 1", manual, "QDIR", "Q")),
  with_axes(g(Code::G72_2, 722, Group::nonmodal, linuxcnc, "lathe roughing cycle along X with pockets, method 2", manual, "QDIR", "Q")),
  with_axes(g(Code::G92, 920, Group::nonmodal, all.without(T), "shifts coordinates so that the tool stands at those given", "NIST IR 6556, 3.5.18")),
  g(Code::G92_1, 921, Group::nonmodal, {L, C, B, M}, "no shift, and forgets it", "NIST IR 6556, 3.5.18"),
  g(Code::G92_2, 922, Group::nonmodal, {L, C, M}, "no shift, until G92.3 brings it back", "NIST IR 6556, 3.5.18"),
  g(Code::G92_3, 923, Group::nonmodal, {L, C, M}, "the shift that was kept", "NIST IR 6556, 3.5.18"),
  g(Code::G5_high_speed, 50, Group::nonmodal, {F}, "high-speed machining, which is always on here", fanuc_manual, "P"),
  g(Code::G5_1_high_speed, 51, Group::nonmodal, {F, H}, "contour control, which is always on here", fanuc_manual, "QR"),
  g(Code::G8_high_speed, 80, Group::nonmodal, {F, H}, "look-ahead, which is always on here", fanuc_manual, "P"),
  with_axes(g(Code::G47, 470, Group::nonmodal, {H}, "engraves the text of a remark, or a number that counts", haas_manual, "PRIJE", "P")),
  g(Code::G103, 1030, Group::nonmodal, {L, H}, "limits look-ahead, which bounds itself here", haas_manual, "P"),
  with_axes(g(Code::G150, 1500, Group::nonmodal, {H}, "pocket of the contour of subprogram P", haas_manual, "PQRIJKD", "P")),
  g(Code::G187, 1870, Group::nonmodal, {L, H}, "smoothness: E is what P of G64 is", haas_manual, "PE"),
  g(Code::G6_4, 64, Group::nonmodal, {L}, "defines a surface, whose points the next blocks are: X Y Z, the weight R, the knots K of u and L of v", leadscrew_manual, "DPQIJ", "DPQIJ"),
  g(Code::G6_5, 65, Group::nonmodal, {L}, "machines a surface, in passes", leadscrew_manual, "DTHQLSPUVIJABRZKC", "D"),
  g(Code::G6_6, 66, Group::nonmodal, {L}, "smooth curve through the places that the next blocks are: X Y Z, and I J K, the tool's direction", leadscrew_manual, "P", "P"),

  g(Code::G17, 170, Group::plane, all, "plane XY", "NIST IR 6556, 3.5.6"),
  g(Code::G17_1, 171, Group::plane, linuxcnc, "plane UV: of canned cycles, there are no arcs in it", manual),
  g(Code::G18, 180, Group::plane, all, "plane ZX", "NIST IR 6556, 3.5.6"),
  g(Code::G18_1, 181, Group::plane, linuxcnc, "plane WU: of canned cycles, there are no arcs in it", manual),
  g(Code::G19, 190, Group::plane, all, "plane YZ", "NIST IR 6556, 3.5.6"),
  g(Code::G19_1, 191, Group::plane, linuxcnc, "plane VW: of canned cycles, there are no arcs in it", manual),
  g(Code::G90, 900, Group::distance, all.without(T), "axis words are coordinates", "NIST IR 6556, 3.5.17"),
  g(Code::G91, 910, Group::distance, all.without(T), "axis words are distances from where the tool stands", "NIST IR 6556, 3.5.17"),
  g(Code::G90_1, 901, Group::arc_distance, {L, C, M}, "I, J and K are coordinates", manual),
  g(Code::G91_1, 911, Group::arc_distance, {L, C, B, M}, "I, J and K are distances from the start of the arc", manual),
  g(Code::G93, 930, Group::feed_mode, no_marlin.without(T), "F is the reciprocal of a block's minutes", "NIST IR 6556, 3.5.19"),
  g(Code::G94, 940, Group::feed_mode, no_marlin.without(T), "F is units per minute", "NIST IR 6556, 3.5.19"),
  g(Code::G95, 950, Group::feed_mode, no_small.without(T), "F is units per revolution of the spindle", manual),
  g(Code::G20, 200, Group::units, all, "inches", "NIST IR 6556, 3.5.7"),
  g(Code::G21, 210, Group::units, all, "millimetres", "NIST IR 6556, 3.5.7"),
  g(Code::G40, 400, Group::cutter_radius, no_marlin, "no cutter compensation", "NIST IR 6556, 3.5.10"),
  g(Code::G41, 410, Group::cutter_radius, no_small, "cutter compensation, left of the path", "NIST IR 6556, 3.5.10", "D"),
  g(Code::G41_1, 411, Group::cutter_radius, linuxcnc, "cutter compensation of a given diameter, left of the path", manual, "DL", "D"),
  g(Code::G42, 420, Group::cutter_radius, no_small, "cutter compensation, right of the path", "NIST IR 6556, 3.5.10", "D"),
  g(Code::G42_1, 421, Group::cutter_radius, linuxcnc, "cutter compensation of a given diameter, right of the path", manual, "DL", "D"),
  g(Code::G43, 430, Group::tool_length, no_small.without(T), "tool length offset of the tool table", "NIST IR 6556, 3.5.11", "H"),
  with_axes(g(Code::G43_1, 431, Group::tool_length, {L, C, B}, "tool length offset as given", manual)),
  g(Code::G43_2, 432, Group::tool_length, linuxcnc, "adds the tool length offset of a tool", manual, "H", "H"),
  g(Code::G43_4, 434, Group::tool_length, {L, F}, "tool centre point control: the tool's tip is where the program says, however rotary axes turn", fanuc_manual, "H"),
  g(Code::G43_5, 435, Group::tool_length, {L, F}, "tool centre point control with tool vectors: I J K of lines point from the tip to the spindle, in the coordinates of X Y Z", fanuc_manual, "HIJKQ"),
  g(Code::G44, 440, Group::tool_length, fanuc, "tool length offset of the tool table, negative", fanuc_manual, "H"),
  g(Code::G49, 490, Group::tool_length, no_marlin.without(T), "no tool length offset", "NIST IR 6556, 3.5.11"),
  g(Code::G98, 980, Group::retract, no_small.without(T), "cycles retract to where the tool was; so begin programs of fanuc, haas and mach3", "NIST IR 6556, 3.5.20"),
  g(Code::G99, 990, Group::retract, no_small.without(T), "cycles retract to R; so begin programs of linuxcnc and leadscrew", "NIST IR 6556, 3.5.20"),
  g(Code::G50, 500, Group::scaling, {L, F, H, M}, "no scaling; with S, limits the spindle's speed", fanuc_manual),
  with_axes(g(Code::G51, 510, Group::scaling, {L, F, H, M}, "scaling about a point", fanuc_manual, "PIJK")),
  with_axes(g(Code::G50_1, 501, Group::mirror, fanuc, "no mirror, of the axes given or of all", fanuc_manual)),
  with_axes(g(Code::G51_1, 511, Group::mirror, fanuc, "mirrors the axes given at their coordinates", fanuc_manual)),
  g(Code::G54, 540, Group::system, all, "coordinate system 1", "NIST IR 6556, 3.5.13"),
  g(Code::G55, 550, Group::system, all, "coordinate system 2", "NIST IR 6556, 3.5.13"),
  g(Code::G56, 560, Group::system, all, "coordinate system 3", "NIST IR 6556, 3.5.13"),
  g(Code::G57, 570, Group::system, all, "coordinate system 4", "NIST IR 6556, 3.5.13"),
  g(Code::G58, 580, Group::system, all, "coordinate system 5", "NIST IR 6556, 3.5.13"),
  g(Code::G59, 590, Group::system, all, "coordinate system 6", "NIST IR 6556, 3.5.13"),
  g(Code::G59_1, 591, Group::system, {L, C, R}, "coordinate system 7", "NIST IR 6556, 3.5.13"),
  g(Code::G59_2, 592, Group::system, {L, C, R}, "coordinate system 8", "NIST IR 6556, 3.5.13"),
  g(Code::G59_3, 593, Group::system, {L, C, R}, "coordinate system 9", "NIST IR 6556, 3.5.13"),
  g(Code::G54_1, 541, Group::system, {L, F, T}, "further coordinate system, of its number P", fanuc_manual, "P", "P"),
  g(Code::G154, 1540, Group::system, {L, H}, "further coordinate system, of its number P", haas_manual, "P", "P"),
  g(Code::G61, 610, Group::path, no_marlin, "exact path; in Fanuc's and Haas' dialect exact stop", "NIST IR 6556, 3.5.14"),
  g(Code::G61_1, 611, Group::path, linuxcnc, "exact stop", "NIST IR 6556, 3.5.14"),
  also(g(Code::G64, 640, Group::path, no_small, "rounds corners within a tolerance", "NIST IR 6556, 3.5.14", "PQ"), "E"),
  g(Code::G96, 960, Group::spindle_mode, no_small, "constant surface speed: the spindle's speed is that of X where a block ends", manual, "D$", "S"),
  g(Code::G97, 970, Group::spindle_mode, no_small, "S is revolutions per minute", manual, "$"),
  g(Code::G90_turn, 900, Group::motion, {T}, "turning cycle: one cut along Z, and back; R is its taper", fanuc_manual, "R"),
  g(Code::G92_thread, 920, Group::motion, {T}, "threading cycle: one cut, and back; F is the lead, R the taper", fanuc_manual, "R"),
  g(Code::G94_face, 940, Group::motion, {T}, "facing cycle: one cut along X, and back; R is its taper", fanuc_manual, "R"),
  with_axes(g(Code::G50_turn, 500, Group::nonmodal, {T}, "with S, limits the spindle's speed; with axes, shifts coordinates so that the tool stands there", fanuc_manual)),
  g(Code::G70_profile, 700, Group::nonmodal, {T}, "goes along the contour of blocks P to Q", fanuc_manual, "PQ", "PQ"),
  with_axes(g(Code::G71_profile, 710, Group::nonmodal, {T}, "roughs the contour of blocks P to Q along Z; in a block before, U is the depth of a cut", fanuc_manual, "PQRUW")),
  with_axes(g(Code::G72_profile, 720, Group::nonmodal, {T}, "roughs the contour of blocks P to Q along X; in a block before, W is the depth of a cut", fanuc_manual, "PQRUW")),
  with_axes(g(Code::G73_profile, 730, Group::nonmodal, {T}, "repeats the contour of blocks P to Q, nearer each time; in a block before, U and W are how far off, R is how often", fanuc_manual, "PQRUW")),
  with_axes(g(Code::G76_profile, 760, Group::nonmodal, {T}, "threading cycle of many cuts; its finish is said in a block before", fanuc_manual, "PQR")),
  with_axes(g(Code::G74_face, 740, Group::nonmodal, {T}, "pecks along Z, at places beside each other along X; in a block before, R is how far back between pecks", fanuc_manual, "PQR")),
  with_axes(g(Code::G75, 750, Group::nonmodal, {T}, "pecks along X, at places beside each other along Z; in a block before, R is how far back between pecks", fanuc_manual, "PQR")),
  g(Code::G7, 70, Group::lathe, linuxcnc, "X is a diameter", manual),
  g(Code::G8, 80, Group::lathe, linuxcnc, "X is a radius", manual),
  with_axes(g(Code::G68, 680, Group::rotation, {L, F, H, M}, "turns coordinates about a point", fanuc_manual, "R", "R")),
  with_axes(g(Code::G68_2, 682, Group::rotation, {L, F}, "tilted working plane: X Y Z its origin, I J K how it is turned", fanuc_manual, "PQIJK")),
  with_axes(g(Code::G68_4, 684, Group::rotation, {L, F}, "tilted working plane, told in the one in force: words as of G68.2", fanuc_manual, "PQIJK")),
  unread(with_axes(g(Code::G68_3, 683, Group::rotation, {L, F}, "tilted working plane across the tool as it stands", fanuc_manual))),
  with_axes(g(Code::G268, 2680, Group::rotation, {L, H}, "tilted working plane: X Y Z its origin, I J K its turns about the workpiece's X, Y and Z", haas_manual, "QIJK")),
  g(Code::G69, 690, Group::rotation, {L, F, H, M}, "coordinates are not turned, the plane is not tilted", fanuc_manual),
  g(Code::G269, 2690, Group::rotation, {L, H}, "the plane is not tilted", haas_manual),
  g(Code::G15, 150, Group::polar, {L, F, H, M}, "axis words are not polar", fanuc_manual),
  g(Code::G16, 160, Group::polar, {L, F, H, M}, "axis words are a radius and an angle", fanuc_manual),
  g(Code::G62, 620, Group::path, {F}, "slows down at inner corners, which the axes' limits do here: as G64", fanuc_manual),
  g(Code::G63, 630, Group::path, {F}, "tapping mode: as G64", fanuc_manual),
  with_axes(g(Code::G100, 1000, Group::mirror, {H}, "no mirror, of the axes given or of all", haas_manual)),
  with_axes(g(Code::G101, 1010, Group::mirror, {H}, "mirrors the axes given at 0 of the program, whatever their numbers", haas_manual)),
  g(Code::G110, 1100, Group::system, {H}, "coordinate systems 1 to 20 of G154, as G110 to G129", haas_manual),
  g(Code::G67, 670, Group::modal_call, {L, F, T}, "ends G66", fanuc_manual),

  m(Code::M0, 0, Group::stop, all, "pause", "NIST IR 6556, 3.6.1"),
  m(Code::M1, 1, Group::stop, all, "pause, where the operator wants one", "NIST IR 6556, 3.6.1"),
  m(Code::M2, 2, Group::stop, all, "end of the program", "NIST IR 6556, 3.6.1"),
  m(Code::M30, 30, Group::stop, all, "end of the program, and change of pallet", "NIST IR 6556, 3.6.1"),
  m(Code::M60, 60, Group::stop, no_small, "change of pallet and pause", "NIST IR 6556, 3.6.1"),
  m(Code::M62, 62, Group::output, linuxcnc, "digital output on, with motion", manual_m, "P", "P"),
  m(Code::M63, 63, Group::output, linuxcnc, "digital output off, with motion", manual_m, "P", "P"),
  m(Code::M64, 64, Group::output, linuxcnc, "digital output on, at once", manual_m, "P", "P"),
  m(Code::M65, 65, Group::output, linuxcnc, "digital output off, at once", manual_m, "P", "P"),
  m(Code::M66, 66, Group::output, linuxcnc, "waits for an input", manual_m, "PELQ"),
  m(Code::M67, 67, Group::output, linuxcnc, "analog output, with motion", manual_m, "EQ", "EQ"),
  m(Code::M68, 68, Group::output, linuxcnc, "analog output, at once", manual_m, "EQ", "EQ"),
  m(Code::M6, 6, Group::tool, no_small, "change of tool; the spindle stops", "NIST IR 6556, 3.6.3"),
  m(Code::M61, 61, Group::tool, linuxcnc, "the tool in the spindle has this number", manual_m, "Q", "Q"),
  m(Code::M3, 3, Group::spindle, all, "spindle clockwise", "NIST IR 6556, 3.6.2", "$"),
  m(Code::M4, 4, Group::spindle, all, "spindle counterclockwise", "NIST IR 6556, 3.6.2", "$"),
  m(Code::M5, 5, Group::spindle, all, "spindle stops", "NIST IR 6556, 3.6.2", "$"),
  m(Code::M19, 19, Group::spindle, no_small, "orients the spindle", manual_m, "RQP$"),
  m(Code::M29, 29, Group::user, fanuc, "rigid tapping, which is always on here", fanuc_manual),
  m(Code::M56, 56, Group::user, {B}, "parking on or off, which a machine here does not do", "grbl 1.1 commands", "P"),
  m(Code::M7, 7, Group::coolant, all, "mist coolant on", "NIST IR 6556, 3.6.4"),
  m(Code::M8, 8, Group::coolant, all, "flood coolant on", "NIST IR 6556, 3.6.4"),
  m(Code::M9, 9, Group::coolant, all, "coolant off", "NIST IR 6556, 3.6.4"),
  m(Code::M48, 48, Group::overrides, no_small, "overrides are obeyed", manual_m),
  m(Code::M49, 49, Group::overrides, no_small, "overrides are not obeyed", manual_m),
  m(Code::M50, 50, Group::overrides, linuxcnc, "feed override: P0 off, P1 on", manual_m, "P"),
  m(Code::M51, 51, Group::overrides, linuxcnc, "spindle override: P0 off, P1 on", manual_m, "P$"),
  m(Code::M52, 52, Group::overrides, linuxcnc, "adaptive feed: P0 off, P1 on", manual_m, "P"),
  m(Code::M53, 53, Group::overrides, linuxcnc, "feed hold: P0 off, P1 on", manual_m, "P"),
  m(Code::M70, 70, Group::modes, linuxcnc, "keeps the modes", manual_m),
  m(Code::M71, 71, Group::modes, linuxcnc, "forgets the modes kept", manual_m),
  m(Code::M72, 72, Group::modes, linuxcnc, "brings the modes back", manual_m),
  m(Code::M73, 73, Group::modes, linuxcnc, "keeps the modes, and brings them back where the subprogram ends", manual_m),
  m(Code::M97, 97, Group::call, {H}, "calls the subprogram at a block number", haas_manual, "PL", "P"),
  m(Code::M98, 98, Group::call, no_small, "calls a subprogram", manual_m, "PL", "P"),
  m(Code::M99, 99, Group::call, no_small, "returns from a subprogram; in a main program, begins again", manual_m, "P"),
  g(Code::G65, 650, Group::call, {L, F, T, H}, "calls a macro with arguments", fanuc_manual, "PL", "P"),
  g(Code::G66, 660, Group::call, {L, F, T}, "calls a macro with arguments behind each block that moves, until G67", fanuc_manual, "PL", "P"),
  m(Code::M100, 100, Group::user, linuxcnc, "function of the machine's builder, of M100 to M199", manual_m, "PQ"),
  m(Code::M428, 428, Group::user, linuxcnc, "tool centre point control on, with the tool length offset in force", kinematics_manual),
  m(Code::M429, 429, Group::user, linuxcnc, "tool centre point control off; the tool length offset stays", kinematics_manual),
}};
// clang-format on

// Numbers by which single dialects call a code as well.
struct OtherNumber {
  Dialect dialect;
  char letter;
  Code code;
  int tenths;
};
constexpr OtherNumber other_numbers[] = {{M, 'G', Code::G20, 700}, {M, 'G', Code::G21, 710}, {M, 'G', Code::G28, 281},
                                         {M, 'M', Code::M99, 470}, {T, 'G', Code::G33, 320}, {T, 'G', Code::G94, 980},
                                         {T, 'G', Code::G95, 990}};

constexpr bool rows_in_order() {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (index(rows[i].code) != i) return false;
  }
  return true;
}
static_assert(rows_in_order(), "a code's row stands at the code's place");

constexpr std::size_t last_user = 199;  // of a builder's functions

template <std::size_t count>
constexpr std::array<std::array<Code, count>, index(Dialect::count)> codes_by_number(char letter, int unit) {
  std::array<std::array<Code, count>, index(Dialect::count)> codes{};
  for (std::size_t dialect = 0; dialect < codes.size(); ++dialect) {
    for (Code& code : codes[dialect]) code = Code::none;
    for (const CodeRow& row : rows) {
      if (row.letter != letter || !row.dialects.has(static_cast<Dialect>(dialect))) continue;
      codes[dialect][static_cast<std::size_t>(row.tenths / unit)] = row.code;
      if (row.code != Code::M100) continue;
      for (std::size_t number = 100; number <= last_user; ++number) codes[dialect][number] = row.code;
    }
    for (std::size_t tenths = 1110; letter == 'G' && tenths <= 1290; tenths += 10) {
      codes[dialect][tenths] = codes[dialect][1100];
    }
  }
  // Each of these machines has functions of its builder's.
  for (const Dialect dialect : {F, H, M, T}) {
    for (std::size_t number = 10; letter == 'M' && number <= last_user; ++number) {
      Code& code = codes[index(dialect)][number];
      if (code == Code::none) code = Code::M100;
    }
  }
  for (const OtherNumber& other : other_numbers) {
    if (other.letter == letter) codes[index(other.dialect)][static_cast<std::size_t>(other.tenths / unit)] = other.code;
  }
  return codes;
}

}  // namespace

namespace detail {
constinit const std::array<CodeRow, index(Code::count)> code_rows = rows;
constinit const std::array<std::array<Code, most_g>, index(Dialect::count)> g_codes = codes_by_number<most_g>('G', 1);
constinit const std::array<std::array<Code, most_m>, index(Dialect::count)> m_codes = codes_by_number<most_m>('M', 10);
}  // namespace detail

Dialects dialects_of(char letter, int tenths) {
  Dialects dialects;
  for (const CodeRow& row : rows) {
    if (row.letter == letter && row.tenths == tenths) dialects = dialects | row.dialects;
  }
  return dialects;
}

std::string name(char letter, int tenths) {
  std::string text = letter + std::to_string(tenths / 10);
  if (tenths % 10 != 0) text += "." + std::to_string(tenths % 10);
  return text;
}

std::string name(Code code) {
  return name(row(code).letter, row(code).tenths);
}

std::string name(Code code, Dialect dialect) {
  if (row(code).dialects.has(dialect)) return name(code);
  for (const OtherNumber& other : other_numbers) {
    if (other.dialect == dialect && other.code == code) return name(other.letter, other.tenths);
  }
  return name(code);
}

const char* instead_of(Code code) {
  if (code == Code::G53_6) return "G53.1, which lets X, Y and Z stand, and a move to where the tip was";
  if (code == Code::G68_3) return "G68.2 P3, with X and the tool's direction for its two vectors";
  if (code == Code::G60)
    return "a line past the point and one back: by how much and from where are parameters of its control";
  return "docs/gcode.md lists what is";
}

std::string name(Group group) {
  static constexpr std::array<const char*, index(Group::count)> names = {
      "modal group 0",  "modal group 1",  "modal group 2",  "modal group 3",  "modal group 4",  "modal group 5",
      "modal group 6",  "modal group 7",  "modal group 8",  "modal group 10", "modal group 11", "modal group 12",
      "modal group 13", "modal group 14", "modal group 15", "modal group 16", "modal group 17", "modal group 22",
      "modal group 23", "M group 4",      "M group 5",      "M group 6",      "M group 7",      "M group 8",
      "M group 9",      "M group 10",     "M group 11",     "M group 12"};
  return group < Group::count ? names[index(group)] : "no modal group";
}

}  // namespace leadscrew::gcode
