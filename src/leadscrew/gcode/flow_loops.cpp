// Loops and conditions.

#include <cmath>
#include <leadscrew/gcode/flow_scan.hpp>
#include <utility>

namespace leadscrew::gcode {

Flow::Next Flow::take(TextLine& line) {
  Statement statement;
  if (!statements_.read(line, statement)) return Next::stop;
  if (statement.keyword == Keyword::none) return Next::block;
  text_.keep(line);
  if (statement.keyword >= Keyword::macro_if) return macro(statement, line);
  const bool has_programs = options_.dialect != Dialect::grbl && options_.dialect != Dialect::marlin;
  if (statement.keyword == Keyword::program && has_programs) return program_number(statement);
  if (options_.dialect != Dialect::leadscrew && options_.dialect != Dialect::linuxcnc) {
    return error(statement, "unsupported-o-word",
                 "dialect " + std::string(name(options_.dialect)) + " does not have this O word",
                 "known by --dialect leadscrew, linuxcnc");
  }
  return execute(statement, line);
}

Flow::Next Flow::execute(const Statement& statement, TextLine& line) {
  switch (statement.keyword) {
    case Keyword::sub:
      return define(statement, line);
    case Keyword::endsub:
    case Keyword::return_:
      return return_from(statement);
    case Keyword::call:
      return call(statement, line);
    case Keyword::if_:
      return begin_if(statement, line);
    case Keyword::elseif:
    case Keyword::else_:
    case Keyword::endif:
      return leave_branch(statement, line);
    case Keyword::while_:
      return at_while(statement, line);
    case Keyword::do_:
      return begin_do(statement, line);
    case Keyword::repeat:
      return begin_repeat(statement, line);
    case Keyword::endwhile:
      return end_loop(statement, Keyword::while_);
    case Keyword::endrepeat:
      return end_loop(statement, Keyword::repeat);
    case Keyword::break_:
      return break_loop(statement, line, false);
    case Keyword::continue_:
      return break_loop(statement, line, true);
    default:
      return error(statement, "bad-o-word", "this O word is followed by no keyword",
                   "sub, endsub, call, return, if, elseif, else, endif, while, endwhile, do, repeat, endrepeat, break "
                   "or continue");
  }
}

/// The loop or condition opened last in the subprogram being executed; none: null.
Flow::Open* Flow::innermost() {
  return open_.size() > first_open() ? &open_.back() : nullptr;
}

Flow::Next Flow::unmatched(const Statement& statement) {
  const Open* const last = innermost();
  std::string message = shown(statement.keyword, statement.name) + " stands where nothing of this name is open";
  if (last) message += ": " + shown(last->keyword, last->name) + " is";
  return error(statement, "unmatched-o-word", std::move(message), "loops and conditions end in the order they began");
}

bool Flow::open(const Statement& statement, Keyword keyword, const TextLine& line, std::int64_t left) {
  for (std::size_t i = first_open(); i < open_.size(); ++i) {
    if (open_[i].name == statement.name) {
      return reporter_.error("duplicate-label", statement.column,
                             shown(open_[i].keyword, open_[i].name) + " is open here already",
                             "give one of them another number");
    }
  }
  if (open_.size() >= most_open) {
    return reporter_.error("nested-too-deep", statement.column,
                           "loops and conditions are nested more than " + std::to_string(most_open) + " deep",
                           "put the inner ones into a subroutine");
  }
  if (options_.dialect == Dialect::linuxcnc && !label_is_new(statement, line)) return false;
  open_.push_back({keyword, statement.name, place_of(line), {}, left});
  return true;
}

/// LinuxCNC gives a label one line of a subroutine.
bool Flow::label_is_new(const Statement& statement, const TextLine& line) {
  const TextPlace body = calls_.empty() ? TextPlace{} : calls_.back().body;
  if (label_lines_.size() >= most_remembered) label_lines_.clear();
  const auto [found, is_new] = label_lines_.emplace(LabelKey(body.file, body.offset, statement.name), line.offset);
  if (is_new || found->second == line.offset) return true;
  return reporter_.error("duplicate-label", statement.column,
                         statements_.text(statement.name) + " is the label of another line already",
                         "give one of them another number; dialect leadscrew takes it");
}

Flow::Next Flow::begin_if(const Statement& statement, TextLine& line) {
  const char* p = statement.rest;
  bool holds = false;
  if (!condition(p, holds) || !at_end(p) || !open(statement, Keyword::if_, line)) return Next::stop;
  return holds ? Next::line : skip_branches(statement.name, line);
}

/// To the first branch whose condition holds.
Flow::Next Flow::skip_branches(StatementName name, TextLine& line) {
  for (;;) {
    Statement found;
    const Keywords wanted = bit(Keyword::elseif) | bit(Keyword::else_) | bit(Keyword::endif);
    if (!skip_to(line, Keyword::if_, name, wanted, found)) return Next::stop;
    const char* p = found.rest;
    bool holds = true;
    if (found.keyword == Keyword::elseif && !condition(p, holds)) return Next::stop;
    if (!at_end(p)) return Next::stop;
    if (found.keyword == Keyword::endif) open_.pop_back();
    if (holds) return Next::line;
  }
}

/// The branch that was executed ends.
Flow::Next Flow::leave_branch(const Statement& statement, TextLine& line) {
  const Open* const last = innermost();
  if (!last || last->keyword != Keyword::if_ || last->name != statement.name) return unmatched(statement);
  if (statement.keyword != Keyword::endif) {
    Statement found;
    if (!skip_to(line, Keyword::if_, statement.name, bit(Keyword::endif), found)) return Next::stop;
    if (!at_end(found.rest)) return Next::stop;
  } else if (!at_end(statement.rest)) {
    return Next::stop;
  }
  open_.pop_back();
  return Next::line;
}

/// The head of a while loop, come to for the first time or again, or the end of a do loop.
Flow::Next Flow::at_while(const Statement& statement, TextLine& line) {
  const Open* const last = innermost();
  const bool is_of_last = last && last->name == statement.name;
  if (is_of_last && last->keyword == Keyword::do_) return end_of_do(statement);
  const bool is_again = is_of_last && last->keyword == Keyword::while_ && last->place.offset == line.offset;
  const char* p = statement.rest;
  bool holds = false;
  if (!condition(p, holds) || !at_end(p)) return Next::stop;
  if (!is_again && !open(statement, Keyword::while_, line)) return Next::stop;
  if (holds) return Next::line;
  Statement found;
  if (!skip_to(line, Keyword::while_, statement.name, bit(Keyword::endwhile), found) || !at_end(found.rest)) {
    return Next::stop;
  }
  open_.pop_back();
  return Next::line;
}

Flow::Next Flow::end_of_do(const Statement& statement) {
  const char* p = statement.rest;
  bool holds = false;
  if (!condition(p, holds) || !at_end(p)) return Next::stop;
  const TextPlace begin = open_.back().place;
  open_.pop_back();
  if (holds && !go(begin, true)) return Next::stop;
  return Next::line;
}

Flow::Next Flow::begin_do(const Statement& statement, const TextLine& line) {
  return at_end(statement.rest) && open(statement, Keyword::do_, line) ? Next::line : Next::stop;
}

Flow::Next Flow::begin_repeat(const Statement& statement, TextLine& line) {
  const char* p = statement.rest;
  double count = 0;
  if (!bracketed_value(p, count) || !at_end(p)) return Next::stop;
  if (!(std::fabs(count) <= 1e9)) {
    return error(statement, "bad-value", "a loop is to be repeated " + gcode::text(count) + " times", "at most 1e9");
  }
  if (!open(statement, Keyword::repeat, line, std::llround(count))) return Next::stop;
  if (open_.back().left > 0) {
    open_.back().body = text_.place();
    return Next::line;
  }
  Statement found;
  if (!skip_to(line, Keyword::repeat, statement.name, bit(Keyword::endrepeat), found) || !at_end(found.rest)) {
    return Next::stop;
  }
  open_.pop_back();
  return Next::line;
}

Flow::Next Flow::end_loop(const Statement& statement, Keyword opener) {
  const Open* const last = innermost();
  if (!last || last->keyword != opener || last->name != statement.name) return unmatched(statement);
  if (!at_end(statement.rest)) return Next::stop;
  if (opener == Keyword::repeat) return repeat_again();
  return go(last->place, true) ? Next::line : Next::stop;
}

Flow::Next Flow::repeat_again() {
  if (--open_.back().left > 0) return go(open_.back().body, true) ? Next::line : Next::stop;
  open_.pop_back();
  return Next::line;
}

/// break, or continue: `goes_on`.
Flow::Next Flow::break_loop(const Statement& statement, TextLine& line, bool goes_on) {
  std::size_t count = open_.size();
  while (count > first_open() && open_[count - 1].name != statement.name) --count;
  if (count == first_open() || open_[count - 1].keyword == Keyword::if_) return unmatched(statement);
  if (!at_end(statement.rest)) return Next::stop;
  if (options_.dialect == Dialect::linuxcnc && open_[count - 1].keyword == Keyword::repeat) {
    return error(statement, "unmatched-o-word", shown(statement.keyword, statement.name) + " stands in a repeat loop",
                 "LinuxCNC leaves while and do loops alone; dialect leadscrew takes it");
  }
  open_.resize(count);
  const Keyword opener = open_.back().keyword;
  if (goes_on && opener == Keyword::while_) return go(open_.back().place, true) ? Next::line : Next::stop;
  const Keyword end = opener == Keyword::while_   ? Keyword::endwhile
                      : opener == Keyword::repeat ? Keyword::endrepeat
                                                  : Keyword::while_;
  Statement found;
  if (!skip_to(line, opener, statement.name, bit(end), found)) return Next::stop;
  if (goes_on) return opener == Keyword::do_ ? end_of_do(found) : repeat_again();
  open_.pop_back();
  return Next::line;
}

}  // namespace leadscrew::gcode
