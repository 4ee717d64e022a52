// The one file that includes CLI11.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <leadscrew/base/nearest.hpp>
#include <leadscrew/options/options.hpp>

namespace leadscrew::options {

namespace {

/// The command as CLI11 has it; texts go to its options.
CLI::App* add_command(CLI::App& app, Command& command) {
  CLI::App* added = app.add_subcommand(command.name(), command.what());
  for (Option& option : command.options()) {
    const auto take_flag = [&option](std::int64_t) { option.given = {""}; };
    const auto take_texts = [&option](const CLI::results_t& texts) {
      option.given = texts;
      return true;
    };
    if (option.kind == Option::Kind::flag) {
      added->add_flag_function(option.name, take_flag, option.what);
      continue;
    }
    CLI::Option* made = added->add_option(option.name, take_texts, option.what)->type_name(option.value_name);
    const bool is_word = option.kind == Option::Kind::word || option.kind == Option::Kind::words;
    if (is_word) made->required();
    if (option.kind == Option::Kind::words) made->expected(CLI::detail::expected_max_vector_size);
  }
  added->footer(command.help());
  return added;
}

Answer usage_answer(const std::string& where, const std::string& message) {
  return {Status::usage, fmt::format("{}: error: {}\n    hint: {} --help\n", where, message, where)};
}

/// What CLI11 could not place: options nobody knows, or words too many.
std::string unexpected(const CLI::App& command) {
  const std::vector<std::string> rest = command.remaining();
  const auto option =
      std::find_if(rest.begin(), rest.end(), [](auto& word) { return word.size() > 1 && word[0] == '-'; });
  if (option == rest.end()) return fmt::format("\"{}\" is one word too many", rest.empty() ? "" : rest.front());
  const std::string name = option->substr(0, option->find('='));
  std::vector<std::string_view> known;
  for (const CLI::Option* each : command.get_options()) {
    for (const std::string& long_name : each->get_lnames()) known.push_back(long_name);
  }
  // Dashes would count as letters that are right.
  const std::string_view letters = std::string_view(name).substr(std::min(name.find_first_not_of('-'), name.size()));
  const auto meant = base::nearest(letters, known);
  return fmt::format("no option {}{}", name, meant ? fmt::format("; did you mean --{}?", *meant) : "");
}

/// An option that was given too often, or as the last word of the line without its value; otherwise what CLI11 said.
std::string mismatch(const CLI::App& command, const std::string& last, const std::string& said) {
  for (const CLI::Option* option : command.get_options()) {
    const auto given = static_cast<int>(option->count());
    const int most = option->get_items_expected_max();  // 0 of a flag, which may be given again
    if (most > 0 && given > most) return fmt::format("{} is given {} times", option->get_name(), given);
  }
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_items_expected_min() > 0 && option->check_name(last))
      return fmt::format("{} needs a value: {}", option->get_name(), option->get_type_name());
  }
  return said;
}

/// The first word must be a command; CLI11 would say less.
std::optional<Answer> check_command(const std::deque<Command>& commands, const ProgramHelp& program, int count,
                                    const char* const* values) {
  if (count < 2) return usage_answer(program.name, fmt::format("no command{}", program.commands));
  const std::string word = values[1];
  if (word.empty() || word[0] != '-') {
    std::vector<std::string_view> known;
    for (const Command& command : commands) known.push_back(command.name());
    if (std::find(known.begin(), known.end(), word) != known.end()) return std::nullopt;
    const std::string meant = base::did_you_mean(word, known);
    return usage_answer(program.name,
                        fmt::format("no command \"{}\"{}", word, meant.empty() ? program.commands : meant));
  }
  const std::array<std::string_view, 2> known = {"--help", "--version"};
  if (word == "-h" || std::find(known.begin(), known.end(), word) != known.end()) return std::nullopt;
  return usage_answer(program.name,
                      fmt::format("no option {} before the command{}", word, base::did_you_mean(word, known)));
}

}  // namespace

void Command::word(std::string name, std::string what, std::string& target) {
  add({Option::Kind::word, std::move(name), "", std::move(what), [&target](const std::string& text) -> Parsed<void> {
         target = text;
         return {};
       }});
}

void Command::word(std::string name, std::string what, std::vector<std::string>& targets) {
  add_words(Option::Kind::word, std::move(name), std::move(what), targets);
}

void Command::words(std::string name, std::string what, std::vector<std::string>& targets) {
  add_words(Option::Kind::words, std::move(name), std::move(what), targets);
}

void Command::add_words(Option::Kind kind, std::string name, std::string what, std::vector<std::string>& targets) {
  add({kind, std::move(name), "", std::move(what), [&targets](const std::string& text) -> Parsed<void> {
         targets.push_back(text);
         return {};
       }});
}

