// Fanuc's custom macros: IF, WHILE, DO, END, GOTO, G65 and G66, and block numbers as places to go to.

#include <array>
#include <cmath>
#include <leadscrew/gcode/flow_scan.hpp>
#include <limits>
#include <utility>

namespace leadscrew::gcode {

namespace {

constexpr std::size_t most_macro_loops = 3;  // one within another

// The parameter of each letter of G65, by its place in the alphabet; 0: none (Fanuc, "argument specification I").
constexpr std::array<int, 26> make_argument_numbers() {
  std::array<int, 26> numbers{};
  constexpr std::pair<char, int> letters[] = {{'A', 1},  {'B', 2},  {'C', 3},  {'I', 4},  {'J', 5},  {'K', 6},
                                              {'D', 7},  {'E', 8},  {'F', 9},  {'H', 11}, {'M', 13}, {'Q', 17},
                                              {'R', 18}, {'S', 19}, {'T', 20}, {'U', 21}, {'V', 22}, {'W', 23},
                                              {'X', 24}, {'Y', 25}, {'Z', 26}};
  for (const auto& [letter, number] : letters) numbers[static_cast<std::size_t>(letter - 'A')] = number;
  return numbers;
}
constexpr std::array<int, 26> argument_numbers = make_argument_numbers();

/// A word of letters at p, in any case; p then is behind it and the blanks there.
bool take_word(const char*& p, std::string_view letters) {
  const char* q = p;
  for (const char c : letters) {
    if (upper(*q++) != c) return false;
  }
  p = q;
  skip_blanks(p);
  return true;
}

}  // namespace

Flow::Next Flow::macro(const Statement& statement, TextLine& line) {
  switch (statement.keyword) {
    case Keyword::macro_if:
      return macro_if(statement, line);
    case Keyword::macro_while:
    case Keyword::macro_do:
      return macro_while(statement, line);
    case Keyword::macro_end:
      return macro_end(statement);
    case Keyword::go_to:
      return go_to_value(statement.rest, line, statement);
    default:
      return macro_call(statement, line);
  }
}

/// IF [...] GOTO n, IF [...] THEN #1=2
Flow::Next Flow::macro_if(const Statement& statement, TextLine& line) {
  const char* p = statement.rest;
  bool holds = false;
  if (!condition(p, holds)) return Next::stop;
  if (take_word(p, "GOTO")) return holds ? go_to_value(p, line, statement) : Next::line;
  if (!take_word(p, "THEN")) {
    return error(statement, "bad-o-word", "IF is followed by neither GOTO nor THEN",
                 "IF [#1 EQ 2] GOTO 100, or IF [#1 EQ 2] THEN #3=4");
  }
  if (!holds) return Next::line;
  if (take_word(p, "GOTO")) return go_to_value(p, line, statement);
  line.text = p;
  return Next::block;
}

/// WHILE [...] DOm, DOm
Flow::Next Flow::macro_while(const Statement& statement, TextLine& line) {
  const char* p = statement.rest;
  bool holds = true;
  const bool is_while = statement.keyword == Keyword::macro_while;
  if (is_while && !condition(p, holds)) return Next::stop;
  double number = 0;
  if (is_while && !take_word(p, "DO")) {
    return error(statement, "bad-o-word", "WHILE is followed by no DO", "WHILE [#1 LT 5] DO1");
  }
  if (!values_.value(p, number) || !at_end(p)) return Next::stop;
  if (!(statement.name >= 1 && statement.name <= most_macro_loops && number == static_cast<double>(statement.name))) {
    return error(statement, "bad-value", "the number of a loop is " + gcode::text(number), "DO1, DO2 or DO3");
  }
  const Open* const last = innermost();
  const bool is_again = last && last->name == statement.name && last->place == place_of(line);
  if (!is_again && !open(statement, Keyword::macro_do, line)) return Next::stop;
  if (holds) return Next::line;
  Statement found;
  if (!skip_to(line, Keyword::macro_do, statement.name, bit(Keyword::macro_end), found)) {
    return Next::stop;
  }
  open_.pop_back();
  return Next::line;
}

Flow::Next Flow::macro_end(const Statement& statement) {
  const Open* const last = innermost();
  if (!last || last->keyword != Keyword::macro_do || last->name != statement.name) return unmatched(statement);
  const char* p = statement.rest;
  double number = 0;
  if (!values_.value(p, number) || !at_end(p)) return Next::stop;
  return go(last->place, true) ? Next::line : Next::stop;
}

Flow::Next Flow::go_to_value(const char* p, TextLine& line, const Statement& at) {
  double value = 0;
  if (!values_.value(p, value) || !at_end(p)) return Next::stop;
  const std::optional<int> number = as_integer(value);
  if (!number || *number < 1) {
    return error(at, "bad-value", "GOTO leads to block " + gcode::text(value), "an integer from 1");
  }
  return go_to_block(*number, line, at);
}

Flow::Next Flow::go_to_block(std::int64_t number, TextLine& line, const Statement& at) {
  const TextPlace here = place_of(line);
  Label label;
  if (!find_label(number, line, at, label)) return Next::stop;
  // Out of loops, never into one.
  std::size_t kept = first_open();
  for (const TextPlace& loop : label.loops) {
    if (kept < open_.size() && open_[kept].place == loop) {
      ++kept;
      continue;
    }
    return error(at, "goto-into-loop",
                 "block N" + std::to_string(number) + " stands in a loop, that of line " + std::to_string(loop.line),
                 "go to the loop's beginning");
  }
  open_.resize(kept);
  return go(label.place, label.place.file != here.file || label.place.offset <= here.offset) ? Next::line : Next::stop;
}

/// The block of that number in the program being executed. The next line is still that behind `line`.
bool Flow::find_label(std::int64_t number, TextLine& line, const Statement& at, Label& label) {
  const TextPlace from = program_begin();
  const LabelKey of(from.file, from.offset, static_cast<std::uint64_t>(number));
  if (const auto known = labels_.find(of); known != labels_.end()) {
    label = known->second;
    return true;
  }
  counts_ = true;  // many labels, each looked for in all of a long program, take their time too
  int count = 0;
  const bool is_read = scan_label(number, from, label, count);
  if (!return_to_line(line) || !is_read) return false;
  if (count == 0) {
    error(at, "missing-label", "no block of this program is N" + std::to_string(number), "number one so");
    return false;
  }
  if (count > 1) {
    error(at, "duplicate-label", std::to_string(count) + " blocks of this program are N" + std::to_string(number),
          "number all but one of them otherwise");
    return false;
  }
  if (labels_.size() >= most_remembered) labels_.clear();
  labels_.emplace(of, label);
  return true;
}

bool Flow::scan_label(std::int64_t number, const TextPlace& from, Label& label, int& count) {
  if (!go(from, false)) return false;
  TextLine line;
  Statement statement;
  std::vector<TextPlace> loops;
  bool is_first = true;
  scan(line, statement, [&] {
    const bool begins = statement.keyword == Keyword::program && !is_first;
    const char* p = line.text;
    skip_blanks(p);
    is_first = is_first && (*p == '\n' || *p == '%');
    if (begins) return true;  // the next program
    if (statements_.block_number(line) == number) {
      if (++count == 1) label = {place_of(line), loops};
    }
    if (statement.keyword == Keyword::macro_while || statement.keyword == Keyword::macro_do) {
      if (loops.size() <= most_macro_loops) loops.push_back(place_of(line));
    } else if (statement.keyword == Keyword::macro_end && !loops.empty()) {
      loops.pop_back();
    }
    return false;
  });
  return !text_.failure();
}

/// G65 P9010 L2 A1 B2, or G66: the program, and its parameters by letters.
Flow::Next Flow::macro_call(const Statement& statement, TextLine& line) {
  std::vector<double> arguments(Parameters::macro_locals, std::numeric_limits<double>::quiet_NaN());
  double program = -1, repeats = 1;
  if (!macro_arguments(statement, arguments, program, repeats)) return Next::stop;
  StatementName number = 0;
  if (program < 0) {
    return error(statement, "missing-word", std::string(name(statement.keyword)) + " lacks P",
                 "give the number of the macro");
  }
  if (!statements_.number(program, statement.column, number)) return Next::stop;
  const std::optional<int> count = as_integer(repeats);
  if (!count || *count < 0) {
    return error(statement, "bad-value", "a macro is to be repeated " + gcode::text(repeats) + " times",
                 "L must be an integer of 0 or more");
  }
  const Sub* const sub = find_sub(number, true, line);
  if (!sub) return Next::stop;
  Call call{.kind = CallKind::macro, .name = number, .body = sub->body, .program = sub->body, .left = *count};
  call.arguments = std::move(arguments);
  if (statement.keyword == Keyword::modal_call) return begin_modal_call(std::move(call), statement);
  if (*count == 0) return Next::line;
  return begin_call(std::move(call), statement);
}

/// Letters that come again are I, J and K, of the second way to give arguments: #4 #5 #6, #7 #8 #9 and so on.
bool Flow::macro_arguments(const Statement& statement, std::vector<double>& arguments, double& program,
                           double& repeats) {
  const char* p = statement.rest;
  int set_of_ijk = 0;
  char last_of_ijk = 'K' + 1;
  for (skip_blanks(p); *p != '\n' && *p != ';'; skip_blanks(p)) {
    if (*p == '(') {
      while (*p != ')' && *p != '\n') ++p;
      p += *p == ')';
      continue;
    }
    const char letter = upper(*p);
    const std::int64_t column = reporter_.column(p);
    const bool is_letter = 'A' <= letter && letter <= 'Z';
    int number = is_letter ? argument_numbers[static_cast<std::size_t>(letter - 'A')] : 0;
    if (number == 0 && letter != 'P' && letter != 'L') {
      return reporter_.error("unused-word", column,
                             std::string(name(statement.keyword)) + " takes no " + gcode::shown(*p),
                             "A to K, M and Q to Z without G, L, N, O and P are arguments");
    }
    double value = 0;
    if (!values_.value(++p, value)) return false;
    if (letter == 'P') program = value;
    if (letter == 'L') repeats = value;
    if (number == 0) continue;
    if ('I' <= letter && letter <= 'K') {
      if (letter <= last_of_ijk) ++set_of_ijk;
      last_of_ijk = letter;
      number += 3 * (set_of_ijk - 1);
    }
    if (number > Parameters::macro_locals) {
      return reporter_.error("too-many-arguments", column, "there are more than ten I, J and K", "use fewer");
    }
    arguments[static_cast<std::size_t>(number) - 1] = value;
  }
  return true;
}

}  // namespace leadscrew::gcode
