#pragma once
// Rows of JSON as a table of CSV and as a structured NumPy array. Columns are the members that are texts or numbers, in the
// order in which rows have them first.

#include <leadscrew/base/sink.hpp>
#include <leadscrew/json/json.hpp>
#include <string>
#include <vector>

namespace leadscrew::sweep {

struct TableColumn {
  enum class Type { integer, number, text };

  std::string name;
  Type type = Type::integer;
  std::size_t width = 1;  ///< bytes of the longest text
};

std::vector<TableColumn> columns_of(const std::vector<json::Json>& rows);

/// What a row lacks is left empty. Errors: those of the sink.
base::Result<void> write_csv(const std::vector<TableColumn>& columns, const std::vector<json::Json>& rows,
                             const base::ByteSink& sink);
/// Format 1.0, fields `<i8`, `<f8` and `S`; what a row lacks is 0, NaN and an empty text; an integer column that some row lacks
/// is `<f8`. Errors: those of the sink.
base::Result<void> write_npy(const std::vector<TableColumn>& columns, const std::vector<json::Json>& rows,
                             const base::ByteSink& sink);

}  // namespace leadscrew::sweep