void Command::flag(std::string name, std::string what, bool& target) {
  add({Option::Kind::flag, std::move(name), "", std::move(what), [&target](const std::string&) -> Parsed<void> {
         target = true;
         return {};
       }});
}

void Command::text(std::string name, std::string value_name, std::string what, std::optional<std::string>& target) {
  value(std::move(name), std::move(value_name), std::move(what), target,
        [](std::string_view text) { return Parsed<std::string>(text); });
}

void Command::output(std::string name, std::string value_name, std::string what, std::optional<std::string>& target) {
  value(std::move(name), std::move(value_name), std::move(what), target,
        [](std::string_view text) -> Parsed<std::string> {
          if (text.empty()) return wrong("the name of the file is empty");
          if (text.front() == '-') return wrong("is no file's name; one that begins with - is given as ./{}", text);
          return std::string(text);
        });
}

void Command::number(std::string name, std::string value_name, std::string what, double& target, double least,
                     double most) {
  value(std::move(name), std::move(value_name), std::move(what), target,
        [least, most](std::string_view text) -> Parsed<double> {
          auto number = parse_number(text);
          if (number && !(*number >= least && *number <= most)) return wrong("give {:g} to {:g}", least, most);
          return number;
        });
}

void Command::only_with(std::string_view needed, std::vector<std::string_view> options) {
  check([this, needed, options = std::move(options)]() -> Parsed<void> {
    if (given(needed)) return {};
    for (const Option& option : options_) {
      if (option.given.empty() || std::ranges::find(options, option.name) == options.end()) continue;
      const auto found = std::ranges::find(options_, needed, &Option::name);
      return wrong("{} is of {}{}{}, which is missing", option.name, needed, found->value_name.empty() ? "" : " ",
                   found->value_name);
    }
    return {};
  });
}

bool Command::given(std::string_view name) const {
  const auto found = std::ranges::find(options_, name, &Option::name);
  return found != options_.end() && !found->given.empty();
}

std::string_view Command::text_of(std::string_view name) const {
  return given(name) ? std::string_view(std::ranges::find(options_, name, &Option::name)->given.back())
                     : std::string_view();
}

std::string_view Command::first_given(std::initializer_list<std::string_view> names) const {
  const auto found = std::ranges::find_if(names, [this](std::string_view name) { return given(name); });
  return found == names.end() ? std::string_view() : *found;
}

std::string Command::none_of(std::string_view text, std::span<const std::string_view> words) {
  return fmt::format("is none of {}{}", fmt::join(words, ", "), base::did_you_mean(text, words));
}

Parsed<void> Command::take() const {
  for (const Option& option : options_) {
    for (const std::string& text : option.given) {
      const auto taken = option.take(text);
      if (!taken) return wrong("{}{}{}: {}", option.name, text.empty() ? "" : " ", text, taken.error());
    }
  }
  for (const auto& check : checks_) {
    if (auto sound = check(); !sound) return sound;
  }
  return {};
}

std::variant<std::size_t, Answer> parse_command_line(std::deque<Command>& commands, const ProgramHelp& program,
                                                     int count, const char* const* values) {
  if (auto answer = check_command(commands, program, count, values)) return std::move(*answer);
  CLI::App app(program.what, program.name);
  app.set_version_flag("--version", program.version);
  app.set_help_flag("-h,--help", "This text");
  app.require_subcommand(1);
  app.footer(program.help);
  std::vector<CLI::App*> added;
  for (Command& command : commands) added.push_back(add_command(app, command));
  const auto place = [&] {
    const auto parsed = std::ranges::find_if(added, [](const CLI::App* command) { return command->parsed(); });
    return static_cast<std::size_t>(parsed - added.begin());
  };
  const auto asked = [&]() -> const CLI::App& { return place() < added.size() ? *added[place()] : app; };
  const auto name = [&] { return place() < added.size() ? program.name + " " + asked().get_name() : program.name; };
  try {
    app.parse(count, values);
  } catch (const CLI::CallForHelp&) {
    return Answer{Status::done, asked().help()};
  } catch (const CLI::CallForVersion&) {
    return Answer{Status::done, app.version() + "\n"};
  } catch (const CLI::ExtrasError&) {
    return usage_answer(name(), unexpected(asked()));
  } catch (const CLI::ArgumentMismatch& error) {
    return usage_answer(name(), mismatch(asked(), values[count - 1], error.what()));
  } catch (const CLI::ParseError& error) {
    return usage_answer(name(), error.what());
  }
  const auto taken = commands[place()].take();
  if (!taken) return usage_answer(name(), taken.error());
  return place();
}

}  // namespace leadscrew::options
