// Moves that another room has something against, said by the reader at their blocks.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_rejected_moves {

/// All moves of these lines are rejected; 0 stands for every line.
Reading read_rejecting(const std::string& text, std::int64_t line = 0) {
  const machine::Machine machine = nine_axes();
  const machine::ToolTable tools;
  Reading reading;
  Reader reader(text_source(text), machine, tools, {.file = "part.ngc", .block_delete = false},
                [&](const base::Diagnostic& d) { reading.diagnostics.push_back(d); });
  Move move;
  while (reader.next(move)) {
    reading.moves.push_back(move);
    if (move.kind == Move::Kind::event || (line != 0 && base::number(move.line) != line)) continue;
    reader.reject(move, base::problem("no-good", "no good", "better", {.axis = base::Axis::Y, .field = "good"}));
  }
  reading.errors = reader.errors();
  return reading;
}

TEST(RejectedMoves, AreNamedAtTheFirstWordOfTheirBlock) {
  const Reading reading = read_rejecting("G0 X1\n / (remark) N20 G1 X2 F60\n  Y3\nM2\n");
  EXPECT_EQ(reading.problems(), "1:1 no-good; 2:13 no-good; 3:3 no-good; ");
  const base::Diagnostic& last = reading.diagnostics.back();
  EXPECT_EQ(last.place.file, "part.ngc");
  EXPECT_EQ(last.source, "  Y3");
  EXPECT_EQ(last.message, "no good");
  EXPECT_EQ(last.hint, "better");
  EXPECT_EQ(reading.errors, 3);
  EXPECT_EQ(reading.moves.size(), 4u);
}

/// At their blocks, and where a curve of several lines begins.
TEST(RejectedMoves, KeepTheirSubject) {
  const Reading reading = read_rejecting("G0 X1 Y1\nG5.2 X2 Y1 F60\nX3 Y0 P3\nX9 Y9\nG5.3\nM2\n");
  ASSERT_EQ(reading.problems(), "1:1 no-good; 2:1 no-good; ");
  for (const base::Diagnostic& problem : reading.diagnostics) {
    EXPECT_EQ(problem.subject.axis, base::Axis::Y);
    EXPECT_EQ(problem.subject.field, "good");
  }
}

/// Among the errors that the reader finds itself; and none of them makes another.
TEST(RejectedMoves, StandInTheOrderOfTheText) {
  const Reading reading = read_rejecting("G0 X1\nG0 X9999\nG1 X2\nG0 Y1\nM2\n");
  EXPECT_EQ(reading.problems(), "1:1 no-good; 2:4 travel; 3:1 missing-feed; 4:1 no-good; ");
}

TEST(RejectedMoves, OfOneBlockAreNamedEach) {
  EXPECT_EQ(read_rejecting("G0 Z5\nG81 X1 Z-1 R1 F60\nM2\n", 2).problems(),
            "2:1 no-good; 2:1 no-good; 2:1 no-good; 2:1 no-good; ");
}

/// Which has been read to its last line, or to the knots behind its points.
TEST(RejectedMoves, AlongCurvesAreNamedWhereThoseBegin) {
  const std::string curve = "G0 X0 Y0\n  G5.2 X1 Y1 F60\nX2 Y0 P3\nX9 Y9\nG5.3\nG0 X0 Y0\n";
  const std::string with_knots = " G6.2 P3 K0 R2\nK0 X5\nK0 Y3\nK1\nK1\nK1\n";
  const Reading reading = read_rejecting(curve + with_knots + "G0 X1\nM2\n");
  EXPECT_EQ(reading.problems(), "2:3 no-good; 6:1 no-good; 7:2 no-good; 13:1 no-good; ");
  EXPECT_EQ(reading.diagnostics.at(0).source, "  G5.2 X1 Y1 F60");
  EXPECT_EQ(reading.diagnostics.at(2).source, " G6.2 P3 K0 R2");
  const std::string blanks(150, ' ');
  const Reading wide = read_rejecting(blanks + "G5.2 X1 Y1 F60" + blanks + "\r\nX2 Y0\nX9 Y9\nG5.3\nM2\n");
  EXPECT_EQ(wide.problems(), "1:151 no-good; ");
  EXPECT_EQ(wide.diagnostics.at(0).source.size(), 200u);
}

TEST(RejectedMoves, EndTheReadingAfterAHundred) {
  std::string text = "F60\n";
  for (int i = 0; i < 1000; ++i) text += i % 2 == 0 ? "G1 X1\n" : "G1 X[1/0]\nG0 X0\n";
  const Reading reading = read_rejecting(text);
  ASSERT_EQ(reading.diagnostics.size(), 101u);
  EXPECT_EQ(reading.diagnostics.back().code, "too-many-problems");
  EXPECT_EQ(reading.errors, 101);
}

}  // namespace test_rejected_moves
}  // namespace leadscrew::gcode
