// With options.cpp, the one file that includes CLI11, which is slow to compile.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/cli/curve_program.hpp>
#include <leadscrew/base/nearest.hpp>
#include <leadscrew/cli/options.hpp>
#include <leadscrew/cli/outputs.hpp>
#include <leadscrew/study/studies.hpp>
#include <set>
#include <stdexcept>

namespace leadscrew::cli {

namespace {

constexpr std::string_view exit_statuses =
    "Exit status: 0 done, 1 a limit or tolerance was not kept or the referee objects, 2 usage,\n"
    "  3 program or machine file rejected, 4 input/output, 130 interrupted; of several programs the greatest.";

constexpr std::string_view main_examples =
    "Examples:\n"
    "  leadscrew run part.ngc                     plan it for the built-in mill, show time and limits\n"
    "  leadscrew check part.ngc                   only read it\n"
    "  leadscrew drive part.ngc                   run it on time, with simulated drives\n"
    "  leadscrew pulse --line --end 11,7          a line in single steps, by every method\n"
    "  leadscrew design --help                    size digital integrators\n"
    "  leadscrew run --help                       every option of run\n";

/// A command line that makes no sense; what() says why.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

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

std::string command_line(int count, const char* const* values) {
  std::string line = "leadscrew";
  for (int i = 1; i < count; ++i) line += " " + shell_quoted(values[i]);
  return line;
}

template <class T>
T value_of(std::string_view option, const std::string& text, Parsed<T> parsed) {
  if (!parsed) throw UsageError(fmt::format("{} {}: {}", option, text, parsed.error()));
  return std::move(*parsed);
}

gcode::PathMode path_mode(const std::string& text) {
  if (text == "exact-stop") return gcode::PathMode::exact_stop;
  if (text == "blend") return gcode::PathMode::blend;
  throw UsageError(fmt::format("--mode {}: is neither exact-stop nor blend", text));
}

ColorChoice color_choice(const std::string& text) {
  if (text == "auto") return ColorChoice::automatic;
  if (text == "always") return ColorChoice::always;
  if (text == "never") return ColorChoice::never;
  throw UsageError(fmt::format("--color {}: is none of auto, always, never", text));
}

void take_values(const Texts& texts, Arguments& arguments) {
  if (texts.period) arguments.period = value_of("--period", *texts.period, parse_period(*texts.period));
  if (texts.mode) arguments.mode = path_mode(*texts.mode);
  if (texts.tolerance)
    arguments.tolerance = value_of("--tolerance", *texts.tolerance, parse_tolerance(*texts.tolerance));
  if (texts.start) arguments.start = value_of("--start", *texts.start, parse_axis_values(*texts.start));
  const bool simulates = arguments.command == Arguments::Command::simulate;
  if (arguments.command == Arguments::Command::run || simulates) {
    auto run = parse_run(texts.run, arguments.programs.size());
    if (!run) throw UsageError(run.error());
    arguments.run = std::move(*run);
  }
  if (simulates) {
    auto simulate = parse_simulate(texts.simulate);
    if (!simulate) throw UsageError(simulate.error());
    arguments.simulate = *simulate;
  }
  if (arguments.command == Arguments::Command::pulse) {
    auto pulse = parse_pulse(texts.pulse, arguments.json);
    if (!pulse) throw UsageError(pulse.error());
    arguments.pulse = std::move(*pulse);
  }
  if (arguments.command == Arguments::Command::design) {
    auto design = parse_design(texts.design);
    if (!design) throw UsageError(design.error());
    arguments.design = std::move(*design);
  }
  if (arguments.command == Arguments::Command::drive) {
    auto drive = parse_drive(texts.drive);
    if (!drive) throw UsageError(drive.error());
    arguments.drive = std::move(*drive);
  }
  if (texts.color) arguments.color = color_choice(*texts.color);
}

void check_standard_input(const Arguments& arguments) {
  const auto from_programs = std::count(arguments.programs.begin(), arguments.programs.end(), "-");
  if (from_programs + (arguments.judged_trace == "-" ? 1 : 0) > 1)
    throw UsageError("standard input (-) can be read only once");
}

void check_curves(const Arguments& arguments) {
  for (const std::string& program : arguments.programs) {
    if (!is_curve(program)) continue;
    const auto curve = curve_program(program);
    if (!curve) throw UsageError(curve.error());
    if (arguments.start.empty()) continue;
    throw UsageError(
        fmt::format("--start is of files; {} begins at X{} Y{}", program, curve->start[0], curve->start[1]));
  }
}

/// What --out writes of one program must not have the name of another's.
void check_names(const Arguments& arguments) {
  if (!arguments.run.out || arguments.programs.size() < 2) return;
  std::set<std::string> names;
  for (const std::string& program : arguments.programs) {
    const OutputPaths paths = output_paths(arguments, program);
    for (const auto& path : paths.all()) {
      if (path && !names.insert(*path).second)
        throw UsageError(fmt::format("--out: two programs would write {}", *path));
    }
  }
}

std::vector<std::string> names_of_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back(name);
  }
  return names;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const std::vector<std::string_view> views(known.begin(), known.end());
  return base::did_you_mean(word, std::span(views));
}

