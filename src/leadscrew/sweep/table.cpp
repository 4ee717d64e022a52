#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <leadscrew/base/block_sink.hpp>
#include <leadscrew/sweep/table.hpp>
#include <limits>
#include <map>

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
std::string npy_header(const std::vector<TableColumn>& columns, std::size_t rows) {
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

std::vector<TableColumn> columns_of(const std::vector<json::Json>& rows) {
  std::vector<TableColumn> columns;
  std::map<std::string, std::pair<std::size_t, std::size_t>, std::less<>> known;  // place, and in how many rows it is
  for (const json::Json& row : rows) {
    for (const auto& [name, value] : *row.members()) {
      const bool is_text = value.text() != nullptr;
      if (!is_text && !value.number()) continue;
      auto found = known.find(name);
      if (found == known.end()) {
        found = known.emplace(name, std::pair(columns.size(), 0U)).first;
        columns.push_back({name, is_text ? Type::text : Type::integer});
      }
      ++found->second.second;
      TableColumn& column = columns[found->second.first];
      if (is_text) column.width = std::max(column.width, value.text()->size());
      if (column.type == Type::integer && !value.integer()) column.type = Type::number;
    }
  }
  for (TableColumn& column : columns) {
    if (column.type == Type::integer && known.find(column.name)->second.second < rows.size())
      column.type = Type::number;
  }
  return columns;
}

base::Result<void> write_csv(const std::vector<TableColumn>& columns, const std::vector<json::Json>& rows,
                             const base::ByteSink& sink) {
  base::BlockSink block(sink);
  for (std::size_t i = 0; i < columns.size(); ++i) block.text() += (i == 0 ? "" : ",") + columns[i].name;
  block.text() += '\n';
  for (const json::Json& row : rows) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (i > 0) block.text() += ',';
      const json::Json* const value = row.find(columns[i].name);
      if (value == nullptr || (value->text() == nullptr && !value->number())) continue;
      block.text() += value->text() != nullptr ? csv_text(*value->text()) : value->written_in_line();
    }
    block.text() += '\n';
    if (auto flushed = block.flush_if_full(); !flushed) return flushed;
  }
  return block.flush();
}

base::Result<void> write_npy(const std::vector<TableColumn>& columns, const std::vector<json::Json>& rows,
                             const base::ByteSink& sink) {
  base::BlockSink block(sink);
  block.text() += npy_header(columns, rows.size());
  for (const json::Json& row : rows) {
    for (const TableColumn& column : columns) add_value(block.text(), column, row.find(column.name));
    if (auto flushed = block.flush_if_full(); !flushed) return flushed;
  }
  return block.flush();
}

}  // namespace leadscrew::sweep
