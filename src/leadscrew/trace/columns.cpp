#include <leadscrew/trace/columns.hpp>

#include <algorithm>

namespace leadscrew::trace {
namespace {

char lower(char c) {
  return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool same_word(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char x, char y) { return lower(x) == lower(y); });
}

/// The part of a long line that a reader of the message needs.
std::string_view around(std::string_view text, std::int64_t column) {
  constexpr std::size_t widest = 160;
  if (text.size() <= widest) return text;
  const auto at = static_cast<std::size_t>(std::max<std::int64_t>(column - 1, 0));
  return text.substr(at < widest / 2 ? 0 : std::min(at - widest / 2, text.size()), widest);
}

}  // namespace

Column column_named(std::string_view name) {
  if (same_word(name, "t")) return {Column::Kind::time};
  if (same_word(name, "line")) return {Column::Kind::line};
  if (name.size() == 1) {
    for (const base::Axis axis : base::all_axes) {
      if (lower(name[0]) == lower(base::letter(axis))) return {Column::Kind::axis, axis};
    }
  }
  return {};
}

std::optional<std::size_t> feed_column(std::span<const std::string> names) {
  const auto feed = std::ranges::find(names, "feed");
  if (feed == names.end() || std::ranges::find(names, "s") == names.end()) return std::nullopt;
  return static_cast<std::size_t>(feed - names.begin());
}

base::Diagnostic problem(std::string_view code, std::string message, std::string hint, std::string_view file,
                         std::int64_t line, std::int64_t column, std::string_view source) {
  base::Diagnostic diagnostic;
  diagnostic.code = code;
  diagnostic.message = std::move(message);
  diagnostic.hint = std::move(hint);
  diagnostic.place = {std::string(file), line, column};
  diagnostic.source = std::string(around(source, column));
  return diagnostic;
}

}  // namespace leadscrew::trace
