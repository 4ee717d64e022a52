#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <leadscrew/sweep/table.hpp>
#include <limits>

namespace leadscrew::sweep {

namespace {

using Type = TableColumn::Type;

/// As RFC 4180 quotes it.
std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string type_text(const TableColumn& column) {
  if (column.type == Type::text) return fmt::format("|S{}", column.width);
  return column.type == Type::integer ? "<i8" : "<f8";
}

void add_little_endian(std::string& bytes, std::uint64_t bits) {
  for (int byte = 0; byte < 8; ++byte) bytes += static_cast<char>(bits >> (8 * byte) & 0xff);
}

void add_value(std::string& bytes, const TableColumn& column, const json::Json* value) {
  if (column.type == Type::text) {
    std::string text = value != nullptr && value->text() != nullptr ? *value->text() : "";
    text.resize(column.width, '\0');
    bytes += text;
  } else if (column.type == Type::integer) {
    const auto whole = value == nullptr ? std::nullopt : value->integer();
    add_little_endian(bytes, static_cast<std::uint64_t>(whole.value_or(0)));
  } else {
    const auto number = value == nullptr ? std::nullopt : value->number();
    add_little_endian(bytes, std::bit_cast<std::uint64_t>(number.value_or(std::numeric_limits<double>::quiet_NaN())));
  }
}

/// With the padding that the format asks for.
std::string npy_header(const std::vector<TableColumn>& columns, std::int64_t rows) {
  std::string fields;
  for (const TableColumn& column : columns) fields += fmt::format("('{}', '{}'), ", column.name, type_text(column));
  std::string text = fmt::format("{{'descr': [{}], 'fortran_order': False, 'shape': ({},), }}", fields, rows);
  constexpr std::size_t before = 10, alignment = 64;
  const std::size_t total = (before + text.size() + 1 + alignment - 1) / alignment * alignment;
  text.resize(total - before - 1, ' ');
  text += '\n';
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(text.size() & 0xff);
  header += static_cast<char>(text.size() >> 8 & 0xff);
  return header + text;
}

}  // namespace

void TableColumns::observe(const json::Json& row) {
  ++rows_;
  for (const auto& [name, value] : *row.members()) {
    const bool is_text = value.text() != nullptr;
    if (!is_text && !value.number()) continue;
    auto found = places_.find(name);
    if (found == places_.end()) {
      found = places_.emplace(name, columns_.size()).first;
      columns_.push_back({name, is_text ? Type::text : Type::integer});
    }
    TableColumn& column = columns_[found->second];
    ++column.rows;
    if (is_text) column.width = std::max(column.width, value.text()->size());
    if (column.type == Type::integer && !value.integer()) column.type = Type::number;
  }
}

std::vector<TableColumn> TableColumns::columns() const {
  std::vector<TableColumn> columns = columns_;
  for (TableColumn& column : columns) {
    if (column.type == Type::integer && column.rows < rows_) column.type = Type::number;
  }
  return columns;
}

CsvTable::CsvTable(std::vector<TableColumn> columns, base::ByteSink sink)
    : columns_(std::move(columns)), block_(std::move(sink)) {
  for (std::size_t i = 0; i < columns_.size(); ++i) block_.text() += (i == 0 ? "" : ",") + columns_[i].name;
  block_.text() += '\n';
}

base::Result<void> CsvTable::write(const json::Json& row) {
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (i > 0) block_.text() += ',';
    const json::Json* const value = row.find(columns_[i].name);
    if (value == nullptr || (value->text() == nullptr && !value->number())) continue;
    block_.text() += value->text() != nullptr ? csv_text(*value->text()) : value->written_in_line();
  }
  block_.text() += '\n';
  return block_.flush_if_full();
}

NpyTable::NpyTable(std::vector<TableColumn> columns, std::int64_t rows, base::ByteSink sink)
    : columns_(std::move(columns)), block_(std::move(sink)) {
  block_.text() += npy_header(columns_, rows);
}

base::Result<void> NpyTable::write(const json::Json& row) {
  for (const TableColumn& column : columns_) add_value(block_.text(), column, row.find(column.name));
  return block_.flush_if_full();
}

}  // namespace leadscrew::sweep
