#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <leadscrew/options/manual.hpp>

namespace leadscrew::options {

namespace {

/// The first character of a UTF-8 text that is not ASCII, which is removed, as roff writes it.
std::string take_wide_character(std::string_view& text) {
  const auto byte = [&](std::size_t place) { return static_cast<unsigned char>(text[place]); };
  const std::size_t length = byte(0) < 0xe0 ? 2 : byte(0) < 0xf0 ? 3 : 4;
  unsigned point = byte(0) & (0xffU >> (length + 1));
  for (std::size_t i = 1; i < std::min(length, text.size()); ++i) point = point << 6 | (byte(i) & 0x3fU);
  text.remove_prefix(std::min(length, text.size()));
  return fmt::format("\\[u{:04X}]", point);
}

/// As text of roff: a page shows the characters that stand there.
std::string roff(std::string_view text) {
  constexpr std::array<std::pair<char, std::string_view>, 6> special = {
      {{'\\', "\\e"}, {'-', "\\-"}, {'^', "\\(ha"}, {'~', "\\(ti"}, {'`', "\\(ga"}, {'\'', "\\(aq"}}};
  std::string written;
  bool at_begin = true;
  while (!text.empty()) {
    const char c = text.front();
    if (static_cast<unsigned char>(c) >= 0x80) {
      written += take_wide_character(text);
      at_begin = false;
      continue;
    }
    const auto found = std::ranges::find(special, c, &std::pair<char, std::string_view>::first);
    if (at_begin && c == '.') written += "\\&";
    if (found != special.end())
      written += found->second;
    else
      written += c;
    at_begin = c == '\n';
    text.remove_prefix(1);
  }
  return written;
}

std::string bold(std::string_view text) {
  return "\\fB" + roff(text) + "\\fR";
}

std::string italic(std::string_view text) {
  return "\\fI" + roff(text) + "\\fR";
}

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  std::ranges::transform(capitals, capitals.begin(), [](unsigned char c) { return std::toupper(c); });
  return capitals;
}

std::string page_name(const Program& program, const Command* command) {
  return command == nullptr ? program.name() : program.name() + "-" + command->name();
}

/// "[OPTION]... PROGRAM..."
std::string synopsis(const Command& command) {
  std::string text = "[" + italic("OPTION") + "]...";
  for (const Option& option : command.options()) {
    if (option.kind == Option::Kind::word) text += " " + italic(option.name);
    if (option.kind == Option::Kind::optional_word) text += " [" + italic(option.name) + "]";
    if (option.kind == Option::Kind::words) text += " " + italic(option.name) + "...";
  }
  return text;
}

std::string option_entries(const Command& command) {
  std::string text;
  for (const Option& option : command.options()) {
    text += ".TP\n";
    text += option.is_word() ? italic(option.name) : bold(option.name);
    if (!option.value_name.empty()) text += " " + italic(option.value_name);
    text += "\n" + roff(option.what) + "\n";
  }
  return text +
         fmt::format(".TP\n{}, {}\n{}\n", bold(HelpOption::short_name), bold(HelpOption::name), roff(HelpOption::what));
}

/// What stands below the options, parted by blank lines.
std::vector<std::string_view> paragraphs(std::string_view text) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find("\n\n"), text.size());
    std::string_view part = text.substr(0, end);
    while (part.starts_with('\n')) part.remove_prefix(1);
    if (!part.empty()) parts.push_back(part);
    text.remove_prefix(std::min(end + 2, text.size()));
  }
  return parts;
}

std::string with_line_end(std::string text) {
  if (!text.ends_with('\n')) text += '\n';
  return text;
}

/// Lines that are indented keep their form.
std::string paragraph(std::string_view text) {
  const bool has_form = text.starts_with(' ') || text.find("\n ") != std::string_view::npos;
  const std::string written = with_line_end(roff(text));
  return has_form ? ".PP\n.nf\n" + written + ".fi\n" : ".PP\n" + written;
}

/// EXAMPLES, and NOTES for all else.
std::string explanations(const Command& command) {
  constexpr std::string_view examples_heading = "Examples:\n";
  std::string examples, notes;
  for (const std::string_view part : paragraphs(command.help())) {
    if (part.starts_with(examples_heading))
      examples += ".SH EXAMPLES\n.nf\n" + with_line_end(roff(part.substr(examples_heading.size()))) + ".fi\n";
    else
      notes += paragraph(part);
  }
  // A paragraph of its own must not follow a heading.
  if (notes.starts_with(".PP\n")) notes.erase(0, 4);
  return examples + (notes.empty() ? "" : ".SH NOTES\n" + notes);
}

std::string commands_section(const Program& program) {
  std::string text = ".SH COMMANDS\n";
  for (const Command& command : program.commands)
    text += fmt::format(".TP\n{} {}\n{}\n", bold(command.name()), synopsis(command), roff(command.what()));
  return text;
}

std::string see_also(const Program& program, const Command* command) {
  std::vector<std::string> pages;
  if (command != nullptr) pages.push_back(fmt::format("{}(1)", bold(page_name(program, nullptr))));
  for (const Command& each : program.commands) {
    if (&each != command) pages.push_back(fmt::format("{}(1)", bold(page_name(program, &each))));
  }
  return fmt::format(".SH SEE ALSO\n{}\n", fmt::join(pages, ",\n"));
}

}  // namespace

std::string manual_page(const Program& program, const Command* command) {
  const Command& described = command == nullptr ? program.itself : *command;
  const std::string name = page_name(program, command);
  const std::string typed = command == nullptr ? program.name() : program.name() + " " + command->name();
  std::string page = fmt::format(".TH {} 1 \"{}\" \"{}\" \"{} manual\"\n", roff(in_capitals(name)), program.released,
                                 roff(program.name() + " " + program.version), roff(program.name()));
  page += fmt::format(".SH NAME\n{} \\- {}\n", roff(name), roff(described.what()));
  page += fmt::format(".SH SYNOPSIS\n{} {}\n", bold(typed), synopsis(described));
  if (command == nullptr) page += fmt::format(".br\n{} {} ...\n", bold(program.name()), italic("COMMAND"));
  if (command == nullptr) page += commands_section(program);
  page += ".SH OPTIONS\n" + option_entries(described) + explanations(described);
  page += ".SH EXIT STATUS\n" + with_line_end(roff(program.exit_statuses));
  return page + see_also(program, command);
}

}  // namespace leadscrew::options
