// Functions of the machine: the events that they become, what is checked of them, what parameters say of them
// afterwards.

#include <leadscrew/base/number_text.hpp>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_machine_functions {

using Kind = base::Event::Kind;

// X of the last line, which a program sets from a parameter.
double answer(std::string_view text) {
  const Reading reading = read_well(text);
  return reading.lines().empty() ? 0 : xyz(reading.lines().back().end).x;
}

// Of a program without errors: "M50 value=0; ", with what says more than the code.
std::string told(std::string_view text, const Conditions& conditions = {}) {
  std::string result;
  for (const base::Event& event : read_well(text, conditions).events()) {
    result += base::code_of(event);
    if (base::has_output(event.kind)) result += " output=" + std::to_string(event.output);
    if (base::has_value(event.kind)) result += " value=" + base::text(event.value, 9);
    if (base::has_q(event.kind)) result += " q=" + base::text(event.q, 9);
    result += event.waits ? " waits; " : "; ";
  }
  return result;
}

TEST(Overrides, AreKept) {
  EXPECT_EQ(answer("M50 P0\nG0 X[1 + #<_feed_override> + 10 * #<_speed_override>]\nM2\n"), 11);
  EXPECT_EQ(answer("M49\nM48\nG0 X[1 + #<_feed_override> + 10 * #<_speed_override>]\nM2\n"), 12);
  EXPECT_EQ(answer("M52\nM53 P0\nG0 X[1 + #<_adaptive_feed> + 10 * #<_feed_hold>]\nM2\n"), 2);
  EXPECT_EQ(answer("M70\nM49\nM72\nG0 X[1 + #<_feed_override>]\nM2\n"), 2);
}

TEST(Overrides, TravelWithThePath) {
  EXPECT_EQ(told("M48\nM49\nM50\nM50 P0\nM51 P1\nM51 P0\nM52\nM52 P0\nM53\nM53 P0\nM2\n"),
            "M48; M49; M50 value=1; M50 value=0; M51 value=1; M51 value=0; M52 value=1; M52 value=0; M53 value=1; "
            "M53 value=0; M2 waits; ");
}

