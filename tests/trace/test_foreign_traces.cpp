#include <gtest/gtest.h>

#include <bit>
#include <leadscrew/trace/trace_reader.hpp>

#include "byte_sinks.hpp"

namespace leadscrew::trace {
namespace test_foreign_traces {

using namespace testing_support;

base::AxisSet xyz() {
  return machine::mill3().axis_set();
}

/// All rows, or what is wrong.
base::Result<std::vector<TraceRow>> read(const std::string& text, std::size_t piece = 7) {
  auto reader = TraceReader::open(from(text, piece), "log.csv", xyz());
  if (!reader) return base::failure(reader.error());
  std::vector<TraceRow> rows;
  while (true) {
    const auto row = reader->next();
    if (!row) return base::failure(row.error());
    if (!*row) return rows;
    rows.push_back(**row);
  }
}

void expect_problem(const std::string& text, std::string_view code, std::int64_t line, std::int64_t column) {
  const auto rows = read(text);
  ASSERT_FALSE(rows) << text;
  EXPECT_EQ(rows.error().code, code) << text;
  EXPECT_EQ(rows.error().place.file, "log.csv");
  EXPECT_EQ(rows.error().place.line, line) << text << rows.error().message;
  EXPECT_EQ(rows.error().place.column, column) << text << rows.error().message;
  EXPECT_FALSE(rows.error().message.empty());
  EXPECT_FALSE(rows.error().hint.empty());
}

TEST(ForeignCsv, AnyOrderCaseQuotesAndLineEnds) {
  const auto rows = read(
      "\xEF\xBB\xBF# made elsewhere\r\n\"z\" , note, T ,\"LINE\",x\r\n 1.5 ,\"a, b\", 0.001 , 12 , +2e1\r\n"
      "# between\r\n-1,,\"2\",,3\r\n\r\n   \r\n");
  ASSERT_TRUE(rows) << rows.error().message;
  ASSERT_EQ(rows->size(), 2u);
  EXPECT_EQ((*rows)[0].t, 0.001);
  EXPECT_EQ((*rows)[0].line, 12);
  EXPECT_EQ((*rows)[0].position, (base::AxisVector{20, 0, 1.5}));
  EXPECT_EQ((*rows)[1].t, 2);
  EXPECT_FALSE((*rows)[1].line.has_value());
  EXPECT_EQ((*rows)[1].position, (base::AxisVector{3, 0, -1}));
}

TEST(ForeignCsv, LastLineNeedsNoEnd) {
  const auto rows = read("t,X\n0,1\n1,2");
  ASSERT_TRUE(rows);
  EXPECT_EQ(rows->size(), 2u);
}

TEST(ForeignCsv, AxesAreThoseOfTheHeader) {
  const auto reader = TraceReader::open(from("t,c,y\n"), "log.csv", xyz());
  ASSERT_TRUE(reader);
  EXPECT_TRUE(reader->axes().contains(base::Axis::C));
  EXPECT_TRUE(reader->axes().contains(base::Axis::Y));
  EXPECT_FALSE(reader->axes().contains(base::Axis::X));
}

TEST(ForeignCsv, ProblemsOfTheHeaderHaveAPlace) {
  expect_problem("", "trace-header", 1, 1);
  expect_problem("# only\n", "trace-header", 1, 1);
  expect_problem("\n0,1,2\n", "trace-header", 2, 1);
  expect_problem("x,y\n", "trace-header", 1, 1);
  expect_problem("t,feed\n", "trace-header", 1, 1);
  expect_problem("t,X, x\n", "trace-header", 1, 6);
}

TEST(ForeignCsv, ProblemsOfRowsHaveAPlace) {
  expect_problem("t,X,Y\n0,1,2\n1,2\n", "trace-column", 3, 4);
  expect_problem("t,X\n0,1,2\n", "trace-column", 2, 5);
  expect_problem("t,X\n0, 1.2.3\n", "trace-number", 2, 4);
  expect_problem("t,X\n0,\n", "trace-number", 2, 3);
  expect_problem("t,X\n\n#\nnan,1\n", "trace-number", 4, 1);
  expect_problem("t,X\n0,1e999\n", "trace-number", 2, 3);
  expect_problem("t,X,line\n0,1,2.5\n", "trace-number", 2, 5);
  expect_problem("t,X\n0," + std::string(70000, '1') + "\n", "trace-format", 2, 1);
}

TEST(ForeignCsv, PassesOnTheSourcesProblem) {
  base::Diagnostic broken;
  broken.code = "read-error";
  int calls = 0;
  const auto source = [&](std::span<char> buffer) -> base::Result<std::size_t> {
    if (calls++ > 0) return base::failure(broken);
    const std::string_view text = "t,X\n0,1\n1,";
    std::copy(text.begin(), text.end(), buffer.begin());
    return text.size();
  };
  auto reader = TraceReader::open(source, "log.csv", xyz());
  ASSERT_TRUE(reader);
  ASSERT_TRUE(reader->next());
  const auto row = reader->next();
  ASSERT_FALSE(row);
  EXPECT_EQ(row.error().code, "read-error");
}

std::string array_file(std::string literal, const std::vector<std::uint64_t>& numbers, int version = 1) {
  literal += "\n";
  std::string bytes = "\x93NUMPY";
  bytes += static_cast<char>(version);
  bytes += '\0';
  const std::size_t length_bytes = version == 1 ? 2 : 4;
  for (std::size_t i = 0; i < length_bytes; ++i) bytes += static_cast<char>(literal.size() >> (8 * i) & 255);
  bytes += literal;
  for (const std::uint64_t number : numbers) {
    for (int i = 0; i < 8; ++i) bytes += static_cast<char>(number >> (8 * i) & 255);
  }
  return bytes;
}

std::uint64_t bits(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

TEST(ForeignNpy, StructuredArraysNameTheirFields) {
  for (const int version : {1, 2}) {
    const auto rows =
        read(array_file("{\"shape\": (2,), 'fortran_order': False, 'descr': [('T', '<f8'), ('line', '<i8'), "
                        "('y', '<f8'), ('load', '<i8')]}",
                        {bits(0.0), 4, bits(1.5), 9, bits(0.5), 5, bits(-2.5), 9}, version));
    ASSERT_TRUE(rows) << rows.error().message;
    ASSERT_EQ(rows->size(), 2u);
    EXPECT_EQ((*rows)[1].t, 0.5);
    EXPECT_EQ((*rows)[1].line, 5);
    EXPECT_EQ((*rows)[1].position[1], -2.5);
  }
}

TEST(ForeignNpy, ProblemsHaveCodes) {
  const std::string plain = "{'descr': '<f8', 'fortran_order': False, 'shape': (1, 7), }";
  const std::vector<std::uint64_t> row(7, bits(1.0));
  ASSERT_TRUE(read(array_file(plain, row)));
  const auto code = [](const std::string& file) {
    const auto rows = read(file);
    return rows ? std::string("none") : std::string(rows.error().code);
  };
  EXPECT_EQ(code(array_file(plain, row).substr(0, 60)), "trace-format");
  EXPECT_EQ(code(array_file(plain, row).substr(0, 9)), "trace-format");
  EXPECT_EQ(code(array_file(plain, std::vector(6, bits(1.0)))), "trace-format");
  EXPECT_EQ(code(array_file(plain, std::vector(8, bits(1.0)))), "trace-format");
  EXPECT_EQ(code(array_file("{'descr': '>f8', 'fortran_order': False, 'shape': (1, 7)}", row)), "trace-format");
  EXPECT_EQ(code(array_file("{'descr': '<f8', 'fortran_order': True, 'shape': (1, 7)}", row)), "trace-format");
  EXPECT_EQ(code(array_file("{'descr': '<f8', 'fortran_order': False, 'shape': (7,)}", row)), "trace-format");
  EXPECT_EQ(code(array_file("{'descr': '<f8', 'shape': (1, 7)}", row)), "trace-format");
  EXPECT_EQ(code(array_file("{'descr': [", row)), "trace-format");
  EXPECT_EQ(code(array_file(plain, row, 9)), "trace-format");
  EXPECT_EQ(code(array_file("{'descr': '<f8', 'fortran_order': False, 'shape': (1, 6)}", row)), "trace-column");
  EXPECT_EQ(code(array_file("{'descr': [('x','<f8')], 'fortran_order': False, 'shape': (1,)}", {0})), "trace-header");
  EXPECT_EQ(code(array_file("{'descr': [('t','<f8')], 'fortran_order': False, 'shape': (1,)}", {0})), "trace-header");
  EXPECT_EQ(
      code(array_file("{'descr': [('t','<f8'),('x','<f8'),('X','<f8')], 'fortran_order': False, 'shape': (0,)}", {})),
      "trace-header");
  std::vector<std::uint64_t> bad = row;
  bad[5] = 0x7ff8000000000000;
  EXPECT_EQ(code(array_file(plain, bad)), "trace-number");
  bad = row;
  bad[1] = bits(1.5);
  EXPECT_EQ(code(array_file(plain, bad)), "trace-number");
}

TEST(ForeignTraces, NoBytesBreakTheReader) {
  std::mt19937_64 random(11);
  const std::string seeds[] = {
      array_file("{'descr': '<f8', 'fortran_order': False, 'shape': (1, 7), }", std::vector(7, bits(1.0))),
      array_file("{'descr': [('t','<f8'),('x','<i8')], 'fortran_order': False, 'shape': (2,)}", {1, 2, 3, 4}),
      "t,\"X\",line\n0,1,2\n\"1\",-2e3,\n"};
  for (int i = 0; i < 60000; ++i) {
    std::string text = seeds[random() % 3];
    for (std::size_t k = random() % 4 + 1; k-- > 0;) text[random() % text.size()] = static_cast<char>(random() % 256);
    text.resize(random() % 2 ? text.size() : random() % (text.size() + 1));
    const auto rows = read(text, random() % 40 + 1);
    ASSERT_TRUE(rows || rows.error().code.starts_with("trace-")) << rows.error().code;
  }
}

}  // namespace test_foreign_traces
}  // namespace leadscrew::trace
