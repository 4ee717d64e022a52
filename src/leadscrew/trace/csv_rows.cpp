#include <leadscrew/trace/csv_rows.hpp>

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cmath>

namespace leadscrew::trace {
namespace {

constexpr std::string_view blanks = " \t";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return text.substr(0, 0);
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// Splits a line at its commas, one field a call. Quotes around a field are taken off; a comma inside them does not
/// split.
class Fields {
 public:
  explicit Fields(std::string_view text) : text_(text) {}

  bool next() {
    if (ended_) return false;
    std::size_t end = text_.find(',', begin_);
    const std::size_t quote = text_.find_first_not_of(blanks, begin_);
    if (quote != std::string_view::npos && text_[quote] == '"') {
      const std::size_t closing = text_.find('"', quote + 1);
      if (closing != std::string_view::npos) end = text_.find(',', closing);
    }
    ended_ = end == std::string_view::npos;
    if (ended_) end = text_.size();
    field_ = trimmed(text_.substr(begin_, end - begin_));
    offset_ = field_.empty() ? begin_ : static_cast<std::size_t>(field_.data() - text_.data());
    if (field_.size() >= 2 && field_.front() == '"' && field_.back() == '"') {
      field_ = trimmed(field_.substr(1, field_.size() - 2));
    }
    begin_ = end + 1;
    return true;
  }

  std::string_view field() const { return field_; }
  std::size_t offset() const { return offset_; }  ///< of the field's first byte, or of where it should be

 private:
  std::string_view text_;
  std::string_view field_;
  std::size_t begin_ = 0;
  std::size_t offset_ = 0;
  bool ended_ = false;
};

std::string quoted(std::string_view text) {
  constexpr std::size_t widest = 40;
  return "'" + std::string(text.substr(0, widest)) + (text.size() > widest ? "…'" : "'");
}

}  // namespace

base::Diagnostic CsvRows::at(std::string_view code, std::string message, std::string hint, std::size_t offset,
                             std::string_view text) const {
  return problem(code, std::move(message), std::move(hint), file_, line_, static_cast<std::int64_t>(offset) + 1, text);
}

/// The next line that is neither blank nor a comment.
base::Result<std::optional<std::string_view>> CsvRows::content(Input& input) {
  while (true) {
    const auto line = input.line();
    if (!line) return base::failure(line.error());
    if (!*line) return std::nullopt;
    ++line_;
    const std::string_view text = (*line)->text;
    if (!(*line)->complete) {
      return base::failure(at("trace-format", "a line is longer than " + std::to_string(Input::capacity) + " bytes",
                              "a CSV trace has one short line for each servo period", 0, text));
    }
    const std::string_view inner = trimmed(text);
    if (!inner.empty() && inner.front() != '#') return text;
  }
}

base::Result<CsvRows> CsvRows::open(Input& input, std::string file, base::AxisSet) {
  const auto mark = input.peek(3);
  if (!mark) return base::failure(mark.error());
  if (*mark == "\xEF\xBB\xBF") input.skip(3);

  CsvRows rows(std::move(file));
  const auto text = rows.content(input);
  if (!text) return base::failure(text.error());
  if (!*text) {
    return base::failure(problem("trace-header", "the trace is empty",
                                 "a header line such as t,line,s,feed,X,Y,Z and one row for each servo period",
                                 rows.file_, std::max<std::int64_t>(rows.line_, 1), 1));
  }
  const auto header = rows.read_header(**text);
  if (!header) return base::failure(header.error());
  return rows;
}

base::Result<void> CsvRows::read_header(std::string_view text) {
  bool has_time = false;
  Fields fields(text);
  while (fields.next()) {
    const Column column = column_named(fields.field());
    if (column.kind != Column::Kind::other && std::ranges::find(columns_, column) != columns_.end()) {
      return base::failure(at("trace-header", "column " + quoted(fields.field()) + " is named twice",
                              "name each column once", fields.offset(), text));
    }
    columns_.push_back(column);
    names_.emplace_back(fields.field());
    has_time = has_time || column.kind == Column::Kind::time;
    if (column.kind == Column::Kind::axis) axes_.insert(column.axis);
  }
  feed_column_ = feed_column(names_);
  if (!has_time) {
    return base::failure(at("trace-header", "the header line has no column t",
                            "name the columns in the first line, separated by commas, such as t,X,Y,Z; t is in seconds",
                            0, text));
  }
  if (axes_.empty()) {
    return base::failure(at("trace-header", "the header line names no axis",
                            "name at least one of X Y Z A B C U V W, such as t,X,Y,Z", 0, text));
  }
  return {};
}

base::Result<double> CsvRows::number(std::string_view text, std::size_t offset, std::string_view field) const {
  const char* begin = field.data();
  const char* const end = begin + field.size();
  if (field.size() > 1 && field[0] == '+' && field[1] != '-') ++begin;
  double value = 0;
  const auto [stopped, error] = fast_float::from_chars(begin, end, value);
  if (error == std::errc{} && stopped == end && std::isfinite(value)) return value;
  return base::failure(
      at("trace-number", field.empty() ? std::string("a number is missing") : quoted(field) + " is not a finite number",
         "decimal numbers such as 12.5 or -3e-4", offset, text));
}

base::Result<std::optional<TraceRow>> CsvRows::next(Input& input) {
  const auto content_line = content(input);
  if (!content_line) return base::failure(content_line.error());
  if (!*content_line) return std::nullopt;
  const std::string_view text = **content_line;

  TraceRow row;
  std::size_t count = 0;
  Fields fields(text);
  for (; fields.next(); ++count) {
    const std::string_view field = fields.field();
    if (count >= columns_.size()) {
      if (field.empty()) continue;
      return base::failure(at("trace-column", "the row has more values than the header names columns",
                              "the header names " + std::to_string(columns_.size()) + " columns", fields.offset(),
                              text));
    }
    const Column column = columns_[count];
    if (count == feed_column_) row.feed = number(text, fields.offset(), field).value_or(0);
    if (column.kind == Column::Kind::other || (column.kind == Column::Kind::line && field.empty())) continue;
    const auto value = number(text, fields.offset(), field);
    if (!value) return base::failure(value.error());
    if (column.kind == Column::Kind::time) row.t = *value;
    if (column.kind == Column::Kind::axis) row.position[base::index(column.axis)] = *value;
    if (column.kind == Column::Kind::line) {
      if (std::fabs(*value) > greatest_line || std::floor(*value) != *value) {
        return base::failure(at("trace-number", quoted(field) + " is not a line number", "a whole number such as 12",
                                fields.offset(), text));
      }
      row.line = static_cast<std::int64_t>(*value);
    }
  }
  if (count < columns_.size()) {
    return base::failure(at("trace-column",
                            "the row ends before column " + quoted(names_[count]) + ": it has " +
                                std::to_string(count) + " of " + std::to_string(columns_.size()) + " values",
                            "one value for each column of the header", text.size(), text));
  }
  return row;
}

}  // namespace leadscrew::trace
