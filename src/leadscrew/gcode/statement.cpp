#include <leadscrew/gcode/statement.hpp>
#include <optional>
#include <tuple>
#include <utility>

namespace leadscrew::gcode {

namespace {

constexpr StatementName first_named = StatementName{1} << 32;
constexpr std::size_t longest_statement_name = 255;

struct KeywordName {
  std::string_view name;
  Keyword keyword;
};

constexpr KeywordName o_keywords[] = {
    {"sub", Keyword::sub},
    {"endsub", Keyword::endsub},
    {"call", Keyword::call},
    {"return", Keyword::return_},
    {"if", Keyword::if_},
    {"elseif", Keyword::elseif},
    {"else", Keyword::else_},
    {"endif", Keyword::endif},
    {"while", Keyword::while_},
    {"endwhile", Keyword::endwhile},
    {"do", Keyword::do_},
    {"repeat", Keyword::repeat},
    {"endrepeat", Keyword::endrepeat},
    {"break", Keyword::break_},
    {"continue", Keyword::continue_},
    {"IF", Keyword::macro_if},
    {"WHILE", Keyword::macro_while},
    {"DO", Keyword::macro_do},
    {"END", Keyword::macro_end},
    {"GOTO", Keyword::go_to},
    {"G65", Keyword::macro_call},
    {"G66", Keyword::modal_call},
};

constexpr char lower(char c) {
  return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

constexpr bool is_letter(char c) {
  return 'A' <= upper(c) && upper(c) <= 'Z';
}

constexpr bool ends_statement(char c) {
  return c == '\n' || c == ';' || c == '(';
}

/// The keyword of an O word, all letters that stand there.
Keyword o_keyword(const char*& p) {
  std::array<char, 10> letters;
  std::size_t count = 0;
  const char* q = p;
  for (; is_letter(*q) && count < letters.size(); skip_blanks(q)) letters[count++] = lower(*q++);
  const std::string_view found(letters.data(), count);
  for (const KeywordName& candidate : o_keywords) {
    if (candidate.name != found) continue;
    p = q;
    return candidate.keyword;
  }
  return Keyword::unknown;
}

}  // namespace

std::string_view name(Keyword keyword) {
  for (const KeywordName& candidate : o_keywords) {
    if (candidate.keyword == keyword) return candidate.name;
  }
  return "O word";
}

/// Behind '/', N and its number.
const char* StatementReader::behind_number(const char* p) const {
  skip_blanks(p);
  if (*p == '/') skip_blanks(++p);
  if (upper(*p) != 'N') return p;
  const char* q = p + 1;
  skip_blanks(q);
  if (!is_digit(*q)) return p;
  while (is_digit(*q) || *q == '.' || is_blank(*q)) ++q;
  return q;
}

bool StatementReader::is_likely(const char* p) const {
  p = behind_number(p);
  switch (upper(*p)) {
    case 'O':
    case ':':
      return true;
    case 'G':
      return upper(p[1]) == 'O' || p[1] == '6';
    case 'I':
    case 'D':
    case 'E':
    case 'W':
      return macros_ && is_letter(p[1]);
    default:
      return false;
  }
}

std::int64_t StatementReader::block_number(const TextLine& line) const {
  const char* p = line.text;
  skip_blanks(p);
  if (*p == '/') {
    if (block_delete_) return -1;
    skip_blanks(++p);
  }
  if (upper(*p) != 'N') return -1;
  skip_blanks(++p);
  double value = 0;
  if (scan_decimal(p, value) == p) return -1;
  const std::optional<int> number = as_integer(value);
  return number ? *number : -1;
}

bool StatementReader::read(const TextLine& line, Statement& statement) {
  statement.keyword = Keyword::none;
  const char* p = line.text;
  skip_blanks(p);
  if (*p == '/' && block_delete_) return true;
  p = behind_number(p);
  statement.column = reporter_.column(p);
  if (upper(*p) == 'O') return read_o_word(p + 1, statement);
  if (*p == ':') return read_program_number(p + 1, statement);
  if (!read_macro_call(p, statement) && macros_) read_macro(p, statement);
  return true;
}

/// G65 and G66.
bool StatementReader::read_macro_call(const char* p, Statement& statement) const {
  for (const auto& [has, letters, keyword] : {std::tuple(has_macro_calls_, "G65", Keyword::macro_call),
                                              std::tuple(has_modal_calls_, "G66", Keyword::modal_call)}) {
    const char* q = p;
    if (!has || !take_letters(q, letters) || is_digit(*q) || *q == '.') continue;
    statement.keyword = keyword;
    statement.rest = q;
    return true;
  }
  return false;
}

/// Numbers of loops are told without their condition being read.
void StatementReader::read_macro(const char* p, Statement& statement) const {
  constexpr std::pair<std::string_view, Keyword> keywords[] = {{"GOTO", Keyword::go_to},
                                                               {"IF", Keyword::macro_if},
                                                               {"WHILE", Keyword::macro_while},
                                                               {"DO", Keyword::macro_do},
                                                               {"END", Keyword::macro_end}};
  for (const auto& [letters, keyword] : keywords) {
    if (!take_letters(p, letters)) continue;
    statement.keyword = keyword;
    statement.rest = p;
    if (keyword == Keyword::macro_while) {
      int open = 0;
      for (; *p != '\n'; ++p) {
        open += (*p == '[') - (*p == ']');
        if (open == 0 && take_letters(p, "DO")) break;
      }
    }
    double number = 0;
    statement.name = scan_decimal(p, number) != p && number < 1e6 ? static_cast<StatementName>(number) : 0;
    return;
  }
}

/// `p` is behind the O.
bool StatementReader::read_o_word(const char* p, Statement& statement) {
  if (!read_name(p, statement.name)) return false;
  statement.keyword = ends_statement(*p) ? Keyword::program : o_keyword(p);
  statement.rest = p;
  return true;
}

/// `:1000` is what O1000 is.
bool StatementReader::read_program_number(const char* p, Statement& statement) {
  skip_blanks(p);
  if (!read_name(p, statement.name)) return false;
  statement.keyword = ends_statement(*p) ? Keyword::program : Keyword::unknown;
  statement.rest = p;
  return true;
}

bool StatementReader::read_name(const char*& p, StatementName& name) {
  skip_blanks(p);
  if (*p == '<') return read_bracketed_name(p, name);
  const char* const begin = p;
  StatementName digits = 0;
  for (; is_digit(*p) && p - begin < 9; ++p) digits = digits * 10 + static_cast<StatementName>(*p - '0');
  const bool is_plain = p != begin;
  skip_blanks(p);
  if (is_plain && !is_digit(*p) && *p != '.') {
    name = digits;
    return true;
  }
  p = begin;
  double value = 0;
  return values_.value(p, value) && number(value, reporter_.column(begin), name);
}

bool StatementReader::number(double value, std::int64_t column, StatementName& name) {
  const std::optional<int> integer = as_integer(value);
  if (!integer || *integer < 0) {
    return reporter_.error("bad-value", column, "the number of the subprogram is " + gcode::text(value),
                           "an integer of 0 to 999999999");
  }
  name = static_cast<StatementName>(*integer);
  return true;
}

bool StatementReader::read_bracketed_name(const char*& p, StatementName& name) {
  const char* const open = p++;
  std::string letters;
  for (; *p != '>'; ++p) {
    if (is_blank(*p)) continue;
    if (*p < ' ' || *p > '~' || letters.size() == longest_statement_name) {
      return reporter_.error("bad-o-word", reporter_.column(open), "the name of this O word does not end",
                             "'<', up to " + std::to_string(longest_statement_name) + " printable characters, '>'");
    }
    letters += lower(*p);
  }
  skip_blanks(++p);
  if (letters.empty()) {
    return reporter_.error("bad-o-word", reporter_.column(open), "the name of this O word is empty", "o<name>");
  }
  if (letters.size() < 10 && letters.find_first_not_of("0123456789") == std::string::npos) {
    name = 0;
    for (const char digit : letters) name = name * 10 + static_cast<StatementName>(digit - '0');
    return true;
  }
  const auto found = numbers_.find(letters);
  if (found != numbers_.end()) {
    name = found->second;
    return true;
  }
  if (names_.size() >= most_names) {
    return reporter_.error("too-many-names", reporter_.column(open),
                           "there are more than " + std::to_string(most_names) + " names of O words",
                           "use numbers: o100");
  }
  name = first_named + names_.size();
  names_.push_back(letters);
  numbers_.emplace(std::move(letters), name);
  return true;
}

std::string StatementReader::file_name(StatementName name) const {
  return name < first_named ? std::to_string(name) : names_[name - first_named];
}

std::string StatementReader::text(StatementName name) const {
  return name < first_named ? "o" + std::to_string(name) : "o<" + file_name(name) + ">";
}

}  // namespace leadscrew::gcode
