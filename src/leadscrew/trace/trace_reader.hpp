#pragma once
// Words read back from a file of any format (formats.hpp), told by its first bytes: ours, or another controller's.

#include <leadscrew/trace/rows.hpp>
#include <memory>

namespace leadscrew::trace {

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
  base::Result<std::optional<TraceRow>> next();

  base::AxisSet axes() const;  ///< axes the trace has

  ~TraceReader();
  TraceReader(TraceReader&&) noexcept;             ///< what is moved from may only be assigned to
  TraceReader& operator=(TraceReader&&) noexcept;  ///< the same

 private:
  class Implementation;
  explicit TraceReader(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace leadscrew::trace
