// Words as comma-separated rows.

#include <leadscrew/base/digits.hpp>
#include <leadscrew/trace/words.hpp>

namespace leadscrew::trace {
namespace {

constexpr std::size_t block_bytes = 64 * 1024;
constexpr std::size_t longest_row = (4 + 2 * base::axis_count) * (base::digits_room + 1);

}  // namespace

CsvWriter::CsvWriter(base::ByteSink sink, base::AxisSet axes, base::Period period, TraceKind kind)
    : sink_(std::move(sink)), axes_(axes), period_(period), kind_(kind) {
  rows_.reserve(block_bytes + longest_row);
  rows_ = "t,line,s,feed";
  for (const base::Axis axis : base::all_axes) {
    if (!axes_.contains(axis)) continue;
    rows_ += ',';
    rows_ += base::letter(axis);
  }
  for (const base::Axis axis : base::all_axes) {
    if (kind_ != TraceKind::followed || !axes_.contains(axis)) continue;
    rows_ += ",actual_";
    rows_ += base::letter(axis);
  }
  rows_ += '\n';
}

base::Result<void> CsvWriter::write(const base::Word& word, const base::AxisVector& actual) {
  if (!state_) return state_;
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
  for (const base::Axis axis : base::all_axes) {
    if (kind_ != TraceKind::followed || !axes_.contains(axis)) continue;
    *at++ = ',';
    at = base::write_digits(at, actual[base::index(axis)]);
  }
  *at++ = '\n';
  rows_.append(row, static_cast<std::size_t>(at - row));
  return rows_.size() < block_bytes ? state_ : finish();
}

base::Result<void> CsvWriter::finish() {
  if (state_ && !rows_.empty()) {
    state_ = sink_(rows_);
    rows_.clear();
  }
  return state_;
}

}  // namespace leadscrew::trace
