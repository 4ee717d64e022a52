#include <fmt/format.h>

#include <algorithm>
#include <leadscrew/language/diagnostic_meaning.hpp>

namespace leadscrew::language {

namespace {

constexpr std::size_t line_width = 100;
constexpr std::string_view indent = "        ";
constexpr std::string_view row_mark = "| `", fence = "```", what_to_do = "*What to do:* ";

/// Cuts the text up to the next mark off the rest; all of it where there is none. The mark is dropped.
std::string_view take_until(std::string_view& rest, std::string_view mark) {
  const std::size_t end = rest.find(mark);
  const std::string_view taken = rest.substr(0, end);
  rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + mark.size());
  return taken;
}

std::string_view bare(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \n");
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(" \n") - first + 1);
}

bool is_small_letter(char c) {
  return c >= 'a' && c <= 'z';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Codes of a row of the table, `a`, `b`, and the cells behind.
struct TableRow {
  std::vector<std::string_view> codes;
  std::string_view meaning;
  std::string_view remedy;
};

TableRow row_of(std::string_view line) {
  TableRow row;
  line.remove_prefix(2);
  std::string_view names = take_until(line, " | ");
  row.meaning = take_until(line, " | ");
  row.remedy = take_until(line, " |");
  while (!names.empty()) {
    take_until(names, "`");
    if (!names.empty()) row.codes.push_back(take_until(names, "`"));
  }
  return row;
}

/// Calls with the name of each section and what it holds, and with each row of the table behind them.
template <class OfSection, class OfRow>
void walk(OfSection&& of_section, OfRow&& of_row) {
  std::string_view rest = diagnostics_md;
  take_until(rest, "\n## ");
  while (!rest.empty()) {
    std::string_view section = take_until(rest, "\n## ");
    const std::string_view name = take_until(section, "\n");
    of_section(name, section);
    while (!section.empty()) {
      const std::string_view line = take_until(section, "\n");
      if (line.starts_with(row_mark)) of_row(row_of(line));
    }
  }
}

/// Words of the text, without the marks of links, in lines behind an indent.
std::string in_lines(std::string_view text) {
  std::string lines, line;
  while (!text.empty()) {
    std::string word(take_until(text, " "));
    if (const std::size_t link = word.find("]("); link != std::string::npos && word.starts_with('[')) {
      const std::size_t end = word.find(')', link);
      word = word.substr(1, link - 1) + (end == std::string::npos ? "" : word.substr(end + 1));
    }
    if (!line.empty() && indent.size() + line.size() + 1 + word.size() > line_width) {
      lines += fmt::format("{}{}\n", indent, line);
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  return line.empty() ? lines : lines + fmt::format("{}{}\n", indent, line);
}

std::string told(std::string_view code, std::string_view meaning, std::string_view remedy) {
  std::string text = fmt::format("{}\n{}", code, in_lines(bare(meaning)));
  if (!bare(remedy).empty()) text += in_lines("What to do: " + std::string(bare(remedy)));
  return text;
}

std::string told(std::string_view code, std::string_view section) {
  std::string_view text = section;
  std::string_view paragraph = take_until(text, fence);
  const std::string_view meaning = take_until(paragraph, what_to_do);
  std::string all = told(code, meaning, take_until(paragraph, "\n\n"));
  const std::string_view kind = take_until(text, "\n");
  if (kind.find('=') != std::string_view::npos) return all;  // an example of thousands of lines
  std::string_view example = take_until(text, "\n```");
  std::string_view head = "such as";
  while (!example.empty()) {
    all += fmt::format("{:<{}}{}\n", head, indent.size(), take_until(example, "\n"));
    head = "";
  }
  return all;
}

}  // namespace

std::vector<std::string_view> diagnostic_codes() {
  std::vector<std::string_view> codes;
  walk([&](std::string_view name, std::string_view) { codes.push_back(name); },
       [&](const TableRow& row) { codes.insert(codes.end(), row.codes.begin(), row.codes.end()); });
  return codes;
}

bool looks_like_diagnostic(std::string_view text) {
  bool begins = true, has_hyphen = false;
  for (const char c : text) {
    if (begins ? !is_small_letter(c) && !(has_hyphen && is_digit(c)) : !is_small_letter(c) && !is_digit(c) && c != '-')
      return false;
    begins = c == '-';
    has_hyphen = has_hyphen || begins;
  }
  return has_hyphen && !begins;
}

std::optional<std::string> diagnostic_meaning(std::string_view code) {
  std::optional<std::string> text;
  walk(
      [&](std::string_view name, std::string_view section) {
        if (name == code) text = told(code, section);
      },
      [&](const TableRow& row) {
        if (!text && std::find(row.codes.begin(), row.codes.end(), code) != row.codes.end())
          text = told(code, row.meaning, row.remedy);
      });
  return text;
}

}  // namespace leadscrew::language
