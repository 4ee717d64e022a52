#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <leadscrew/options/quantity.hpp>
#include <optional>

namespace leadscrew::options {

namespace {

auto wrong_quantity(std::string message) {
  return tl::unexpected<std::string>(std::move(message));
}

std::optional<base::Axis> axis_of(char letter) {
  const char upper = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  for (const base::Axis axis : base::all_axes) {
    if (base::letter(axis) == upper) return axis;
  }
  return std::nullopt;
}

/// `place`: how many values stand before this one; a number without a letter is for the axis of that place.
Parsed<AxisValue> parse_axis_value(std::string_view text, std::size_t place) {
  if (text.empty()) return wrong_quantity("an axis is missing between commas");
  if (const auto number = parse_number(text)) {
    if (place >= base::axis_count) return wrong_quantity("more values than there are axes");
    return AxisValue{base::all_axes[place], *number};
  }
  const auto axis = axis_of(text.front());
  if (!axis) return wrong_quantity(fmt::format("'{}' does not begin with an axis (X Y Z A B C U V W)", text));
  const auto value = parse_number(text.substr(1));
  if (!value) return wrong_quantity(fmt::format("'{}': {}", text, value.error()));
  return AxisValue{*axis, *value};
}

/// A time with its unit, from the first of `range` to the second; `example` and `limits` are for messages.
Parsed<std::int64_t> parse_nanoseconds(std::string_view text, std::string_view example, std::pair<double, double> range,
                                       std::string_view limits) {
  const auto unit_begin = std::find_if(text.begin(), text.end(), [](char c) {
    return std::isalpha(static_cast<unsigned char>(c)) || static_cast<unsigned char>(c) >= 0x80;
  });
  const auto digits = static_cast<std::size_t>(unit_begin - text.begin());
  const std::string_view unit = text.substr(digits);
  double nanoseconds = 0;
  if (unit == "ms")
    nanoseconds = 1e6;
  else if (unit == "us" || unit == "µs" || unit == "μs")
    nanoseconds = 1e3;
  else if (unit == "ns")
    nanoseconds = 1;
  else
    return wrong_quantity(fmt::format("needs a number and a unit, {}", example));
  const auto value = parse_number(text.substr(0, digits));
  if (!value) return wrong_quantity(fmt::format("needs a number and a unit, {}", example));
  nanoseconds *= *value;
  if (!(nanoseconds >= range.first && nanoseconds <= range.second))
    return wrong_quantity(fmt::format("lies outside {}", limits));
  const double whole = std::round(nanoseconds);
  if (std::abs(nanoseconds - whole) > 1e-6) return wrong_quantity("is not a whole number of nanoseconds");
  return static_cast<std::int64_t>(whole);
}

}  // namespace

Parsed<double> parse_number(std::string_view text) {
  const std::string_view digits = !text.empty() && text.front() == '+' ? text.substr(1) : text;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value))
    return wrong_quantity("is not a number");
  return value;
}

Parsed<std::vector<double>> parse_numbers(std::string_view text) {
  std::vector<double> numbers;
  while (true) {
    const std::size_t comma = text.find(',');
    const auto number = parse_number(text.substr(0, comma));
    if (!number) return wrong_quantity(number.error());
    numbers.push_back(*number);
    if (comma == std::string_view::npos) return numbers;
    text.remove_prefix(comma + 1);
  }
}

Parsed<base::Period> parse_period(std::string_view text) {
  const auto nanoseconds = parse_nanoseconds(text, "such as 1ms or 250us", {10e3, 20e6}, "10us to 20ms");
  if (!nanoseconds) return wrong_quantity(nanoseconds.error());
  return base::Period{*nanoseconds};
}

Parsed<std::int64_t> parse_step_time(std::string_view text) {
  return parse_nanoseconds(text, "such as 2.5us or 500ns", {0, 1e9}, "0 to 1000ms");
}

Parsed<std::int64_t> parse_frequency(std::string_view text) {
  constexpr std::string_view what = "needs a number and a unit, such as 1MHz or 250kHz";
  const auto unit_begin =
      std::find_if(text.begin(), text.end(), [](char c) { return c == 'k' || c == 'M' || c == 'H'; });
  const auto digits = static_cast<std::size_t>(unit_begin - text.begin());
  const std::string_view unit = text.substr(digits);
  const auto value = parse_number(text.substr(0, digits));
  if (!value || (!unit.empty() && unit != "Hz" && unit != "kHz" && unit != "MHz"))
    return wrong_quantity(std::string(what));
  const double hertz = *value * (unit == "kHz" ? 1e3 : unit == "MHz" ? 1e6 : 1);
  if (!(hertz >= 10e3 && hertz <= 10e6)) return wrong_quantity("lies outside 10kHz to 10MHz");
  const double whole = std::round(hertz);
  if (std::abs(hertz - whole) > 1e-6) return wrong_quantity("is no whole number of Hz");
  return static_cast<std::int64_t>(whole);
}

Parsed<double> parse_tolerance(std::string_view text) {
  auto value = parse_number(text);
  if (!value) return wrong_quantity("needs a number of millimetres, such as 0.01");
  if (*value < 0) return wrong_quantity("is below 0");
  return value;
}

Parsed<std::vector<AxisValue>> parse_axis_values(std::string_view text) {
  std::vector<AxisValue> values;
  while (true) {
    const std::size_t comma = text.find(',');
    const auto value = parse_axis_value(text.substr(0, comma), values.size());
    if (!value) return wrong_quantity(value.error());
    const bool twice =
        std::any_of(values.begin(), values.end(), [&](auto& other) { return other.first == value->first; });
    if (twice) return wrong_quantity(fmt::format("axis {} is given twice", base::letter(value->first)));
    values.push_back(*value);
    if (comma == std::string_view::npos) return values;
    text.remove_prefix(comma + 1);
  }
}

}  // namespace leadscrew::options
