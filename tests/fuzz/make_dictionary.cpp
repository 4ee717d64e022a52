// Writes a dictionary for libFuzzer, a quoted word a line: every code of the table with a value for each word that it
// takes, and the words of flow and of expressions.

#include <cstdio>
#include <leadscrew/gcode/codes.hpp>
#include <string>

namespace {

void write(const std::string& word) {
  std::printf("\"%s\"\n", word.c_str());
}

}  // namespace

int main() {
  using namespace leadscrew::gcode;
  for (const CodeRow& row : code_rows()) {
    std::string block = name(row.code);
    write(block);
    for (char letter = 'A'; letter <= 'Z'; ++letter) {
      if (row.words.has(letter) || row.more_words.has(letter)) block += std::string(" ") + letter + "1";
    }
    if (row.group == Group::motion || row.takes_axes) block += " X1 Y2 Z3";
    write(block);
  }
  for (const char* word : {"o1 sub",
                           "o1 endsub",
                           "o1 call [1] [2]",
                           "o1 return [1]",
                           "o1 if [1]",
                           "o1 elseif [0]",
                           "o1 else",
                           "o1 endif",
                           "o1 while [#1 lt 3]",
                           "o1 endwhile",
                           "o1 do",
                           "o1 repeat [2]",
                           "o1 endrepeat",
                           "o1 break",
                           "o1 continue",
                           "O1000",
                           ":1000",
                           "IF [#1 EQ 0] GOTO 1",
                           "IF [#1 LT 1] THEN #2=1",
                           "WHILE [#1 LT 3] DO 1",
                           "END 1",
                           "GOTO 1",
                           "N1",
                           "#1=",
                           "#<name>=",
                           "#<_global>",
                           "EXISTS[#<a>]",
                           "##1",
                           "[1+2]",
                           "ATAN[1]/[2]",
                           "MOD",
                           "XOR",
                           "**",
                           "SQRT[2]",
                           "@1 ^2",
                           "(MSG,",
                           "(DEBUG,#1",
                           "(PRINT,",
                           "(ABORT,",
                           "(LOGOPEN,",
                           ";PRINT,",
                           "%",
                           "/"}) {
    write(word);
  }
  return 0;
}
