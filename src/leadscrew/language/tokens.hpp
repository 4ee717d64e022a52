#pragma once
// A line of a part program in tokens, as it is written: for what changes or explains text without executing it. Nothing
// is refused; what is no word, remark or setting of a parameter is `other`.

#include <string_view>
#include <vector>

namespace leadscrew::language {

struct Token {
  enum class Kind : unsigned char {
    word,       ///< G1, X[#1+2], N10
    setting,    ///< #1=5, to the end of its value
    remark,     ///< (…) or ;…
    skip,       ///< / at the beginning
    percent,    ///< a line of %
    statement,  ///< O words, IF, WHILE, GOTO, END: to the end of the line, or to a remark
    other,      ///< the rest of the line
  };
  Kind kind = Kind::other;
  std::string_view text;   ///< all of it
  char letter = 0;         ///< of a word, in capitals
  std::string_view value;  ///< of a word: what stands behind the letter
};

/// `line` without its line feed. The tokens point into it.
std::vector<Token> tokens_of(std::string_view line);

}  // namespace leadscrew::language
