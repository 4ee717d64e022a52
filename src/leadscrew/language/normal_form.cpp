#include <algorithm>
#include <leadscrew/gcode/dialect_forms.hpp>
#include <leadscrew/gcode/printer_commands.hpp>
#include <leadscrew/language/normal_form.hpp>
#include <leadscrew/language/tokens.hpp>

namespace leadscrew::language {

namespace {

using gcode::Dialect;
using gcode::Form;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// "007.50" as "7.5", ".5" as "0.5", "-0." as "0"; what is no plain number as it is.
std::string normal_number(std::string_view value, bool keeps_point) {
  std::string digits;
  for (const char c : value) {
    if (c != ' ' && c != '\t') digits += c;
  }
  const auto sign = digits.find_last_of("+-");
  const bool plain = !digits.empty() && digits.find_first_not_of("+-.0123456789") == std::string::npos &&
                     (sign == 0 || sign == std::string::npos);
  if (!plain) return std::string(value);
  const bool negative = digits.front() == '-';
  if (negative || digits.front() == '+') digits.erase(0, 1);
  const auto point = digits.find('.');
  if (digits.find_first_of("0123456789") == std::string::npos || point != digits.rfind('.')) return std::string(value);
  if (point != std::string::npos) digits.erase(digits.find_last_not_of('0') + 1);
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
  if (digits.empty() || digits.front() == '.') digits.insert(0, "0");
  if (digits.back() == '.' && !keeps_point) digits.pop_back();
  const bool zero = digits.find_first_not_of("0.") == std::string::npos;
  return (negative && !zero ? "-" : "") + digits;
}

// Text that a printer shows, and names of axes without numbers.
bool is_text_of_printer(const std::vector<Token>& tokens) {
  for (const Token& token : tokens) {
    if (token.kind == Token::Kind::other) return true;
    if (token.kind == Token::Kind::word && token.value.empty()) return true;
    if (token.kind == Token::Kind::word && token.letter == 'M' && (token.value == "117" || token.value == "118"))
      return true;
  }
  return false;
}

}  // namespace

std::string normal_form(std::string_view line, Dialect dialect) {
  const std::string_view text = trimmed(line);
  const std::vector<Token> tokens = tokens_of(text);
  if (has_form(dialect, Form::printer_commands) && is_text_of_printer(tokens)) return std::string(text);
  const bool points_matter = has_form(dialect, Form::whole_milliseconds);
  std::string result;
  for (const Token& token : tokens) {
    const bool is_letter = token.kind == Token::Kind::word && token.value.empty();
    if (is_letter || token.kind == Token::Kind::other) return std::string(text);
    if (!result.empty() && result != "/") result += ' ';
    if (token.kind != Token::Kind::word) {
      result += token.text;
      continue;
    }
    const bool is_code = token.letter == 'G' || token.letter == 'M' || token.letter == 'N';
    result += token.letter;
    result += normal_number(token.value, points_matter && !is_code);
  }
  return result;
}

}  // namespace leadscrew::language
