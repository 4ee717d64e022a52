#pragma once
// Numbers with units, as they are written on the command line.

#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/time.hpp>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

namespace leadscrew::options {

/// A value, or what is wrong with the text in words that follow "--option TEXT: ".
template <class T>
using Parsed = tl::expected<T, std::string>;

/// A finite number and nothing else.
Parsed<double> parse_number(std::string_view text);

/// Numbers with commas between them, one or more.
Parsed<std::vector<double>> parse_numbers(std::string_view text);

/// 1ms, 250us, 62.5us: a whole number of nanoseconds from 10 us to 20 ms.
Parsed<base::Period> parse_period(std::string_view text);

/// 500ns, 2.5us, 1ms: a whole number of nanoseconds from 0 to 1 s.
Parsed<std::int64_t> parse_step_time(std::string_view text);

/// 10kHz … 10MHz, a whole number of Hz: 1MHz, 250kHz, 48000Hz or 48000.
Parsed<std::int64_t> parse_frequency(std::string_view text);

/// A tolerance in millimetres, 0 or more.
Parsed<double> parse_tolerance(std::string_view text);

using AxisValue = std::pair<base::Axis, double>;

/// X0,Y-1.5,A90: letters of axes with numbers.
Parsed<std::vector<AxisValue>> parse_axis_values(std::string_view text);

}  // namespace leadscrew::options
