#include <cmath>
#include <leadscrew/gcode/parameter_file.hpp>

#include "reading.hpp"

namespace leadscrew::gcode {
namespace test_parameter_file {

std::string problems_of(const std::string& text) {
  std::string result;
  for (const base::Diagnostic& d : read_parameter_file(text, "a.var").diagnostics) {
    EXPECT_EQ(d.place.file, "a.var");
    result += std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + " " + std::string(d.code) + "; ";
  }
  return result;
}

TEST(ParameterFile, HasALineForEachParameter) {
  const ParameterFileText read =
      read_parameter_file("# remark\n31\t5\nnot a number\n\n 400   6e-3 # why\n5161 -1.5\r\n5220\t2.0", "a.var");
  EXPECT_TRUE(read.diagnostics.empty());
  EXPECT_EQ(read.values, (std::vector<NumberedValue>{{31, 5}, {400, 0.006}, {5161, -1.5}, {5220, 2}}));
}

TEST(ParameterFile, IsReadBackAsItWasWritten) {
  const std::vector<NumberedValue> values = {{31, 0.1}, {5161, -1.0 / 3}, {5390, 1e-300}};
  const std::string text = parameter_file_text(values);
  EXPECT_EQ(text, "31\t0.1\n5161\t-0.3333333333333333\n5390\t1e-300\n");
  EXPECT_EQ(read_parameter_file(text, {}).values, values);
}

TEST(ParameterFile, IsToldWhatIsWrongWithIt) {
  EXPECT_EQ(problems_of("5162 0\n5161 0\n"), "2:1 bad-parameter-file; ");
  EXPECT_EQ(problems_of("31 0\n31 0\n"), "2:1 bad-parameter-file; ");
  EXPECT_EQ(problems_of("0 1\n5602 1\n"), "1:1 bad-parameter-file; 2:1 bad-parameter-file; ");
  EXPECT_EQ(problems_of("99999999999999999999 1\n"), "1:1 bad-parameter-file; ");
  EXPECT_EQ(problems_of("31.5 1\n"), "1:1 bad-parameter-file; ");
  EXPECT_EQ(problems_of("31 x\n32\n33 \n34 1 2\n35 inf\n36 1e999\n"),
            "1:4 bad-parameter-file; 2:1 bad-parameter-file; 3:4 bad-parameter-file; 4:4 bad-parameter-file; "
            "5:4 bad-parameter-file; 6:4 bad-parameter-file; ");
  EXPECT_EQ(problems_of("5161 1e10\n5220 10\n"), "1:6 bad-parameter-file; 2:6 bad-parameter-file; ");
  EXPECT_EQ(problems_of("5220 1.5\n"), "1:6 bad-parameter-file; ");
  EXPECT_EQ(problems_of(std::string(70'000, '1')), "1:65537 line-too-long; ");
}

TEST(ParameterFile, SaysWhatHoldsWhereAProgramBegins) {
  Conditions conditions;
  conditions.options.parameters = {{100, 3}, {5161, 30}, {5220, 2}, {5241, 12}};
  const Reading reading = read_well("G0 X[1+#100]\nG28\nM2\n", conditions);
  ASSERT_EQ(reading.lines().size(), 2u);
  EXPECT_EQ(at(reading.lines()[0].end, base::Axis::X), 16);
  EXPECT_EQ(at(reading.lines()[1].end, base::Axis::X), 30);
  conditions.options.parameters = {{5210, 1}, {5211, 7}};
  EXPECT_EQ(at(read_well("G0 X1\nM2\n", conditions).lines()[0].end, base::Axis::X), 8);
  conditions.options.parameters = {{5210, 0}, {5211, 7}, {5220, 0}};
  EXPECT_EQ(at(read_well("G0 X1\nM2\n", conditions).lines()[0].end, base::Axis::X), 1);
}

std::vector<NumberedValue> kept_by(std::string_view text, std::vector<NumberedValue> before = {},
                                   Dialect dialect = Dialect::leadscrew) {
  std::vector<NumberedValue> kept;
  int calls = 0;
  Conditions conditions = in_dialect(dialect);
  conditions.options.parameters = std::move(before);
  conditions.options.parameters_at_end = [&](const std::vector<NumberedValue>& values) {
    kept = values;
    ++calls;
  };
  read(text, conditions);
  EXPECT_LE(calls, 1);
  return kept;
}

double value_in(const std::vector<NumberedValue>& values, int number) {
  for (const NumberedValue& each : values) {
    if (each.number == number) return each.value;
  }
  return std::nan("");
}

TEST(ParameterFile, KeepsOffsetsAndWhatItHeldBefore) {
  const auto kept =
      kept_by("G10 L2 P2 X5\n#100=8 #200=9\nG20 G92 Y1\nG0 Y2\nG28.1\nG92.1\nM2\n", {{100, 3}, {5000, 4}});
  EXPECT_EQ(value_in(kept, 5241), 5);
  EXPECT_EQ(value_in(kept, 100), 8);
  EXPECT_EQ(value_in(kept, 5000), 4);
  EXPECT_TRUE(std::isnan(value_in(kept, 200)));
  EXPECT_NEAR(value_in(kept, 5162), 25.4, 1e-12);
  EXPECT_EQ(value_in(kept, 5210), 0);
  EXPECT_EQ(value_in(kept, 5220), 1);
  EXPECT_EQ(value_in(kept_by("#5220=2\nG0 X1\nM2\n"), 5220), 1);
  // Nine places of G28 and of G30, G92 and its nine, the system, and ten of each of nine systems; two more.
  EXPECT_EQ(kept.size(), 9u + 9 + 1 + 9 + 1 + 9 * 10 + 2);
  EXPECT_EQ(read_parameter_file(parameter_file_text(kept), {}).values, kept);
}

TEST(ParameterFile, KeepsWhatShiftsAllSystems) {
  EXPECT_EQ(value_in(kept_by("G10 L2 P0 Z7.\nM30\n", {}, Dialect::fanuc), 5203), 7);
  EXPECT_EQ(value_in(kept_by("G10 L2 P0 Z7.\nM30\n", {}, Dialect::haas), 5213), 7);
  Conditions conditions = in_dialect(Dialect::fanuc);
  conditions.options.parameters = {{5203, 7}};
  EXPECT_EQ(at(read_well("G0 Z1.\nM30\n", conditions).lines()[0].end, base::Axis::Z), 8);
}

TEST(ParameterFile, IsNotWrittenBehindAnError) {
  EXPECT_TRUE(kept_by("G10 L2 P2 X5\nG0 X$\nM2\n").empty());
  EXPECT_TRUE(kept_by("(ABORT,x)\nM2\n").empty());
  EXPECT_FALSE(kept_by("G10 L2 P2 X5\n").empty());
  EXPECT_FALSE(kept_by("%\nG10 L2 P2 X5\n%\n").empty());
}

}  // namespace test_parameter_file
}  // namespace leadscrew::gcode
