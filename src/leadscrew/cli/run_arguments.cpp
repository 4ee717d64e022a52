#include <algorithm>
#include <cctype>
#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/cli/curve_program.hpp>
#include <leadscrew/cli/pulse_arguments.hpp>
#include <leadscrew/cli/run_arguments.hpp>
#include <leadscrew/cli/shared_arguments.hpp>
#include <leadscrew/machine/step_times.hpp>
#include <leadscrew/trace/word_writer.hpp>

namespace leadscrew::cli {

namespace {

constexpr std::string_view run_examples =
    "Examples:\n"
    "  leadscrew run part.ngc\n"
    "  leadscrew run part.ngc --machine machines/heavy3.toml --trace part.csv --report part.html\n"
    "  leadscrew run part.ngc --pulses part.vcd   steps and directions that follow the motion\n"
    "  leadscrew run part.ngc --pulses part.csv --machine machines/mill3-worn.toml   its screws' errors made good\n"
    "  leadscrew run *.ngc --out results          results/NAME.csv, .html and .svg of each\n"
    "  leadscrew run *.ngc --out results --pulses vcd   and its steps, results/NAME.steps.vcd\n"
    "  generator | leadscrew run - --json         a program from standard input, figures as JSON\n"
    "\n"
    "Times of step signals may be given for each axis in the machine file, [axis.X], in microseconds, 1 by default:\n"
    "step_length_us, step_space_us, direction_setup_us, direction_hold_us. What clock and times cannot give at an "
    "axis'\n"
    "greatest velocity and acceleration is refused before anything moves.\n"
    "\n"
    "Files appear whole or not at all. A program with an error is not moved. cycle_ns of --json is the time of\n"
    "a call that makes a word, of every 61st from the first on, the two looks at the clock included.\n";

constexpr std::array<const char*, 4> step_times_help = {
    "Of --pulses: least length of a step, such as 2.5us, in place of the machine's",
    "Of --pulses: least time between two steps of an axis, likewise",
    "Of --pulses: least time from a change of direction to the next step, likewise",
    "Of --pulses: least time from the end of a step to a change of direction, likewise"};

std::vector<std::pair<std::string_view, interpolator::StepRule>> step_rules() {
  std::vector<std::pair<std::string_view, interpolator::StepRule>> rules;
  for (const interpolator::StepRule rule : interpolator::all_step_rules)
    rules.emplace_back(interpolator::name(rule), rule);
  return rules;
}

void add_step_times(Command& command, RunArguments& run) {
  for (std::size_t k = 0; k < step_time_options.size(); ++k) {
    const std::int64_t least = machine::all_step_times[k].least;
    command.value(step_time_options[k], "TIME", step_times_help[k], run.step_times[k], [least](std::string_view text) {
      auto time = parse_step_time(text);
      return time && *time < least ? Parsed<std::int64_t>(wrong("must be above 0")) : time;
    });
  }
}

void add_blocks(Command& command, Arguments& arguments) {
  command.output("--blocks", "FILE.csv", "Write what each block took and lost, and what it waited for",
                 arguments.run.blocks, {".csv"});
  command.check([&command, &arguments]() -> Parsed<void> {
    if (arguments.programs.size() < 2 || !command.given("--blocks")) return {};
    return wrong("--blocks is for one program");
  });
}

void add_pulses(Command& command, RunArguments& run) {
  command.output("--pulses", "FILE",
                 "Write steps and directions: .vcd or .csv; beside --out vcd or csv, for DIR/NAME.steps.vcd",
                 run.pulses, {".vcd", ".csv"}, {"vcd", "csv"});
  command.value("--pulse-method", "NAME",
                "Of --pulses: by an interpolator of the papers, not steps that follow the words: " +
                    names_of_pulse_methods() + "; here dda too has capacity R or L and begins half full",
                run.pulse_method, parse_pulse_method, {.words = pulse_method_names()});
  command.flag("--accelerate",
               "Of --pulse-method: feed rises and falls as the axes can; else one that an axis cannot make is refused",
               run.accelerate);
  command.flag("--hardware-model",
               "Of --pulses: by the hardware itself, hdl/rtl as Verilator simulates it (method bresenham)",
               run.hardware_model);
  command.output("--waves", "FILE.fst", "Of --hardware-model: write all its signals, at every clock", run.waves,
                 {".fst"});
  command.value("--step-clock", "HZ", "Of --pulses: 10kHz to 10MHz (default 1MHz)", run.step_clock, parse_frequency);
  add_step_times(command, run);
}

/// Options that would be ignored, and steps of several programs in one file.
Parsed<void> check_pulses(Arguments& arguments) {
  RunArguments& run = arguments.run;
  if (run.hardware_model) {
    if (run.accelerate || run.pulse_method.value_or(nc::PulseMethod::bresenham) != nc::PulseMethod::bresenham)
      return wrong("--hardware-model is --pulse-method bresenham, at constant feed");
    run.pulse_method = nc::PulseMethod::bresenham;
  }
  if (run.accelerate && !run.pulse_method)
    return wrong("--accelerate is of --pulse-method; steps that follow the words have the words' acceleration");
  if (run.pulses && !run.out && step_format(*run.pulses))
    return wrong("--pulses {0}: names a format beside --out DIR; alone it is a file's name, such as steps.{0}",
                 *run.pulses);
  if (arguments.programs.size() < 2 || !run.pulses || (run.out && step_format(*run.pulses))) return {};
  return wrong(
      "--pulses {}: is for one program; with several, --out DIR --pulses vcd, or csv, writes the steps of each",
      *run.pulses);
}

}  // namespace

std::optional<std::string> step_format(std::string_view text) {
  std::string format(text);
  std::transform(format.begin(), format.end(), format.begin(), [](unsigned char c) { return std::tolower(c); });
  if (format == "vcd" || format == "csv") return format;
  return std::nullopt;
}

void describe_run(Command& command, Arguments& arguments) {
  RunArguments& run = arguments.run;
  command.words("PROGRAM", programs_help, arguments.programs, program_values());
  add_common(command, arguments);
  add_period(command, arguments);
  add_motion(command, arguments);
  command.choice("--interpolator", "RULE",
                 "Parameter steps along curves: arc-length (default), taylor1, taylor2, newton or uniform",
                 run.interpolator, step_rules());
  command.output("--trace", "FILE", "Write the words: " + trace::endings_text(), run.trace, trace_endings());
  add_pulses(command, run);
  add_pages(command, arguments);
  add_blocks(command, arguments);
  add_threads(command, arguments);
  command.check([&arguments] { return check_pulses(arguments); });
  add_one_set_of_parameters(command, arguments);
  command.only_with("--hardware-model", {"--waves"});
  command.only_with("--pulses", {"--pulse-method", "--hardware-model", "--step-clock", "--step-length", "--step-space",
                                 "--direction-setup", "--direction-hold"});
  command.help(std::string(run_examples) + curves_text());
}

}  // namespace leadscrew::cli
