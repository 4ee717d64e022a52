#pragma once
// Looking through lines of a program for a statement.

#include <leadscrew/gcode/flow.hpp>

namespace leadscrew::gcode {

/// Goes through the lines that come next until `look` returns true of a statement; false at the text's end, or at the %
/// that ends the program. What is wrong with lines is not reported.
template <class Look>
bool Flow::scan(TextLine& line, Statement& statement, Look&& look) {
  bool begun = false;
  while (text_.next(line)) {
    if (counts_) --fuel_;
    reporter_.begin(line);
    reporter_.mute();
    const char* p = line.text;
    skip_blanks(p);
    if (*p == '%' && begun) return false;
    begun = begun || *p != '\n';
    if (!statements_.may_be(line)) {
      statement.keyword = Keyword::none;
    } else if (!statements_.read(line, statement)) {
      continue;
    }
    if (look()) {
      reporter_.begin(line);
      return true;
    }
  }
  return false;
}

}  // namespace leadscrew::gcode
