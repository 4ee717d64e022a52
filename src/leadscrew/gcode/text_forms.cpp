// Text that is neither a word nor a remark: names of programs, checksums, commands to the controller. Which dialect has
// which is in dialect_forms.cpp.

#include <leadscrew/gcode/block_reader.hpp>
#include <leadscrew/gcode/dialect_forms.hpp>

namespace leadscrew::gcode {

namespace {

Form form_of(char c) {
  switch (c) {
    case '<':
      return Form::program_name;
    case '*':
      return Form::checksum;
    case '$':
    case '!':
    case '~':
    case '?':
      return Form::controller_commands;
    default:
      return Form::count;
  }
}

// Whether the text begins with the mark of UTF-16.
[[gnu::cold]] bool begins_wide_text(const TextLine& line) {
  const std::string_view text(line.begin, static_cast<std::size_t>(line.end - line.begin));
  return line.number == 1 && (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"));
}

}  // namespace

bool BlockReader::other(const char*& p, const TextLine& line) {
  const Form form = form_of(*p);
  if (form != Form::count && has_form(dialect_, form)) {
    if (form == Form::program_name) return program_name(p);
    if (form == Form::checksum) return checksum(p, line);
    return controller_command(p);
  }
  if (begins_wide_text(line)) {
    reporter_.error("bad-character", 1, "the text is in UTF-16, two bytes for a character",
                    "save it as plain text: ASCII or UTF-8");
    reporter_.stop();  // every line would be another
    return false;
  }
  std::string hint = "a letter and a number, #parameter=value, or a comment";
  if (form != Form::count) {
    const FormRow& known = form_rows()[static_cast<std::size_t>(form)];
    hint = std::string(known.summary) + ": of --dialect " + names_of(known.dialects);
  }
  return reporter_.error("bad-character", reporter_.column(p), shown(*p) + " stands where a word should",
                         std::move(hint));
}

bool BlockReader::program_name(const char*& p) {
  const char* const open = p;
  while (*p != '>' && *p != '\n') ++p;
  if (*p == '\n') {
    return reporter_.error("unclosed-comment", reporter_.column(open), "this name of a program does not end",
                           "add '>'");
  }
  ++p;
  return true;
}

// All bytes before the '*' in exclusive or (RepRap's protocol, which Marlin follows).
bool BlockReader::checksum(const char*& p, const TextLine& line) {
  const char* const star = p++;
  double given = 0;
  if (!values_.value(p, given)) return false;
  unsigned sum = 0;
  for (const char* each = line.text; each != star; ++each) sum ^= static_cast<unsigned char>(*each);
  if (given == sum) return true;
  return reporter_.error("bad-checksum", reporter_.column(star), "the checksum of this line is " + text(given),
                         "it should be " + std::to_string(sum) + ": has the line been changed?");
}

bool BlockReader::controller_command(const char*& p) {
  const char* const begin = p;
  const bool whole_line = *p == '$';
  do {
    ++p;
  } while (whole_line && *p != '\n');
  if (*begin != '?') {
    reporter_.warning("controller-command", reporter_.column(begin),
                      shown(*begin) + " begins a command to the controller, which is passed over",
                      "send it by hand; a program holds blocks alone");
  }
  return true;
}

}  // namespace leadscrew::gcode
