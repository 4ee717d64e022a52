#include <fmt/format.h>

#include <fast_float/fast_float.h>

#include <cmath>
#include <leadscrew/base/nearest.hpp>
#include <leadscrew/gcode/dialect_forms.hpp>
#include <leadscrew/language/code_words.hpp>
#include <leadscrew/language/diagnostic_meaning.hpp>
#include <leadscrew/language/explanation.hpp>
#include <leadscrew/language/tokens.hpp>
#include <optional>

namespace leadscrew::language {

namespace {

using gcode::Code;
using gcode::CodeRow;
using gcode::Dialect;

constexpr int name_width = 8;

std::optional<double> number_of(std::string_view value) {
  std::string digits;
  for (const char c : value) {
    if (c != ' ' && c != '\t') digits += c;
  }
  const char* const begin = digits.data() + (digits.starts_with('+') ? 1 : 0);
  double number = 0;
  const auto [end, problem] = fast_float::from_chars(begin, digits.data() + digits.size(), number);
  if (problem != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return number;
}

/// The number of a G or M word times ten; −1 where it is none.
int tenths_of(const Token& word) {
  const auto number = number_of(word.value);
  if (!number || *number < 0 || *number >= 200) return -1;
  const double tenths = std::round(*number * 10);
  return std::abs(*number * 10 - tenths) < 1e-3 ? static_cast<int>(tenths) : -1;
}

Code code_of(const Token& word, Dialect dialect) {
  const int tenths = tenths_of(word);
  if (tenths < 0) return Code::none;
  if (word.letter == 'G') return gcode::g_code(dialect, tenths);
  return tenths % 10 == 0 ? gcode::m_code(dialect, tenths / 10) : Code::none;
}

std::string first_line(std::string_view name, std::string_view text, std::size_t width = name_width) {
  return fmt::format("{:<{}}{}{}\n", name, width, name.size() < width ? "" : "  ", text);
}
std::string further_line(std::string_view text) {
  return fmt::format("{:{}}{}\n", "", name_width, text);
}

std::string about(const CodeRow& row) {
  std::string text = fmt::format("{}; {}; dialects: {}", name(row.group), row.source, gcode::names_of(row.dialects));
  if (!row.read) text += "; known, but not read here";
  return text;
}

std::string word_line(char letter, std::string_view value, const WordMeaning& meaning) {
  const bool literal = number_of(value).has_value();
  std::string text(meaning.meaning);
  if (!meaning.unit.empty())
    text += literal ? fmt::format(": {} {}", value, meaning.unit) : fmt::format(", {}", meaning.unit);
  return "  " + first_line(fmt::format("{}{}", letter, value.empty() ? "_" : value), text, name_width - 2);
}

// Other meanings of the same number, in other dialects.
std::string other_meanings(const CodeRow& row) {
  std::string text;
  for (const CodeRow& other : gcode::code_rows()) {
    if (other.code == row.code || other.letter != row.letter || other.tenths != row.tenths) continue;
    text += further_line(fmt::format("in {}: {}", gcode::names_of(other.dialects), other.summary));
  }
  return text;
}

class Explanation {
 public:
  Explanation(std::string_view block, Dialect dialect) : tokens_(tokens_of(block)), dialect_(dialect) {}

  base::Result<std::string> text() {
    for (const Token& token : tokens_) {
      if (token.kind == Token::Kind::word) find_code(token);
    }
    for (const Token& token : tokens_) explain(token);
    if (known_) return text_;
    return base::failure(base::problem("unknown-code", "no code is known in this: " + unknown_,
                                       "docs/gcode.md lists all; --dialect names another dialect"));
  }

 private:
  void find_code(const Token& word) {
    if (word.letter != 'G' && word.letter != 'M') return;
    const Code code = code_of(word, dialect_);
    if (code != Code::none) codes_.push_back(code);
  }

  void explain(const Token& token) {
    switch (token.kind) {
      case Token::Kind::word:
        return token.letter == 'G' || token.letter == 'M' ? explain_code(token) : explain_word(token);
      case Token::Kind::remark:
        return say(token.text, "remark");
      case Token::Kind::setting:
        return say(token.text, "sets a parameter");
      case Token::Kind::skip:
        return say("/", "the block is skipped where block delete is on");
      case Token::Kind::percent:
        return say("%", "begins or ends the program");
      case Token::Kind::statement:
        return say(token.text, "flow: a subprogram, a loop or a condition");
      case Token::Kind::other:
        unknown_ = std::string(token.text);
    }
  }

  void say(std::string_view name, std::string_view text) {
    known_ = true;
    text_ += first_line(name, text);
  }

  void explain_code(const Token& word) {
    const Code code = code_of(word, dialect_);
    if (code == Code::none) return explain_elsewhere(word);
    const CodeRow& row = gcode::row(code);
    known_ = true;
    const std::string name = gcode::name(word.letter, tenths_of(word));
    text_ += first_line(name, row.summary) + further_line(about(row)) + other_meanings(row);
    if (tokens_.size() == 1) text_ += alone(row);
  }

  // A number that only other dialects know.
  void explain_elsewhere(const Token& word) {
    const int tenths = tenths_of(word);
    for (const CodeRow& row : gcode::code_rows()) {
      if (row.letter != word.letter || row.tenths != tenths) continue;
      known_ = true;
      text_ += first_line(gcode::name(row.code), fmt::format("not of {}: {}", name(dialect_), row.summary)) +
               further_line(about(row));
      if (tokens_.size() == 1) text_ += alone(row);
    }
    if (tenths < 0 || gcode::dialects_of(word.letter, tenths).empty()) {
      unknown_ = std::string(word.text);
      text_ += first_line(word.text, "not known");
    }
  }

  static std::string alone(const CodeRow& row) {
    std::string text;
    for (const char letter : gcode::word_marks) {
      if (takes(row.code, letter)) text += word_line(letter, {}, meaning_of(row.code, letter));
    }
    std::string_view rest = example_of(row.code);
    for (std::string_view head = "such as"; !rest.empty(); head = "") {
      const auto end = rest.find('\n');
      text += fmt::format("{:<{}}{}\n", head, name_width, rest.substr(0, end));
      rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    }
    return text;
  }

  void explain_word(const Token& word) {
    Code taker = Code::none;
    for (const Code code : codes_) {
      const bool has_vector = gcode::row(Code::G43_5).dialects.has(dialect_) && is_of_tool_vector(code, word.letter);
      if (gcode::row(code).words_in(dialect_).has(word.letter) || (has_vector && taker == Code::none)) taker = code;
    }
    const WordMeaning meaning = meaning_of(taker, word.letter);
    if (meaning.meaning.empty()) {
      unknown_ = std::string(word.text);
      text_ += fmt::format("  {:<{}}nothing in this block takes it\n", word.text, name_width - 2);
      return;
    }
    known_ = true;
    text_ += word_line(word.letter, word.value, meaning);
  }

  std::vector<Token> tokens_;
  Dialect dialect_;
  std::vector<Code> codes_;
  std::string text_;
  std::string unknown_ = "an empty block";
  bool known_ = false;
};

}  // namespace

base::Result<std::string> explanation(std::string_view block, Dialect dialect) {
  if (auto text = diagnostic_meaning(block)) return *text;
  if (looks_like_diagnostic(block))
    return base::failure(base::problem(
        "unknown-code",
        fmt::format("no diagnostic has the code {}{}", block, base::did_you_mean(block, diagnostic_codes())),
        "docs/diagnostics.md lists all"));
  return Explanation(block, dialect).text();
}

}  // namespace leadscrew::language
