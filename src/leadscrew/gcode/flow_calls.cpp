// Subprograms: O words, program numbers, M97, M98 and M99, in the text of the program and in files of their own.

#include <cmath>
#include <leadscrew/gcode/flow_scan.hpp>
#include <utility>

namespace leadscrew::gcode {

namespace {

constexpr std::size_t most_subs = 100'000;
constexpr int most_repeats = 1'000'000'000;
// What a subroutine returns (LinuxCNC manual, "O Codes: Subroutines").
const std::string return_value = "_VALUE";
const std::string has_returned = "_VALUE_RETURNED";

}  // namespace

/// A definition is remembered and passed over.
Flow::Next Flow::define(const Statement& statement, TextLine& line) {
  if (!calls_.empty() && calls_.back().kind == CallKind::o_word) {
    return error(statement, "nested-sub", "a subroutine begins within " + statements_.text(calls_.back().name),
                 "end that one before");
  }
  if (!at_end(statement.rest)) return Next::stop;
  if (!add_sub(statement.name, {text_.place(), false}, statement) || !meet_sub(statement)) return Next::stop;
  Statement found;
  if (!skip_to(line, Keyword::sub, statement.name, bit(Keyword::endsub), found)) return Next::stop;
  return Next::line;
}

bool Flow::add_sub(StatementName name, const Sub& sub, const Statement& at) {
  if (subs_.size() >= most_subs) {
    return reporter_.error("too-many-subs", at.column,
                           "there are more than " + std::to_string(most_subs) + " subprograms", "use fewer");
  }
  const auto [found, is_new] = subs_.emplace(key(sub.body.file, name), sub);
  if (is_new || found->second.body == sub.body) return true;
  // LinuxCNC takes the first, and minds only another `sub` that it comes to (meet_sub).
  if (options_.dialect == Dialect::linuxcnc) return true;
  return reporter_.error("duplicate-sub", at.column,
                         "subprogram " + statements_.file_name(name) + " has begun in line " +
                             std::to_string(found->second.body.line - 1) + " already",
                         "give one of them another name");
}

/// LinuxCNC comes to a definition once, and not where the subroutine has been called before.
bool Flow::meet_sub(const Statement& statement) {
  if (options_.dialect != Dialect::linuxcnc) return true;
  Sub& sub = subs_.find(key(text_.place().file, statement.name))->second;
  if (sub.body == text_.place() && !std::exchange(sub.is_met, true)) return true;
  return reporter_.error(
      "misplaced-sub", statement.column,
      "the program comes to " + shown(Keyword::sub, statement.name) + ", which it has called or passed over before",
      "define subroutines before their first call, or behind the program's M2");
}

const Flow::Sub* Flow::known_sub(StatementName name) const {
  for (const int file : {text_.place().file, 0}) {
    if (const auto found = subs_.find(key(file, name)); found != subs_.end()) return &found->second;
  }
  const auto file = files_.find(name);
  if (file == files_.end()) return nullptr;
  const auto found = subs_.find(key(file->second, name));
  return found == subs_.end() ? nullptr : &found->second;
}

/// Finds the subprograms of a file: all of them, or those behind the line where the text cannot be opened anew.
bool Flow::index_subs(int file, TextLine& line) {
  const auto number = static_cast<std::size_t>(file);
  if (indexed_.size() <= number) indexed_.resize(number + 1);
  if (indexed_[number]) return true;
  indexed_[number] = true;
  const TextLine origin = line;
  if ((options_.opener || file != base::file(line.id)) && !go({file, 0, 1}, false)) return false;
  TextLine at;
  Statement statement;
  bool is_good = true;
  scan(at, statement, [&] {
    if (statement.keyword != Keyword::sub && statement.keyword != Keyword::program) return false;
    reporter_.begin(at);
    is_good = add_sub(statement.name, {text_.place(), statement.keyword == Keyword::program}, statement);
    return !is_good;
  });
  line = origin;
  return is_good && !text_.failure() && return_to_line(line);
}

/// Of that name: in the text that calls it, in the program's, or in a file. Null where there is none, which has been
/// reported; otherwise the next line is still that behind `line`.
const Flow::Sub* Flow::find_sub(StatementName name, bool is_program, TextLine& line) {
  const Sub* found = known_sub(name);
  if (!found) {
    if (!index_subs(base::file(line.id), line)) return nullptr;
    if (base::file(line.id) != 0 && options_.opener && !index_subs(0, line)) return nullptr;
    found = known_sub(name);
  }
  if (!found) found = open_sub(name, is_program, line);
  if (!found) return nullptr;
  if (found->is_program == is_program) return found;
  const std::string called = statements_.file_name(name);
  reporter_.error("missing-sub", 1, "subprogram " + called + (is_program ? " begins with sub" : " is a program number"),
                  is_program ? "o" + called + " call" : "M98 P" + called);
  return nullptr;
}

/// Of a file. One without a program number begins at its beginning.
const Flow::Sub* Flow::open_sub(StatementName name, bool is_program, TextLine& line) {
  const std::string called = statements_.file_name(name);
  const auto file = text_.open(called);
  if (!file) {
    reporter_.error(file.error().code, 1, "there is no subprogram " + called + ": " + file.error().message,
                    file.error().hint);
    return nullptr;
  }
  reporter_.set_files(text_.names());
  files_[name] = *file;
  if (!index_subs(*file, line)) return nullptr;
  if (const Sub* const found = known_sub(name)) return found;
  if (is_program) return &subs_.emplace(key(*file, name), Sub{{*file, 0, 1}, true}).first->second;
  reporter_.error(
      "missing-sub", 1,
      "file " + text_.names()[static_cast<std::size_t>(*file)] + " has no " + statements_.text(name) + " sub",
      "the subroutine of a file has the file's name");
  return nullptr;
}

Flow::Next Flow::call(const Statement& statement, TextLine& line) {
  Call call{.kind = CallKind::o_word, .name = statement.name};
  const char* p = statement.rest;
  for (skip_remarks(p); *p == '['; skip_remarks(p)) {
    double value = 0;
    if (!values_.value(p, value)) return Next::stop;
    if (call.arguments.size() == Parameters::locals) {
      return error(statement, "too-many-arguments",
                   "a subroutine is given more than " + std::to_string(Parameters::locals) + " values",
                   "pass the others by #<_names>");
    }
    call.arguments.push_back(value);
  }
  if (!at_end(p)) return Next::stop;
  const Sub* const sub = find_sub(statement.name, false, line);
  if (!sub) return Next::stop;
  call.body = call.program = sub->body;
  subs_.find(key(sub->body.file, statement.name))->second.is_met = true;
  return begin_call(std::move(call), statement);
}

Flow::Next Flow::begin_call(Call call, const Statement& at) {
  const std::size_t most = options_.dialect == Dialect::linuxcnc ? most_calls_of_linuxcnc : most_calls;
  if (calls_.size() >= most) {
    return error(at, "calls-too-deep", "calls are nested more than " + std::to_string(most) + " deep",
                 "does a subprogram call itself without end?");
  }
  call.return_to = text_.place();
  call.open = open_.size();
  const bool has_locals = call.kind == CallKind::o_word || call.kind == CallKind::macro;
  if (has_locals) parameters_.enter_call(call.arguments);
  const TextPlace body = call.body;
  calls_.push_back(std::move(call));
  modal_.calls = calls_.size();
  return go(body, true) ? Next::line : Next::stop;
}

Flow::Next Flow::call_contour(double number, std::uint32_t at, const TextLine& line) {
  text_.keep(line);
  Statement statement;
  statement.column = at;
  TextLine of_block = line;
  Call call{.kind = CallKind::o_word};
  if (!statements_.number(number, at, call.name)) return Next::stop;
  const Sub* const sub = find_sub(call.name, false, of_block);
  if (!sub) return Next::stop;
  call.body = call.program = sub->body;
  return begin_call(std::move(call), statement);
}

/// endsub or return. A return may have any name: it is that of the subroutine it stands in (LinuxCNC).
Flow::Next Flow::return_from(const Statement& statement) {
  const bool is_inside = !calls_.empty() && calls_.back().kind == CallKind::o_word;
  if (!is_inside || (statement.keyword == Keyword::endsub && calls_.back().name != statement.name)) {
    return error(
        statement, "return-outside-sub",
        shown(statement.keyword, statement.name) + " stands outside " + statements_.text(statement.name) + " sub",
        is_inside ? "this is " + statements_.text(calls_.back().name) : "");
  }
  if (statement.keyword == Keyword::endsub && innermost()) return unmatched(statement);
  const char* p = statement.rest;
  skip_blanks(p);
  double value = 0;
  const bool returns = *p == '[';
  if ((returns && !values_.value(p, value)) || !at_end(p)) return Next::stop;
  parameters_.set(return_value, value);
  parameters_.set(has_returned, returns ? 1 : 0);
  return end_call(std::nullopt, statement);
}

/// Once more where it is repeated, else to the line behind the call, or to a block of the caller's program.
Flow::Next Flow::end_call(std::optional<StatementName> block_number, const Statement& at) {
  Call& last = calls_.back();
  open_.resize(last.open);
  const bool has_locals = last.kind == CallKind::o_word || last.kind == CallKind::macro;
  if (has_locals) parameters_.leave_call();
  modal_.fewest_calls = std::min(modal_.fewest_calls, calls_.size() - 1);
  if (last.left > 1 && !block_number) {
    --last.left;
    if (has_locals) parameters_.enter_call(last.arguments);
    return go(last.body, true) ? Next::line : Next::stop;
  }
  const TextPlace back = last.return_to;
  if (last.is_modal) activate_modal_calls(active_modal_calls_ + 1);
  calls_.pop_back();
  modal_.calls = calls_.size();
  if (!go(back, true)) return Next::stop;
  if (!block_number) return Next::line;
  TextLine line;
  if (!text_.next(line)) return Next::line;
  return go_to_block(static_cast<std::int64_t>(*block_number), line, at);
}

/// The number of the program is said at its beginning; further ones begin subprograms.
Flow::Next Flow::program_number(const Statement& statement) {
  if (!add_sub(statement.name, {text_.place(), true}, statement)) return Next::stop;
  return Next::line;
}

Flow::Next Flow::execute(const Block& block, const TextLine& line) {
  text_.keep(line);
  if (block.is(Code::G65) || block.is(Code::G66)) {
    Statement at;
    at.column = block.column_of(Group::call);
    const std::string code = name(block.code(Group::call));
    return error(at, "bad-o-word", code + " stands behind other words", code + " begins its block");
  }
  constexpr std::uint32_t own = letter_bit('N') | letter_bit('P') | letter_bit('L');
  const bool stands_alone = !(block.words & ~own) && !(block.groups & ~gcode::bit(Group::call));
  if (options_.dialect == Dialect::linuxcnc && (!stands_alone || (block.is(Code::M99) && block.has('P')))) {
    Statement at;
    at.column = block.column_of(Group::call);
    return error(at, "bad-o-word", name(block.code(Group::call)) + " stands beside other words",
                 "LinuxCNC has it alone; dialect leadscrew takes it");
  }
  return block.is(Code::M99) ? return_program(block, line) : call_program(block, line);
}

/// L of M97 and M98; none: it has been reported.
std::optional<std::int64_t> Flow::repeats(const Block& block) {
  const std::optional<int> count = as_integer(block.value_or('L', 1));
  if (count && *count >= 0 && *count <= most_repeats) return *count;
  reporter_.error("bad-value", block.column_of('L'), "a subprogram is to be repeated " + text(block['L']) + " times",
                  "L must be an integer of 0 or more");
  return std::nullopt;
}

/// M97 and M98.
Flow::Next Flow::call_program(const Block& block, const TextLine& line) {
  Statement at;
  at.column = block.column_of(Group::call);
  std::optional<std::int64_t> count = repeats(block);
  StatementName number = 0;
  if (!block.has('P')) {
    return error(at, "missing-word", name(block.code(Group::call)) + " lacks P", "give the number of the subprogram");
  }
  if (!count || !statements_.number(block['P'], block.column_of('P'), number)) return Next::stop;
  const bool is_local = block.is(Code::M97);
  constexpr StatementName most_program = 10'000;
  // Fanuc's P of more than four digits: how often, and then the number.
  if (!is_local && is_of_fanuc_family(options_.dialect) && options_.dialect != Dialect::haas && !block.has('L') &&
      number >= most_program) {
    count = static_cast<std::int64_t>(number / most_program);
    number %= most_program;
  }
  TextLine of_block = line;
  Call call{.kind = is_local ? CallKind::block_number : CallKind::program, .name = number, .left = *count};
  if (is_local) {
    Label label;
    if (!find_label(static_cast<std::int64_t>(number), of_block, at, label)) return Next::stop;
    call.body = label.place;
    call.program = program_begin();
  } else {
    const Sub* const sub = find_sub(number, true, of_block);
    if (!sub) return Next::stop;
    call.body = call.program = sub->body;
  }
  if (*count == 0) return Next::line;
  return begin_call(std::move(call), at);
}

Flow::Next Flow::return_program(const Block& block, const TextLine& line) {
  Statement at;
  at.column = block.column_of(Group::call);
  std::optional<StatementName> number;
  if (block.has('P')) {
    number.emplace();
    if (!statements_.number(block['P'], block.column_of('P'), *number)) return Next::stop;
  }
  if (!calls_.empty()) {
    if (calls_.back().kind == CallKind::o_word && options_.dialect == Dialect::linuxcnc) {
      return error(at, "unmatched-o-word", "M99 stands in " + statements_.text(calls_.back().name) + " sub",
                   "that one ends with endsub or return");
    }
    return end_call(number, at);
  }
  TextLine of_block = line;
  if (number) return go_to_block(static_cast<std::int64_t>(*number), of_block, at);
  if (options_.repeats) {
    open_.clear();
    for (auto& [place, sub] : subs_) sub.is_met = false;
    return go({}, true) ? Next::line : Next::stop;
  }
  reporter_.report(base::Severity::note, "program-repeats", {reporter_.file(), line.number, at.column},
                   "M99 would begin the program again", "it is read once");
  return Next::program_end;
}

}  // namespace leadscrew::gcode
