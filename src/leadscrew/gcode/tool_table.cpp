#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/block.hpp>
#include <leadscrew/gcode/expression.hpp>
#include <leadscrew/gcode/line_source.hpp>
#include <leadscrew/gcode/number.hpp>
#include <leadscrew/gcode/reporter.hpp>
#include <leadscrew/gcode/tool_table.hpp>
#include <unordered_set>
#include <utility>

namespace leadscrew::gcode {

namespace {

class ToolLine {
 public:
  explicit ToolLine(Reporter& reporter) : reporter_(reporter) {}

  // Reads one line; std::nullopt if it holds no tool, or a problem.
  std::optional<machine::Tool> read(const TextLine& line) {
    tool_ = {};
    seen_ = 0;
    const char* p = line.begin;
    for (skip_blanks(p); *p != '\n' && *p != ';'; skip_blanks(p)) {
      if (!entry(p)) return std::nullopt;
    }
    if (*p == ';') remark(p + 1, line.end);
    if (seen_ == 0) return std::nullopt;
    if (!has('T')) {
      reporter_.error("missing-word", 1, "the tool has no number", "give T");
      return std::nullopt;
    }
    if (seen_ & shape_letters) check_shape();
    return reporter_.failed() ? std::nullopt : std::optional<machine::Tool>(tool_);
  }

  std::uint32_t number_column() const { return number_column_; }

 private:
  static constexpr std::uint32_t shape_letters = letter_bit('R') | letter_bit('L') | letter_bit('H') | letter_bit('K');
  static constexpr std::uint32_t lathe_letters = letter_bit('I') | letter_bit('J') | letter_bit('Q');
  static constexpr double ball_rounding = 1e-6;  // mm; by which R of a ball may differ from D/2

  bool has(char letter) const { return seen_ & letter_bit(letter); }

  bool entry(const char*& p) {
    const std::int64_t column = reporter_.column(p);
    const char letter = upper(*p);
    constexpr std::uint32_t known =
        axis_letter_bits | shape_letters | lathe_letters | letter_bit('T') | letter_bit('P') | letter_bit('D');
    if (letter < 'A' || letter > 'Z' || !(known & letter_bit(letter))) {
      return reporter_.error("bad-character", column,
                             shown(*p) + " stands where T, P, D, R, L, H, K, I, J, Q or an axis should",
                             "T1 P1 D3.175 Z0.511 ;remark");
    }
    ++p;
    skip_blanks(p);
    const bool negative = *p == '-';
    if (negative || *p == '+') ++p;
    double value = 0;
    const char* const end = scan_decimal(p, value);
    if (end == p || !(value <= 1e9)) {
      return reporter_.error("bad-number", column, std::string("no number follows ") + letter, "a number up to 1e9");
    }
    p = end;
    if (*p != '\n' && *p != ';' && !is_blank(*p) && !(('A' <= upper(*p)) && (upper(*p) <= 'Z'))) {
      return reporter_.error("bad-number", column, "the number of " + std::string(1, letter) + " ends in " + shown(*p),
                             "digits with at most one decimal point");
    }
    if (has(letter)) {
      return reporter_.error("repeated-word", column, std::string(1, letter) + " stands in this line already", "once");
    }
    seen_ |= letter_bit(letter);
    return set(letter, negative ? -value : value, column);
  }

  bool set(char letter, double value, std::int64_t column) {
    const std::optional<int> integer = as_integer(value);
    const auto refuse = [&](const char* hint) {
      return reporter_.error("bad-value", column, std::string(1, letter) + " is " + text(value), hint);
    };
    switch (letter) {
      case 'T':
        if (!integer || *integer < 1) return refuse("the number of a tool is an integer above 0");
        tool_.number = *integer;
        number_column_ = static_cast<std::uint32_t>(column);
        return true;
      case 'P':
        if (!integer || *integer < 0) return refuse("the pocket is an integer of 0 or more");
        tool_.pocket = *integer;
        return true;
      case 'D':
        tool_.diameter = value;
        return true;
      case 'I':
        tool_.front_angle = value;
        return true;
      case 'J':
        tool_.back_angle = value;
        return true;
      case 'Q':
        if (!integer || *integer < 0 || *integer > 9) return refuse("the orientation is an integer from 0 to 9");
        tool_.orientation = *integer;
        return true;
      case 'R':
      case 'L':
      case 'H':
      case 'K':
        return set_shape(letter, value, column);
      default:
        tool_.offset[base::index(axis_of_letter(static_cast<unsigned>(letter - 'A')))] = value;
        return true;
    }
  }

