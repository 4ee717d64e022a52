#include <algorithm>
#include <leadscrew/results/program_json.hpp>
#include <leadscrew/results/studies.hpp>
#include <leadscrew/study/studies.hpp>

namespace leadscrew::results {

namespace {

constexpr std::string_view schema = "leadscrew.study/2";

/// Characters of a UTF-8 text, each one column wide.
std::size_t columns(std::string_view text) {
  const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; };
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), begins));
}

std::string blanks(std::size_t wanted, std::size_t taken) {
  return std::string(wanted > taken ? wanted - taken : 0, ' ');
}
std::string left(std::string_view text, std::size_t width) {
  return std::string(text) + blanks(width, columns(text));
}
std::string right(std::string_view text, std::size_t width) {
  return blanks(width, columns(text)) + std::string(text);
}

/// Breaks at blanks so that no line is longer than the width, if its words allow.
std::vector<std::string> wrapped(std::string_view text, std::size_t width) {
  std::vector<std::string> lines(1);
  while (!text.empty()) {
    const std::size_t blank = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, blank);
    text.remove_prefix(std::min(blank + 1, text.size()));
    const bool fits = columns(lines.back()) + 1 + columns(word) <= width;
    if (lines.back().empty()) {
      lines.back() = word;
    } else if (fits) {
      lines.back().append(" ").append(word);
    } else {
      lines.emplace_back(word);
    }
  }
  return lines;
}

Tone tone_of(study::Verdict verdict) {
  switch (verdict) {
    case study::Verdict::exact:
    case study::Verdict::reproduced:
    case study::Verdict::no_worse:
    case study::Verdict::kept:
      return Tone::good;
    case study::Verdict::differs:
    case study::Verdict::worse:
    case study::Verdict::not_run:
      return Tone::warning;
    case study::Verdict::exceeded:
      return Tone::error;
    case study::Verdict::fitted:
    case study::Verdict::measured:
    case study::Verdict::not_reproducible:
      return Tone::faint;
  }
  return Tone::faint;
}

std::string figure(const std::optional<double>& value, const study::Scale& scale) {
  return value ? study::decimal(*value, scale.decimals) : std::string("-");
}

/// The texts of a row's columns; what and why are the outer ones.
struct Cells {
  std::string what, published, expected, ours;
  std::string_view unit, verdict;
  std::string why;
};

std::optional<double> value_of(const std::optional<study::Published>& published) {
  return published ? std::optional(published->value) : std::nullopt;
}

/// The source before what else is to be said.
std::string why_of(const study::Row& row) {
  if (!row.published) return row.why;
  const study::Source& source = row.published->source;
  const std::string text = std::string(study::citation(source.paper).authors) + ", " + std::string(source.where);
  return row.why.empty() ? text : text + ": " + row.why;
}

Cells cells_of(const study::Row& row) {
  return {row.what,
          figure(value_of(row.published), row.scale),
          figure(row.expected, row.scale),
          figure(row.ours, row.scale),
          row.scale.unit,
          study::name(row.verdict),
          why_of(row)};
}

struct Widths {
  std::size_t what = 4, published = 9, expected = 8, ours = 4, unit = 0, verdict = 7;

  void fit(const Cells& cells) {
    what = std::max(what, columns(cells.what));
    published = std::max(published, columns(cells.published));
    expected = std::max(expected, columns(cells.expected));
    ours = std::max(ours, columns(cells.ours));
    unit = std::max(unit, columns(cells.unit));
    verdict = std::max(verdict, columns(cells.verdict));
  }
  /// Column in which `why` begins.
  std::size_t before_why() const {
    return 2 + what + 2 + published + 2 + expected + 2 + ours + 1 + unit + 2 + verdict + 2;
  }
};

