#pragma once
// The options of a command, as data: what they are called, what --help says of them, what their values are, and where
// these go. Help, manual pages (manual.hpp) and the completion of shells (completion.hpp) are made of the same data.
// Behind the parsing stands CLI11, which options.cpp alone includes, since it takes ten seconds to compile.
//
//   Command run("run", "Plan and interpolate");
//   run.value("--period", "TIME", "Servo period, such as 1ms", arguments.period, parse_period);
//   parse_command_line(…)  ─▶  text of every option  ─▶  values, in the order of description  ─▶  checks of the whole

#include <fmt/core.h>

#include <deque>
#include <functional>
#include <initializer_list>
#include <leadscrew/options/quantity.hpp>
#include <leadscrew/options/status.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace leadscrew::options {

/// What a user did wrong, in words.
template <class... Values>
tl::unexpected<std::string> wrong(fmt::format_string<Values...> text, Values&&... values) {
  return tl::unexpected<std::string>(fmt::format(text, std::forward<Values>(values)...));
}

/// What the text of an option or a word may be, as shells complete it. With neither words nor files nor folders: any
/// text.
struct Values {
  std::vector<std::string> words = {};
  bool is_list = false;                   ///< one or more of the words, with commas between them
  bool files = false;                     ///< the name of a file
  std::vector<std::string> endings = {};  ///< of the file's name, in small letters, ".csv"; empty: any
  bool folders = false;                   ///< the name of a folder
};

/// A file with one of these endings, or one of the words.
inline Values file(std::vector<std::string> endings = {}, std::vector<std::string> words = {}) {
  return {.words = std::move(words), .files = true, .endings = std::move(endings)};
}

/// An option, a flag or a word by its place.
struct Option {
  enum class Kind { flag, value, values, optional_value, word, optional_word, words };

  Kind kind = Kind::value;
  std::string name;        ///< "--period"; of words "PROGRAM"
  std::string value_name;  ///< "TIME"
  std::string what;
  Values values;
  /// Called with each text that was given, of a flag with none: puts the value where it goes, or says what is wrong
  /// with it in words that follow "--period TEXT: ".
  std::function<Parsed<void>(const std::string&)> take;
  std::vector<std::string> given = {};

  /// Is the word behind it its value, whatever it is?
  bool has_value() const { return kind == Kind::value || kind == Kind::values; }
  bool is_word() const { return kind == Kind::word || kind == Kind::optional_word || kind == Kind::words; }
};

/// What every command has beside its own options.
struct HelpOption {
  static constexpr std::string_view short_name = "-h", name = "--help", what = "This text";
};

class Command {
 public:
  Command(std::string name, std::string what) : name_(std::move(name)), what_(std::move(what)) {}
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  /// Words that must be there: one, one that is added to a list, or one or more of those; and one that may be there.
  void word(std::string name, std::string what, std::string& target, Values values = {});
  void word(std::string name, std::string what, std::vector<std::string>& targets, Values values = {});
  void words(std::string name, std::string what, std::vector<std::string>& targets, Values values = {});
  void optional_word(std::string name, std::string what, std::optional<std::string>& target, Values values = {});

  /// An option with one word or more behind it, up to the next option; they are added to a list.
  void values(std::string name, std::string value_name, std::string what, std::vector<std::string>& targets,
              Values values = {});

  void flag(std::string name, std::string what, bool& target);
  void text(std::string name, std::string value_name, std::string what, std::optional<std::string>& target,
            Values values = {});
  /// The name of a file to be written: not empty, no option that was taken for it, and with one of the endings if there
  /// are any, or one of the words. What is there and is no regular file, /dev/null or a pipe, may have any name.
  void output(std::string name, std::string value_name, std::string what, std::optional<std::string>& target,
              std::vector<std::string> endings, std::vector<std::string> words = {});
  /// The name of a folder that files are written to.
  void folder(std::string name, std::string value_name, std::string what, std::optional<std::string>& target);
  /// A number from `least` to `most`.
  void number(std::string name, std::string value_name, std::string what, double& target, double least, double most);

  /// What `parse` makes of the text: a function of std::string_view that returns a Parsed.
  template <class Target, class Parse>
  void value(std::string name, std::string value_name, std::string what, Target& target, Parse parse,
             Values values = {}) {
    add({Option::Kind::value, std::move(name), std::move(value_name), std::move(what), std::move(values),
         [&target, parse](const std::string& given) -> Parsed<void> {
           auto parsed = parse(std::string_view(given));
           if (!parsed) return tl::unexpected(std::move(parsed.error()));
           target = std::move(*parsed);
           return {};
         }});
  }

