#include <algorithm>
#include <leadscrew/gcode/foreign_language.hpp>
#include <leadscrew/gcode/reporter.hpp>
#include <utility>

namespace leadscrew::gcode {

namespace {

constexpr std::int64_t most_errors = 100;
constexpr std::int64_t most_warnings = 100;
constexpr std::int64_t most_repeated_errors =
    10'000;                                      // of errors that were said: an error in a loop takes no more time
constexpr std::size_t longest_source = 200;      // bytes of a line that a diagnostic carries
constexpr std::int64_t last_shown_column = 180;  // further to the right, the beginning of the line says nothing

constexpr unsigned char byte(char c) {
  return static_cast<unsigned char>(c);
}
constexpr bool continues_character(char c) {
  return (byte(c) & 0xC0) == 0x80;
}

// Length of the UTF-8 character that begins at i, or 0. Overlong forms and surrogates are not told apart from others of
// their length where the second byte alone shows them.
std::size_t utf8_length(std::string_view text, std::size_t i) {
  const unsigned char lead = byte(text[i]);
  const std::size_t length = lead < 0x80   ? 1
                             : lead < 0xC2 ? 0
                             : lead < 0xE0 ? 2
                             : lead < 0xF0 ? 3
                             : lead < 0xF5 ? 4
                                           : 0;
  if (length == 0 || i + length > text.size()) return 0;
  for (std::size_t k = 1; k < length; ++k) {
    if (!continues_character(text[i + k])) return 0;
  }
  if (length < 3) return length;
  const unsigned char second = byte(text[i + 1]);
  const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
  const bool beyond = (lead == 0xED && second > 0x9F) || (lead == 0xF4 && second > 0x8F);
  return overlong || beyond ? 0 : length;
}

/// The line of text as diagnostics carry it, for a place at a column of it.
std::string source_of(std::string_view line, std::int64_t column) {
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  if (line.size() > longest_source) {
    if (column > last_shown_column) return {};
    std::size_t length = longest_source;
    while (length > 0 && continues_character(line[length])) --length;
    line = line.substr(0, length);
  }
  return printable(line);
}

}  // namespace

std::string printable(std::string_view text) {
  std::string result(text);
  for (std::size_t i = 0; i < result.size();) {
    const std::size_t length = utf8_length(result, i);
    if (length == 0) result[i] = '?';
    if (length == 1 && (byte(result[i]) < 0x20 || byte(result[i]) == 0x7F)) result[i] = ' ';
    i += std::max<std::size_t>(length, 1);
  }
  return result;
}

std::string shown(char c) {
  if (byte(c) >= 0x20 && byte(c) < 0x7F) return {'\'', c, '\''};
  constexpr char digits[] = "0123456789ABCDEF";
  return std::string("byte 0x") + digits[byte(c) >> 4] + digits[byte(c) & 15];
}

Reporter::Reporter(std::string file, DiagnosticSink sink) : files_{std::move(file)}, sink_(std::move(sink)) {
  kept_text_.reserve(longest_source + 1);
}

void Reporter::send(base::Severity severity, std::string_view code, base::Place place, std::string message,
                    std::string hint, std::string source, base::Subject subject) {
  if (sink_) sink_({severity, code, std::move(message), std::move(hint), std::move(place), std::move(source), subject});
}

void Reporter::report(base::Severity severity, std::string_view code, base::Place place, std::string message,
                      std::string hint) {
  if (severity == base::Severity::error) ++errors_;
  send(severity, code, std::move(place), std::move(message), std::move(hint), {});
}

bool Reporter::error(std::string_view code, std::int64_t column, std::string message, std::string hint,
                     base::Subject subject) {
  failed_ = true;
  if (muted_ || full_) return false;
  if (const auto language = foreign_language(text())) return refuse_language(*language);
  return error_at(line_.id, column, text(), code, std::move(message), std::move(hint), subject);
}

void Reporter::refuse_foreign() {
  if (const auto language = foreign_language(text())) refuse_language(*language);
}

// One error says it: every line of such a text would be another.
bool Reporter::refuse_language(const ForeignLanguage& language) {
  error_at(line_.id, 1, text(), "foreign-language", "this is " + std::string(language.name) + ", not G-code",
           std::string(language.hint), {});
  full_ = true;
  return false;
}

void Reporter::keep(std::int64_t column) {
  kept_line_ = line_.id;
  kept_column_ = column;
  kept_text_.assign(text().substr(0, longest_source + 1));
}

bool Reporter::error_where_kept(std::string_view code, std::string message, std::string hint, base::Subject subject) {
  return error_at(kept_line_, kept_column_, kept_text_, code, std::move(message), std::move(hint), subject);
}

// The same place in another visit, which becomes the one to compare with: they are counted modulo a million. At most 200
// are said in all.
bool Reporter::was_said(std::string_view code, base::Line line, std::int64_t column) {
  for (Said& said : said_) {
    if (said.code == code && said.column == column && base::place_of(said.line) == base::place_of(line) &&
        said.line != line) {
      said.line = line;
      return true;
    }
  }
  said_.push_back({code, column, line});
  return false;
}

bool Reporter::error_at(base::Line line, std::int64_t column, std::string_view text, std::string_view code,
                        std::string message, std::string hint, base::Subject subject) {
  if (muted_ || full_) return false;
  const base::Place place = place_of(line, column);
  if (was_said(code, line, column)) {
    if (++repeats_ < most_repeated_errors) return false;
  } else {
    ++errors_;
    send(base::Severity::error, code, place, std::move(message), std::move(hint), source_of(text, place.column),
         subject);
    if (errors_ < most_errors) return false;
  }
  full_ = true;
  const std::int64_t most = repeats_ < most_repeated_errors ? most_errors : most_repeated_errors;
  ++errors_;
  send(base::Severity::error, "too-many-problems", place, "reading stops after " + std::to_string(most) + " errors",
       most == most_errors ? "is this a part program?" : "the errors of a loop come each time: correct them first",
       source_of(text, place.column));
  return false;
}

void Reporter::warning(std::string_view code, std::int64_t column, std::string message, std::string hint) {
  warning_at(line_.id, column, text(), code, std::move(message), std::move(hint));
}

void Reporter::note(std::string_view code, std::int64_t column, std::string message, std::string hint) {
  warning_at(line_.id, column, text(), code, std::move(message), std::move(hint), base::Severity::note);
}

KeptPlace Reporter::place(std::uint32_t column) const {
  return {line_.id, column, std::string(text().substr(0, longest_source + 1))};
}

Reporter::Present Reporter::go_to(const KeptPlace& place) {
  const Present present{line_, failed_, muted_};
  TextLine line;
  line.begin = line.text = place.text.data();
  line.end = line.begin + place.text.size();
  line.number = base::number(place.line);
  line.id = place.line;
  begin(line);
  return present;
}

void Reporter::go_back(const Present& present) {
  line_ = present.line;
  failed_ = present.failed;
  muted_ = present.muted;
}

void Reporter::warning_where_kept(std::string_view code, std::string message, std::string hint) {
  warning_at(kept_line_, kept_column_, kept_text_, code, std::move(message), std::move(hint));
}

void Reporter::warning_at(base::Line line, std::int64_t column, std::string_view text, std::string_view code,
                          std::string message, std::string hint, base::Severity severity) {
  if (muted_ || full_ || warnings_ >= most_warnings || was_said(code, line, column)) return;
  ++warnings_;
  const base::Place place = place_of(line, column);
  send(severity, code, place, std::move(message), std::move(hint), source_of(text, place.column));
}

}  // namespace leadscrew::gcode
