#include <cmath>
#include <numbers>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_expressions {

struct Row {
  const char* text;
  double value;
};

// The expression as an X word.
double value_of(const std::string& text) {
  const Reading reading = read_well("#1=4 #2=-2.5 #<name>=7\n#3=2\nG53 G0 X200\nG90 G0 X" + text + "\nM2\n");
  return reading.moves.empty() ? std::nan("") : at(reading.moves[reading.moves.size() - 1].end, base::Axis::X);
}

TEST(Expressions, HaveTheValuesOfTheStandard) {
  const Row rows[] = {
      {"[1+2]", 3},
      {"[1 + 2 * 3 - 4 / 5]", 6.2},
      {"[2 * 3 / 4]", 1.5},
      {"[10 - 4 - 3]", 3},
      {"[2 ** 3]", 8},
      {"[2 ** 3 ** 2]", 64},
      {"[2 * 3 ** 2]", 18},
      {"[-2 ** 2]", 4},
      {"[7 MOD 4]", 3},
      {"[-7 MOD 4]", 1},
      {"[7 MOD -4]", 3},
      {"[1 + 7 mod 4]", 4},
      {"[2 EQ 2]", 1},
      {"[2 EQ 2.0000001]", 1},
      {"[2 NE 2]", 0},
      {"[2 GT 1]", 1},
      {"[2 GT 2]", 0},
      {"[2 GE 2]", 1},
      {"[1 LT 2]", 1},
      {"[2 LT 2]", 0},
      {"[2 LE 2]", 1},
      {"[1 + 1 EQ 2]", 1},
      {"[1 LT 2 AND 2 LT 1]", 0},
      {"[1 LT 2 OR 2 LT 1]", 1},
      {"[1 XOR 1]", 0},
      {"[1 XOR 0]", 1},
      {"[5 AND 3]", 1},
      {"[1 OR 1 AND 0]", 0},
      {"[[1 + 2] * [3 + 4]]", 21},
      {"ABS[-3]", 3},
      {"ACOS[0]", 90},
      {"ASIN[1]", 90},
      {"ASIN[-0.5]", -30},
      {"ATAN[1]/[1]", 45},
      {"ATAN[1]/[-1]", 135},
      {"ATAN[-1]/[0]", -90},
      {"COS[60]", 0.5},
      {"COS[90]", 0},
      {"COS[-180]", -1},
      {"COS[720]", 1},
      {"EXP[1]", std::numbers::e},
      {"FIX[2.8]", 2},
      {"FIX[-2.8]", -3},
      {"FUP[2.2]", 3},
      {"FUP[-2.8]", -2},
      {"LN[EXP[2]]", 2},
      {"ROUND[2.5]", 3},
      {"ROUND[-2.5]", -3},
      {"ROUND[2.4]", 2},
      {"SIN[30]", 0.5},
      {"SIN[270]", -1},
      {"SIN[-90]", -1},
      {"SIN[180]", 0},
      {"SQRT[2]", std::numbers::sqrt2},
      {"TAN[45]", 1},
      {"SQRT[3**2 + 4**2]", 5},
      {"-SIN[30]", -0.5},
      {"- - 3", 3},
      {"+[4]", 4},
      {"[+3 - -4]", 7},
      {"#1", 4},
      {"-#1", -4},
      {"#[1+1]", -2.5},
      {"##3", -2.5},
      {"[#1 * #2]", -10},
      {"#<name>", 7},
      {"#< N a m E >", 7},
      {"EXISTS[#<name>]", 1},
      {"EXISTS[#<other>]", 0},
      {"EXISTS[#4]", 1},
      {"EXISTS[#99999]", 0},
      {"EXISTS[#-3]", 0},
      {"s i n [ 3 0 ]", 0.5},
      {"[ 7 m o d 4 ]", 3},
      {"[ 2 * * 3 ]", 8},
      {"1 . 5", 1.5},
      {"- 1 2 . 2 5", -12.25},
      {"+0005.50", 5.5},
      {".5", 0.5},
      {"5.", 5},
      {"[1.0 2]", 1.02},
  };
  for (const Row& row : rows) EXPECT_NEAR(value_of(row.text), row.value, 1e-12) << row.text;
}

TEST(Expressions, ExactAnglesHaveExactSines) {
  EXPECT_EQ(value_of("SIN[90]"), 1);
  EXPECT_EQ(value_of("[1 + SIN[180]]"), 1);
  EXPECT_EQ(value_of("[1 + COS[270]]"), 1);
}

TEST(Numbers, AreTheNearestDoubles) {
  EXPECT_EQ(value_of("0.1"), 0.1);
  EXPECT_EQ(value_of("123.456789"), 123.456789);
  EXPECT_EQ(value_of("9.007199254740993"), 9.007199254740993);
  EXPECT_EQ(value_of("0.30000000000000004440892098500626"), 0.30000000000000004);
  EXPECT_EQ(value_of("0.299999999999999988897769753748434596"), 0.3);
  EXPECT_EQ(value_of("100.00000000000000000000000000000000000000000000000000000000001"), 100);
}

TEST(Expressions, NestAsDeepAsAnyoneWrites) {
  std::string text;
  for (int i = 0; i < 30; ++i) text += "[1+";
  text += "1";
  for (int i = 0; i < 30; ++i) text += "]";
  EXPECT_EQ(value_of(text), 31);
}

}  // namespace test_expressions
}  // namespace leadscrew::gcode
