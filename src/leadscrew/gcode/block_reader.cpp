#include <array>
#include <cmath>
#include <cstring>
#include <leadscrew/gcode/block_reader.hpp>
#include <leadscrew/gcode/dialect_forms.hpp>
#include <leadscrew/gcode/polar.hpp>

namespace leadscrew::gcode {

namespace {

// What a character begins, where a word may begin.
enum Class : std::uint8_t { first_letter = 0, last_letter = 25, blank, line_end, remark, parameter, mark, other };

constexpr std::array<std::uint8_t, 256> make_classes() {
  std::array<std::uint8_t, 256> classes{};
  for (auto& c : classes) c = other;
  for (unsigned i = 0; i < 26; ++i) classes['A' + i] = classes['a' + i] = static_cast<std::uint8_t>(i);
  classes[' '] = classes['\t'] = classes['\r'] = blank;
  classes['\n'] = classes[';'] = line_end;
  classes['('] = remark;
  classes['#'] = parameter;
  classes['@'] = classes['^'] = classes['$'] = mark;
  return classes;
}
constexpr std::array<std::uint8_t, 256> classes = make_classes();

// Bounds every sum of offsets, so that coordinates are finite.
constexpr double largest_value = 1e9;

// Variables of the system that macros set (Fanuc custom macro B, "System Variables").
constexpr int alarm = 3000, clock_of_milliseconds = 3001, clock_of_hours = 3002, single_block = 3003, holds = 3004,
              message_stop = 3006;

constexpr bool is_clock(int number) {
  return number == clock_of_milliseconds || number == clock_of_hours;
}

constexpr unsigned index_of(char letter) {
  return static_cast<unsigned>(letter - 'A');
}
constexpr char letter_at(unsigned index) {
  return static_cast<char>('A' + index);
}

// Ten times the number of a G word, to within a thousandth, from 0 to 1999.
std::optional<int> tenths_of(double value) {
  const double tenths = value * 10;
  if (!(tenths >= -0.5 && tenths < static_cast<double>(detail::most_g) - 0.5)) return std::nullopt;
  const int below = static_cast<int>(tenths);
  const int nearest = tenths - below > 0.5 ? below + 1 : below;
  if (std::fabs(tenths - nearest) > 1e-3) return std::nullopt;
  return nearest;
}

}  // namespace

bool BlockReader::read(const TextLine& line, Block& block) {
  block.clear();
  const char* p = line.text;
  skip_blanks(p);
  if (*p == '/') {
    if (block_delete_) return false;
    ++p;
  }
  bool any = false;
  bool in_step = true;
  while (in_step) {
    const std::uint8_t kind = classes[static_cast<unsigned char>(*p)];
    if (kind <= last_letter) {
      if (!any) block.first_column = static_cast<std::uint32_t>(p - line.begin) + 1;
      any = true;
      in_step = word(p, kind, block);
    } else if (kind == blank) {
      ++p;
    } else if (kind == line_end) {
      // A remark runs to the end of a line that is all here.
      if (*p == ';' && Remarks::may_ask(p + 1)) note_remark(p + 1, line.end);
      break;
    } else if (kind == remark) {
      in_step = comment(p);
    } else if (kind == parameter) {
      if (!any) block.first_column = static_cast<std::uint32_t>(p - line.begin) + 1;
      any = true;
      in_step = assignment(p);
    } else if (kind == mark && (*p != '$' || begins_spindle_number(p))) {
      if (!any) block.first_column = static_cast<std::uint32_t>(p - line.begin) + 1;
      any = true;
      in_step = marked_word(p, block);
    } else {
      in_step = other(p, line);
    }
  }
  block.complete = in_step;
  if (block.has(Group::cutter_radius) && block.has(Group::nonmodal)) set_side(block);
  if (!assignments_.empty()) assign(block);
  if (remark_.data() != nullptr) {
    if (in_step) remarks_.execute(remark_);
    remark_ = {};
  }
  return any;
}

bool BlockReader::word(const char*& p, unsigned letter, Block& block) {
  const char* const begin = p++;
  if (letter == index_of('O')) return refuse_o_word(begin, block);
  double value = 0;
  if (!values_.value(p, value)) return false;
  const auto column = static_cast<std::uint32_t>(reporter_.column(begin));
  if (letter == index_of('G')) return g_word(value, column, block);
  if (letter == index_of('M')) return m_word(value, column, block);
  if (!(std::fabs(value) <= largest_value)) return refuse_value(letter, value, column);
  const std::uint32_t bit = std::uint32_t{1} << letter;
  if (block.words & bit) return refuse_repeated(letter, column);
  block.words |= bit;
  block.value[letter] = value;
  block.column[letter] = column;
  return true;
}

bool BlockReader::has_marked_words() const {
  return dialect_ == Dialect::leadscrew || dialect_ == Dialect::linuxcnc;
}

bool BlockReader::begins_spindle_number(const char* p) const {
  if (!has_marked_words()) return false;
  skip_blanks(++p);
  return *p != 0 && std::strchr("+-.#[0123456789", *p) != nullptr;
}

bool BlockReader::marked_word(const char*& p, Block& block) {
  const char* const begin = p++;
  if (!has_marked_words()) {
    return reporter_.error("bad-character", reporter_.column(begin),
                           shown(*begin) + " is not of dialect " + std::string(name(dialect_)),
                           "polar words are known by --dialect leadscrew and linuxcnc");
  }
  double value = 0;
  if (!values_.value(p, value)) return false;
  const auto column = static_cast<std::uint32_t>(reporter_.column(begin));
  const std::size_t i = word_marks.find(*begin);
  const std::uint32_t bit = std::uint32_t{1} << i;
  if (std::isnan(value)) return true;
  if (!(std::fabs(value) <= largest_value)) {
    return reporter_.error("bad-value", column, *begin + text(value) + " is out of all bounds",
                           "at most 1e9 in magnitude");
  }
  if (block.words & bit) {
    reporter_.error("repeated-word", column, std::string(1, *begin) + " stands in this block already", "once");
    return true;
  }
  block.words |= bit;
  block.value[i] = value;
  block.column[i] = column;
  return true;
}

bool BlockReader::refuse_o_word(const char* begin, Block& block) {
  block.clear();
  assignments_.clear();
  return reporter_.error("unsupported-o-word", reporter_.column(begin),
                         "O words are not read: subroutines, loops, conditions", "write the program out in full");
}

// A word whose value is vacant is as if it did not stand there (Fanuc).
bool BlockReader::refuse_value(unsigned letter, double value, std::uint32_t column) {
  if (std::isnan(value)) return true;
  return reporter_.error("bad-value", column, std::string(1, letter_at(letter)) + text(value) + " is out of all bounds",
                         "at most 1e9 in magnitude");
}

bool BlockReader::refuse_repeated(unsigned letter, std::uint32_t column) {
  reporter_.error("repeated-word", column, std::string(1, letter_at(letter)) + " stands in this block already",
                  "each letter but G and M once");
  return true;
}

// Problems with a code do not lose the place in the line: reading goes on behind them.
bool BlockReader::g_word(double value, std::uint32_t column, Block& block) {
  const std::optional<int> tenths = tenths_of(value);
  const Code code = tenths ? g_code(dialect_, *tenths) : Code::none;
  if (code == Code::G150) block.user_code = 0;
  if (code == Code::G110) block.further_system = static_cast<std::int16_t>(*tenths / 10 - 109);
  return code_word('G', code, value, column, block);
}

bool BlockReader::m_word(double value, std::uint32_t column, Block& block) {
  const int number = as_integer(value).value_or(-1);
  const bool known = 0 <= number && number < static_cast<int>(detail::most_m);
  const Code code = known ? m_code(dialect_, number) : Code::none;
  if (code == Code::M100) block.user_code = static_cast<std::int16_t>(number);
  return code_word('M', code, value, column, block);
}

bool BlockReader::code_word(char letter, Code code, double value, std::uint32_t column, Block& block) {
  if (code == Code::none) return refuse_unknown(letter, value, column);
  const CodeRow& known = row(code);
  if (!known.read || block.has(known.group)) return refuse_code(code, column, block);
  block.groups |= bit(known.group);
  block.codes[index(known.group)] = code;
  block.code_columns[index(known.group)] = column;
  return true;
}

bool BlockReader::refuse_unknown(char letter, double value, std::uint32_t column) {
  if (std::isnan(value)) return true;
  std::optional<int> tenths = tenths_of(value);
  if (const auto number = as_integer(value); letter == 'M' && number && 0 <= *number && *number < 1000)
    tenths = *number * 10;
  const Dialects others = tenths ? dialects_of(letter, *tenths) : Dialects{};
  if (others.empty()) {
    reporter_.error("unknown-code", column, letter + text(value) + " is not known", "docs/gcode.md lists all codes");
  } else {
    reporter_.error("unknown-code", column, name(letter, *tenths) + " is not of dialect " + std::string(name(dialect_)),
                    "known by --dialect " + names_of(others));
  }
  return true;
}

bool BlockReader::refuse_code(Code code, std::uint32_t column, Block& block) {
  const CodeRow& known = row(code);
  const bool cancels =
      known.group == Group::motion && (code == Code::G80 || block.is(Code::G80)) && code != block.code(Group::motion);
  if (known.read && cancels && has_form(dialect_, Form::g80_beside_motion)) {
    if (code == Code::G80) return true;
    block.codes[index(Group::motion)] = code;
    block.code_columns[index(Group::motion)] = column;
    return true;
  }
  if (!known.read) {
    reporter_.error("unsupported-code", column, name(code, dialect_) + " (" + known.summary + ") is not supported",
                    instead_of(code));
  } else {
    reporter_.error("modal-conflict", column,
                    name(code, dialect_) + " and " + name(block.code(known.group), dialect_) + " stand in one block",
                    "both are of " + name(known.group) + ": one block, one of them");
  }
  return true;
}

// Haas: G150 has G41 or G42 beside it, which say the side of its contour.
void BlockReader::set_side(Block& block) {
  if (!block.is(Code::G150)) return;
  block.user_code = static_cast<std::int16_t>(block.is(Code::G41) ? 41 : block.is(Code::G42) ? 42 : 0);
  block.groups &= ~bit(Group::cutter_radius);
}

bool BlockReader::assignment(const char*& p) {
  Assignment assignment;
  assignment.column = reporter_.column(p++);
  if (!values_.parameter_name(p, assignment.name)) return false;
  if (*p != '=') {
    return reporter_.error("bad-parameter", assignment.column, "a parameter stands where a word should",
                           "set it with '=', or put a letter before it");
  }
  ++p;
  if (!values_.assigned_value(p, assignment.value)) return false;
  if (can_assign(assignment, p)) assignments_.push_back(std::move(assignment));
  return true;
}

bool BlockReader::can_assign(const Assignment& assignment, const char* rest) {
  const auto& [name, value, column] = assignment;
  if (!name.name.empty()) {
    return name.name.front() != '_' || !Predefined::is_read_only(name.name) || refuse_assignment(assignment);
  }
  if (name.number == 0 || Predefined::is_read_only(name.number)) return refuse_assignment(assignment);
  if (has_macros(dialect_) && name.number >= Predefined::first_macro_number) return can_assign_macro(assignment, rest);
  if (!Parameters::is_offset(name.number)) return true;
  if (name.number == Parameters::current_system) {
    reporter_.warning("parameter-without-effect", column, "#5220 selects no coordinate system",
                      "G54 ... G59.3 select one");
  }
  return std::fabs(value) <= largest_value ||
         reporter_.error("bad-value", column, "an offset of " + text(value) + " is out of all bounds",
                         "at most 1e9 in magnitude");
}

// #3000 stops the program with an alarm, #3006 pauses it with a message (Fanuc).
bool BlockReader::can_assign_macro(const Assignment& assignment, const char* rest) {
  const int number = assignment.name.number;
  skip_blanks(rest);
  const std::string remark = *rest == '(' ? printable({rest + 1, std::strcspn(rest + 1, ")\n")}) : std::string();
  if (number == alarm) {
    std::string message = "the program stops here with alarm " + text(assignment.value);
    if (!remark.empty()) message += ": " + remark;
    reporter_.error("program-alarm", assignment.column, std::move(message), "find out why it sets #3000");
    reporter_.stop();
    return false;
  }
  if (number == message_stop) {
    message_ = remark.empty() ? text(assignment.value) : remark;
    return true;
  }
  if (is_clock(number)) return true;
  if (number == single_block || number == holds) {
    reporter_.warning("parameter-without-effect", assignment.column,
                      "#" + std::to_string(number) + " keeps nobody from holding the program here",
                      "single blocks, feed hold and overrides stay as they are");
    return true;
  }
  if (!Predefined::is_macro_offset(number)) {
    return reporter_.error(
        "unsupported-parameter", assignment.column,
        "#" + std::to_string(number) + " is a system variable that cannot be set",
        "#1 to #999 are variables; of the system's can be set #3000 to #3004, #3006 and #5221 to #5390");
  }
  return std::fabs(assignment.value) <= largest_value ||
         reporter_.error("bad-value", assignment.column,
                         "an offset of " + text(assignment.value) + " is out of all bounds",
                         "at most 1e9 in magnitude");
}

// The number of the system's variable is one that can_assign_macro() lets pass.
void BlockReader::set_of_system(const Assignment& assignment, Block& block) {
  if (assignment.name.number != message_stop) return;
  remarks_.show(message_, assignment.column);
  if (block.has(Group::stop)) return;
  block.groups |= bit(Group::stop);
  block.codes[index(Group::stop)] = Code::M0;
  block.code_columns[index(Group::stop)] = block.first_column;
}

void BlockReader::set_number(int number, double value) {
  if (std::isnan(value)) {
    parameters_.unset(number);
  } else {
    parameters_.set(number, value);
  }
}

// The line goes on behind it.
bool BlockReader::refuse_assignment(const Assignment& assignment) {
  const auto& name = assignment.name;
  const std::string shown_name = name.name.empty() ? "#" + std::to_string(name.number) : "#<" + name.name + ">";
  return reporter_.error("read-only-parameter", assignment.column, shown_name + " cannot be set",
                         "it tells what holds; choose another name or a number from 31 to 5000");
}

// Settings take effect when the whole line has been read, each in its turn (3.3.2.1).
void BlockReader::assign(Block& block) {
  for (const Assignment& assignment : assignments_) {
    const int number = assignment.name.number;
    const bool is_of_system = assignment.name.name.empty() && alarm <= number && number <= message_stop;
    if (is_of_system && has_macros(dialect_)) {
      set_of_system(assignment, block);
    } else if (assignment.name.name.empty()) {
      set_number(assignment.name.number, assignment.value);
    } else if (!parameters_.set(assignment.name.name, assignment.value)) {
      reporter_.error("too-many-parameters", assignment.column,
                      "there are more than " + std::to_string(Parameters::most_names) + " named parameters",
                      "use numbered ones");
    }
  }
  assignments_.clear();
}

bool BlockReader::comment(const char*& p) {
  const char* const open = p++;
  remark_ = {};
  for (; *p != ')'; ++p) {
    if (*p == '\n') {
      return reporter_.error("unclosed-comment", reporter_.column(open), "this comment does not end", "add ')'");
    }
    if (*p == '(') return nested_comment(open, p);
  }
  if (Remarks::may_ask(open + 1)) note_remark(open + 1, p);
  ++p;
  return true;
}

// Where every bracket is closed it is plain what was meant.
bool BlockReader::nested_comment(const char* open, const char*& p) {
  const std::int64_t column = reporter_.column(p);
  const char* end = open;
  for (int depth = 0; *end != '\n';) {
    depth += *end == '(' ? 1 : *end == ')' ? -1 : 0;
    ++end;
    if (depth != 0) continue;
    if (dialect_ != Dialect::leadscrew) break;
    reporter_.warning("nested-comment", column, "a comment begins within a comment",
                      "other controls refuse this: use square brackets within comments");
    p = end;
    return true;
  }
  return reporter_.error("nested-comment", column, "a comment begins within a comment", "comments cannot be nested");
}

void BlockReader::note_remark(const char* begin, const char* end) {
  if (dialect_ != Dialect::leadscrew && dialect_ != Dialect::linuxcnc) return;
  if (end != begin && end[-1] == '\r') --end;
  remark_ = {begin, static_cast<std::size_t>(end - begin)};
}

}  // namespace leadscrew::gcode