  /// The same, or `without` where the option is the last word, or another option follows.
  template <class Target, class Parse>
  void optional_value(std::string name, std::string value_name, std::string what, Target& target, Target without,
                      Parse parse) {
    value(std::move(name), "[" + value_name + "]", std::move(what), target,
          [without = std::move(without), parse](std::string_view given) -> Parsed<Target> {
            if (given.empty()) return without;
            return parse(given);
          });
    options_.back().kind = Option::Kind::optional_value;
  }

  /// One of some words.
  template <class Chosen, class Target>
  void choice(std::string name, std::string value_name, std::string what, Target& target,
              std::vector<std::pair<std::string_view, Chosen>> choices) {
    Values values;
    for (const auto& [word, chosen] : choices) values.words.emplace_back(word);
    const auto parse = [choices = std::move(choices)](std::string_view text) -> Parsed<Chosen> {
      std::vector<std::string_view> words;
      for (const auto& [word, chosen] : choices) {
        if (word == text) return chosen;
        words.push_back(word);
      }
      return tl::unexpected(none_of(text, words));
    };
    value(std::move(name), std::move(value_name), std::move(what), target, parse, std::move(values));
  }

  /// Examples and the like, below the options.
  void help(std::string text) { help_ = std::move(text); }

  /// Looks at the values together, once all are taken; says in a whole sentence what is wrong.
  void check(std::function<Parsed<void>()> check) { checks_.push_back(std::move(check)); }
  /// Each of the options would be ignored without the first.
  void only_with(std::string_view needed, std::vector<std::string_view> options);

  /// Was the option given?
  bool given(std::string_view name) const;
  /// As it was given last; empty where it was not.
  std::string_view text_of(std::string_view name) const;
  /// The first of them that was given; empty for none.
  std::string_view first_given(std::initializer_list<std::string_view> names) const;

  const std::string& name() const { return name_; }
  const std::string& what() const { return what_; }
  const std::string& help() const { return help_; }
  std::span<Option> options() { return options_; }
  std::span<const Option> options() const { return options_; }

  /// Hands every text that was given to its option, then checks the whole. What is wrong is a whole sentence.
  Parsed<void> take() const;

 private:
  void add_words(Option::Kind kind, std::string name, std::string what, std::vector<std::string>& targets,
                 Values values);
  Parsed<void> check_ending(std::string_view text, const Values& values) const;
  void add(Option option) { options_.push_back(std::move(option)); }
  static std::string none_of(std::string_view text, std::span<const std::string_view> words);

  std::string name_, what_, help_;
  std::vector<Option> options_;
  std::vector<std::function<Parsed<void>()>> checks_;
};

/// Instead of arguments: a text for standard output (help), or for standard error when the status is usage.
struct Answer {
  Status status = Status::done;
  std::string text;
};

/// What is wrong with the words behind `where`, "leadscrew run".
Answer usage_answer(const std::string& where, const std::string& message);

/// A program of several commands.
struct Program {
  Program(std::string name, std::string what, std::string version_number, std::string released_on = {})
      : version(std::move(version_number)),
        released(std::move(released_on)),
        itself(std::move(name), std::move(what)) {}

  std::string version;
  std::string released;          ///< the day of that version, as 2026-11-28, in manual pages; may be empty
  Command itself;                ///< what is asked for without a command
  std::deque<Command> commands;  ///< in the order of help
  std::string known_commands;    ///< "; there are …", for a word that is no command
  std::string exit_statuses;     ///< in the help of the program and in every manual page

  const std::string& name() const { return itself.name(); }
  /// The command of this name, or what is wrong with it in a whole sentence.
  Parsed<const Command*> find(std::string_view command) const;
};

/// The command that the line asks for, whose values are where they go; null: what stands before commands alone.
std::variant<const Command*, Answer> parse_command_line(Program& program, int count, const char* const* values);

/// The words of a command line, as a shell would take them; the first of the values is left out for the program's name.
std::string command_line(std::string_view program, int count, const char* const* values);

/// What --help prints behind the command; null: without one.
std::string help_text(Program& program, const Command* command);

}  // namespace leadscrew::options
