#pragma once
// Rows of JSON as a table of CSV and as a structured NumPy array. Columns are the members that are texts or numbers, in the
// order in which rows have them first. Rows come twice, so that none is kept: once to find the columns, once to be written.

#include <leadscrew/base/block_sink.hpp>
#include <leadscrew/json/json.hpp>
#include <map>
#include <string>
#include <vector>

namespace leadscrew::sweep {

struct TableColumn {
  enum class Type { integer, number, text };

  std::string name;
  Type type = Type::integer;
  std::size_t width = 1;  ///< bytes of the longest text
  std::int64_t rows = 0;  ///< that have it
};

class TableColumns {
 public:
  void observe(const json::Json& row);
  /// After the last row. An integer column that some row lacks is one of numbers.
  std::vector<TableColumn> columns() const;
  std::int64_t rows() const { return rows_; }

 private:
  std::vector<TableColumn> columns_;
  std::map<std::string, std::size_t, std::less<>> places_;
  std::int64_t rows_ = 0;
};

/// What a row lacks is left empty.
class CsvTable {
 public:
  CsvTable(std::vector<TableColumn> columns, base::ByteSink sink);
  /// Errors: those of the sink.
  base::Result<void> write(const json::Json& row);
  base::Result<void> finish() { return block_.flush(); }  ///< the same

 private:
  std::vector<TableColumn> columns_;
  base::BlockSink block_;
};

/// Format 1.0, fields `<i8`, `<f8` and `S`; what a row lacks is NaN and an empty text.
class NpyTable {
 public:
  NpyTable(std::vector<TableColumn> columns, std::int64_t rows, base::ByteSink sink);
  /// Errors: those of the sink.
  base::Result<void> write(const json::Json& row);
  base::Result<void> finish() { return block_.flush(); }  ///< the same

 private:
  std::vector<TableColumn> columns_;
  base::BlockSink block_;
};

}  // namespace leadscrew::sweep
