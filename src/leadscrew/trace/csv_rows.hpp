#pragma once
// Rows of a comma-separated trace.

#include <leadscrew/trace/columns.hpp>
#include <leadscrew/trace/rows.hpp>

namespace leadscrew::trace {

class CsvRows {
 public:
  /// Nothing that begins a text says that it is CSV.
  static bool recognises(std::string_view) { return false; }
  /// Reads up to and with the header line, which names the columns.
  static base::Result<CsvRows> open(Input& input, std::string file, base::AxisSet machine_axes = {});

  base::Result<std::optional<TraceRow>> next(Input& input);
  base::AxisSet axes() const { return axes_; }

 private:
  explicit CsvRows(std::string file) : file_(std::move(file)) {}

  base::Result<std::optional<std::string_view>> content(Input& input);
  base::Result<void> read_header(std::string_view text);
  base::Result<double> number(std::string_view text, std::size_t at, std::string_view field) const;
  base::Diagnostic at(std::string_view code, std::string message, std::string hint, std::size_t offset,
                      std::string_view text) const;

  std::string file_;
  std::int64_t line_ = 0;  ///< of the text
  std::vector<Column> columns_;
  std::vector<std::string> names_;
  std::optional<std::size_t> feed_column_;
  base::AxisSet axes_;
};
static_assert(Rows<CsvRows>);

}  // namespace leadscrew::trace
