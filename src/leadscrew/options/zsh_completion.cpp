// Each command is described to _arguments, whose notation is not the shell's: colons and brackets are escaped.

#include <fmt/format.h>

#include <leadscrew/options/completion.hpp>

namespace leadscrew::options {

namespace {

std::string zsh_escaped(std::string_view text, std::string_view special) {
  std::string written;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) written += '\\';
    written += c;
  }
  return written;
}

std::string zsh_quoted(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

/// What _arguments does for a value; a blank in front keeps it from adding arguments.
std::string zsh_action(std::string_view program, const Values& values) {
  std::string words;
  for (const std::string& word : values.words) words += " " + zsh_escaped(word, ":\\");
  if (values.files) {
    std::vector<std::string> endings;
    for (const std::string& ending : values.endings) endings.push_back(ending.substr(1));
    return fmt::format(" _{}_files \"{}\"{}", program, fmt::join(endings, "|"), words);
  }
  if (values.folders) return "_files -/";
  if (values.is_list) return fmt::format(" _values -s , value{}", words);
  return words.empty() ? " " : fmt::format("({})", words.substr(1));
}

std::string zsh_spec(std::string_view program, const Option& option, int place) {
  const std::string what = "[" + zsh_escaped(option.what, "[]:\\") + "]";
  const std::string shown = zsh_escaped(option.is_word() ? option.name : option.value_name, ":\\");
  switch (option.kind) {
    case Option::Kind::flag:
      return option.name + what;
    case Option::Kind::value:
    case Option::Kind::values:
      return fmt::format("{}={}:{}:{}", option.name, what, shown, zsh_action(program, option.values));
    case Option::Kind::optional_value:
      return fmt::format("{}{}::{}:{}", option.name, what, shown, zsh_action(program, option.values));
    case Option::Kind::word:
      return fmt::format("{}:{}:{}", place, shown, zsh_action(program, option.values));
    case Option::Kind::optional_word:
      return fmt::format("{}::{}:{}", place, shown, zsh_action(program, option.values));
    case Option::Kind::words:
      return fmt::format("*:{}:{}", shown, zsh_action(program, option.values));
  }
  return {};
}

/// The arguments of _arguments, a line each.
std::vector<std::string> zsh_specs(std::string_view program, const Command& command, std::string_view indent) {
  std::vector<std::string> lines;
  int place = 1;
  for (const Option& option : command.options()) {
    lines.push_back(std::string(indent) + zsh_quoted(zsh_spec(program, option, place)));
    if (option.is_word()) ++place;
  }
  const std::string what = zsh_quoted("[" + std::string(HelpOption::what) + "]");
  lines.push_back(fmt::format("{}'(- *)'{{{},{}}}{}", indent, HelpOption::short_name, HelpOption::name, what));
  return lines;
}

}  // namespace

std::string zsh_completion(const Program& program) {
  constexpr std::string_view next_line = " \\\n";
  std::vector<std::string> commands, cases;
  for (const Command& command : program.commands) {
    commands.push_back("    " + zsh_quoted(zsh_escaped(command.name(), ":") + ":" + command.what()));
    cases.push_back(fmt::format("    {})\n      _arguments \\\n{}\n      ;;", command.name(),
                                fmt::join(zsh_specs(program.name(), command, "        "), next_line)));
  }
  const auto itself = zsh_specs(program.name(), program.itself, "    ");
  return filled(completion_zsh, {{"NAME", program.name()},
                                 {"COMMANDS", fmt::format("{}", fmt::join(commands, "\n"))},
                                 {"ITSELF", fmt::format("{} \\", fmt::join(itself, next_line))},
                                 {"ARGUMENTS", fmt::format("{}", fmt::join(cases, "\n"))}});
}

}  // namespace leadscrew::options
