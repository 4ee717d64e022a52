// Magic, version 1.0, length of the header, the header as a Python literal, then the
// numbers. Format: NumPy Enhancement Proposal 1, and numpy/lib/format.py.

#include <leadscrew/trace/npy_writer.hpp>

#include <bit>
#include <cstring>

namespace leadscrew::trace {
namespace {

constexpr std::size_t header_bytes = 128;  // a multiple of 64 that has room for any number of rows

void append_little_endian(std::string& bytes, double value) {
  auto bits = std::bit_cast<std::uint64_t>(value);
  char text[8];
  if constexpr (std::endian::native == std::endian::little) {
    std::memcpy(text, &bits, sizeof text);
  } else {
    for (char& byte : text) {
      byte = static_cast<char>(bits & 0xff);
      bits >>= 8;
    }
  }
  bytes.append(text, sizeof text);
}

int column_count(base::AxisSet axes, const MoreColumns& columns) {
  return 4 + axes.size() * (1 + static_cast<int>(slide_columns_of(columns).size())) + (columns.power ? 1 : 0) +
         (columns.pose ? static_cast<int>(pose_columns.size()) : 0);
}

}  // namespace

NpyWriter::NpyWriter(base::ByteSink sink, base::AxisSet axes, base::Period period, MoreColumns columns)
    : rows_(std::move(sink), 8 * most_columns), axes_(axes), period_(period), columns_(columns) {
  rows_.text() = header();
}

std::string NpyWriter::header() const {
  std::string text("\x93NUMPY\x01\x00", 8);
  text += static_cast<char>(header_bytes - 10);
  text += '\0';
  text += "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(rows_written_) + ", " +
          std::to_string(column_count(axes_, columns_)) + "), }";
  text.resize(header_bytes - 1, ' ');
  text += '\n';
  return text;
}

base::Result<void> NpyWriter::write(const base::Word& word, const BesideWord& beside) {
  if (!rows_.state()) return rows_.state();
  std::string& rows = rows_.text();
  append_little_endian(rows, base::seconds(word.tick, period_));
  append_little_endian(rows, static_cast<double>(base::number(word.line)));
  append_little_endian(rows, word.path_length);
  append_little_endian(rows, word.feed);
  for (const base::Axis axis : base::all_axes) {
    if (axes_.contains(axis)) append_little_endian(rows, word.position[base::index(axis)]);
  }
  for (const SlideColumn& column : slide_columns_of(columns_)) {
    for (const base::Axis axis : base::all_axes) {
      if (axes_.contains(axis)) append_little_endian(rows, (beside.*column.values)[base::index(axis)]);
    }
  }
  if (columns_.power) append_little_endian(rows, beside.power);
  for (std::size_t i = 0; columns_.pose && i < beside.pose.size(); ++i) append_little_endian(rows, beside.pose[i]);
  ++rows_written_;
  return rows_.flush_if_full();
}

}  // namespace leadscrew::trace
