// Going from place to place, and looking for where to go.

#include <cmath>
#include <leadscrew/gcode/flow_scan.hpp>
#include <utility>

namespace leadscrew::gcode {

namespace {

constexpr std::int64_t lines_of_reopening = 500;  // what it takes is what so many lines take

}  // namespace

Flow::Flow(ProgramText& text, const Context& context, const Predefined& predefined)
    : text_(text),
      parameters_(context.parameters),
      modal_(context.modal),
      reporter_(context.reporter),
      options_(context.options),
      values_(parameters_, predefined, reporter_, options_),
      statements_(values_, reporter_, options_.dialect, options_.block_delete),
      fuel_(options_.fuel) {
  // Jumps lead to blocks before them.
  if (statements_.has_macros() || options_.repeats) text_.keep_all();
}

bool Flow::out_of_fuel() {
  return reporter_.error(
      "fuel-exhausted", 1,
      "the program has not ended after " + std::to_string(options_.fuel) + " lines in loops and subprograms",
      "is a loop endless?");
}

Flow::Next Flow::error(const Statement& at, std::string_view code, std::string message, std::string hint) {
  reporter_.error(code, at.column, std::move(message), std::move(hint));
  return Next::stop;
}

std::string Flow::shown(Keyword keyword, StatementName of) const {
  if (keyword < Keyword::macro_if) return statements_.text(of) + " " + std::string(name(keyword));
  std::string text(name(keyword));
  if (keyword == Keyword::macro_do || keyword == Keyword::macro_end) text += std::to_string(of);
  return text;
}

/// Goes on from there; a visit of its own where lines may be read again.
bool Flow::go(const TextPlace& place, bool is_visit) {
  if (is_visit) {
    counts_ = true;
    text_.set_visit(++visits_);
  }
  const std::int64_t reopenings = text_.reopenings();
  const auto gone = text_.go_to(place);
  if (counts_) fuel_ -= (text_.reopenings() - reopenings) * lines_of_reopening;
  if (gone) return true;
  const base::Diagnostic& problem = gone.error();
  if (problem.code == "text-not-kept") return reporter_.error(problem.code, 1, problem.message, problem.hint);
  failure_ = problem;
  return false;
}

/// After a search that went behind it: to the line again, for a report.
bool Flow::return_to_line(TextLine& line) {
  const base::Line id = line.id;
  if (!go(place_of(line), false) || !text_.next(line)) return false;
  line.id = id;
  reporter_.begin(line);
  return true;
}

/// Over blanks and remarks; one that does not end is left where it begins.
void Flow::skip_remarks(const char*& p) {
  for (skip_blanks(p); *p == '('; skip_blanks(p)) {
    const char* end = p;
    int depth = 0;
    do {
      depth += (*end == '(') - (*end == ')');
    } while (depth > 0 && *++end != '\n');
    if (depth > 0) return;
    p = end + 1;
  }
}

/// Nothing but remarks may stand there.
bool Flow::at_end(const char* p) {
  skip_remarks(p);
  if (*p == '\n' || *p == ';' || *p == '(') return true;
  return reporter_.error("bad-o-word", reporter_.column(p), gcode::shown(*p) + " stands behind the statement",
                         "a statement has a line for itself");
}

bool Flow::bracketed_value(const char*& p, double& value) {
  skip_blanks(p);
  if (*p == '[') return values_.value(p, value);
  return reporter_.error("bad-o-word", reporter_.column(p), "no value in brackets stands behind the keyword",
                         "o100 if [#1 GT 2]");
}

bool Flow::condition(const char*& p, bool& holds) {
  double value = 0;
  if (!bracketed_value(p, value)) return false;
  holds = value != 0 && !std::isnan(value);
  return true;
}

/// From a line that opens something to the next statement of its name that is wanted; the line is that statement's
/// then. False where there is none, which has been reported.
bool Flow::skip_to(TextLine& line, Keyword opener, StatementName name, Keywords wanted, Statement& found) {
  const TextPlace from = place_of(line);
  const Key at = key(from);
  if (const auto known = matches_.find(at); known != matches_.end()) {
    if (!go(known->second, false) || !text_.next(line)) return false;
    reporter_.begin(line);
    return statements_.read(line, found);
  }
  TextLine origin = line;
  Keyword in_the_way = Keyword::none;
  const bool is_macro = opener >= Keyword::macro_if;
  const Keywords openers = is_macro ? bit(Keyword::macro_do) | bit(Keyword::macro_while)
                                    : bit(Keyword::if_) | bit(Keyword::while_) | bit(Keyword::do_) |
                                          bit(Keyword::repeat) | bit(Keyword::sub);
  const Keywords borders = is_macro                 ? bit(Keyword::program)
                           : opener == Keyword::sub ? bit(Keyword::sub)
                                                    : bit(Keyword::sub) | bit(Keyword::endsub);
  const bool is_found = scan(line, found, [&] {
    const Keywords kind = bit(found.keyword);
    const bool is_of_name = found.name == name;
    if (is_of_name && (kind & wanted)) return true;
    if ((is_of_name && (kind & openers)) || (kind & borders)) in_the_way = found.keyword;
    return in_the_way != Keyword::none;
  });
  if (is_found && in_the_way == Keyword::none) {
    if (matches_.size() >= most_remembered) matches_.clear();
    matches_.emplace(at, place_of(line));
    return statements_.read(line, found);
  }
  if (is_found && in_the_way == Keyword::sub && opener == Keyword::sub) {
    return reporter_.error("nested-sub", found.column, "a subroutine begins within " + shown(opener, name),
                           "end that one before");
  }
  if (is_found && found.name == name && (bit(in_the_way) & openers)) {
    return reporter_.error("duplicate-label", found.column, shown(opener, name) + " is open here already",
                           "give one of them another number");
  }
  if (text_.failure() || !return_to_line(origin)) return false;
  return reporter_.error("unmatched-o-word", origin.text - origin.begin + 1, shown(opener, name) + " does not end",
                         "add its end");
}

Flow::Next Flow::end_of_text() {
  const auto report = [this](const TextPlace& place, std::string message, std::string hint) {
    const base::Place at{text_.names()[static_cast<std::size_t>(place.file)], place.line, 1};
    reporter_.report(base::Severity::error, "unmatched-o-word", at, std::move(message), std::move(hint));
    return Next::stop;
  };
  if (open_.size() > first_open()) {
    const Open& last = open_.back();
    return report(last.place, shown(last.keyword, last.name) + " does not end", "add its end");
  }
  if (calls_.empty()) return Next::program_end;
  const Call& last = calls_.back();
  if (last.kind == CallKind::profile) {
    return report(last.body, "the contour does not come to block N" + statements_.file_name(last.name),
                  "Q of the cycle is a block behind P, which no jump passes by");
  }
  const bool is_sub = last.kind == CallKind::o_word;
  TextPlace begin = last.body;
  if (begin.line > 1) --begin.line;
  return report(begin, "the subprogram " + statements_.file_name(last.name) + " does not end",
                is_sub ? "add endsub" : "add M99");
}

}  // namespace leadscrew::gcode