void check_picture(const Arguments& arguments) {
  if (!arguments.study_picture) return;
  std::vector<std::string_view> drawn;
  for (const study::Study& study : study::studies()) {
    if (study.charts == nullptr) continue;
    if (study.name == arguments.study) return;
    drawn.push_back(study.name);
  }
  throw UsageError(
      fmt::format("--picture: there is none of {}; there is of {}", arguments.study, fmt::join(drawn, ", ")));
}

void check_study(const Arguments& arguments) {
  if (arguments.command != Arguments::Command::study) return;
  std::vector<std::string> known = {"list"};
  for (const study::Study& study : study::studies()) known.emplace_back(study.name);
  if (std::find(known.begin(), known.end(), arguments.study) != known.end()) return check_picture(arguments);
  const std::string meant = did_you_mean(arguments.study, known);
  throw UsageError(fmt::format("no study \"{}\"{}", arguments.study,
                               meant.empty() ? fmt::format("; there are {}", fmt::join(known, ", ")) : meant));
}

/// What CLI11 could not place: options nobody knows, or words too many.
std::string unexpected(const CLI::App& command) {
  const std::vector<std::string> rest = command.remaining();
  const auto option =
      std::find_if(rest.begin(), rest.end(), [](auto& word) { return word.size() > 1 && word[0] == '-'; });
  if (option == rest.end()) return fmt::format("\"{}\" is one word too many", rest.empty() ? "" : rest.front());
  const std::string name = option->substr(0, option->find('='));
  // Dashes would count as letters that are right.
  const std::vector<std::string> known = names_of_options(command);
  const std::vector<std::string_view> views(known.begin(), known.end());
  const auto meant = base::nearest(std::string_view(name).substr(std::min(name.find_first_not_of('-'), name.size())), views);
  return fmt::format("no option {}{}", name, meant ? fmt::format("; did you mean --{}?", *meant) : "");
}

/// "--bits: 1 required N missing" and its likes, in words.
std::string mismatch(const std::string& said) {
  const std::size_t colon = said.find(": 1 required ");
  const std::string_view missing = " missing";
  if (colon == std::string::npos || !said.ends_with(missing)) return said;
  const std::size_t value = colon + std::string_view(": 1 required ").size();
  return fmt::format("{} needs a value: {}", said.substr(0, colon),
                     said.substr(value, said.size() - missing.size() - value));
}

Answer usage(const std::string& where, const std::string& message) {
  return {Status::usage, fmt::format("{}: error: {}\n    hint: {} --help\n", where, message, where)};
}

constexpr std::string_view commands_there_are =
    "; there are run, check, verify and simulate for programs, drive to run them on time, pulse, study and design";

