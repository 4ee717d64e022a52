#include <fmt/format.h>

#include <array>
#include <leadscrew/cli/about.hpp>
#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/interpolator/word_kernels.hpp>
#include <leadscrew/json/json.hpp>
#include <leadscrew/options/completion.hpp>
#include <leadscrew/options/manual.hpp>
#include <leadscrew/trace/word_writer.hpp>

namespace leadscrew::cli {

namespace {

constexpr std::string_view help_examples =
    "Examples:\n"
    "  leadscrew help run                         the same as leadscrew run --help\n"
    "  leadscrew help --man run | man -l -        its manual page, which installation puts into share/man\n";

constexpr std::string_view completion_examples =
    "Examples:\n"
    "  source <(leadscrew completion bash)        for this shell; in ~/.bashrc for all\n"
    "  leadscrew completion zsh > ~/.zfunc/_leadscrew\n"
    "  leadscrew completion fish > ~/.config/fish/completions/leadscrew.fish\n"
    "\n"
    "Installation puts the scripts where the shells look for them.\n";

constexpr std::array<std::pair<std::string_view, options::Shell>, 3> shells = {
    {{"bash", options::Shell::bash}, {"zsh", options::Shell::zsh}, {"fish", options::Shell::fish}}};

std::string_view name_of(interpolator::Kernel kernel) {
  switch (kernel) {
    case interpolator::Kernel::plain:
      return "plain";
    case interpolator::Kernel::avx2:
      return "avx2";
    case interpolator::Kernel::neon:
      return "neon";
  }
  return {};
}

/// docs/schemas/version.json.
std::string version_json(const options::Program& program) {
  json::Json kernels = json::Json::list(), commands = json::Json::list();
  for (const interpolator::Kernel kernel : interpolator::all_kernels) {
    if (interpolator::has(kernel)) kernels.push_back(name_of(kernel));
  }
  for (const Command& command : program.commands) commands.push_back(command.name());
  return json::Json::object({{"schema", "leadscrew.version/1"},
                             {"name", program.name()},
                             {"version", program.version},
                             {"compiler", LEADSCREW_COMPILER},
                             {"build_type", LEADSCREW_BUILD_TYPE},
                             {"system", LEADSCREW_SYSTEM},
                             {"kernels", kernels},
                             {"kernel", name_of(interpolator::widest_kernel())},
                             {"commands", commands},
                             {"trace_formats", trace::endings()}})
             .written() +
         "\n";
}

Answer answer_help(options::Program& program, const AboutArguments& about) {
  const Command* command = nullptr;
  if (about.command) {
    const auto found = program.find(*about.command);
    if (!found) return options::usage_answer(program.name(), found.error());
    command = *found;
  }
  return {Status::done, about.manual ? options::manual_page(program, command) : options::help_text(program, command)};
}

Answer answer_completion(const options::Program& program, std::string_view asked) {
  for (const auto& [name, shell] : shells) {
    if (name == asked) return {Status::done, options::completion_script(program, shell)};
  }
  return options::usage_answer(program.name() + " completion", fmt::format("{} is none of bash, zsh, fish", asked));
}

}  // namespace

void describe_help(Command& command, Arguments& arguments) {
  command.optional_word("COMMAND", "Which; without one, what there is", arguments.about.command,
                        {.words = command_names()});
  command.flag("--man", "As a manual page, in the macros of man(7)", arguments.about.manual);
  command.help(std::string(help_examples));
}

void describe_completion(Command& command, Arguments& arguments) {
  Values values;
  for (const auto& [name, shell] : shells) values.words.emplace_back(name);
  command.word("SHELL", "bash, zsh or fish", arguments.about.shell, std::move(values));
  command.help(std::string(completion_examples));
}

void describe_itself(Command& itself, Arguments& arguments) {
  itself.flag("--version", "Which leadscrew this is", arguments.about.version);
  itself.flag("--json", "Of --version: with its compiler, its kernels, its commands and formats, as one JSON object",
              arguments.json);
}

std::optional<Answer> answer_about(options::Program& program, const Command* command, const Arguments& arguments) {
  if (command == nullptr) {
    if (!arguments.about.version) return options::usage_answer(program.name(), "no command" + program.known_commands);
    if (arguments.json) return Answer{Status::done, version_json(program)};
    return Answer{Status::done, program.name() + " " + program.version + "\n"};
  }
  if (command->name() == "help") return answer_help(program, arguments.about);
  if (command->name() == "completion") return answer_completion(program, arguments.about.shell);
  return std::nullopt;
}

}  // namespace leadscrew::cli
