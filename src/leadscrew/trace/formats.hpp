#pragma once
// The formats of words: one row each, named by how file names end.

#include <leadscrew/trace/csv_rows.hpp>
#include <leadscrew/trace/csv_writer.hpp>
#include <leadscrew/trace/npy_rows.hpp>
#include <leadscrew/trace/npy_writer.hpp>
#include <tuple>

namespace leadscrew::trace {

/// Who writes and who reads files of one ending.
template <class W, class R>
  requires Writer<W> && Rows<R>
struct Format {
  using Writer = W;         ///< of words
  using Rows = R;           ///< of what was written
  std::string_view ending;  ///< in small letters
};

/// A text that none recognises is read as the first, and so is written what has no ending of these.
inline constexpr std::tuple formats{
    Format<CsvWriter, CsvRows>{".csv"},
    Format<NpyWriter, NpyRows>{".npy"},
};

}  // namespace leadscrew::trace
