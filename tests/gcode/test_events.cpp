#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_events {

using Kind = base::Event::Kind;

std::vector<std::pair<Kind, double>> events(std::string_view text, const Conditions& conditions = {}) {
  std::vector<std::pair<Kind, double>> result;
  for (const base::Event& event : read_well(text, conditions).events()) result.emplace_back(event.kind, event.value);
  return result;
}
using Events = std::vector<std::pair<Kind, double>>;

TEST(Events, HaveTheirValues) {
  EXPECT_EQ(events("S1000\nM3\nM4\nM5\nM7\nM8\nM9\nT3\nM6\nM0\nM1\nM60\nM2\n"),
            (Events{{Kind::spindle_speed, 1000},
                    {Kind::spindle_clockwise, 1000},
                    {Kind::spindle_counterclockwise, 1000},
                    {Kind::spindle_stop, 0},
                    {Kind::coolant_mist, 0},
                    {Kind::coolant_flood, 0},
                    {Kind::coolant_off, 0},
                    {Kind::tool_prepare, 3},
                    {Kind::tool_change, 3},
                    {Kind::pause, 0},
                    {Kind::optional_pause, 0},
                    {Kind::pallet_pause, 0},
                    {Kind::program_end, 0}}));
}

// LinuxCNC, "M62 - M65", "M67", "M68"
TEST(Events, OfOutputsHaveTheirNumbersAndValues) {
  const Reading reading = read_well("M62 P0\nM63 P63\nM64 P1\nM65 P2\nM67 E3 Q-1.5\nQ[1/4] E0 M68\nM2\n");
  const std::vector<base::Event> expected = {
      {Kind::digital_output_on_with_motion, 1, base::Line{1}, 0, false},
      {Kind::digital_output_off_with_motion, 0, base::Line{2}, 63, false},
      {Kind::digital_output_on, 1, base::Line{3}, 1, false},
      {Kind::digital_output_off, 0, base::Line{4}, 2, false},
      {Kind::analog_output_with_motion, -1.5, base::Line{5}, 3, false},
      {Kind::analog_output, 0.25, base::Line{6}, 0, false},
      {Kind::program_end, 0, base::Line{7}, 0, true},
  };
  EXPECT_EQ(reading.events(), expected);
}

TEST(Events, OfOutputsThatCannotBeAreSaid) {
  const struct {
    const char* block;
    const char* problems;
  } rows[] = {
      {"M62", "1:1 missing-word; "},      {"M68 Q1", "1:1 missing-word; "},      {"M67 E0", "1:1 missing-word; "},
      {"M62 P64", "1:5 bad-value; "},     {"M65 P-1", "1:5 bad-value; "},        {"M67 E0.5 Q1", "1:5 bad-value; "},
      {"M62 P0 Q1", "1:8 unused-word; "}, {"M62 P0 G4", "1:5 ambiguous-word; "}, {"M62 M63 P0", "1:5 modal-conflict; "},
      {"M66 P64", "1:5 bad-value; "},
  };
  for (const auto& row : rows) {
    EXPECT_EQ(read(std::string(row.block) + "\nM2\n").problems().substr(0, std::string(row.problems).size()),
              row.problems)
        << row.block;
  }
}

TEST(Events, SayWhetherMotionRestsForThem) {
  const auto waits = [](bool spindle_waits) {
    Conditions conditions;
    conditions.machine.spindle_waits = spindle_waits;
    std::string text;
    for (const base::Event& event :
         read_well("S1\nM3\nM4\nM5\nM7\nM8\nM9\nT3\nM6\nM64 P0\nM67 E0 Q0\nM0\nM1\nM60\nM2\n", conditions).events())
      text += event.waits ? 'w' : '-';
    return text;
  };
  EXPECT_EQ(waits(true), "-www----w--wwww");
  EXPECT_EQ(waits(false), "--------w--wwww");
}

