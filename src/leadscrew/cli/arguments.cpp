// The one file that includes CLI11, which is slow to compile.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/cli/nearest.hpp>
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

constexpr std::string_view check_examples =
    "Examples:\n"
    "  leadscrew check part.ngc\n"
    "  leadscrew check *.ngc --machine machines/mill6.toml --json\n";

constexpr std::string_view verify_examples =
    "Examples:\n"
    "  leadscrew verify part.csv part.ngc\n"
    "  leadscrew verify other-controller.csv part.ngc --machine machines/heavy3.toml --period 1ms --json\n"
    "\n"
    "TRACE is CSV with columns t and axis letters, or NPY. Without --period its rows must be evenly spaced in t.\n";

constexpr std::string_view study_examples =
    "Examples:\n"
    "  leadscrew study list                       what there is\n"
    "  leadscrew study butterfly\n"
    "  leadscrew study feed-fluctuation --json    rows of what, published, ours, unit, verdict and why\n";

/// A command line that makes no sense; what() says why.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Options as text, before their values are looked at.
struct Texts {
  std::optional<std::string> period, mode, tolerance, start, color;
  std::string one_program;  ///< of verify and drive
  RunTexts run;
  PulseTexts pulse;
  DesignTexts design;
  SimulateTexts simulate;
  DriveTexts drive;
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

void add_output(CLI::App& command, Arguments& arguments, Texts& texts) {
  command.add_flag("--json", arguments.json, "One JSON object on standard output, nothing else there");
  command.add_flag("--quiet", arguments.quiet, "No summary and no progress bar");
  command.add_option("--color", texts.color, "auto, always or never; NO_COLOR is heeded")->type_name("WHEN");
}

void add_common(CLI::App& command, Arguments& arguments, Texts& texts) {
  command.add_option("--machine", arguments.machine, "Machine file (TOML), or the built-in mill3 (default)")
      ->type_name("FILE");
  command.add_option("--tools", arguments.tools, "Tool table, in LinuxCNC's format")->type_name("FILE");
  command
      .add_option("--start", texts.start,
                  "Where the program begins, machine coordinates: X10,Y5 or 10,5,0 (default: 0)")
      ->type_name("X0,Y0,...");
  add_output(command, arguments, texts);
}

void add_motion(CLI::App& command, Arguments&, Texts& texts) {
  command.add_option("--mode", texts.mode, "exact-stop or blend, in place of G61, G61.1 and G64")->type_name("MODE");
  command.add_option("--tolerance", texts.tolerance, "In place of P of G64 and the machine's, mm")->type_name("MM");
}

CLI::App* add_run(CLI::App& app, Arguments& arguments, Texts& all) {
  RunTexts& texts = all.run;
  CLI::App* run = app.add_subcommand("run", "Plan and interpolate; summary, report, picture, traces, steps");
  run->add_option("PROGRAM", arguments.programs, "Part programs; - is standard input")->required()->type_name("");
  add_common(*run, arguments, all);
  run->add_option("--period", all.period, "Servo period, such as 1ms or 250us, in place of the machine's")
      ->type_name("TIME");
  add_motion(*run, arguments, all);
  run->add_option("--interpolator", texts.interpolator,
                  "Parameter steps along curves: arc-length (default), taylor1, taylor2, newton or uniform")
      ->type_name("RULE");
  run->add_option("--trace", texts.trace, "Write the words: .csv or .npy")->type_name("FILE");
  run->add_option("--pulses", texts.pulses,
                  "Write steps and directions: .vcd or .csv; beside --out vcd or csv, for DIR/NAME.steps.vcd")
      ->type_name("FILE");
  run->add_option("--pulse-method", texts.pulse_method,
                  "Of --pulses: by an interpolator of the papers, not steps that follow the words: " +
                      names_of_pulse_methods() + "; here dda too has capacity R or L and begins half full")
      ->type_name("NAME");
  run->add_flag("--accelerate", texts.accelerate, "Of --pulse-method: feed rises and falls as the axes can");
  run->add_option("--step-clock", texts.step_clock, "Of --pulses: 10kHz to 10MHz (default 1MHz)")->type_name("HZ");
  constexpr std::array<const char*, 4> step_times = {
      "Of --pulses: least length of a step, such as 2.5us, in place of the machine's",
      "Of --pulses: least time between two steps of an axis, likewise",
      "Of --pulses: least time from a change of direction to the next step, likewise",
      "Of --pulses: least time from the end of a step to a change of direction, likewise"};
  for (std::size_t k = 0; k < step_times.size(); ++k)
    run->add_option(step_time_options[k], texts.step_times[k], step_times[k])->type_name("TIME");
  run->add_option("--report", texts.report, "Write one self-contained page")->type_name("FILE.html");
  run->add_option("--picture", texts.picture, "Write the path alone, coloured by speed")->type_name("FILE.svg");
  run->add_option("--out", texts.out, "Write DIR/NAME.csv, .html and .svg of each program")->type_name("DIR");
  run->footer(std::string(run_examples));
  return run;
}

void add_adaptive(CLI::App& simulate, AdaptiveTexts& texts) {
  simulate.add_flag("--adaptive", texts.asked_for,
                    "Hold the cutting force at a limit by the feed override; the cut is:");
  const auto add = [&](const char* name, std::optional<std::string>& text, const char* what, const char* unit) {
    simulate.add_option(name, text, what)->type_name(unit);
  };
  add("--material", texts.material, materials_there_are, "NAME");
  add("--depth", texts.depth, "Along the cutter's axis (default: 2)", "MM");
  add("--depth-steps", texts.depth_steps, "Depths from places along the path on, in place of --depth", "S:MM,...");
  add("--width", texts.width, "Across the cutter (default: 0.4 of its diameter)", "MM");
  add("--teeth", texts.teeth, "Of the cutter (default: 4)", "N");
  add("--diameter", texts.diameter, "Of the cutter (default: 10)", "MM");
  add("--spindle", texts.spindle, "Speed of the spindle (default: 3000)", "RPM");
  add("--edge-force", texts.edge_force, "Of a mm of cutting edge that rubs (default: 0)", "N/MM");
  add("--force-limit", texts.force_limit, "Of the mean force (default: of the first depth at the greatest feed)", "N");
  add("--noise", texts.noise, "Of the sensor, in % of the limit (default: 5)", "PERCENT");
  add("--seed", texts.seed, "Of the noise (default: 1)", "N");
  add("--safe-factor", texts.safe_factor, "Of the programmed feed, once the sensor has failed (default: 0.5)", "SHARE");
  add("--sensor-fault", texts.sensor_fault, "nan, stuck or silent from a time on, such as stuck@1.5", "KIND@S");
}

CLI::App* add_simulate(CLI::App& app, Arguments& arguments, Texts& all) {
  CLI::App* simulate =
      app.add_subcommand("simulate", "Words through simulated loops of all axes: errors of the slides");
  simulate->add_option("PROGRAM", arguments.programs, "Part programs; - is standard input")->required()->type_name("");
  add_common(*simulate, arguments, all);
  simulate->add_option("--period", all.period, "Servo period, such as 1ms or 250us, in place of the machine's")
      ->type_name("TIME");
  add_motion(*simulate, arguments, all);
  simulate
      ->add_option("--gains", all.simulate.gains,
                   "PID in every axis: u = P e + I T sum(e) + D (e - last e), in place of the machine's controllers")
      ->type_name("P,I,D");
  simulate->add_option("--feed-forward", all.simulate.feed_forward, "on or off, of velocity and acceleration")
      ->type_name("WHETHER");
  simulate->add_flag("--pulses", all.simulate.pulses, "Steps through pulse-driven loops, in place of words");
  add_adaptive(*simulate, all.simulate.adaptive);
  simulate->add_option("--trace", all.run.trace, "Write words and slides: .csv or .npy")->type_name("FILE");
  simulate->add_option("--report", all.run.report, "Write one self-contained page")->type_name("FILE.html");
  simulate->add_option("--picture", all.run.picture, "Write the path alone, coloured by speed")->type_name("FILE.svg");
  simulate->add_option("--out", all.run.out, "Write DIR/NAME.csv, .html and .svg of each program")->type_name("DIR");
  simulate->footer(simulate_help());
  return simulate;
}

CLI::App* add_check(CLI::App& app, Arguments& arguments, Texts& texts) {
  CLI::App* check = app.add_subcommand("check", "Read only: diagnostics");
  check->add_option("PROGRAM", arguments.programs, "Part programs; - is standard input")->required()->type_name("");
  add_common(*check, arguments, texts);
  check->footer(std::string(check_examples));
  return check;
}

CLI::App* add_verify(CLI::App& app, Arguments& arguments, Texts& texts) {
  CLI::App* verify = app.add_subcommand("verify", "The referee: any trace against its program and machine");
  verify->add_option("TRACE", arguments.judged_trace, "Trace, .csv or .npy; - is standard input")
      ->required()
      ->type_name("");
  verify->add_option("PROGRAM", texts.one_program, "Its part program; - is standard input")->required()->type_name("");
  add_common(*verify, arguments, texts);
  verify->add_option("--period", texts.period, "Time between rows, such as 1ms, in place of what t says")
      ->type_name("TIME");
  add_motion(*verify, arguments, texts);
  verify->footer(std::string(verify_examples));
  return verify;
}

CLI::App* add_drive(CLI::App& app, Arguments& arguments, Texts& all) {
  DriveTexts& texts = all.drive;
  CLI::App* drive = app.add_subcommand("drive", "Run on time: the real-time controller, with simulated drives");
  drive->add_option("PROGRAM", all.one_program, "Part program; - is standard input")->required()->type_name("");
  add_common(*drive, arguments, all);
  drive->add_option("--period", all.period, "Servo period, such as 1ms or 250us, in place of the machine's")
      ->type_name("TIME");
  add_motion(*drive, arguments, all);
  drive->add_option("--trace", texts.trace, "Write the words that the drives took: .csv or .npy")->type_name("FILE");
  drive->add_option("--axes", texts.axes, "Write where the axes went, period by period: .csv or .npy")
      ->type_name("FILE");
  drive->add_option("--state", texts.state, "Keep on disk how far it has come, for --resume")->type_name("FILE");
  drive->add_option("--resume", texts.resume, "Go on from where a drive was stopped or killed; FILE is kept up")
      ->type_name("FILE");
  drive->add_option("--look-ahead", texts.look_ahead, "Planned ahead of the words (default 300ms)")->type_name("TIME");
  drive
      ->add_option("--lead", texts.lead,
                   "Words made ahead of their time, so that late ones harm nothing (default 100ms)")
      ->type_name("TIME");
  drive->footer(std::string(drive_examples));
  return drive;
}

CLI::App* add_pulse(CLI::App& app, Arguments& arguments, Texts& all) {
  PulseTexts& texts = all.pulse;
  CLI::App* pulse = app.add_subcommand("pulse", "One line or arc in reference pulses, clock by clock");
  pulse->add_flag("--arc", texts.arc, "An arc");
  pulse->add_flag("--line", texts.line, "A straight line");
  pulse->add_option("--start", texts.start, "Where it starts (of a line, default: 0,0)")->type_name("X,Y");
  pulse->add_option("--end", texts.end, "Where it ends")->type_name("X,Y");
  pulse->add_option("--center", texts.center, "Of an arc (default: 0,0)")->type_name("X,Y");
  pulse->add_flag("--cw", texts.clockwise, "Clockwise");
  pulse->add_flag("--ccw", texts.counterclockwise, "Counterclockwise (default)");
  pulse->add_option("--method", texts.methods, "Some of " + names_of_pulse_methods() + " (default: all)")
      ->type_name("LIST");
  pulse->add_option("--bits", texts.bits, "Width of the registers; the capacity of dda is then 2^N")->type_name("N");
  pulse->add_option("--preload", texts.preload, "Of the remainders: zero, half, half-lagging or full")
      ->type_name("LOAD");
  pulse->add_option("--tie", texts.tie, "Where point comparison goes on the circle: outward or inward")
      ->type_name("WAY");
  pulse
      ->add_option("--order", texts.order,
                   "Of the integrators of arcs: parallel, x-first, shrinking-first or growing-first")
      ->type_name("ORDER");
  pulse->add_flag("--table", texts.table, "Every register at every clock, as text");
  pulse->add_flag("--path", texts.path, "Every place, in JSON");
  pulse->add_option("--vcd", texts.vcd, "Write every register at every clock")->type_name("FILE.vcd");
  pulse->add_option("--svg", texts.svg, "Write the steps over the true curve")->type_name("FILE.svg");
  add_output(*pulse, arguments, all);
  pulse->footer(std::string(pulse_examples));
  return pulse;
}

CLI::App* add_study(CLI::App& app, Arguments& arguments, Texts& texts) {
  CLI::App* study = app.add_subcommand("study", "Published tables and figures made again, ours beside them");
  study->add_option("NAME", arguments.study, "Which; list says what there is")->required()->type_name("");
  add_output(*study, arguments, texts);
  study->footer(std::string(study_examples));
  return study;
}

CLI::App* add_design(CLI::App& app, Arguments& arguments, Texts& all) {
  DesignTexts& texts = all.design;
  CLI::App* design = app.add_subcommand("design", "Size digital integrators: bits, clock, feed word, rates");
  design->add_option("--travel", texts.travel, "Greatest way of an axis")->type_name("MM");
  design->add_option("--blu", texts.blu, "Basic length unit: a step")->type_name("MM");
  design->add_option("--max-feed", texts.max_feed, "Greatest feed")->type_name("MM/MIN");
  design->add_option("--min-distance", texts.min_distance, "Shortest line at the greatest feed")->type_name("MM");
  design->add_option("--from", texts.from, "Where a line starts (default: 0)")->type_name("X,Y,...");
  design->add_option("--to", texts.to, "Where it ends")->type_name("X,Y,...");
  design->add_option("--feed", texts.feed, "Along it")->type_name("MM/MIN");
  design->add_flag("--timer", texts.timer, "A timer: first overflow after each delay");
  design->add_option("--clock", texts.clock, "Of the timer")->type_name("PULSES/S");
  design->add_option("--delays", texts.delays, "Of the timer")->type_name("S,...");
  design->add_flag("--inverse-time", texts.inverse_time, "Feed words of the inverse-time code, and of software");
  design->add_option("--distance", texts.distance, "Length of a line, for --inverse-time")->type_name("UNITS");
  design->add_option("--radius", texts.radius, "Radius of an arc, for --inverse-time")->type_name("UNITS");
  design->add_option("--resolution", texts.resolution, "Of the feed in software (default: 0.01)")
      ->type_name("UNITS/MIN");
  design->add_option("--digits", texts.digits, "Of the inverse-time code (default: 4)")->type_name("N");
  add_output(*design, arguments, all);
  design->footer(std::string(design_examples));
  return design;
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
  return cli::did_you_mean(word, std::span(views));
}

void check_study(const Arguments& arguments) {
  if (arguments.command != Arguments::Command::study) return;
  std::vector<std::string> known = {"list"};
  for (const study::Study& study : study::studies()) known.emplace_back(study.name);
  if (std::find(known.begin(), known.end(), arguments.study) != known.end()) return;
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
  const auto meant = nearest(std::string_view(name).substr(std::min(name.find_first_not_of('-'), name.size())), views);
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
