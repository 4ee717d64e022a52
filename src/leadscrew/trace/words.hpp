#pragma once
// Words as files: CSV for people and spreadsheets, NPY for numerical programs.
//
// Columns `t line s feed X Y Z …`: seconds, source line, path length, feed, then the machine's axes; mm, degrees,
// seconds. CSV has a header line and 17 significant digits, so that reading it back gives the same bits. NPY
// (format 1.0) is a two-dimensional little-endian float64 array, one row a word; the names of its columns stand in the
// order above.

#include <array>
#include <cstdint>
#include <leadscrew/base/axes.hpp>
#include <leadscrew/base/result.hpp>
#include <leadscrew/base/sink.hpp>
#include <leadscrew/base/time.hpp>
#include <leadscrew/base/word.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace leadscrew::trace {

/// What the rows of a trace hold.
enum class TraceKind : std::uint8_t {
  words,     ///< where the axes were to be
  followed,  ///< and where their slides were: columns actual_X, actual_Y, … after those of the words
};

/// Writes words as they come. Rows are gathered into blocks of 64 KiB before they reach the sink. Once the sink has
/// failed, every later call fails with the same diagnostic.
class CsvWriter {
 public:
  CsvWriter(base::ByteSink sink, base::AxisSet axes, base::Period period, TraceKind kind = TraceKind::words);
  /// actual: of TraceKind::followed, mm or degrees.
  base::Result<void> write(const base::Word& word, const base::AxisVector& actual = {});
  /// Writes what is still gathered.
  base::Result<void> finish();

 private:
  base::ByteSink sink_;
  base::AxisSet axes_;
  base::Period period_;
  TraceKind kind_;
  std::string rows_;
  base::Result<void> state_;
};

/// Writes words as they come. The number of rows stands in the header and is known only at the end: when finish() has
/// succeeded, the caller writes header() over the first header().size() bytes of the file. Once the sink has failed,
/// every later call fails with the same diagnostic.
class NpyWriter {
 public:
  NpyWriter(base::ByteSink sink, base::AxisSet axes, base::Period period, TraceKind kind = TraceKind::words);
  /// actual: of TraceKind::followed, mm or degrees.
  base::Result<void> write(const base::Word& word, const base::AxisVector& actual = {});
  base::Result<void> finish();
  /// The header for the rows written so far; always of the same size.
  std::string header() const;

 private:
  base::ByteSink sink_;
  base::AxisSet axes_;
  base::Period period_;
  TraceKind kind_;
  std::int64_t rows_written_ = 0;
  std::string rows_;
  base::Result<void> state_;
};

/// One row of a trace that is read back, ours or another controller's.
struct Row {
  double t = 0;                      ///< seconds
  base::AxisVector position{};       ///< mm or degrees; 0 for axes the trace does not have
  std::optional<std::int64_t> line;  ///< source line, where the trace has a column for it
};

/// Reads a trace row by row in constant memory. CSV needs a header line that names the columns `t` and at least one
/// axis letter, in any order and case, separated by commas (spaces and quotes allowed); other columns are passed over,
/// and so are blank lines and lines that begin with '#'. NPY must be what NpyWriter writes, with the machine's axes, or
/// a structured array (1-D, float64/int64 fields) with such names. Errors: `trace-header`, `trace-column`,
/// `trace-number` (with line and column), `trace-format`, and the source's own.
class TraceReader {
 public:
  /// Reads the header. `axes`: those of the machine, for NPY without names.
  static base::Result<TraceReader> open(base::ByteSource source, std::string_view file, base::AxisSet axes);

  /// The next row; nullopt at the end.
  base::Result<std::optional<Row>> next();

  base::AxisSet axes() const;  ///< axes the trace has

  ~TraceReader();
  TraceReader(TraceReader&&) noexcept;
  TraceReader& operator=(TraceReader&&) noexcept;

 private:
  class Implementation;
  explicit TraceReader(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace leadscrew::trace