std::string without_end_blanks(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

std::string heading(const Widths& widths, const Style& style) {
  const std::string line = "  " + left("what", widths.what) + "  " + right("published", widths.published) + "  " +
                           right("expected", widths.expected) + "  " + right("ours", widths.ours) +
                           blanks(widths.unit + 1, 0) + "  " + left("verdict", widths.verdict) + "  why";
  return style(Tone::faint, line) + "\n";
}

/// `why` beside the other columns where a terminal leaves room for it, else below.
std::string why_lines(std::string_view why, const Widths& widths, std::optional<int> width, const Style& style) {
  constexpr std::size_t narrowest = 24, below = 6;
  const std::size_t all = width ? static_cast<std::size_t>(*width) : widths.before_why() + columns(why) + narrowest;
  const bool beside = all >= widths.before_why() + narrowest;
  const std::size_t indent = beside ? widths.before_why() : below;
  std::string text;
  for (const std::string& line : wrapped(why, all > indent ? all - indent : narrowest)) {
    const bool first = text.empty() && beside;
    text += (first ? std::string() : "\n" + std::string(indent, ' ')) + style(Tone::faint, line);
  }
  return text;
}

std::string line_of(const study::Row& row, const Widths& widths, std::optional<int> width, const Style& style) {
  const Cells cells = cells_of(row);
  const std::string figures = "  " + left(cells.what, widths.what) + "  " + right(cells.published, widths.published) +
                              "  " + right(cells.expected, widths.expected) + "  " + right(cells.ours, widths.ours) +
                              " " + left(cells.unit, widths.unit) + "  ";
  const std::string verdict = style(tone_of(row.verdict), cells.verdict);
  if (cells.why.empty()) return figures + verdict + "\n";
  return without_end_blanks(figures + verdict + blanks(widths.verdict + 2, columns(cells.verdict)) +
                            why_lines(cells.why, widths, width, style)) +
         "\n";
}

Json json_of(const study::Source& source) {
  const study::Citation citation = study::citation(source.paper);
  return Json::object(
      {{"paper", std::string(citation.authors) + ", " + std::string(citation.title)}, {"where", source.where}});
}

Json json_of(const study::Row& row) {
  return Json::object({{"what", row.group.empty() ? row.what : row.group + ": " + row.what},
                       {"published", value_of(row.published)},
                       {"source", row.published ? json_of(row.published->source) : Json{}},
                       {"expected", row.expected},
                       {"ours", row.ours},
                       {"unit", row.scale.unit},
                       {"verdict", study::name(row.verdict)},
                       {"why", row.why}});
}

}  // namespace

std::string study_table(const study::Rows& rows, std::optional<int> width, const Style& style) {
  Widths widths;
  for (const study::Row& row : rows) widths.fit(cells_of(row));
  std::string text = heading(widths, style);
  std::string_view group;
  for (const study::Row& row : rows) {
    if (row.group != group) text += style(Tone::strong, row.group) + "\n";
    group = row.group;
    text += line_of(row, widths, width, style);
  }
  return text;
}

std::string study_json(std::string_view name, const study::Rows& rows) {
  Json list = Json::list();
  for (const study::Row& row : rows) list.push_back(json_of(row));
  return json_text(schema, {Json::object({{"schema", schema}, {"name", name}, {"rows", std::move(list)}})});
}

std::string study_list(const Style& style) {
  std::size_t width = 0;
  for (const study::Study& each : study::studies()) width = std::max(width, each.name.size());
  std::string text;
  for (const study::Study& each : study::studies())
    text +=
        "  " + style(Tone::strong, each.name) + blanks(width + 2, each.name.size()) + std::string(each.title) + "\n";
  return text;
}

std::string study_list_json() {
  Json list = Json::list();
  for (const study::Study& each : study::studies())
    list.push_back(Json::object({{"name", each.name}, {"title", each.title}}));
  return json_text(schema, {Json::object({{"schema", schema}, {"name", "list"}, {"studies", std::move(list)}})});
}

}  // namespace leadscrew::results
