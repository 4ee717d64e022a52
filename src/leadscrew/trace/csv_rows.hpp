#pragma once
// Rows of a comma-separated trace.

#include <leadscrew/trace/columns.hpp>
#include <leadscrew/trace/input.hpp>
#include <leadscrew/trace/words.hpp>

namespace leadscrew::trace {

class CsvRows {
 public:
  /// Reads up to and with the header line.
  static base::Result<CsvRows> open(Input& input, std::string file);

  base::Result<std::optional<Row>> next(Input& input);
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
  base::AxisSet axes_;
};

}  // namespace leadscrew::trace
