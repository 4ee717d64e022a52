// The header of a NumPy array file is a Python literal: a dictionary of `descr` ('<f8', or a list of (name, type)
// pairs), `fortran_order` and `shape`. NumPy Enhancement Proposal 1 fixes keys and types; their order is free.

#include <leadscrew/trace/named_columns.hpp>
#include <leadscrew/trace/npy_rows.hpp>
#include <leadscrew/trace/writer.hpp>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>

namespace leadscrew::trace {
namespace {

/// Walks through the literal. Every function steps over blanks first and says whether it found what it wants.
class Literal {
 public:
  explicit Literal(std::string_view text) : rest_(text) {}

  bool symbol(char wanted) {
    blanks();
    if (!rest_.starts_with(wanted)) return false;
    rest_.remove_prefix(1);
    return true;
  }

  bool word(std::string_view wanted) {
    blanks();
    if (!rest_.starts_with(wanted)) return false;
    rest_.remove_prefix(wanted.size());
    return true;
  }

  std::optional<std::string_view> text() {
    blanks();
    if (rest_.empty() || (rest_[0] != '\'' && rest_[0] != '"')) return std::nullopt;
    const std::size_t end = rest_.find(rest_[0], 1);
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view found = rest_.substr(1, end - 1);
    rest_.remove_prefix(end + 1);
    return found;
  }

  std::optional<std::int64_t> integer() {
    blanks();
    std::int64_t value = 0;
    const auto [stopped, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    if (error != std::errc{} || value < 0) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(stopped - rest_.data()));
    return value;
  }

  bool at_end() {
    blanks();
    return rest_.empty();
  }

 private:
  void blanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\n"), rest_.size())); }

