#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_macro_expressions {

double macro_value(const std::string& blocks, const std::string& text) {
  const Reading reading =
      read_well(blocks + "#100=" + text + "\nG90 G21 G53 G0 X-300\nG53 X#100\nM30\n", in_dialect(Dialect::fanuc));
  return at(reading.lines().back().end, base::Axis::X);
}

struct Row {
  const char* text;
  double value;
};

TEST(MacroExpressions, HaveTheValuesOfFanuc) {
  const Row rows[] = {
      {"1+2*3", 7},
      {"[1+2]*3", 9},
      {"-#2", 0},
      {"#[1+1]+5", 5},
      {"FIX[2.8]", 2},
      {"FIX[-2.8]", -2},
      {"FUP[2.2]", 3},
      {"FUP[-2.2]", -3},
      {"ROUND[2.5]", 3},
      {"RND[-2.5]", -3},
      {"SQR[16]", 4},
      {"BIN[37]", 25},
      {"BCD[25]", 37},
      {"ATAN[1]/[1]*2", 90},
      {"SIN[30]*2", 1},
      {"6 AND 3", 2},
      {"6 OR 3", 7},
      {"6 XOR 3", 5},
      {"1+6 AND 3", 3},
      {"7 MOD 4", 3},
      {"2 EQ 2", 1},
      {"1+1 EQ 2", 1},
      {"[2 GT 1] AND [1 LT 2]", 1},
  };
  for (const Row& row : rows) EXPECT_NEAR(macro_value("", row.text), row.value, 1e-12) << row.text;
}

TEST(MacroVariables, AreVacantBeforeTheyAreSet) {
  EXPECT_EQ(macro_value("", "#1 EQ #0"), 1);
  EXPECT_EQ(macro_value("", "#1 NE #0"), 0);
  EXPECT_EQ(macro_value("", "#1 EQ 0"), 0);
  EXPECT_EQ(macro_value("#1=0\n", "#1 EQ #0"), 0);
  EXPECT_EQ(macro_value("#1=#0\n", "#1 EQ #0"), 1);
  EXPECT_EQ(macro_value("#1=7\n#1=#0\n", "#1 EQ #0"), 1);
  EXPECT_EQ(macro_value("#2=#1\n", "#2 EQ #0"), 1);
  EXPECT_EQ(macro_value("#2=#1*5\n", "#2 EQ #0"), 0);
  EXPECT_EQ(macro_value("", "#1+5"), 5);
  EXPECT_EQ(macro_value("", "#1 GE 0"), 1);
}

TEST(MacroVariables, LeaveOutTheWordsThatTheyAreVacantIn) {
  const Reading reading = read_well("G0 X1 Y2\nX#1 Y5\nM30\n", in_dialect(Dialect::fanuc));
  EXPECT_EQ(xyz(reading.lines().back().end), (Point{1, 5, 0}));
}

TEST(MacroVariables, OfTheSystemTellModesAndPositions) {
  EXPECT_EQ(macro_value("G91 G20 G18 G0 X1\n", "[#4003 + #4006 + #4002]"), 91 + 20 + 18);
  EXPECT_EQ(macro_value("G54 G10 L2 P1 X5\nG0 X3\n", "#5021 * 10 + #5041"), 83);
  EXPECT_EQ(macro_value("#5221=12\n", "#5221"), 12);
}

TEST(MacroVariables, OfTheSystemAreToldWhereTheyAreNotRead) {
  EXPECT_EQ(read("#1=#2001\nM30\n", in_dialect(Dialect::fanuc)).problems(), "1:4 unsupported-parameter; ");
  EXPECT_EQ(read("#3007=1\nM30\n", in_dialect(Dialect::fanuc)).problems(), "1:1 unsupported-parameter; ");
  EXPECT_EQ(read("#0=1\nM30\n", in_dialect(Dialect::fanuc)).problems(), "1:1 read-only-parameter; ");
}

TEST(MacroVariables, PauseTheProgramWithAMessage) {
  std::vector<std::string> messages;
  Conditions conditions = in_dialect(Dialect::fanuc);
  conditions.options.remarks = [&](const Remark& remark) { messages.emplace_back(remark.text); };
  const Reading reading = read_well("G0 X1.\n#3006=1 (TURN THE PART)\n#3006=2\nG0 X2.\nM30\n", conditions);
  EXPECT_EQ(messages, (std::vector<std::string>{"TURN THE PART", "2"}));
  ASSERT_EQ(reading.events().size(), 3u);
  EXPECT_EQ(reading.events()[0].kind, base::Event::Kind::pause);
  EXPECT_EQ(reading.events()[1].kind, base::Event::Kind::pause);
  EXPECT_EQ(ends_along_x(reading), "1 2 ");
}

TEST(MacroVariables, OfClocksAndHoldsAreSet) {
  EXPECT_EQ(read("#3001=0 #3002=0\nM30\n", in_dialect(Dialect::fanuc)).problems(), "");
  EXPECT_EQ(read("#3003=1\n#3004=7\nM30\n", in_dialect(Dialect::fanuc)).problems(),
            "1:1 parameter-without-effect; 2:1 parameter-without-effect; ");
  EXPECT_EQ(read("#1=#3001\nM30\n", in_dialect(Dialect::fanuc)).problems(), "1:4 unsupported-parameter; ");
  // In other dialects they are numbers like others.
  EXPECT_EQ(ends_along_x(read_well("#3006=4\nG0 X#3006\nM2\n")), "4 ");
}

TEST(MacroVariables, StopTheProgramWithAnAlarm) {
  const Reading reading = read("G0 X1\n#3000=7 (TOOL BROKEN)\nG0 X2 #5000=1\nM30\n", in_dialect(Dialect::fanuc));
  EXPECT_EQ(reading.problems(), "2:1 program-alarm; ");
  EXPECT_EQ(reading.diagnostics.back().message, "the program stops here with alarm 7: TOOL BROKEN");
  EXPECT_EQ(reading.lines().size(), 1u);
}

TEST(MacroExpressions, NeedBracketsInLinuxCnc) {
  Conditions linuxcnc;
  linuxcnc.options.dialect = Dialect::linuxcnc;
  EXPECT_EQ(read("#1=#2+1\nM2\n", linuxcnc).problems(), "1:6 bad-character; ");
  EXPECT_EQ(read_well("#1=#2+1\nG0 X#1\nM2\n").lines().size(), 1u);
}

TEST(MacroExpressions, HaveNoBinaryDigitsElsewhere) {
  EXPECT_EQ(read("#1=BIN[37]\nM2\n").problems(), "1:4 bad-number; ");
}

}  // namespace test_macro_expressions
}  // namespace leadscrew::gcode
