#include <array>
#include <cmath>
#include <leadscrew/gcode/block_reader.hpp>

namespace leadscrew::gcode {

namespace {

// What a character begins, where a word may begin.
enum Class : std::uint8_t { first_letter = 0, last_letter = 25, blank, line_end, remark, parameter, other };

constexpr std::array<std::uint8_t, 256> make_classes() {
  std::array<std::uint8_t, 256> classes{};
  for (auto& c : classes) c = other;
  for (unsigned i = 0; i < 26; ++i) classes['A' + i] = classes['a' + i] = static_cast<std::uint8_t>(i);
  classes[' '] = classes['\t'] = classes['\r'] = blank;
  classes['\n'] = classes[';'] = line_end;
  classes['('] = remark;
  classes['#'] = parameter;
  return classes;
}
constexpr std::array<std::uint8_t, 256> classes = make_classes();

// Bounds every sum of offsets, so that coordinates are finite.
constexpr double largest_value = 1e9;

constexpr unsigned index_of(char letter) {
  return static_cast<unsigned>(letter - 'A');
}
constexpr char letter_at(unsigned index) {
  return static_cast<char>('A' + index);
}

// The code of a G word: ten times its number, to within a thousandth, from 0 to 999.
std::optional<GCode> g_code_of(double value) {
  const double tenths = value * 10;
  if (!(tenths >= -0.5 && tenths < 999.5)) return std::nullopt;
  const auto below = static_cast<GCode>(tenths);
  const auto nearest = static_cast<GCode>(tenths - below > 0.5 ? below + 1 : below);
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
      break;
    } else if (kind == remark) {
      in_step = comment(p);
    } else if (kind == parameter) {
      if (!any) block.first_column = static_cast<std::uint32_t>(p - line.begin) + 1;
      any = true;
      in_step = assignment(p);
    } else {
      in_step = reporter_.error("bad-character", reporter_.column(p), shown(*p) + " stands where a word should",
                                "a letter and a number, #parameter=value, or a comment");
    }
  }
  block.complete = in_step;
  if (!assignments_.empty()) assign();
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

bool BlockReader::refuse_o_word(const char* begin, Block& block) {
  block.clear();
  assignments_.clear();
  return reporter_.error("unsupported-o-word", reporter_.column(begin),
                         "O words are not read: subroutines, loops, conditions", "write the program out in full");
}

bool BlockReader::refuse_value(unsigned letter, double value, std::uint32_t column) {
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
  const std::optional<GCode> code = g_code_of(value);
  const Group group = code ? group_of_g(*code) : Group::unknown;
  if (group >= Group::unsupported || block.has(group)) return refuse_g(value, column, block);
  block.g_groups |= bit(group);
  block.g[index(group)] = *code;
  block.g_column[index(group)] = column;
  return true;
}

bool BlockReader::refuse_g(double value, std::uint32_t column, const Block& block) {
  const std::optional<GCode> code = g_code_of(value);
  const Group group = code ? group_of_g(*code) : Group::unknown;
  if (group == Group::unknown) {
    reporter_.error("unknown-code", column, "G" + text(value) + " is not known", "see the list of G codes");
  } else if (group == Group::unsupported) {
    reporter_.error("unsupported-code", column, g_name(*code) + " is not supported", "see the list of G codes");
  } else {
    reporter_.error("modal-conflict", column,
                    g_name(*code) + " and " + g_name(block.code(group)) + " stand in one block",
                    "both are of modal group " + std::to_string(index(group)) + ": one block, one of them");
  }
  return true;
}

bool BlockReader::m_word(double value, std::uint32_t column, Block& block) {
  const int code = as_integer(value).value_or(-1);
  const int group = group_of_m(code);
  if (group == 0 || block.has_m(group)) return refuse_m(value, column, block);
  const auto g = static_cast<std::size_t>(group);
  block.m_groups |= std::uint32_t{1} << group;
  block.m[g] = static_cast<std::uint8_t>(code);
  block.m_column[g] = column;
  return true;
}

bool BlockReader::refuse_m(double value, std::uint32_t column, const Block& block) {
  const int code = as_integer(value).value_or(-1);
  const int group = group_of_m(code);
  if (group != 0) {
    reporter_.error("modal-conflict", column,
                    "M" + std::to_string(code) + " and M" + std::to_string(block.m[static_cast<std::size_t>(group)]) +
                        " stand in one block",
                    "both are of M group " + std::to_string(group) + ": one block, one of them");
  } else if (is_unsupported_m(code)) {
    reporter_.error("unsupported-code", column, "M" + std::to_string(code) + " is not supported",
                    "M0 to M9, M30, M60, M62 to M65, M67 and M68 are");
  } else {
    reporter_.error("unknown-code", column, "M" + text(value) + " is not known",
                    "M0 to M9, M30, M60, M62 to M65, M67 and M68 are");
  }
  return true;
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
  if (!values_.value(p, assignment.value)) return false;
  if (assignment.name.name.empty() && Parameters::is_read_only(assignment.name.number)) {
    reporter_.error("read-only-parameter", assignment.column,
                    "#" + std::to_string(assignment.name.number) + " cannot be set",
                    "G54 ... G59.3 and moves change it");
    return true;
  }
  if (assignment.name.name.empty() && Parameters::is_offset(assignment.name.number) &&
      !(std::fabs(assignment.value) <= largest_value)) {
    return reporter_.error("bad-value", assignment.column,
                           "an offset of " + text(assignment.value) + " is out of all bounds",
                           "at most 1e9 in magnitude");
  }
  assignments_.push_back(assignment);
  return true;
}

// Settings take effect when the whole line has been read, each in its turn (3.3.2.1).
void BlockReader::assign() {
  for (const Assignment& assignment : assignments_) {
    if (assignment.name.name.empty()) {
      parameters_.set(assignment.name.number, assignment.value);
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
  for (; *p != ')'; ++p) {
    if (*p == '\n') {
      return reporter_.error("unclosed-comment", reporter_.column(open), "this comment does not end", "add ')'");
    }
    if (*p == '(') {
      return reporter_.error("nested-comment", reporter_.column(p), "a comment begins within a comment",
                             "comments cannot be nested");
    }
  }
  ++p;
  return true;
}

}  // namespace leadscrew::gcode
