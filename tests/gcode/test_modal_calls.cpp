// G66: a macro behind each block that moves. Where moves come to is worked out by hand.

#include <string>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_modal_calls {

// The places that moves come to: "0 1 0; 1 1 0; ".
std::string places_of(std::string_view program, Dialect dialect = Dialect::fanuc) {
  std::string places;
  const Reading reading = read_well(program, in_dialect(dialect));
  for (const Move& move : reading.lines())
    places += text(move.end[0]) + " " + text(move.end[1]) + " " + text(move.end[2]) + "; ";
  return places;
}

const std::string step_along_x = "O8001\nG91 G0 X#1\nG90\nM99\n";
const std::string step_along_y = "O8002\nG91 G0 Y#2\nG90\nM99\n";

TEST(ModalCalls, FollowEachBlockThatMoves) {
  const std::string program = "G66 P8001 A1\nG0 Y1\nY2\nG67\nY3\nM30\n" + step_along_x;
  EXPECT_EQ(places_of(program), "0 1 0; 1 1 0; 1 2 0; 2 2 0; 2 3 0; ");
  EXPECT_EQ(places_of(program, Dialect::leadscrew), places_of(program));
}

TEST(ModalCalls, FollowNoBlockThatStands) {
  EXPECT_EQ(
      places_of("G66 P8001 A1\nM8\nG4 P100\nG4 X1.\nF100\n#100=1\nG1\nG10 L2 P2 X5.\nG0 Y1\nM30\n" + step_along_x),
      "0 1 0; 1 1 0; ");
}

TEST(ModalCalls, FollowArcs) {
  const Reading reading = read_well("G66 P8001 A1\nG2 I5. F100\nG67\nM30\n" + step_along_x, in_dialect(Dialect::fanuc));
  EXPECT_EQ(reading.arcs().size(), 1u);
  EXPECT_EQ(ends_along_x(reading), "1 ");
}

TEST(ModalCalls, RepeatTheMacro) {
  EXPECT_EQ(places_of("G66 P8001 L3 A1\nG0 Y1\nM30\n" + step_along_x), "0 1 0; 1 1 0; 2 1 0; 3 1 0; ");
  EXPECT_EQ(places_of("G66 P8001 L0 A1\nG0 Y1\nM30\n" + step_along_x), "0 1 0; ");
}

TEST(ModalCalls, GiveTheSameArgumentsEachTime) {
  EXPECT_EQ(places_of("G66 P8001 A1\nG0 Y1\nY2\nM30\nO8001\nG91 G0 X#1\nG90\n#1=7\nM99\n"),
            "0 1 0; 1 1 0; 1 2 0; 2 2 0; ");
}

TEST(ModalCalls, WithinOneAnother) {
  // What moves in the macro given last calls the one before; what moves in that calls none.
  EXPECT_EQ(places_of("G66 P8001 A1\nG66 P8002 B10\nG0 Z5\nG67\nZ6\nG67\nZ7\nM30\n" + step_along_x + step_along_y),
            "0 0 5; 0 10 5; 1 10 5; 1 10 6; 2 10 6; 2 10 7; ");
}

TEST(ModalCalls, GoOnInSubprograms) {
  EXPECT_EQ(places_of("G66 P8001 A1\nM98 P100\nG67\nM98 P100\nM30\nO100\nG91 G0 Y1\nG90\nM99\n" + step_along_x),
            "0 1 0; 1 1 0; 1 2 0; ");
}

TEST(ModalCalls, EndWhereNoneIs) {
  EXPECT_EQ(places_of("G17 G40 G49 G67 G80\nG67 G0 X1\nM30\n"), "1 0 0; ");
}

TEST(ModalCalls, TellWhatIsWrong) {
  const struct {
    std::string text, problems;
  } rows[] = {
      {"G66 A1\nM30\n", "1:1 missing-word; "},
      {"G66 P1 N1\nM30\n", "1:8 unused-word; "},
      {"G66 P1 L-1\nM30\n", "1:1 bad-value; "},
      {"G66 P8009\nM30\n", "1:1 missing-sub; "},
      {"G90 G66 P1\nM30\n", "1:5 bad-o-word; "},
      {"G66 P8001\nG66 P8001\nG66 P8001\nG66 P8001\nG66 P8001\nM30\n" + step_along_x, "5:1 calls-too-deep; "},
      {"G66 P1\nG0 X1\nM30\nO1\nG66 P1\nM99\n", "5:1 modal-call-inside; "},
      {"G66 P1\nG0 X1\nM30\nO1\nG67\nM99\n", "5:1 modal-call-inside; "},
  };
  for (const auto& row : rows)
    EXPECT_EQ(read(row.text, in_dialect(Dialect::fanuc)).problems(), row.problems) << row.text;
  EXPECT_EQ(read("G66 P8001\nM30\n", in_dialect(Dialect::haas)).problems(), "1:1 unknown-code; ");
}

}  // namespace test_modal_calls
}  // namespace leadscrew::gcode
