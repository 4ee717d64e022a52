#include <fast_float/fast_float.h>

#include <charconv>
#include <cmath>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/gcode/line_source.hpp>
#include <leadscrew/gcode/number.hpp>
#include <leadscrew/gcode/operations.hpp>
#include <leadscrew/gcode/parameter_file.hpp>
#include <leadscrew/gcode/parameters.hpp>
#include <leadscrew/gcode/reporter.hpp>

namespace leadscrew::gcode {

namespace {

constexpr double largest_offset = 1e9;  // mm or degrees, as in a program

class ParameterLine {
 public:
  explicit ParameterLine(Reporter& reporter) : reporter_(reporter) {}

  /// Adds what the line says to the values.
  bool read(const TextLine& line, std::vector<NumberedValue>& values) {
    const char* p = line.text;
    skip_blanks(p);
    if (!is_digit(*p)) return true;
    const char* const begin = p;
    NumberedValue read;
    const auto number = std::from_chars(p, line.end, read.number);
    p = number.ptr;
    if (number.ec != std::errc() || !is_blank(*p)) return refuse(begin, "a number and a value", "5161 0.5");
    skip_blanks(p);
    if (*p == '+') ++p;
    const char* const value_begin = p;
    const auto value = fast_float::from_chars(p, line.end, read.value);
    p = value.ptr;
    skip_blanks(p);
    if (value.ec != std::errc() || !std::isfinite(read.value) || (*p != '\n' && *p != '#' && *p != ';')) {
      return refuse(value_begin, "a value", "a decimal number, and nothing behind it but a remark");
    }
    if (read.number < 1 || read.number > Parameters::last) {
      return refuse(begin, "a number from 1 to " + std::to_string(Parameters::last), "there is no other parameter");
    }
    if (!values.empty() && values.back().number >= read.number) {
      return refuse(begin, "a number above that of the line before", "the numbers ascend");
    }
    if (!is_sound(read)) return refuse(value_begin, "a possible value", hint_of(read.number));
    values.push_back(read);
    return true;
  }

 private:
  static bool is_sound(const NumberedValue& read) {
    if (read.number == Parameters::current_system) return 0 <= read.value && read.value <= 9 && as_integer(read.value);
    return !Parameters::is_offset(read.number) || std::fabs(read.value) <= largest_offset;
  }

  static std::string hint_of(int number) {
    return number == Parameters::current_system ? "1 to 9 for G54 to G59.3" : "at most 1e9 in magnitude";
  }

  bool refuse(const char* at, const std::string& wanted, std::string hint) {
    return reporter_.error("bad-parameter-file", reporter_.column(at), "here should stand " + wanted, std::move(hint));
  }

  Reporter& reporter_;
};

}  // namespace

ParameterFileText read_parameter_file(std::string_view text, std::string_view file) {
  ParameterFileText result;
  Reporter reporter(std::string(file), [&](const base::Diagnostic& d) { result.diagnostics.push_back(d); });
  LineSource lines(text_source(text));
  ParameterLine reader(reporter);
  for (TextLine line; !reporter.full() && lines.next(line);) {
    reporter.begin(line);
    if (line.too_long) {
      reporter.error("line-too-long", static_cast<std::int64_t>(longest_line) + 1,
                     "this line is longer than " + std::to_string(longest_line) + " bytes",
                     "is this a parameter file?");
      continue;
    }
    reader.read(line, result.values);
  }
  if (reporter.errors() > 0) result.values.clear();
  return result;
}

std::string parameter_file_text(std::span<const NumberedValue> values) {
  std::string text;
  for (const NumberedValue& each : values) {
    text += std::to_string(each.number) + '\t' + base::text(each.value) + '\n';
  }
  return text;
}

}  // namespace leadscrew::gcode
