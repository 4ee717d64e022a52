#include <cstddef>
#include <leadscrew/language/tokens.hpp>

namespace leadscrew::language {

namespace {

constexpr bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}
constexpr bool is_numeral(char c) {
  return '0' <= c && c <= '9';
}
constexpr char capital(char c) {
  return 'a' <= c && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}
constexpr bool is_capital(char c) {
  return 'A' <= c && c <= 'Z';
}

class Scanner {
 public:
  explicit Scanner(std::string_view line) : line_(line) {}

  std::vector<Token> tokens() {
    skip_spaces();
    if (peek() == '%') take(Token::Kind::percent, line_.size());
    if (peek() == '/') take(Token::Kind::skip, at_ + 1);
    bool begins = true;  // nothing but the number of the block before
    while (skip_spaces(), at_ < line_.size()) {
      const char c = capital(peek());
      if (c == '(') {
        take(Token::Kind::remark, behind_remark());
      } else if (c == ';') {
        take(Token::Kind::remark, line_.size());
      } else if (begins && is_statement()) {
        take(Token::Kind::statement, before_remark());
      } else if (is_capital(c) || is_mark()) {
        word();
        begins = begins && c == 'N';
        continue;
      } else if (c == '#') {
        setting();
      } else {
        take(Token::Kind::other, line_.size());
      }
    }
    return std::move(tokens_);
  }

 private:
  char peek(std::size_t ahead = 0) const { return at_ + ahead < line_.size() ? line_[at_ + ahead] : '\0'; }
  void skip_spaces() {
    while (is_space(peek())) ++at_;
  }

  void take(Token::Kind kind, std::size_t end) {
    std::string_view text = line_.substr(at_, end - at_);
    while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
    tokens_.push_back({kind, text, 0, {}});
    at_ = end;
  }

  std::size_t behind_remark() const {
    int depth = 0;
    for (std::size_t i = at_; i < line_.size(); ++i) {
      depth += line_[i] == '(' ? 1 : line_[i] == ')' ? -1 : 0;
      if (depth == 0) return i + 1;
    }
    return line_.size();
  }
  std::size_t before_remark() const {
    std::size_t i = at_;
    while (i < line_.size() && line_[i] != '(' && line_[i] != ';') ++i;
    return i;
  }

  bool begins_with(std::string_view word) const {
    for (std::size_t i = 0; i < word.size(); ++i) {
      if (capital(peek(i)) != word[i]) return false;
    }
    return true;
  }
  bool is_statement() const {
    if (capital(peek()) == 'O') return true;
    for (const std::string_view word : {"IF", "WHILE", "GOTO", "END", "DO"}) {
      if (begins_with(word)) return true;
    }
    return false;
  }

  /// Polar words and the number of a spindle; not commands to a controller, such as "$H".
  bool is_mark() const {
    if (peek() != '@' && peek() != '^' && peek() != '$') return false;
    std::size_t ahead = 1;
    while (is_space(peek(ahead))) ++ahead;
    return std::string_view("+-.#[0123456789").find(peek(ahead)) != std::string_view::npos;
  }

  void word() {
    const std::size_t begin = at_++;
    const std::size_t value_begin = (skip_spaces(), at_);
    value(0);
    std::size_t end = at_;
    while (end > value_begin && is_space(line_[end - 1])) --end;
    const std::string_view written = line_.substr(value_begin, end - value_begin);
    tokens_.push_back({Token::Kind::word, line_.substr(begin, end - begin), capital(line_[begin]), written});
  }

  // #5 = [#1 + 2]; of macros #5 = #1 * 2 + COS[#3] as well.
  void setting() {
    std::size_t end = at_;
    int depth = 0;
    bool in_name = false, behind_equals = false;
    for (; end < line_.size(); ++end) {
      const char c = line_[end];
      if (in_name) {
        in_name = c != '>';
        continue;
      }
      in_name = c == '<';
      if (c == '[') ++depth;
      if (c == ']') --depth;
      if (depth == 0 && (c == '(' || c == ';')) break;
      if (depth == 0 && behind_equals && is_word(end)) break;
      // A further setting, or a word, behind the value.
      if (c == '=') {
        const std::size_t next = line_.rfind('#', end);
        if (behind_equals && next > at_) {
          end = next;
          break;
        }
        behind_equals = true;
      }
    }
    take(Token::Kind::setting, end);
  }

  /// Whether a letter alone stands there, with a value: what functions and operators have more letters than.
  bool is_word(std::size_t at) const {
    if (!is_capital(capital(line_[at])) || is_capital(capital(line_[at - 1]))) return false;
    std::size_t i = at + 1;
    while (i < line_.size() && is_space(line_[i])) ++i;
    return i < line_.size() && std::string_view("+-.#[0123456789").find(line_[i]) != std::string_view::npos;
  }

  /// A number, an expression, a parameter or a function, with signs before it.
  void value(int depth) {
    while (is_space(peek()) || peek() == '+' || peek() == '-') ++at_;
    if (is_numeral(peek()) || peek() == '.') {
      while (is_numeral(peek()) || peek() == '.' || is_space(peek())) ++at_;
    } else if (peek() == '[') {
      bracket();
    } else if (peek() == '#') {
      ++at_;
      if (peek() == '<') {
        const std::size_t end = line_.find('>', at_);
        at_ = end == std::string_view::npos ? line_.size() : end + 1;
      } else {
        deeper(depth);
      }
    } else {
      function(depth);
    }
  }

  // What nests deeper is none that is read: it ends the word.
  void deeper(int depth) {
    constexpr int deepest = 100;
    if (depth < deepest) value(depth + 1);
  }

  void bracket() {
    int depth = 0;
    for (; at_ < line_.size(); ++at_) {
      depth += line_[at_] == '[' ? 1 : line_[at_] == ']' ? -1 : 0;
      if (depth == 0) break;
    }
    if (at_ < line_.size()) ++at_;
  }

  void function(int depth) {
    std::size_t i = at_;
    while (i < line_.size() && is_capital(capital(line_[i]))) ++i;
    while (i < line_.size() && is_space(line_[i])) ++i;
    if (i == at_ || i >= line_.size() || line_[i] != '[') return;  // a letter without a number
    at_ = i;
    bracket();
    const std::size_t behind = at_;
    skip_spaces();
    if (peek() != '/') {
      at_ = behind;
      return;
    }
    ++at_;
    deeper(depth);
  }

  std::string_view line_;
  std::size_t at_ = 0;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokens_of(std::string_view line) {
  return Scanner(line).tokens();
}

}  // namespace leadscrew::language
