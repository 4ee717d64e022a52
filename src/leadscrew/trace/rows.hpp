#pragma once
// What a format that can be read back has to offer.

#include <concepts>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/trace/input.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace leadscrew::trace {

/// One row of a trace, ours or another controller's.
struct TraceRow {
  double t = 0;                      ///< seconds
  base::AxisVector position{};       ///< mm or degrees; 0 for axes the trace does not have
  std::optional<std::int64_t> line;  ///< source line, where the trace has a column for it
  std::optional<double> feed;        ///< mm/s or degrees/s, as planned, where the trace tells it (feed_column)
};

/// Of a format that is told from others by the first bytes of a text, opened at its header and read row
/// by row. `file`: for messages. `axes`: those of the machine, for columns without names.
template <class T>
concept Rows =
    requires(T rows, const T opened, Input& input, std::string file, base::AxisSet axes, std::string_view start) {
      { T::recognises(start) } -> std::same_as<bool>;
      { T::open(input, file, axes) } -> std::same_as<base::Result<T>>;
      { rows.next(input) } -> std::same_as<base::Result<std::optional<TraceRow>>>;
      { opened.axes() } -> std::same_as<base::AxisSet>;
    };

/// That recognises() is asked about, where a text has so many.
inline constexpr std::size_t start_bytes = 6;

}  // namespace leadscrew::trace
