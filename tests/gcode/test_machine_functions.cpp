// Functions of the machine that no event carries: what is checked of them, what parameters say of them afterwards.

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_machine_functions {

// X of the last line, which a program sets from a parameter.
double answer(std::string_view text) {
  const Reading reading = read(text);
  EXPECT_EQ(reading.errors, 0) << text;
  return reading.lines().empty() ? 0 : xyz(reading.lines().back().end).x;
}

TEST(Overrides, AreKeptAndSaidOnce) {
  EXPECT_EQ(answer("M50 P0\nG0 X[1 + #<_feed_override> + 10 * #<_speed_override>]\nM2\n"), 11);
  EXPECT_EQ(answer("M49\nM48\nG0 X[1 + #<_feed_override> + 10 * #<_speed_override>]\nM2\n"), 12);
  EXPECT_EQ(answer("M52\nM53 P0\nG0 X[1 + #<_adaptive_feed> + 10 * #<_feed_hold>]\nM2\n"), 2);
  EXPECT_EQ(answer("M70\nM49\nM72\nG0 X[1 + #<_feed_override>]\nM2\n"), 2);
  EXPECT_EQ(read("M49\nM49\nM48\nM2\n").problems(), "1:1 machine-not-told; ");
}

TEST(ToolNumber, IsSetWithoutAChange) {
  EXPECT_EQ(answer("M61 Q7\nG0 X#<_current_tool>\nM2\n"), 7);
  EXPECT_EQ(read("M61 Q7\nM2\n").events().size(), 1u);
  EXPECT_EQ(read("M61 Q-1\nM2\n").problems(), "1:5 bad-value; ");
  EXPECT_EQ(read("M61\nM2\n").problems(), "1:1 missing-word; ");
  Conditions conditions;
  machine::Tool tool;
  tool.number = 1;
  conditions.tools = machine::ToolTable({tool});
  EXPECT_EQ(read("M61 Q7\nM2\n", conditions).problems(), "1:5 unknown-tool; ");
}

TEST(SpindleOrientation, IsChecked) {
  EXPECT_EQ(read("M19 R90 Q1 P2\nM19\nM2\n").problems(), "1:1 machine-not-told; ");
  EXPECT_EQ(read("M19 R361\nM2\n").problems(), "1:5 bad-value; ");
  EXPECT_EQ(read("M19 Q0\nM2\n").problems(), "1:5 bad-value; ");
  EXPECT_EQ(read("M19 P3\nM2\n").problems(), "1:5 bad-value; ");
}

TEST(Inputs, AreOff) {
  EXPECT_EQ(answer("M66 P0 L0\nG0 X[5 + #5399]\nM2\n"), 5);
  EXPECT_EQ(answer("M66 P0 L3 Q1\nG0 X[5 + #5399]\nM2\n"), 4);
  EXPECT_EQ(answer("M66 P0 L4 Q1\nG0 X[5 + #5399]\nM2\n"), 5);
  EXPECT_EQ(read("M66 L0\nM2\n").problems(), "1:1 missing-word; ");
  EXPECT_EQ(read("M66 P0 E0\nM2\n").problems(), "1:1 ambiguous-word; ");
  EXPECT_EQ(read("M66 P64\nM2\n").problems(), "1:5 bad-value; ");
  EXPECT_EQ(read("M66 E0 L1 Q1\nM2\n").problems(), "1:8 bad-value; ");
  EXPECT_EQ(read("M66 P0 L5 Q1\nM2\n").problems(), "1:8 bad-value; ");
  EXPECT_EQ(read("M66 P0 L3\nM2\n").problems(), "1:1 bad-value; ");
}

TEST(BuildersFunctions, AreSaidOnceEach) {
  EXPECT_EQ(read("M101 P1 Q2\nM101\nM199\nM2\n").problems(), "1:1 machine-not-told; 3:1 machine-not-told; ");
  Conditions haas;
  haas.options.dialect = Dialect::haas;
  EXPECT_EQ(read("M88\nM31\nM89\nM88\nM30\n", haas).problems(),
            "1:1 machine-not-told; 2:1 machine-not-told; 3:1 machine-not-told; ");
}

}  // namespace test_machine_functions
}  // namespace leadscrew::gcode
