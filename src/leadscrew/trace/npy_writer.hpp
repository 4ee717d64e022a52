#pragma once
// Words as a NumPy array file (format 1.0), for numerical programs: a two-dimensional little-endian float64 array, one
// row a word. The number of rows stands in the header and is known only at the end. What the columns are, a side file says
// (files::WordFile).

#include <leadscrew/base/block_sink.hpp>
#include <leadscrew/trace/writer.hpp>

namespace leadscrew::trace {

/// A trace::HeaderLast.
class NpyWriter {
 public:
  static constexpr bool is_nameless = true;  ///< has no names of its columns

  /// Columns: t, line, s, feed, those of the axes, and more.
  NpyWriter(base::ByteSink sink, base::AxisSet axes, base::Period period, MoreColumns columns = {});
  /// The next word. Errors: those of the sink.
  base::Result<void> write(const base::Word& word, const BesideWord& beside = {});
  /// All words have been written. Errors: those of the sink.
  base::Result<void> finish() { return rows_.flush(); }
  /// For the rows written so far; always of the same size.
  std::string header() const;

 private:
  base::BlockSink rows_;
  base::AxisSet axes_;
  base::Period period_;
  MoreColumns columns_;
  std::int64_t rows_written_ = 0;
};
static_assert(HeaderLast<NpyWriter> && Nameless<NpyWriter>);

}  // namespace leadscrew::trace
