#include <leadscrew/base/digits.hpp>
#include <leadscrew/trace/csv_writer.hpp>
#include <leadscrew/trace/named_columns.hpp>

namespace leadscrew::trace {
namespace {

constexpr std::size_t longest_row = most_columns * (base::digits_room + 1);

}  // namespace

CsvWriter::CsvWriter(base::ByteSink sink, base::AxisSet axes, base::Period period, MoreColumns columns)
    : rows_(std::move(sink), longest_row), axes_(axes), period_(period), columns_(columns) {
  std::string& header = rows_.text();
  for (const NamedColumn& column : named_columns(axes_, columns_)) {
    if (!header.empty()) header += ',';
    header += column.name;
  }
  header += '\n';
}

base::Result<void> CsvWriter::write(const base::Word& word, const BesideWord& beside) {
  if (!rows_.state()) return rows_.state();
  char row[longest_row];
  char* at = base::write_digits(row, base::seconds(word.tick, period_));
  *at++ = ',';
  at = base::write_integer(at, base::number(word.line));
  *at++ = ',';
  at = base::write_digits(at, word.path_length);
  *at++ = ',';
  at = base::write_digits(at, word.feed);
  for (const base::Axis axis : base::all_axes) {
    if (!axes_.contains(axis)) continue;
    *at++ = ',';
    at = base::write_digits(at, word.position[base::index(axis)]);
  }
  for (const SlideColumn& column : slide_columns_of(columns_)) {
    for (const base::Axis axis : base::all_axes) {
      if (!axes_.contains(axis)) continue;
      *at++ = ',';
      at = base::write_digits(at, (beside.*column.values)[base::index(axis)]);
    }
  }
  if (columns_.power) {
    *at++ = ',';
    at = base::write_digits(at, beside.power);
  }
  for (std::size_t i = 0; columns_.pose && i < beside.pose.size(); ++i) {
    *at++ = ',';
    at = base::write_digits(at, beside.pose[i]);
  }
  *at++ = '\n';
  rows_.text().append(row, static_cast<std::size_t>(at - row));
  return rows_.flush_if_full();
}

}  // namespace leadscrew::trace
