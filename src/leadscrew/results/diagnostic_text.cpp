#include <fmt/format.h>

#include <algorithm>
#include <leadscrew/results/diagnostic_text.hpp>

namespace leadscrew::results {

namespace {

constexpr std::size_t widest_excerpt = 120;
constexpr std::string_view indent = "    ";

unsigned byte_at(std::string_view text, std::size_t place) {
  return static_cast<unsigned char>(text[place]);
}

bool continues_character(unsigned byte) {
  return (byte & 0xc0) == 0x80;
}

/// Length of the UTF-8 character that begins here; 0 if none does.
std::size_t character_length(std::string_view text, std::size_t place) {
  const unsigned first = byte_at(text, place);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xc2 ? 0
                             : first < 0xe0 ? 2
                             : first < 0xf0 ? 3
                             : first < 0xf5 ? 4
                                            : 0;
  if (place + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!continues_character(byte_at(text, place + i))) return 0;
  }
  // U+0080 … U+009F are control characters as well.
  if (length == 2 && first == 0xc2 && byte_at(text, place + 1) < 0xa0) return 0;
  return length;
}

/// The part of a long line around a column (from 0), and the column in that part.
std::pair<std::string_view, std::size_t> around(std::string_view line, std::size_t column) {
  if (line.size() <= widest_excerpt) return {line, column};
  std::size_t begin = column > widest_excerpt / 2 ? column - widest_excerpt / 2 : 0;
  begin = std::min(begin, line.size() - widest_excerpt);
  while (begin < column && continues_character(byte_at(line, begin))) ++begin;
  return {line.substr(begin, widest_excerpt), column - begin};
}

/// Blanks and tabs as wide as the text.
std::string blank(std::string_view text) {
  std::string blanks;
  for (std::size_t i = 0; i < text.size();) {
    blanks += text[i] == '\t' ? '\t' : ' ';
    i += std::max<std::size_t>(1, character_length(text, i));
  }
  return blanks;
}

std::string excerpt(const base::Diagnostic& diagnostic, const Style& style) {
  std::string_view line = diagnostic.source;
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.remove_suffix(1);
  const auto column = static_cast<std::size_t>(std::max<std::int64_t>(diagnostic.place.column, 1) - 1);
  const bool has_caret = diagnostic.place.column > 0 && column <= line.size();
  const auto [part, place] = around(line, has_caret ? column : 0);
  std::string text = fmt::format("{}{}\n", indent, printable(part));
  if (has_caret) text += fmt::format("{}{}{}\n", indent, blank(part.substr(0, place)), style(Tone::good, "^"));
  return text;
}

std::string place_text(const base::Place& place) {
  if (place.file.empty()) return "leadscrew: ";
  std::string text = printable(place.file);
  if (place.line > 0) text += fmt::format(":{}", place.line);
  if (place.line > 0 && place.column > 0) text += fmt::format(":{}", place.column);
  return text + ": ";
}

Tone tone_of(base::Severity severity) {
  switch (severity) {
    case base::Severity::note:
      return Tone::note;
    case base::Severity::warning:
      return Tone::warning;
    case base::Severity::error:
      return Tone::error;
  }
  return Tone::error;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text, i);
    const bool control = (byte_at(text, i) < 0x20 && text[i] != '\t') || text[i] == 0x7f;
    if (length == 0 || control) {
      shown += '?';
      i += 1;
    } else {
      shown += text.substr(i, length);
      i += length;
    }
  }
  return shown;
}

std::string diagnostic_text(const base::Diagnostic& diagnostic, const Style& style) {
  std::string text = style(Tone::strong, place_text(diagnostic.place));
  text += style(tone_of(diagnostic.severity), fmt::format("{}:", base::name(diagnostic.severity)));
  text += fmt::format(" {}", printable(diagnostic.message));
  if (!diagnostic.code.empty()) text += style(Tone::faint, fmt::format(" [{}]", diagnostic.code));
  text += '\n';
  if (!diagnostic.source.empty()) text += excerpt(diagnostic, style);
  if (!diagnostic.hint.empty()) text += fmt::format("{}hint: {}\n", indent, printable(diagnostic.hint));
  return text;
}

}  // namespace leadscrew::results
