#include <fmt/format.h>

#include <algorithm>
#include <leadscrew/gcode/dialect_forms.hpp>
#include <leadscrew/gcode/printer_commands.hpp>
#include <leadscrew/language/code_page.hpp>
#include <leadscrew/language/code_words.hpp>
#include <vector>

namespace leadscrew::language {

namespace {

using gcode::CodeRow;

constexpr std::string_view head =
    "# G-code\n"
    "\n"
    "Every code that is known: `leadscrew explain CODE` says the same. This page is made by `script/gcode` from the "
    "table of\n"
    "codes in `src/leadscrew/gcode/codes.cpp` and its neighbours in `src/leadscrew/language`; each example is run by a "
    "test.\n"
    "\n"
    "**Dialects.** `--dialect`, or `dialect` in the machine file, says what codes mean. `leadscrew`, which holds "
    "without it, has\n"
    "LinuxCNC's meanings, what LinuxCNC leaves free, and what every CAM writes where it is unambiguous. The others are "
    "strict: a\n"
    "code that one lacks is an error, with the dialects that have it in the hint.\n"
    "\n"
    "**Words.** X, Y, Z, U, V, W are mm (G21) or inches (G20), A, B, C degrees: coordinates (G90) or distances (G91). "
    "F is the\n"
    "feed, S the speed of the spindle, T the tool that M6 changes to, N the number of a block. Other letters belong to "
    "a code\n"
    "of their block, as said below. *Needed* words are in bold.\n";

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '|' || c == '<') result += '\\';
    result += c;
  }
  return result;
}

std::string example_text(std::string_view text) {
  std::string result = "`";
  for (const char c : text) result += c == '\n' ? std::string("`<br>`") : std::string(1, c);
  return result + "`";
}

std::string words_of(const CodeRow& row) {
  std::string text;
  for (const char letter : gcode::word_marks) {
    if (!takes(row.code, letter)) continue;
    const WordMeaning meaning = meaning_of(row.code, letter);
    const std::string_view mark = row.needs.has(letter) ? "**" : "";
    text += fmt::format("{}{}{}{} {}{}", text.empty() ? "" : "<br>", mark, letter, mark, escaped(meaning.meaning),
                        meaning.unit.empty() ? "" : fmt::format(", {}", meaning.unit));
  }
  if (row.takes_axes) text += text.empty() ? "axes" : "<br>axes";
  return text;
}

bool is_before(const CodeRow* a, const CodeRow* b) {
  return std::tuple(a->letter, a->tenths, a->code) < std::tuple(b->letter, b->tenths, b->code);
}

std::string table_of_codes(char letter) {
  std::vector<const CodeRow*> rows;
  for (const CodeRow& row : gcode::code_rows()) {
    if (row.letter == letter) rows.push_back(&row);
  }
  std::ranges::sort(rows, is_before);
  std::string text =
      "\n| code | what it does | words | group | defined in | dialects | example |\n|---|---|---|---|---|---|---|\n";
  for (const CodeRow* row : rows) {
    const std::string read =
        row->read ? "" : fmt::format(" *Known, not read. In its place: {}.*", escaped(gcode::instead_of(row->code)));
    text += fmt::format("| {} | {}.{} | {} | {} | {} | {} | {} |\n", name(row->code), escaped(row->summary), read,
                        words_of(*row), name(row->group), escaped(row->source), gcode::names_of(row->dialects),
                        example_text(example_of(row->code)));
  }
  return text;
}

std::string table_of_forms() {
  std::string text = "\n| form | dialects | such as |\n|---|---|---|\n";
  for (const gcode::FormRow& row : gcode::form_rows()) {
    text += fmt::format("| {} | {} | {} |\n", escaped(row.summary), gcode::names_of(row.dialects),
                        example_text(row.example));
  }
  return text;
}

std::string table_of_printer_commands() {
  std::string text = "\n| command | what it is about |\n|---|---|\n";
  for (const gcode::PrinterCommand& each : gcode::printer_commands()) {
    const std::string last = each.last == each.first ? "" : fmt::format(" … {}{}", each.letter, each.last);
    text += fmt::format("| {}{}{} | {} |\n", each.letter, each.first, last, escaped(each.summary));
  }
  return text;
}

}  // namespace

std::string code_page() {
  return fmt::format(
      "{}\n## G codes\n{}\n## M codes\n{}\n## Forms that are no codes\n\nWhat dialects write in ways of their own. "
      "Where one "
      "lacks a form, it is an error there.\n{}\n## Commands of printers\n\nIn dialect `marlin` these are passed over; "
      "the first "
      "of each kind that asks something of hardware is told as a\nwarning.\n{}",
      head, table_of_codes('G'), table_of_codes('M'), table_of_forms(), table_of_printer_commands());
}

}  // namespace leadscrew::language