/// The first word must be a command; CLI11 would say less.
std::optional<Answer> check_command(int count, const char* const* values) {
  const std::vector<std::string> known = {"run", "check", "verify", "pulse", "study", "design", "simulate", "drive"};
  if (count < 2) return usage("leadscrew", fmt::format("no command{}", commands_there_are));
  const std::string word = values[1];
  if (word.empty() || word[0] != '-') {
    if (std::find(known.begin(), known.end(), word) != known.end()) return std::nullopt;
    const std::string meant = did_you_mean(word, known);
    return usage("leadscrew", fmt::format("no command \"{}\"{}", word, meant.empty() ? commands_there_are : meant));
  }
  const std::vector<std::string> options = {"--help", "--version"};
  const bool known_option = word == "-h" || std::find(options.begin(), options.end(), word) != options.end();
  if (known_option) return std::nullopt;
  return usage("leadscrew", fmt::format("no option {} before the command{}", word, did_you_mean(word, options)));
}

class Parser {
 public:
  Parser() {
    app_.set_version_flag("--version", std::string("leadscrew ") + LEADSCREW_VERSION);
    app_.set_help_flag("-h,--help", "This text");
    app_.require_subcommand(1);
    app_.footer(std::string(main_examples) + "\n" + std::string(exit_statuses));
    commands_ = {add_run(app_, arguments_, texts_),      add_check(app_, arguments_, texts_),
                 add_verify(app_, arguments_, texts_),   add_pulse(app_, arguments_, texts_),
                 add_study(app_, arguments_, texts_),    add_design(app_, arguments_, texts_),
                 add_simulate(app_, arguments_, texts_), add_drive(app_, arguments_, texts_)};
  }

  std::variant<Arguments, Answer> parse(int count, const char* const* values) {
    try {
      app_.parse(count, values);
      arguments_.command = app_.got_subcommand(commands_[0])   ? Arguments::Command::run
                           : app_.got_subcommand(commands_[1]) ? Arguments::Command::check
                           : app_.got_subcommand(commands_[2]) ? Arguments::Command::verify
                           : app_.got_subcommand(commands_[3]) ? Arguments::Command::pulse
                           : app_.got_subcommand(commands_[4]) ? Arguments::Command::study
                           : app_.got_subcommand(commands_[5]) ? Arguments::Command::design
                           : app_.got_subcommand(commands_[6]) ? Arguments::Command::simulate
                                                               : Arguments::Command::drive;
      arguments_.command_line = command_line(count, values);
      const bool has_one =
          arguments_.command == Arguments::Command::verify || arguments_.command == Arguments::Command::drive;
      if (has_one) arguments_.programs = {texts_.one_program};
      take_values(texts_, arguments_);
      check_study(arguments_);
      check_standard_input(arguments_);
      check_curves(arguments_);
      check_names(arguments_);
      return arguments_;
    } catch (const CLI::CallForHelp&) {
      return Answer{Status::done, command().help()};
    } catch (const CLI::CallForVersion&) {
      return Answer{Status::done, app_.version() + "\n"};
    } catch (const CLI::ExtrasError&) {
      return usage(name(), unexpected(command()));
    } catch (const CLI::ArgumentMismatch& error) {
      return usage(name(), mismatch(error.what()));
    } catch (const CLI::ParseError& error) {
      return usage(name(), error.what());
    } catch (const UsageError& error) {
      return usage(name(), error.what());
    }
  }

 private:
  /// The command that was being parsed.
  const CLI::App& command() const {
    const auto found = std::find_if(commands_.begin(), commands_.end(), [](const CLI::App* c) { return c->parsed(); });
    return found == commands_.end() ? app_ : **found;
  }
  std::string name() const { return &command() == &app_ ? "leadscrew" : "leadscrew " + command().get_name(); }

  Arguments arguments_;
  Texts texts_;
  CLI::App app_{"CNC part programs into motion.", "leadscrew"};
  std::array<CLI::App*, 8> commands_{};
};

}  // namespace

std::variant<Arguments, Answer> parse_arguments(int count, const char* const* values) {
  if (auto answer = check_command(count, values)) return std::move(*answer);
  return Parser().parse(count, values);
}

}  // namespace leadscrew::cli
