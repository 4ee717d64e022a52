#include <algorithm>
#include <leadscrew/config/file_text.hpp>

namespace leadscrew::config {

namespace {

/// Behind the string that opens at `begin`; at the end of its line, where one of a single line is not closed.
std::size_t end_of_string(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  const std::string_view triple = quote == '"' ? "\"\"\"" : "'''";
  const bool is_multiline = text.substr(begin).starts_with(triple);
  for (std::size_t i = begin + (is_multiline ? 3 : 1); i < text.size(); ++i) {
    if (text[i] == '\\' && quote == '"') {
      ++i;
    } else if (!is_multiline && (text[i] == quote || text[i] == '\n')) {
      return text[i] == quote ? i + 1 : i;
    } else if (is_multiline && text.substr(i).starts_with(triple)) {
      // Up to two quotes before the closing three are part of the string.
      std::size_t end = i + 3;
      while (end < text.size() && end < i + 5 && text[end] == quote) ++end;
      return end;
    }
  }
  return text.size();
}

}  // namespace

std::optional<std::size_t> find_deep_nesting(std::string_view text) {
  int open = 0, dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    if (c == '"' || c == '\'') {
      i = end_of_string(text, i);
      continue;
    }
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size());
      continue;
    }
    if (c == '[' || c == '{') ++open;
    if (c == ']' || c == '}') open = std::max(open - 1, 0);
    if (c == '.') {
      ++dots;
    } else if (std::string_view("[]{}=,\n").find(c) != std::string_view::npos) {
      dots = 0;
    }
    if (open > deepest_nesting || dots > deepest_nesting) return i;
    ++i;
  }
  return std::nullopt;
}

TextPosition position_of(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte);
  const std::size_t last_end = before.rfind('\n');
  const std::size_t begin = last_end == std::string_view::npos ? 0 : last_end + 1;
  return {static_cast<std::uint32_t>(std::count(before.begin(), before.end(), '\n')) + 1,
          static_cast<std::uint32_t>(byte - begin) + 1};
}

std::string line_of(std::string_view text, std::int64_t number) {
  constexpr std::size_t longest = 4096;
  for (std::int64_t line = 1; line < number; ++line) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  return std::string(text.substr(0, std::min(text.find('\n'), longest)));
}

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 64;
  if (text.size() <= longest) return std::string(text);
  std::size_t end = longest;
  const auto continues_character = [&](std::size_t at) {
    return (static_cast<unsigned char>(text[at]) & 0xc0) == 0x80;
  };
  while (end > 0 && continues_character(end)) --end;
  return std::string(text.substr(0, end)) + "…";
}

}  // namespace leadscrew::config
