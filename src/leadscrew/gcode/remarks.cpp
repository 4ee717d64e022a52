#include <algorithm>
#include <array>
#include <charconv>
#include <leadscrew/gcode/operations.hpp>
#include <leadscrew/gcode/remarks.hpp>

namespace leadscrew::gcode {

struct Remarks::Row {
  enum class Action : std::uint8_t { say, open, log, close, open_probe, close_probe, abort, unsupported };

  std::string_view word;
  bool has_text;  ///< which stands behind a comma
  Action action;
  Remark::Kind kind = Remark::Kind::message;
  bool expands = true;
};

namespace {

constexpr int default_decimals = 6;
constexpr std::string_view no_value = "######";

std::string_view without_blanks_before(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  return text;
}

std::string_view without_blanks(std::string_view text) {
  text = without_blanks_before(text);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

bool begins_with(std::string_view text, std::string_view word) {
  return text.size() >= word.size() &&
         std::equal(word.begin(), word.end(), text.begin(), [](char a, char b) { return a == upper(b); });
}

std::string decimal_of(double value, int decimals) {
  std::array<char, 400> buffer;
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  return {buffer.data(), end.ptr};
}

// The decimals that a format at the beginning of the text asks for, which is taken from it; −1 where there is none.
int take_format(std::string_view& text) {
  const auto take = [&](std::size_t length, int decimals) {
    text.remove_prefix(length);
    return decimals;
  };
  if (text.starts_with("%d")) return take(2, 0);
  if (text.starts_with("%f")) return take(2, 4);
  if (text.size() >= 4 && text.starts_with("%.") && is_digit(text[2]) && text[3] == 'f') return take(4, text[2] - '0');
  return -1;
}

// Whether a name leads out of the folder that it is seen from.
bool leads_outside(std::string_view name) {
  if (name.starts_with('/')) return true;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    if (name.substr(begin, end - begin) == "..") return true;
    begin = end + 1;
  }
  return false;
}

}  // namespace

bool Remarks::may_ask(const char* text) {
  skip_blanks(text);
  return std::string_view("ADLMP").find(upper(*text)) != std::string_view::npos;
}

void Remarks::execute(std::string_view text) {
  using Action = Row::Action;
  using Kind = Remark::Kind;
  // A word that begins another stands behind it.
  static constexpr Row rows[] = {
      {"MSG", true, Action::say, Kind::message, false},
      {"DEBUG", true, Action::say, Kind::message},
      {"PRINT", true, Action::say, Kind::print},
      {"LOGOPEN", true, Action::open, Kind::log_open},
      {"LOGAPPEND", true, Action::open, Kind::log_append},
      {"LOGCLOSE", false, Action::close},
      {"LOG", true, Action::log},
      {"ABORT", true, Action::abort},
      {"PROBEOPEN", false, Action::open_probe, Kind::probe_open},
      {"PROBECLOSE", false, Action::close_probe},
      {"PY", true, Action::unsupported},
  };
  text = without_blanks_before(text);
  const auto* const row = std::ranges::find_if(rows, [&](const Row& each) {
    return begins_with(text, each.word) && (!each.has_text || text.substr(each.word.size()).starts_with(','));
  });
  if (row == std::end(rows)) return;
  const std::int64_t column = reporter_.column(&text.front());
  text.remove_prefix(row->word.size() + (row->has_text ? 1 : 0));
  switch (row->action) {
    case Action::say:
      if (row->word == "DEBUG" && parameters_.get(Parameters::shows_debug).value_or(0) == 0) return;
      if (options_.remarks) send(row->kind, row->expands ? expanded(text) : std::string(text), column);
      return;
    case Action::open:
      log_is_open_ = open_log(*row, without_blanks(text), column, "(LOGOPEN,log.txt)");
      return;
    case Action::open_probe:
      if (!open_log(*row, without_blanks(text), column, "(PROBEOPEN points.txt)")) send(Kind::probe_close, {}, column);
      return;
    case Action::close_probe:
      return send(Kind::probe_close, {}, column);
    case Action::log:
      return log(text, column);
    case Action::close:
      if (log_is_open_) send(Kind::log_close, {}, column);
      log_is_open_ = false;
      return;
    case Action::abort:
      return abort(without_blanks(text), column);
    case Action::unsupported:
      reporter_.warning("unsupported-remark", column, std::string(row->word) + " is not done",
                        "MSG, DEBUG, PRINT, LOG, LOGOPEN, LOGAPPEND, LOGCLOSE, PROBEOPEN, PROBECLOSE and ABORT are");
      return;
  }
}

void Remarks::send(Remark::Kind kind, std::string text, std::int64_t column) const {
  if (!options_.remarks) return;
  options_.remarks({kind, std::move(text), {reporter_.file(), base::number(reporter_.line()), column}});
}

// Whether it is open now.
bool Remarks::open_log(const Row& row, std::string_view name, std::int64_t column, std::string_view example) {
  if (name.empty()) {
    reporter_.warning("bad-log", column, std::string(row.word) + " names no file", std::string(example));
  } else if (leads_outside(name)) {
    reporter_.warning("bad-log", column, "log file " + std::string(name) + " would not be in the program's folder",
                      "it is not written; give a name without '/' at the beginning and without '..'");
  } else {
    send(row.kind, std::string(name), column);
    return true;
  }
  return false;
}

void Remarks::log(std::string_view text, std::int64_t column) {
  if (log_is_open_) {
    if (options_.remarks) send(Remark::Kind::log, expanded(text), column);
    return;
  }
  if (told_unopened_) return;
  told_unopened_ = true;
  reporter_.warning("bad-log", column, "LOG stands where no log file is open, and writes nothing",
                    "(LOGOPEN,log.txt) before it");
}

void Remarks::abort(std::string_view text, std::int64_t column) {
  reporter_.error("program-abort", column,
                  "the program stops itself" + (text.empty() ? std::string() : ": " + printable(expanded(text))),
                  "what it says is why");
  reporter_.stop();
}

std::string Remarks::expanded(std::string_view text) const {
  std::string result;
  int decimals = default_decimals;
  while (!text.empty()) {
    const int format = text.front() == '%' ? take_format(text) : -1;
    if (format >= 0) {
      decimals = format;
    } else if (text.front() == '#') {
      result += value_of(text, decimals);
    } else {
      result += text.front();
      text.remove_prefix(1);
    }
  }
  return result;
}

// Of the parameter that stands at the beginning, which is taken from the text; what is none is taken as it is.
std::string Remarks::value_of(std::string_view& rest, int decimals) const {
  std::size_t end = 1;
  std::optional<double> value;
  if (rest.substr(1).starts_with('<')) {
    end = rest.find('>');
    if (end == std::string_view::npos) {
      rest.remove_prefix(1);
      return "#";
    }
    std::string name;
    for (const char c : rest.substr(2, end++ - 2)) {
      if (!is_blank(c)) name += upper(c);
    }
    value = parameters_.get(name);
    if (!value) value = predefined_.get(name);
  } else {
    while (end < rest.size() && is_digit(rest[end])) ++end;
    int number = 0;
    const auto read = std::from_chars(rest.data() + 1, rest.data() + end, number);
    if (end == 1) {
      rest.remove_prefix(1);
      return "#";
    }
    if (read.ec == std::errc() && number >= 1 && number <= Parameters::last) {
      value = predefined_.get(number);
      if (!value) value = parameters_.get(number).value_or(0);
    }
  }
  rest.remove_prefix(end);
  return value ? decimal_of(*value, decimals) : std::string(no_value);
}

}  // namespace leadscrew::gcode