  bool set_shape(char letter, double value, std::int64_t column) {
    if (value < 0 || (value == 0 && letter != 'R')) {
      return reporter_.error("bad-value", column, std::string(1, letter) + " is " + text(value),
                             letter == 'R' ? "the radius of the edge is 0 or more" : "mm, above 0");
    }
    if (letter == 'R') tool_.corner_radius = value;
    if (letter == 'L') tool_.length = value;
    if (letter == 'H') tool_.holder_diameter = value;
    if (letter == 'K') tool_.holder_length = value;
    shape_column_ = column;
    return true;
  }

  // What the letters of its shape say together; told at the last of them.
  bool check_shape() {
    if (has('H') != has('K') || (has('H') && !has('L'))) {
      return reporter_.error("missing-word", shape_column_, "a holder is told by H, K and L together",
                             "T1 D10 R5 L40 H32 K50: the tool is 40 mm long to its holder of 32 by 50 mm");
    }
    if (!has('R')) return true;
    const double radius = tool_.diameter / 2;
    if (!has('D') || radius <= 0) {
      return reporter_.error("missing-word", shape_column_, "R is of no diameter", "give D, above 0, beside R");
    }
    if (*tool_.corner_radius > radius + ball_rounding) {
      return reporter_.error("bad-value", shape_column_,
                             "R is " + text(*tool_.corner_radius) + ", and half the diameter " + text(radius),
                             "0 is flat, half the diameter a ball, between them a bull nose");
    }
    if (*tool_.corner_radius > radius - ball_rounding) tool_.corner_radius = radius;
    if (!has('L') || tool_.length > *tool_.corner_radius) return true;
    return reporter_.error("bad-value", shape_column_, "the tool is no longer than its edge is round",
                           "L is from the tip to the holder, more than R");
  }

  void remark(const char* first, const char* last) {
    while (first != last && is_blank(*first)) ++first;
    while (last != first && is_blank(last[-1])) --last;
    tool_.remark.assign(first, last);
  }

  Reporter& reporter_;
  machine::Tool tool_;
  std::uint32_t seen_ = 0;
  std::uint32_t number_column_ = 1;
  std::int64_t shape_column_ = 1;
};

}  // namespace

ToolTableText read_tool_table(std::string_view text, std::string_view file) {
  ToolTableText result;
  Reporter reporter(std::string(file), [&](const base::Diagnostic& d) { result.diagnostics.push_back(d); });
  LineSource lines(text_source(text));
  ToolLine reader(reporter);
  std::vector<machine::Tool> tools;
  std::unordered_set<int> numbers;
  for (TextLine line; !reporter.full() && lines.next(line);) {
    reporter.begin(line);
    if (line.too_long) {
      reporter.error("line-too-long", static_cast<std::int64_t>(longest_line) + 1,
                     "this line is longer than " + std::to_string(longest_line) + " bytes", "is this a tool table?");
      continue;
    }
    std::optional<machine::Tool> tool = reader.read(line);
    if (!tool) continue;
    if (!numbers.insert(tool->number).second) {
      reporter.error("repeated-tool", reader.number_column(),
                     "tool " + std::to_string(tool->number) + " stands in this table already",
                     "one line for each tool");
      continue;
    }
    tools.push_back(std::move(*tool));
  }
  if (tools.empty() && reporter.errors() == 0) {
    reporter.report(base::Severity::error, "empty-tool-table", {reporter.file(), 1, 1},
                    "there is no tool in this table", "T1 P1 D3.175 Z0.511 ;remark, a line for each tool");
  }
  result.table = machine::ToolTable(std::move(tools));
  return result;
}

}  // namespace leadscrew::gcode
