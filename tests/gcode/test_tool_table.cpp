#include <gtest/gtest.h>

#include <leadscrew/gcode/tool_table.hpp>
#include <string>

namespace leadscrew::gcode {
namespace test_tool_table {

std::string problems(const ToolTableText& text) {
  std::string result;
  for (const base::Diagnostic& d : text.diagnostics) {
    result += std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + " " + std::string(d.code) + "; ";
  }
  return result;
}

TEST(ToolTable, ReadsToolsWithTheirOffsets) {
  const ToolTableText text = read_tool_table(
      "; remark alone\n\nT1 P2 D3.175 Z+0.511 ; 1/8 end mill \r\nt10 p0 x-1 Y2.5 a3 B4 c5 u6 v7 w8 d0\nT3", "tool.tbl");
  EXPECT_EQ(problems(text), "");
  ASSERT_EQ(text.table.tools().size(), 3u);
  EXPECT_EQ(
      text.table.tools()[0],
      (machine::Tool{.number = 1, .pocket = 2, .offset = {0, 0, 0.511}, .diameter = 3.175, .remark = "1/8 end mill"}));
  const machine::Tool* const tool = text.table.find(10);
  ASSERT_TRUE(tool);
  EXPECT_EQ(tool->offset, (base::AxisVector{-1, 2.5, 0, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(text.table.find(4), nullptr);
}

TEST(ToolTable, ReadsLatheTools) {
  const ToolTableText text = read_tool_table("T1 D-0.8 I93 J33.5 Q2\n", "tool.tbl");
  EXPECT_EQ(problems(text), "");
  EXPECT_EQ(*text.table.find(1),
            (machine::Tool{.number = 1, .diameter = -0.8, .front_angle = 93, .back_angle = 33.5, .orientation = 2}));
}

TEST(ToolTable, WithoutAToolIsAnError) {
  for (const char* const text : {"", "\n\n", "; only a remark\n", " \t\r\n"}) {
    const ToolTableText table = read_tool_table(text, "tool.tbl");
    EXPECT_EQ(problems(table), "1:1 empty-tool-table; ") << text;
    ASSERT_EQ(table.diagnostics.size(), 1u);
    EXPECT_EQ(table.diagnostics[0].severity, base::Severity::error);
    EXPECT_EQ(table.diagnostics[0].place.file, "tool.tbl");
    EXPECT_TRUE(table.table.tools().empty());
  }
}

TEST(ToolTable, ReportsEveryProblemAtItsPlace) {
  const struct {
    const char* text;
    const char* problems;
  } rows[] = {
      {"P1 Z1", "1:1 missing-word; "},     {"T1\nT2 P1\nT1 Z5", "3:1 repeated-tool; "},
      {"T0", "1:1 bad-value; "},           {"T1.5", "1:1 bad-value; "},
      {"T1 P-1", "1:4 bad-value; "},       {"T1 Q10", "1:4 bad-value; "},
      {"T1 S5", "1:4 bad-character; "},    {"T1 ?", "1:4 bad-character; "},
      {"T1 Z", "1:4 bad-number; "},        {"T1 Z1.2.3", "1:4 bad-number; "},
      {"T1 Z1 Z2", "1:7 repeated-word; "}, {"T1 S5\nT2\n\nP3", "1:4 bad-character; 4:1 missing-word; "},
  };
  for (const auto& row : rows) EXPECT_EQ(problems(read_tool_table(row.text, "tool.tbl")), row.problems) << row.text;
  EXPECT_EQ(read_tool_table("T0", "tool.tbl").diagnostics.at(0).place.file, "tool.tbl");
}

TEST(ToolTable, ReadsShapes) {
  const ToolTableText text =
      read_tool_table("T1 D10 R5 L40 H32 K50.5 Z60\nT2 D8 R0\nT3 R1 D8.0 L20\nT4 D0.333 R0.1665001\n", "tool.tbl");
  EXPECT_EQ(problems(text), "");
  ASSERT_EQ(text.table.tools().size(), 4u);
  EXPECT_EQ(text.table.tools()[0], (machine::Tool{.number = 1,
                                                  .offset = {0, 0, 60},
                                                  .diameter = 10,
                                                  .corner_radius = 5,
                                                  .length = 40,
                                                  .holder_diameter = 32,
                                                  .holder_length = 50.5}));
  EXPECT_EQ(text.table.find(2)->corner_radius, 0);
  EXPECT_EQ(text.table.find(3)->corner_radius, 1);
  EXPECT_EQ(text.table.find(3)->length, 20);
  EXPECT_EQ(text.table.find(4)->corner_radius, 0.333 / 2);
  EXPECT_EQ(read_tool_table("T1 D8", "").table.find(1)->corner_radius, std::nullopt);
}

TEST(ToolTable, ReportsShapesThatAreNone) {
  const struct {
    const char* text;
    const char* problems;
  } rows[] = {
      {"T1 R5", "1:4 missing-word; "},           {"T1 D0 R0", "1:7 missing-word; "},
      {"T1 R-1 D10", "1:4 bad-value; "},         {"T1 D10 R5.1", "1:8 bad-value; "},
      {"T1 D10 R5 L5", "1:11 bad-value; "},      {"T1 D10 L0", "1:8 bad-value; "},
      {"T1 D10 L40 H0 K9", "1:12 bad-value; "},  {"T1 D10 L40 H30", "1:12 missing-word; "},
      {"T1 D-8 R0", "1:8 missing-word; "},       {"T1 D10 L40 K30", "1:12 missing-word; "},
      {"T1 D10 H30 K50", "1:12 missing-word; "},
  };
  for (const auto& row : rows) EXPECT_EQ(problems(read_tool_table(row.text, "tool.tbl")), row.problems) << row.text;
}

TEST(ToolTable, KeepsToolsOutThatHaveAProblem) {
  EXPECT_TRUE(read_tool_table("T1 Z", "tool.tbl").table.tools().empty());
}

}  // namespace test_tool_table
}  // namespace leadscrew::gcode