  std::string_view rest_;
};

/// The header as it stands: types as text, names empty for a plain array.
struct Header {
  struct Field {
    std::string_view name;
    std::string_view type;
  };
  std::vector<Field> fields;
  bool structured = false;
  bool fortran_order = false;
  std::vector<std::int64_t> shape;
};

bool read_type(Literal& literal, Header& header) {
  if (const auto type = literal.text()) {
    header.fields.push_back({{}, *type});
    return true;
  }
  header.structured = true;
  if (!literal.symbol('[')) return false;
  while (!literal.symbol(']')) {
    if (!literal.symbol('(')) return false;
    const auto name = literal.text();
    if (!name || !literal.symbol(',')) return false;
    const auto type = literal.text();
    if (!type || !literal.symbol(')')) return false;
    header.fields.push_back({*name, *type});
    literal.symbol(',');
  }
  return true;
}

bool read_shape(Literal& literal, Header& header) {
  if (!literal.symbol('(')) return false;
  while (!literal.symbol(')')) {
    const auto length = literal.integer();
    if (!length) return false;
    header.shape.push_back(*length);
    literal.symbol(',');
  }
  return true;
}

std::optional<Header> read_literal(std::string_view text) {
  Literal literal(text);
  Header header;
  bool has_type = false, has_order = false, has_shape = false;
  if (!literal.symbol('{')) return std::nullopt;
  while (!literal.symbol('}')) {
    const auto key = literal.text();
    if (!key || !literal.symbol(':')) return std::nullopt;
    if (*key == "descr" && !has_type) {
      has_type = read_type(literal, header);
      if (!has_type) return std::nullopt;
    } else if (*key == "fortran_order" && !has_order) {
      has_order = true;
      header.fortran_order = literal.word("True");
      if (!header.fortran_order && !literal.word("False")) return std::nullopt;
    } else if (*key == "shape" && !has_shape) {
      has_shape = read_shape(literal, header);
      if (!has_shape) return std::nullopt;
    } else {
      return std::nullopt;
    }
    literal.symbol(',');
  }
  if (!has_type || !has_order || !has_shape || !literal.at_end()) return std::nullopt;
  return header;
}

std::uint64_t little_endian(std::string_view bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

std::string letters(base::AxisSet axes) {
  std::string text;
  for (const base::Axis axis : base::all_axes) {
    if (axes.contains(axis)) (text += text.empty() ? "" : " ") += base::letter(axis);
  }
  return text;
}

}  // namespace

base::Diagnostic NpyRows::wrong(std::string_view code, std::string message, std::string hint) const {
  return problem(code, std::move(message), std::move(hint), file_);
}

base::Result<NpyRows> NpyRows::open(Input& input, std::string file, base::AxisSet axes) {
  NpyRows rows(std::move(file));
  const std::string hint = "an array file of format 1.0 or 2.0, as numpy.save writes it";
  const auto start = input.peek(12);
  if (!start) return base::failure(start.error());
  const int version = start->size() < 8 ? 0 : (*start)[6];
  const std::size_t length_bytes = version == 1 ? 2 : 4;
  if (version < 1 || version > 3 || start->size() < 8 + length_bytes) {
    return base::failure(
        rows.wrong("trace-format", "the array file has an unknown format or ends in its header", hint));
  }
  const std::uint64_t length = little_endian(start->substr(8, length_bytes));
  if (length > Input::capacity) {
    return base::failure(
        rows.wrong("trace-format", "the header of the array file is " + std::to_string(length) + " bytes long", hint));
  }
  input.skip(8 + length_bytes);
  const auto text = input.peek(length);
  if (!text) return base::failure(text.error());
  if (text->size() < length) {
    return base::failure(rows.wrong("trace-format", "the array file ends in its header", hint));
  }
  const auto header = rows.read_header(*text, axes);
  if (!header) return base::failure(header.error());
  input.skip(length);
  return rows;
}

base::Result<void> NpyRows::read_header(std::string_view text, base::AxisSet machine_axes) {
  const auto header = read_literal(text);
  if (!header) {
    return base::failure(wrong("trace-format",
                               "the header of the array file cannot be read: " + std::string(text.substr(0, 80)),
                               "a dictionary of descr, fortran_order and shape, as numpy.save writes it"));
  }
  for (const Header::Field& field : header->fields) {
    if (field.type != "<f8" && !(header->structured && field.type == "<i8")) {
      return base::failure(wrong("trace-format",
                                 "the array file holds numbers of type '" + std::string(field.type) + "'",
                                 header->structured ? "fields of type '<f8' or '<i8'" : "numbers of type '<f8'"));
    }
    fields_.push_back(
        {std::string(field.name), field.type == "<f8" ? Type::float64 : Type::int64, column_named(field.name)});
  }
  const std::size_t dimensions = header->structured ? 1 : 2;
  if (header->shape.size() != dimensions) {
    return base::failure(wrong("trace-format", "the array has " + std::to_string(header->shape.size()) + " dimensions",
                               header->structured ? "one dimension: a record for each servo period"
                                                  : "two dimensions: a row for each servo period"));
  }
  if (header->fortran_order && !header->structured) {
    return base::failure(wrong("trace-format", "the array is stored column by column",
                               "C order: numpy.ascontiguousarray before numpy.save"));
  }
  rows_ = header->shape[0];
  if (auto taken = header->structured ? take_named_columns() : take_plain_columns(header->shape[1], machine_axes);
      !taken)
    return taken;
  std::vector<std::string> names;
  for (const Field& field : fields_) names.push_back(field.name);
  feed_column_ = feed_column(names);
  return {};
}

base::Result<void> NpyRows::take_plain_columns(std::int64_t columns, base::AxisSet machine_axes) {
  fields_ = {{"t", Type::float64, {Column::Kind::time}},
             {"line", Type::float64, {Column::Kind::line}},
             {"s", Type::float64, {}},
             {"feed", Type::float64, {}}};
  for (const base::Axis axis : base::all_axes) {
    if (machine_axes.contains(axis)) {
      fields_.push_back({std::string(1, base::letter(axis)), Type::float64, {Column::Kind::axis, axis}});
    }
  }
  axes_ = machine_axes;
  const std::size_t of_words = fields_.size();
  for (const bool actual : {false, true}) {
    for (const bool power : {false, true}) {
      for (const bool pose : {false, true}) {
        const std::size_t all = named_columns(machine_axes, {actual, power, pose}).size();
        if (columns != static_cast<std::int64_t>(all)) continue;
        fields_.resize(all);  // the names of the others are of no use here
        return {};
      }
    }
  }
  return base::failure(wrong("trace-column", "the array has " + std::to_string(columns) + " columns",
                             "the " + std::to_string(of_words) + " columns t line s feed " + letters(machine_axes) +
                                 ", or a structured array that names its fields"));
}

base::Result<void> NpyRows::take_named_columns() {
  bool has_time = false;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const Column column = fields_[i].column;
    if (column.kind == Column::Kind::other) continue;
    for (std::size_t k = 0; k < i; ++k) {
      if (fields_[k].column == column) {
        return base::failure(
            wrong("trace-header", "field '" + fields_[i].name + "' is named twice", "name each field once"));
      }
    }
    has_time = has_time || column.kind == Column::Kind::time;
    if (column.kind == Column::Kind::axis) axes_.insert(column.axis);
  }
  if (has_time && !axes_.empty()) return {};
  return base::failure(wrong("trace-header", has_time ? "no field is an axis" : "no field is named t",
                             "fields named t and at least one of X Y Z A B C U V W"));
}

base::Result<double> NpyRows::value(const Field& field, const char* bytes) const {
  const std::uint64_t bits = little_endian({bytes, 8});
  const bool whole = field.type == Type::int64;
  const double found = whole ? static_cast<double>(std::bit_cast<std::int64_t>(bits)) : std::bit_cast<double>(bits);
  const bool is_line = field.column.kind == Column::Kind::line;
  const bool right =
      std::isfinite(found) && (!is_line || (std::fabs(found) <= greatest_line && std::floor(found) == found));
  if (right) return found;
  return base::failure(wrong("trace-number",
                             "row " + std::to_string(row_ + 1) + ", column " + field.name + " holds " +
                                 (is_line ? "no line number" : "no finite number"),
                             is_line ? "a whole number" : "a finite number"));
}

base::Result<std::optional<TraceRow>> NpyRows::next(Input& input) {
  const std::size_t bytes_of_row = 8 * fields_.size();
  const auto bytes = input.peek(row_ < rows_ ? bytes_of_row : 1);
  if (!bytes) return base::failure(bytes.error());
  if (row_ == rows_) {
    if (bytes->empty()) return std::nullopt;
    return base::failure(wrong("trace-format",
                               "the array file goes on behind the " + std::to_string(rows_) + " rows its header names",
                               "a file that its writer has finished"));
  }
  if (bytes->size() < bytes_of_row) {
    return base::failure(
        wrong("trace-format", "the array file ends in row " + std::to_string(row_ + 1) + " of " + std::to_string(rows_),
              "a file that its writer has finished"));
  }
  TraceRow row;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const Field& field = fields_[i];
    if (i == feed_column_) row.feed = value(field, bytes->data() + 8 * i).value_or(0);
    if (field.column.kind == Column::Kind::other) continue;
    const auto found = value(field, bytes->data() + 8 * i);
    if (!found) return base::failure(found.error());
    if (field.column.kind == Column::Kind::time) row.t = *found;
    if (field.column.kind == Column::Kind::line) row.line = static_cast<std::int64_t>(*found);
    if (field.column.kind == Column::Kind::axis) row.position[base::index(field.column.axis)] = *found;
  }
  input.skip(bytes_of_row);
  ++row_;
  return row;
}

}  // namespace leadscrew::trace
