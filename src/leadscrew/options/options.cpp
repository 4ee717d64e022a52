// The one file that includes CLI11.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <leadscrew/base/nearest.hpp>
#include <leadscrew/options/options.hpp>

namespace leadscrew::options {

namespace {

/// The options as CLI11 has them; texts go to ours.
void add_options(CLI::App& app, Command& command) {
  for (Option& option : command.options()) {
    const auto take_flag = [&option](std::int64_t) { option.given = {""}; };
    const auto take_texts = [&option](const CLI::results_t& texts) {
      option.given = texts;
      return true;
    };
    if (option.kind == Option::Kind::flag) {
      app.add_flag_function(option.name, take_flag, option.what);
      continue;
    }
    CLI::Option* made = app.add_option(option.name, take_texts, option.what)->type_name(option.value_name);
    if (option.is_word() && option.kind != Option::Kind::optional_word) made->required();
    if (option.kind == Option::Kind::optional_value) made->expected(0, 1)->default_str("");
    if (option.kind == Option::Kind::words) made->expected(CLI::detail::expected_max_vector_size);
    if (option.kind == Option::Kind::values)
      made->expected(1, CLI::detail::expected_max_vector_size)->allow_extra_args();
  }
  app.set_help_flag(fmt::format("{},{}", HelpOption::short_name, HelpOption::name), std::string(HelpOption::what));
  app.footer(command.help());
}

std::string in_small_letters(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// A pipe, /dev/null; and /dev/stdout, which may lead to a file of any name.
bool is_special(std::string_view path) {
  std::error_code error;
  return path.starts_with("/dev/") || std::filesystem::is_other(std::filesystem::status(path, error));
}

/// "does not end in .html", "ends in neither .csv nor .npy".
std::string missing_ending(std::span<const std::string> endings) {
  if (endings.size() == 1) return fmt::format("does not end in {}", endings.front());
  return fmt::format("ends in neither {} nor {}", fmt::join(endings.first(endings.size() - 1), ", "), endings.back());
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

/// A word that must be there, unless an option is what was misspelt; otherwise what CLI11 said.
std::string missing_word(const CLI::App& command, const std::string& said) {
  const bool has_option = std::ranges::any_of(command.remaining(), [](auto& word) { return word.starts_with("--"); });
  if (has_option) return unexpected(command);
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_required() && option->count() == 0)
      return fmt::format("{} is missing: {}", option->get_name(), option->get_description());
  }
  return said;
}

/// Of a word that is no command: the file, or the option of the program, that it is.
std::optional<std::string> other_meaning(const Program& program, std::string_view word) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(word, ignored))
    return fmt::format("no command before {0}; did you mean {1} {0}?", word, program.commands.front().name());
  const std::string option = fmt::format("--{}", word);
  if (std::ranges::find(program.itself.options(), option, &Option::name) == program.itself.options().end()) return {};
  return fmt::format("no command \"{}\"; did you mean {}?", word, option);
}

/// The first word must be a command, or an option of the program, which no command follows; CLI11 would say less.
std::optional<Answer> check_command(const Program& program, std::span<const char* const> words) {
  if (words.empty()) return usage_answer(program.name(), fmt::format("no command{}", program.known_commands));
  const std::string_view word = words.front();
  if (word.empty() || word[0] != '-') {
    const auto found = program.find(word);
    if (found) return std::nullopt;
    return usage_answer(program.name(), other_meaning(program, word).value_or(found.error()));
  }
  if (word == HelpOption::short_name || word == HelpOption::name) return std::nullopt;
  std::vector<std::string_view> known = {HelpOption::name};
  for (const Option& option : program.itself.options()) known.push_back(option.name);
  if (std::ranges::find(known, word) == known.end())
    return usage_answer(program.name(),
                        fmt::format("no option {} before the command{}", word, base::did_you_mean(word, known)));
  const auto other = std::ranges::find_if(words, [](const char* each) { return each[0] != '-'; });
  if (other == words.end()) return std::nullopt;
  return usage_answer(program.name(), fmt::format("\"{}\" is one word too many behind {}", *other, word));
}

std::string shell_quoted(std::string_view text) {
  const auto is_plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) ||
           std::string_view("_-./,:=+@%").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_plain)) return std::string(text);
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace

std::string command_line(std::string_view program, int count, const char* const* values) {
  std::string line(program);
  for (int i = 1; i < count; ++i) line += " " + shell_quoted(values[i]);
  return line;
}

Answer usage_answer(const std::string& where, const std::string& message) {
  return {Status::usage, fmt::format("{}: error: {}\n    hint: {} --help\n", where, message, where)};
}

void Command::word(std::string name, std::string what, std::string& target, Values values) {
  add({Option::Kind::word, std::move(name), "", std::move(what), std::move(values),
       [&target](const std::string& text) -> Parsed<void> {
         target = text;
         return {};
       }});
}

void Command::word(std::string name, std::string what, std::vector<std::string>& targets, Values values) {
  add_words(Option::Kind::word, std::move(name), std::move(what), targets, std::move(values));
}

void Command::words(std::string name, std::string what, std::vector<std::string>& targets, Values values) {
  add_words(Option::Kind::words, std::move(name), std::move(what), targets, std::move(values));
}

void Command::add_words(Option::Kind kind, std::string name, std::string what, std::vector<std::string>& targets,
                        Values values) {
  add({kind, std::move(name), "", std::move(what), std::move(values),
       [&targets](const std::string& text) -> Parsed<void> {
         targets.push_back(text);
         return {};
       }});
}

void Command::values(std::string name, std::string value_name, std::string what, std::vector<std::string>& targets,
                     Values values) {
  add_words(Option::Kind::values, std::move(name), std::move(what), targets, std::move(values));
  options_.back().value_name = std::move(value_name);
}

