#pragma once
// Words as comma-separated rows, for people and spreadsheets: a header line, and 17 significant digits, so that reading
// them back gives the same bits.

#include <leadscrew/base/block_sink.hpp>
#include <leadscrew/trace/writer.hpp>

namespace leadscrew::trace {

/// A trace::Writer.
class CsvWriter {
 public:
  /// Columns: t, line, s, feed, those of the axes, and more.
  CsvWriter(base::ByteSink sink, base::AxisSet axes, base::Period period, MoreColumns columns = {});
  /// The next word. Errors: those of the sink.
  base::Result<void> write(const base::Word& word, const BesideWord& beside = {});
  /// All words have been written. Errors: those of the sink.
  base::Result<void> finish() { return rows_.flush(); }

 private:
  base::BlockSink rows_;
  base::AxisSet axes_;
  base::Period period_;
  MoreColumns columns_;
};
static_assert(Writer<CsvWriter>);

}  // namespace leadscrew::trace
