#include <fmt/format.h>

#include <leadscrew/options/completion.hpp>

namespace leadscrew::options {

namespace {

std::string fish_quoted(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "'";
}

/// What stands behind -a; empty for any text.
std::string fish_candidates(std::string_view program, const Values& values) {
  std::vector<std::string> parts;
  if (values.files) parts.push_back(fmt::format("(__{}_files {})", program, fmt::join(values.endings, " ")));
  if (values.folders) parts.emplace_back("(__fish_complete_directories)");
  if (values.is_list)
    parts.push_back(fmt::format("(__{}_list {})", program, fmt::join(values.words, " ")));
  else
    parts.insert(parts.end(), values.words.begin(), values.words.end());
  return fmt::format("{}", fmt::join(parts, " "));
}

std::string fish_values(const Command& command) {
  std::string names;
  for (const Option& option : command.options()) {
    if (option.has_value()) names += " " + option.name;
  }
  return names;
}

/// One `complete` for an option or word, where the condition holds.
std::string fish_line(std::string_view program, const std::string& condition, const Option& option) {
  std::string text = fmt::format("complete -c {} -n {}", program, fish_quoted(condition));
  const std::string candidates = fish_candidates(program, option.values);
  if (!option.is_word()) text += fmt::format(" -l {} -d {}", option.name.substr(2), fish_quoted(option.what));
  if (option.has_value()) text += " -x";
  if (!candidates.empty()) text += " -a " + fish_quoted(candidates);
  return text + "\n";
}

std::string fish_lines(std::string_view program, const std::string& condition, const Command& command) {
  std::string text;
  int place = 0;
  for (const Option& option : command.options()) {
    const bool has_place = option.kind == Option::Kind::word || option.kind == Option::Kind::optional_word;
    std::string where = condition;
    if (has_place) where += fmt::format("; and __{}_at {}{}", program, place++, fish_values(command));
    text += fish_line(program, where, option);
  }
  return text + fmt::format("complete -c {} -n {} -s {} -l {} -d {}\n", program, fish_quoted(condition),
                            HelpOption::short_name.substr(1), HelpOption::name.substr(2),
                            fish_quoted(HelpOption::what));
}

}  // namespace

std::string fish_completion(const Program& program) {
  const std::string& name = program.name();
  const std::string no_command = fmt::format("__{}_is", name);
  std::string lines;
  for (const Command& command : program.commands)
    lines += fmt::format("complete -c {} -n {} -a {} -d {}\n", name, no_command, command.name(),
                         fish_quoted(command.what()));
  lines += fish_lines(name, no_command, program.itself);
  for (const Command& command : program.commands)
    lines += fish_lines(name, fmt::format("__{}_is {}", name, command.name()), command);
  lines.pop_back();
  return filled(completion_fish, {{"NAME", name}, {"COMPLETIONS", lines}});
}

}  // namespace leadscrew::options