void Command::optional_word(std::string name, std::string what, std::optional<std::string>& target, Values values) {
  add({Option::Kind::optional_word, std::move(name), "", std::move(what), std::move(values),
       [&target](const std::string& text) -> Parsed<void> {
         target = text;
         return {};
       }});
}

void Command::flag(std::string name, std::string what, bool& target) {
  add({Option::Kind::flag, std::move(name), "", std::move(what), {}, [&target](const std::string&) -> Parsed<void> {
         target = true;
         return {};
       }});
}

void Command::text(std::string name, std::string value_name, std::string what, std::optional<std::string>& target,
                   Values values) {
  const auto parse = [](std::string_view text) { return Parsed<std::string>(text); };
  value(std::move(name), std::move(value_name), std::move(what), target, parse, std::move(values));
}

void Command::output(std::string name, std::string value_name, std::string what, std::optional<std::string>& target,
                     std::vector<std::string> endings, std::vector<std::string> words) {
  const Values values = file(std::move(endings), std::move(words));
  const auto parse = [this, values](std::string_view text) -> Parsed<std::string> {
    if (text.empty()) return wrong("the name of the file is empty");
    if (text.front() == '-') return wrong("is no file's name; one that begins with - is given as ./{}", text);
    if (auto sound = check_ending(text, values); !sound) return tl::unexpected(std::move(sound.error()));
    return std::string(text);
  };
  value(std::move(name), std::move(value_name), std::move(what), target, parse, values);
}

/// What the file holds is said by how its name ends: any other would hold what nobody expects.
Parsed<void> Command::check_ending(std::string_view text, const Values& values) const {
  const std::string ending = in_small_letters(std::filesystem::path(text).extension());
  const auto writes_it = [&](const Option& option) {
    return !option.is_word() && std::ranges::find(option.values.endings, ending) != option.values.endings.end();
  };
  if (values.endings.empty() || std::ranges::find(values.endings, ending) != values.endings.end()) return {};
  const bool is_word = std::ranges::find(values.words, in_small_letters(std::string(text))) != values.words.end();
  if (is_word || is_special(text)) return {};
  const auto other = std::ranges::find_if(options_, writes_it);
  return wrong("{}; {}", missing_ending(values.endings),
               other == options_.end() ? "the ending says the format" : other->name + " is for " + ending);
}

void Command::folder(std::string name, std::string value_name, std::string what, std::optional<std::string>& target) {
  const auto parse = [](std::string_view text) -> Parsed<std::string> {
    if (text.empty()) return wrong("the name of the folder is empty");
    if (text.front() == '-') return wrong("is no folder's name; one that begins with - is given as ./{}", text);
    return std::string(text);
  };
  value(std::move(name), std::move(value_name), std::move(what), target, parse, {.folders = true});
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

Parsed<const Command*> Program::find(std::string_view command) const {
  const auto found = std::ranges::find(commands, command, &Command::name);
  if (found != commands.end()) return &*found;
  std::vector<std::string_view> known;
  for (const Command& each : commands) known.push_back(each.name());
  const std::string meant = base::did_you_mean(command, known);
  return wrong("no command \"{}\"{}", command, meant.empty() ? known_commands : meant);
}

std::variant<const Command*, Answer> parse_command_line(Program& program, int count, const char* const* values) {
  if (auto answer =
          check_command(program, std::span(values, static_cast<std::size_t>(count)).subspan(std::min(count, 1))))
    return std::move(*answer);
  CLI::App app(program.itself.what(), program.name());
  add_options(app, program.itself);
  app.footer(fmt::format("{}\nExit status: {}", program.itself.help(), program.exit_statuses));
  app.require_subcommand(0, 1);  // a second word that is a command's name is a word
  std::vector<CLI::App*> added;
  for (Command& command : program.commands) {
    added.push_back(app.add_subcommand(command.name(), command.what()));
    add_options(*added.back(), command);
  }
  const auto place = [&] {
    const auto parsed = std::ranges::find_if(added, [](const CLI::App* command) { return command->parsed(); });
    return static_cast<std::size_t>(parsed - added.begin());
  };
  const auto asked = [&]() -> const CLI::App& { return place() < added.size() ? *added[place()] : app; };
  const auto name = [&] { return place() < added.size() ? program.name() + " " + asked().get_name() : program.name(); };
  try {
    app.parse(count, values);
  } catch (const CLI::CallForHelp&) {
    return Answer{Status::done, asked().help(place() < added.size() ? program.name() : std::string())};
  } catch (const CLI::ExtrasError&) {
    return usage_answer(name(), unexpected(asked()));
  } catch (const CLI::ArgumentMismatch& error) {
    return usage_answer(name(), mismatch(asked(), values[count - 1], error.what()));
  } catch (const CLI::RequiredError& error) {
    return usage_answer(name(), missing_word(asked(), error.what()));
  } catch (const CLI::ParseError& error) {
    return usage_answer(name(), error.what());
  }
  const bool is_of_command = place() < added.size();
  const Command& command = is_of_command ? program.commands[place()] : program.itself;
  const auto taken = command.take();
  if (!taken) return usage_answer(name(), taken.error());
  return is_of_command ? &command : nullptr;
}

std::string help_text(Program& program, const Command* command) {
  std::vector<const char*> line = {program.name().c_str()};
  if (command != nullptr) line.push_back(command->name().c_str());
  line.push_back(HelpOption::name.data());
  const auto parsed = parse_command_line(program, static_cast<int>(line.size()), line.data());
  return std::get<Answer>(parsed).text;
}

}  // namespace leadscrew::options
