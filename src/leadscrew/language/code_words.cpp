#include <leadscrew/language/code_words.hpp>

namespace leadscrew::language {

namespace {

using gcode::Code;

constexpr std::string_view length = "mm or inches", seconds = "s", degrees = "degrees", number = "";

constexpr std::string_view tool_vector =
    "part of the tool's direction, from the tip to the spindle; of any length, without all three the last one holds";

constexpr std::string_view one_spindle = "which spindle: 0, the one that there is";

constexpr std::string_view way_out_of_tap =
    "how many times as fast the tool leaves as it enters, 1 to 9; in fanuc speed of the spindle as it leaves, from S "
    "to "
    "twice S";

// Of the codes from the first to the last in the order of gcode::Code; the first row that fits holds.
struct Row {
  Code first, last;
  char letter;
  std::string_view meaning;
  std::string_view unit;
};

constexpr Row rows[] = {
    {Code::G2, Code::G3, 'I', "centre, along X from the start of the arc (G90.1: its coordinate)", length},
    {Code::G2, Code::G3, 'J', "centre, along Y from the start of the arc (G90.1: its coordinate)", length},
    {Code::G2, Code::G3, 'K', "centre, along Z from the start of the arc (G90.1: its coordinate)", length},
    {Code::G2, Code::G3, 'R', "radius; negative: the arc of more than half a turn", length},
    {Code::G2, Code::G3, 'P', "how many turns are begun, 1 or more", number},
    {Code::G5, Code::G5, 'I', "first control point, along X from the start", length},
    {Code::G5, Code::G5, 'J', "first control point, along Y from the start", length},
    {Code::G5, Code::G5, 'P', "second control point, along X from the end", length},
    {Code::G5, Code::G5, 'Q', "second control point, along Y from the end", length},
    {Code::G5_1, Code::G5_1, 'I', "control point, along X from the start", length},
    {Code::G5_1, Code::G5_1, 'J', "control point, along Y from the start", length},
    {Code::G5_2, Code::G5_2, 'P', "weight of the control point, above 0", number},
    {Code::G5_2, Code::G5_2, 'L', "order of the curve, 3 to 6", number},
    {Code::G6_2, Code::G6_2, 'P', "order of the curve, 2 to 6", number},
    {Code::G6_2, Code::G6_2, 'K', "knot", number},
    {Code::G6_2, Code::G6_2, 'R', "weight of the control point, above 0", number},
    {Code::G33, Code::G33_1, 'K', "travel in a revolution of the spindle; G33 of fanuc and haas: F", length},
    {Code::G33_1, Code::G33_1, 'I', "how much faster the tool leaves than it enters", number},
    {Code::G33, Code::G33_1, '$', one_spindle, number},
    {Code::G76, Code::G76, '$', one_spindle, number},
    {Code::G96, Code::G97, '$', one_spindle, number},
    {Code::M19, Code::M19, '$', one_spindle, number},
    {Code::M51, Code::M51, '$', one_spindle, number},
    {Code::M3, Code::M5, '$', "which spindle: 0, the one that there is, or -1, all", number},
    {Code::G76, Code::G76, 'P', "pitch of the thread", length},
    {Code::G76, Code::G76, 'I', "crest of the thread, from the drive line; negative outside", length},
    {Code::G76, Code::G76, 'J', "depth of the first cut", length},
    {Code::G76, Code::G76, 'K', "full depth of the thread", length},
    {Code::G76, Code::G76, 'R', "how depths of cuts decrease: 1 equally, 2 by equal area", number},
    {Code::G76, Code::G76, 'Q', "angle of infeed", degrees},
    {Code::G76, Code::G76, 'H', "spring passes", number},
    {Code::G76, Code::G76, 'L', "tapers: 0 none, 1 entry, 2 exit, 3 both", number},
    {Code::G76, Code::G76, 'E', "length of the tapers", length},
    {Code::G76_bore, Code::G76_bore, 'Q', "how far the tool leaves the wall", length},
    {Code::G76_bore, Code::G76_bore, 'I', "how far the tool leaves the wall, along X", length},
    {Code::G76_bore, Code::G76_bore, 'J', "how far the tool leaves the wall, along Y", length},
    {Code::G87, Code::G87, 'I', "how far aside the tool goes in, along X", length},
    {Code::G87, Code::G87, 'J', "how far aside the tool goes in, along Y", length},
    {Code::G87, Code::G87, 'K', "level up to which it bores", length},
    {Code::G87, Code::G87, 'Q', "how far aside the tool goes in, along X", length},
    {Code::G73, Code::G73, 'Q', "depth of a peck, above 0", length},
    {Code::G83, Code::G83, 'Q', "depth of a peck, above 0", length},
    {Code::G73, Code::G89, 'R', "level that the tool approaches at rapid", length},
    {Code::G73, Code::G89, 'L', "how often the cycle is done, at further holes under G91", number},
    {Code::G73, Code::G89, 'P', "dwell at the bottom", seconds},
    {Code::G73, Code::G73, 'I', "depth of the first peck (Haas)", length},
    {Code::G83, Code::G83, 'I', "depth of the first peck (Haas)", length},
    {Code::G73, Code::G73, 'K', "depth of a peck, at least (Haas)", length},
    {Code::G83, Code::G83, 'K', "depth of a peck, at least (Haas)", length},
    {Code::G73, Code::G73, 'J', "by how much each peck is less than the one before (Haas)", length},
    {Code::G83, Code::G83, 'J', "by how much each peck is less than the one before (Haas)", length},
    {Code::G74, Code::G74, 'Q', "depth of a peck, the tool out to R between pecks", length},
    {Code::G84, Code::G84, 'Q', "depth of a peck, the tool out to R between pecks", length},
    {Code::G74, Code::G74, 'J', way_out_of_tap, number},
    {Code::G84, Code::G84, 'J', way_out_of_tap, number},
    {Code::G31, Code::G31, 'P', "which of four skip signals; here all are the probe's", number},
    {Code::G4, Code::G4, 'P', "how long; in some dialects milliseconds (see the forms)", seconds},
    {Code::G10, Code::G10, 'L',
     "what is set: 1, 10, 11 tools, 2, 20 coordinate systems; of LinuxCNC also 0, without P: the table of tools is "
     "read again; of fanuc and haas also 12, 13, and under G91 what stands there is added; in fanuc-lathe without L "
     "the offset P",
     number},
    {Code::G10, Code::G10, 'P',
     "which tool, or which system: 1 to 9, 0 for the one in force; L2 P0 of fanuc, haas and fanuc-lathe sets what "
     "shifts all systems, in haas the offset of G52; in fanuc-lathe without L the wear of offset 1 to "
     "99, 10001 to 10099 its geometry",
     number},
    {Code::G10, Code::G10, 'R',
     "turn of the system, degrees, or radius of the tool; of fanuc and haas as L10 to L13 say: length, its "
     "wear, radius, its wear; L1 is L11 there",
     ""},
    {Code::G10, Code::G10, 'I', "angle of the tool's front", degrees},
    {Code::G10, Code::G10, 'J', "angle of the tool's back", degrees},
    {Code::G10, Code::G10, 'Q',
     "orientation of the tool, 0 to 9, as LinuxCNC numbers it; in dialect fanuc-lathe as Fanuc does: 3 for turning "
     "outside, 2 for boring",
     number},
    {Code::G12, Code::G13, 'I', "radius of the first circle, or of the only one", length},
    {Code::G12, Code::G13, 'K', "radius of the pocket", length},
    {Code::G12, Code::G13, 'Q', "by how much each circle is greater than the one before", length},
    {Code::G12, Code::G13, 'L', "how many levels deep, under G91", number},
    {Code::G12, Code::G13, 'D',
     "tool of the tool table, by whose radius the path is within, which G51 does not scale; 0 by none", number},
    {Code::G90_turn, Code::G94_face, 'R', "by how much the cut begins elsewhere than it ends, along X; of G94 along Z",
     length},
    {Code::G70_profile, Code::G73_profile, 'P', "number of the contour's first block", number},
    {Code::G70_profile, Code::G73_profile, 'Q', "number of the contour's last block", number},
    {Code::G71_profile, Code::G72_profile, 'R', "how far the tool leaves the cut", length},
    {Code::G73_profile, Code::G73_profile, 'R', "how often the contour is gone along", number},
    {Code::G71_profile, Code::G73_profile, 'U',
     "what is left, of the diameter; in the block before depth of a cut, of G73 distance", length},
    {Code::G71_profile, Code::G73_profile, 'W',
     "what is left along Z: the contour is moved by U/2 and W as a whole, and so into walls that face the other way; "
     "in the block before depth of a cut of G72, of G73 distance",
     length},
    {Code::G76_profile, Code::G76_profile, 'P',
     "height of the thread, 0.001 mm; in the block before six digits: passes at full depth, tenths of the lead that "
     "the thread runs out by, angle of the tip",
     ""},
    {Code::G76_profile, Code::G76_profile, 'Q', "depth of the first cut, 0.001 mm; in the block before the least cut",
     ""},
    {Code::G76_profile, Code::G76_profile, 'R', "taper; in the block before what is left for the last passes", length},
    {Code::G74_face, Code::G75, 'P', "step along X, of the radius, 0.001 mm: of G74 between places, of G75 a peck", ""},
    {Code::G74_face, Code::G75, 'Q', "step along Z, 0.001 mm: of G74 a peck, of G75 between places", ""},
    {Code::G74_face, Code::G75, 'R', "off the wall at the bottom; in the block before, back between pecks", length},
    {Code::G47, Code::G47, 'P',
     "0 the text of the remark, 1 a number that counts, of as many digits as the remark has #, 32 to 126 a character",
     number},
    {Code::G47, Code::G47, 'R', "level that the tool is lifted to", length},
    {Code::G47, Code::G47, 'I', "angle of the line of text", degrees},
    {Code::G47, Code::G47, 'J', "height of the characters; 1 inch", length},
    {Code::G47, Code::G47, 'E', "feed into the work; F", ""},
    {Code::G150, Code::G150, 'P', "subprogram, or block where it begins, of the contour", number},
    {Code::G150, Code::G150, 'Q', "depth of a level; without it all at once", length},
    {Code::G150, Code::G150, 'R', "level that the tool approaches at rapid", length},
    {Code::G150, Code::G150, 'I', "step along X from line to line", length},
    {Code::G150, Code::G150, 'J', "step along Y from line to line", length},
    {Code::G150, Code::G150, 'K', "what is left for a last way along the contour; 0", length},
    {Code::G150, Code::G150, 'D',
     "tool of the tool table, by whose radius the path is within, which G51 does not scale; 0 by none", number},
    {Code::G70_bolts, Code::G70_bolts, 'I', "radius of the circle", length},
    {Code::G70_bolts, Code::G70_bolts, 'J', "angle of the first hole", degrees},
    {Code::G71_bolts, Code::G71_bolts, 'I', "radius of the arc", length},
    {Code::G71_bolts, Code::G71_bolts, 'J', "angle of the first hole", degrees},
    {Code::G71_bolts, Code::G71_bolts, 'K', "angle from hole to hole", degrees},
    {Code::G72_bolts, Code::G72_bolts, 'I', "distance from hole to hole", length},
    {Code::G72_bolts, Code::G72_bolts, 'J', "angle of the line", degrees},
    {Code::G70_bolts, Code::G72_bolts, 'L', "holes", number},
    {Code::G70, Code::G72_2, 'Q', "number of the subprogram that is the contour", number},
    {Code::G70, Code::G70, 'D', "distance from the contour at which the passes begin; 0", length},
    {Code::G70, Code::G70, 'E', "distance of the last pass from the contour; 0", length},
    {Code::G71, Code::G72_2, 'D', "distance from the contour that is left; 0", length},
    {Code::G71, Code::G72_2, 'I', "depth of a cut, above 0; 1", length},
    {Code::G71, Code::G72_2, 'R', "how far the tool leaves the work along X and Z; 0.5", length},
    {Code::G70, Code::G70, 'P', "passes; 1", number},
    {Code::G5_high_speed, Code::G5_high_speed, 'P', "10000 on, 0 off", number},
    {Code::G5_1_high_speed, Code::G5_1_high_speed, 'Q', "1 on, 0 off", number},
    {Code::G5_1_high_speed, Code::G5_1_high_speed, 'R', "level of precision", number},
    {Code::G8_high_speed, Code::G8_high_speed, 'P', "1 on, 0 off", number},
    {Code::G103, Code::G103, 'P', "blocks read in advance", number},
    {Code::G187, Code::G187, 'P', "smoothness: 1 rough, 2 medium, 3 finish", number},
    {Code::G187, Code::G187, 'E', "how far corners may be rounded", length},
    {Code::G6_4, Code::G6_5, 'D', "number of the surface", number},
    {Code::G6_4, Code::G6_4, 'P', "order in u: the degree and one, 2 to 6", number},
    {Code::G6_4, Code::G6_4, 'Q', "order in v: the degree and one, 2 to 6", number},
    {Code::G6_4, Code::G6_4, 'I', "points along u", number},
    {Code::G6_4, Code::G6_4, 'J', "points along v", number},
    {Code::G6_5, Code::G6_5, 'T', "tool whose shape machines it; without it the one in the spindle", number},
    {Code::G6_5, Code::G6_5, 'H', "height of the ridges between passes; or Q", length},
    {Code::G6_5, Code::G6_5, 'Q', "distance between passes on the surface; or H", length},
    {Code::G6_5, Code::G6_5, 'L', "passes along 1 u, 2 v; 1", number},
    {Code::G6_5, Code::G6_5, 'S', "1 zig, 2 zigzag, 3 spiral in, 4 iso-scallop, 5 planar; 2", number},
    {Code::G6_5, Code::G6_5, 'P', "corner where passes begin, 1 to 4: (U, I), (V, I), (V, J), (U, J); 1", number},
    {Code::G6_5, Code::G6_5, 'U', "range: u from here; all", number},
    {Code::G6_5, Code::G6_5, 'V', "range: u to here; all", number},
    {Code::G6_5, Code::G6_5, 'I', "range: v from here; all", number},
    {Code::G6_5, Code::G6_5, 'J', "range: v to here; all", number},
    {Code::G6_5, Code::G6_5, 'A',
     "lead of the tool, forward along the pass; A0 B0 along the normal, without both it keeps its direction", degrees},
    {Code::G6_5, Code::G6_5, 'B', "tilt of the tool, sideways", degrees},
    {Code::G6_5, Code::G6_5, 'R', "the tool is on the side of Su × Sv: 1, or the other: -1; 1", number},
    {Code::G6_5, Code::G6_5, 'Z', "clearance, at which the tool comes and goes; without it the level where it stands",
     length},
    {Code::G6_5, Code::G6_5, 'K', "feed is that of 1 the place of contact, 2 the tool's tip; 2", number},
    {Code::G6_5, Code::G6_5, 'C', "how near curves are to passes; 1e-10 mm", length},
    {Code::G6_6, Code::G6_6, 'P', "how many blocks of places follow", number},
    {Code::G41, Code::G42_1, 'D',
     "tool of the tool table, without it the one in the spindle; of G41.1 and G42.1 its diameter, negative for the "
     "other side",
     length},
    {Code::G41, Code::G42_1, 'L', "orientation of a lathe tool in G18, 0 to 9: 0 and 9 its middle", number},
    {Code::G43, Code::G44, 'H', "tool of the tool table; without it the one in the spindle", number},
    {Code::G43_5, Code::G43_5, 'I', tool_vector, number},
    {Code::G43_5, Code::G43_5, 'J', tool_vector, number},
    {Code::G43_5, Code::G43_5, 'K', tool_vector, number},
    {Code::G43_5, Code::G43_5, 'Q', "by how much the tool leans ahead of I J K along its way: 0 only", degrees},
    {Code::G51, Code::G51, 'P', "factor of all axes", number},
    {Code::G51, Code::G51, 'I', "factor of X; negative mirrors", number},
    {Code::G51, Code::G51, 'J', "factor of Y; negative mirrors", number},
    {Code::G51, Code::G51, 'K', "factor of Z; negative mirrors", number},
    {Code::G54_1, Code::G154, 'P', "which system", number},
    {Code::G64, Code::G64, 'P', "how far the path may leave the corners; without it the machine's tolerance", length},
    {Code::G64, Code::G64, 'Q', "how far chains of short lines may be smoothed; without it P", length},
    {Code::G64, Code::G64, 'E', "how far the tool's direction may leave the programmed one; without it the machine's",
     degrees},
    {Code::G96, Code::G96, 'D', "greatest speed of the spindle", "1/min"},
    {Code::G68, Code::G68, 'R', "angle, counterclockwise", degrees},
    {Code::G68_2, Code::G68_4, 'P', "0 Euler angles, 1 angles about X, Y and Z, 2 three points, 3 two vectors", number},
    {Code::G68_2, Code::G68_4, 'Q', "of P1 the order of turns, 123 for X, Y, Z; of P2 and P3 which point or vector",
     number},
    {Code::G68_2, Code::G68_4, 'I', "of P0 angle about Z, of P1 about X; of P3 the vector along X", degrees},
    {Code::G68_2, Code::G68_4, 'J', "of P0 angle about the turned X, of P1 about Y; of P3 the vector along Y", degrees},
    {Code::G68_2, Code::G68_4, 'K', "of P0 angle about the turned Z, of P1 about Z; of P3 the vector along Z", degrees},
    {Code::G268, Code::G268, 'Q', "order of turns, 123 for X, Y, Z", number},
    {Code::G268, Code::G268, 'I', "angle about X", degrees},
    {Code::G268, Code::G268, 'J', "angle about Y", degrees},
    {Code::G268, Code::G268, 'K', "angle about Z", degrees},
    {Code::G53_1, Code::G53_1, 'P', "0 the nearest angles, 1 those of the greater tilt, 2 of the lesser", number},
    {Code::M62, Code::M65, 'P', "number of the output, 0 to 63", number},
    {Code::M66, Code::M66, 'P', "number of the digital input", number},
    {Code::M66, Code::M66, 'E', "number of the analog input", number},
    {Code::M66, Code::M66, 'L', "what is waited for: 0 nothing, 1 rise, 2 fall, 3 on, 4 off", number},
    {Code::M66, Code::M66, 'Q', "how long it is waited for", seconds},
    {Code::M67, Code::M68, 'E', "number of the output, 0 to 63", number},
    {Code::M67, Code::M68, 'Q', "value of the output", number},
    {Code::M61, Code::M61, 'Q', "number of the tool", number},
    {Code::M19, Code::M19, 'R', "angle", degrees},
    {Code::M19, Code::M19, 'Q', "how long the spindle may take", seconds},
    {Code::M19, Code::M19, 'P', "direction: 0 the shorter, 1 clockwise, 2 counterclockwise", number},
    {Code::M56, Code::M56, 'P', "0 off, 1 on", number},
    {Code::M50, Code::M53, 'P', "0 off, otherwise on", number},
    {Code::M97, Code::M97, 'P', "number of the block where the subprogram begins", number},
    {Code::M98, Code::M98, 'P', "number of the subprogram; with more than four digits, how often before it", number},
    {Code::M99, Code::M99, 'P', "number of the block to go on with", number},
    {Code::G65, Code::G66, 'P', "number of the program", number},
    {Code::M97, Code::G66, 'L', "how often", number},
    {Code::M100, Code::M100, 'P', "first number for the function", number},
    {Code::M100, Code::M100, 'Q', "second number for the function", number},
};

WordMeaning meaning_alone(char letter) {
  switch (letter) {
    case 'X':
    case 'Y':
    case 'Z':
    case 'U':
    case 'V':
    case 'W':
      return {"coordinate (G90) or distance (G91)", length};
    case 'A':
    case 'B':
    case 'C':
      return {"angle (G90) or turn (G91)", degrees};
    case 'F':
      return {"feed: of a minute (G94), of a revolution (G95), or the reciprocal of minutes (G93)", ""};
    case 'S':
      return {"speed of the spindle, revolutions a minute (G97) or surface speed (G96)", ""};
    case 'T':
      return {"tool that M6 changes to", number};
    case 'N':
      return {"number of the block", number};
    case '$':
      return {"which spindle: 0, the one that there is, or -1, all", number};
    case 'O':
      return {"number of a program, or of a subprogram or loop", number};
    default:
      return {};
  }
}

}  // namespace

bool is_of_tool_vector(Code code, char letter) {
  return (code == Code::G0 || code == Code::G1) && 'I' <= letter && letter <= 'K';
}

namespace {

/// What the table says of it; null where the code does not take it or nothing is said of it.
const Row* row_of(Code code, char letter) {
  if (code == Code::none) return nullptr;
  const gcode::CodeRow& known = gcode::row(code);
  if (!known.words.has(letter) && !known.more_words.has(letter)) return nullptr;
  for (const Row& row : rows) {
    if (row.first <= code && code <= row.last && row.letter == letter) return &row;
  }
  return nullptr;
}

}  // namespace

bool takes(Code code, char letter) {
  return gcode::row(code).words.has(letter) || row_of(code, letter) != nullptr;
}

WordMeaning meaning_of(Code code, char letter) {
  if (is_of_tool_vector(code, letter))
    return {"under G43.5: part of the tool's direction, from the tip to the spindle", ""};
  if (const Row* row = row_of(code, letter)) return {row->meaning, row->unit};
  return meaning_alone(letter);
}

}  // namespace leadscrew::language
