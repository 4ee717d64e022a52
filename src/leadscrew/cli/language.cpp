#include <leadscrew/cli/language.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/cli/shared_arguments.hpp>
#include <leadscrew/gcode/line_source.hpp>
#include <leadscrew/language/code_page.hpp>
#include <leadscrew/language/explanation.hpp>
#include <leadscrew/language/normal_form.hpp>

namespace leadscrew::cli {

namespace {

constexpr std::string_view explain_examples =
    "Examples:\n"
    "  leadscrew explain G64\n"
    "  leadscrew explain \"G41.1 D3 L2\"\n"
    "  leadscrew explain G76 --dialect fanuc\n"
    "  leadscrew explain cutter-gouge\n"
    "  leadscrew explain --page > docs/gcode.md\n";

constexpr std::string_view format_examples =
    "Examples:\n"
    "  leadscrew format part.ngc > tidy.ngc\n"
    "  leadscrew format part.nc --dialect fanuc | less\n";

gcode::Dialect dialect_of(const Arguments& arguments) {
  return arguments.dialect.value_or(gcode::Dialect::leadscrew);
}

}  // namespace

void describe_explain(Command& command, Arguments& arguments) {
  command.optional_word("BLOCK", "A block in quotes, a code alone, or a diagnostic's", arguments.explained);
  add_dialect(command, arguments);
  command.flag("--page", "Every code, as the page docs/gcode.md, in place of a block", arguments.explain_page);
  command.help(std::string(explain_examples));
  command.check([&arguments]() -> Parsed<void> {
    if (arguments.explained.has_value() != arguments.explain_page) return {};
    return wrong("explain takes a block, or --page");
  });
}

void describe_format(Command& command, Arguments& arguments) {
  command.word("PROGRAM", "Part program; - is standard input", arguments.programs, program_values());
  add_dialect(command, arguments);
  command.help(std::string(format_examples));
}

Status explain(const Arguments& arguments, Console& console) {
  if (arguments.explain_page) return write_output(console, language::code_page());
  DiagnosticLog log(console);
  const auto text = language::explanation(*arguments.explained, dialect_of(arguments));
  if (text) return write_output(console, *text);
  log.add(text.error());
  return log.status();
}

Status format(const Arguments& arguments, Console& console) {
  DiagnosticLog log(console);
  const auto file = open_program(arguments.programs.front());
  if (!file) {
    log.add(file.error());
    return log.status();
  }
  constexpr std::size_t enough_to_write = 65'536;
  gcode::LineSource lines(file->source());
  gcode::TextLine line;
  std::string text;
  Status status = Status::done;
  while (status == Status::done && lines.next(line)) {
    if (line.too_long) {
      log.add({base::Severity::error,
               "line-too-long",
               "this line is too long to be formatted",
               "is this a part program?",
               {file->name(), line.number, 1},
               {}});
      return log.status();
    }
    text += language::normal_form({line.begin, static_cast<std::size_t>(line.end - line.begin)}, dialect_of(arguments));
    text += '\n';
    if (text.size() < enough_to_write) continue;
    status = write_output(console, text);
    text.clear();
  }
  if (lines.failure()) log.add(*lines.failure());
  return worse(worse(status, log.status()), write_output(console, text));
}

}  // namespace leadscrew::cli
