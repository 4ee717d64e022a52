#include <fmt/format.h>

#include <leadscrew/options/completion.hpp>

namespace leadscrew::options {

namespace {

/// Calls that add what the value may be; empty for any text.
std::string bash_calls(std::string_view program, const Values& values) {
  std::string calls;
  if (values.files) calls += fmt::format("_{}_files {}; ", program, fmt::join(values.endings, " "));
  if (values.folders) calls += fmt::format("_{}_folders; ", program);
  if (!values.words.empty())
    calls += fmt::format("_{}_{} {}; ", program, values.is_list ? "list" : "words", fmt::join(values.words, " "));
  return calls;
}

bool bash_takes_value(const Option& option) {
  return option.has_value();
}

std::string bash_names(const Command& command, bool (*is_wanted)(const Option&)) {
  std::string names;
  for (const Option& option : command.options()) {
    if (is_wanted(option)) names += option.name + " ";
  }
  return names;
}

std::string bash_options(const Command& command) {
  return bash_names(command, [](const Option& option) { return !option.is_word(); }) +
         fmt::format("{} {}", HelpOption::short_name, HelpOption::name);
}

/// Of one command: its options, which of them take values, and what these may be.
std::string bash_case(std::string_view program, const Command& command) {
  std::string text = fmt::format("  {})\n    options='{}'\n    takes='{}'\n    case $previous in\n", command.name(),
                                 bash_options(command), bash_names(command, bash_takes_value));
  for (const Option& option : command.options()) {
    if (!bash_takes_value(option)) continue;
    text += fmt::format("    {}) {}return ;;\n", option.name, bash_calls(program, option.values));
  }
  return text + "    esac\n    ;;\n";
}

/// Its words, each by its place.
std::string bash_words(std::string_view program, const Command& command) {
  std::string text;
  int place = 0;
  for (const Option& option : command.options()) {
    if (!option.is_word()) continue;
    const std::string where = option.kind == Option::Kind::words ? "*" : std::to_string(place++);
    text += fmt::format("  \"{} \"{}) {};;\n", command.name(), where, bash_calls(program, option.values));
  }
  return text;
}

}  // namespace

std::string bash_completion(const Program& program) {
  std::string commands, options, words;
  for (const Command& command : program.commands) {
    commands += command.name() + " ";
    options += bash_case(program.name(), command);
    words += bash_words(program.name(), command);
  }
  options.pop_back();
  words.pop_back();
  return filled(completion_bash, {{"NAME", program.name()},
                                  {"COMMANDS", commands + bash_options(program.itself)},
                                  {"OPTIONS", options},
                                  {"WORDS", words}});
}

}  // namespace leadscrew::options