TEST(Overrides, ComeBackWithTheModes) {
  EXPECT_EQ(told("M49\nM70\nM48\nM52\nM53 P0\nM72\nM2\n"),
            "M49; M48; M52 value=1; M53 value=0; M50 value=0; M51 value=0; M52 value=0; M53 value=1; M2 waits; ");
  EXPECT_EQ(told("M70\nM48\nM72\nM2\n"), "M48; M2 waits; ");
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

TEST(SpindleOrientation, IsWaitedFor) {
  EXPECT_EQ(told("M19 R90.5 Q1.5 P2\nM19\nM2\n"),
            "M19 output=2 value=90.5 q=1.5 waits; M19 output=0 value=0 q=0 waits; M2 waits; ");
  EXPECT_EQ(read("M19 R361\nM2\n").problems(), "1:5 bad-value; ");
  EXPECT_EQ(read("M19 Q0\nM2\n").problems(), "1:5 bad-value; ");
  EXPECT_EQ(read("M19 P3\nM2\n").problems(), "1:5 bad-value; ");
}

// LinuxCNC manual, "M66 Wait on Input": of an input that is always off.
// What rs274 of LinuxCNC 2.9 with one spindle accepts; the fraction of a number counts nothing there.
TEST(SpindleNumber, OfTheOneSpindleIsRead) {
  for (const Dialect dialect : {Dialect::leadscrew, Dialect::linuxcnc}) {
    for (const char* const block :
         {"S200 $0", "S200 $-1", "M3 $0", "M4 $-1", "M5 $0 (stop)", "M5 $-1", "M19 R10 $0", "M3 S1 $0.9",
          "M3 S1 $ [1-1]", "G96 S100 D100 $0", "G97 S100 $0", "G97 S100 M3 $0", "G33 Z-1 K1 $0", "G33.1 Z-1 K1 $0",
          "M51 P0 $0", "G18 G76 P1 Z-1 I-.1 J.1 K.3 $0", "G33 Z-1 K1\nZ-2 K1 $0", "#1=0\nM5 $#1"}) {
      EXPECT_EQ(read("G0 X20 Z5\nS100 M3\n" + std::string(block) + "\nM2\n", in_dialect(dialect)).problems(), "")
          << block;
    }
  }
  EXPECT_EQ(told("S200 M3 $0\nM5 $-1\nM2\n"), told("S200 M3\nM5\nM2\n"));
}

TEST(SpindleNumber, OfNoSpindleIsRefused) {
  const struct {
    const char* block;
    const char* problems;
  } rows[] = {{"S200 $1", "3:6 spindle-number; "},
              {"M3 $2", "3:4 spindle-number; "},
              {"M5 $-2", "3:4 spindle-number; "},
              {"M19 R10 $-1", "3:9 spindle-number; "},
              {"G96 S100 $-1", "3:10 spindle-number; "},
              {"G97 S100 M3 $-1", "3:13 spindle-number; "},
              {"G33 Z-1 K1 $-1", "3:12 spindle-number; "},
              {"G33 Z-1 K1 $1", "3:12 spindle-number; "},
              {"G18 G76 P1 Z-1 I-.1 J.1 K.3 $1", "3:29 spindle-number; "},
              {"M3 $0 S1 $0", "3:10 repeated-word; "},
              {"M3 $2000000000", "3:4 bad-value; "},
              {"G1 X1 F100 $0", "3:12 unused-word; "},
              {"$0", "3:1 unused-word; "},
              {"G95 F1 $0", "3:8 unused-word; "}};
  for (const auto& row : rows)
    EXPECT_EQ(read("G0 X20 Z5\nS100 M3\n" + std::string(row.block) + "\nM2\n").problems(), row.problems) << row.block;
  EXPECT_EQ(read("S100 M3 $0\nM2\n", in_dialect(Dialect::fanuc)).problems(), "1:9 bad-character; ");
}

TEST(Inputs, AreOff) {
  EXPECT_EQ(answer("M66 P0 L0\nG0 X[5 + #5399]\nM2\n"), 5);
  EXPECT_EQ(answer("M66 P0 L1 Q1\nG0 X[5 + #5399]\nM2\n"), 4);
  EXPECT_EQ(answer("M66 P0 L2 Q1\nG0 X[5 + #5399]\nM2\n"), 4);
  EXPECT_EQ(answer("M66 P0 L3 Q1\nG0 X[5 + #5399]\nM2\n"), 4);
  EXPECT_EQ(answer("M66 P0 L4 Q1\nG0 X[5 + #5399]\nM2\n"), 5);
  EXPECT_EQ(answer("M66 E3\nG0 X[5 + #5399]\nM2\n"), 5);
}

TEST(Inputs, AreWaitedFor) {
  EXPECT_EQ(told("M66 P0\nM66 P63 L3 Q2.5\nM66 E1 L0\nM2\n"),
            "M66 output=0 value=0 q=0 waits; M66 output=63 value=3 q=2.5 waits; M66 output=1 waits; M2 waits; ");
  EXPECT_EQ(read("M66 L0\nM2\n").problems(), "1:1 missing-word; ");
  EXPECT_EQ(read("M66 P0 E0\nM2\n").problems(), "1:1 ambiguous-word; ");
  EXPECT_EQ(read("M66 P64\nM2\n").problems(), "1:5 bad-value; ");
  EXPECT_EQ(read("M66 E0 L1 Q1\nM2\n").problems(), "1:8 bad-value; ");
  EXPECT_EQ(read("M66 P0 L5 Q1\nM2\n").problems(), "1:8 bad-value; ");
  EXPECT_EQ(read("M66 P0 L3\nM2\n").problems(), "1:1 bad-value; ");
}

TEST(BuildersFunctions, AreCalledWithPAndQ) {
  EXPECT_EQ(told("M101 P1 Q-2.5\nM199\nM100 Q3\nM2\n"),
            "M101 value=1 q=-2.5 waits; M199 value=-1 q=-1 waits; M100 value=-1 q=3 waits; M2 waits; ");
  Conditions haas;
  haas.options.dialect = Dialect::haas;
  EXPECT_EQ(told("M88\nM31\nM30\n", haas), "M88 value=-1 q=-1 waits; M31 value=-1 q=-1 waits; M2 waits; ");
}

TEST(BuildersFunctions, StandInTheTableByTheirNumbers) {
  base::Event event{Kind::user_function};
  for (const auto& [number, code] :
       {std::pair(0, "M0"), {9, "M9"}, {10, "M10"}, {99, "M99"}, {100, "M100"}, {199, "M199"}}) {
    event.output = number;
    EXPECT_EQ(base::code_of(event), code);
  }
}

}  // namespace test_machine_functions
}  // namespace leadscrew::gcode