// NIST IR 6556, 3.8
TEST(Execution, HasTheOrderOfTheStandardWhateverTheOrderOfWords) {
  const Reading reading = read_well("M30 X1 G1 P2 G4 M8 M3 M6 T7 M68 E0 Q1 S500 F60\n");
  std::vector<std::pair<Move::Kind, Kind>> found;
  for (const Move& move : reading.moves) found.emplace_back(move.kind, move.event.kind);
  const Kind none = Kind::program_end;
  EXPECT_EQ(found, (std::vector<std::pair<Move::Kind, Kind>>{{Move::Kind::event, Kind::spindle_speed},
                                                             {Move::Kind::event, Kind::tool_prepare},
                                                             {Move::Kind::event, Kind::analog_output},
                                                             {Move::Kind::event, Kind::tool_change},
                                                             {Move::Kind::event, Kind::spindle_clockwise},
                                                             {Move::Kind::event, Kind::coolant_flood},
                                                             {Move::Kind::dwell, none},
                                                             {Move::Kind::line, none},
                                                             {Move::Kind::event, Kind::program_end}}));
}

TEST(Execution, ChangesPlaneUnitsOffsetsAndDistanceBeforeItMoves) {
  const Reading reading = read_well("F60 G10 L2 P2 X10\nG91 G55 G20 G18 G0 X1\nM2\n");
  EXPECT_EQ(reading.lines()[0].plane, Plane::ZX);
  EXPECT_EQ(xyz(reading.lines()[0].end), (Point{25.4, 0, 0}));
}

TEST(Events, StandStillInTheirPlace) {
  const Move move = read_well("G0 X1\nM3\nM2\n").of(Move::Kind::event)[0];
  EXPECT_EQ(xyz(move.start), (Point{1, 0, 0}));
  EXPECT_EQ(move.start, move.end);
  EXPECT_EQ(base::number(move.event.line), 2);
}

TEST(Dwell, IsInSeconds) {
  const std::vector<Move> dwells = read_well("G4 P1.5\nG20 G4 P0\nM2\n").of(Move::Kind::dwell);
  ASSERT_EQ(dwells.size(), 2u);
  EXPECT_EQ(dwells[0].dwell_seconds, 1.5);
  EXPECT_EQ(dwells[1].dwell_seconds, 0);
}

TEST(ProgramEnd, IsOneEventAndTheLast) {
  for (const char* text : {"G0 X1\nM2\nG0 X2\n", "G0 X1\nM30\n?", "%\nG0 X1\n%\nG0 X2", "G0 X1", "G0 X1\n"}) {
    const Reading reading = read_well(text);
    ASSERT_EQ(reading.moves.size(), 2u) << text;
    EXPECT_EQ(reading.moves[1].kind, Move::Kind::event);
    EXPECT_EQ(reading.moves[1].event.kind, Kind::program_end);
  }
}

TEST(ProgramEnd, ThatNobodyWroteIsNoted) {
  for (const char* text : {"G0 X1\n\nG0 X2\n", "%\nG0 X1\nG0 X2"}) {
    const Reading reading = read(text);
    ASSERT_EQ(reading.diagnostics.size(), 1u);
    EXPECT_EQ(reading.diagnostics[0].code, "program-end");
    EXPECT_EQ(reading.diagnostics[0].severity, base::Severity::note);
    EXPECT_EQ(reading.diagnostics[0].place.line, 3);
    EXPECT_EQ(reading.errors, 0);
  }
}

TEST(Tools, ThatTheTableLacksAreWorthAWarning) {
  Conditions conditions;
  conditions.tools = machine::ToolTable(std::vector<machine::Tool>{{.number = 1}});
  const Reading reading = read("T1 M6\nT2\nM2\n", conditions);
  EXPECT_EQ(reading.problems(), "2:1 unknown-tool; ");
  EXPECT_EQ(reading.errors, 0);
}

}  // namespace test_events
}  // namespace leadscrew::gcode
