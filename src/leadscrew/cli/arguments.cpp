#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <leadscrew/cli/about.hpp>
#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/cli/curve_program.hpp>
#include <leadscrew/cli/language.hpp>
#include <leadscrew/cli/outputs.hpp>
#include <leadscrew/cli/shared_arguments.hpp>
#include <leadscrew/trace/word_writer.hpp>
#include <set>

namespace leadscrew::cli {

namespace {

constexpr std::string_view exit_statuses =
    "0 done, 1 a limit or tolerance was not kept or the referee objects, 2 usage,\n"
    "3 program or machine file rejected, 4 input/output, 130 interrupted; of several programs the greatest.\n"
    "A reader that closes the pipe of standard output, as head does, is 4 without a message.";

constexpr std::string_view main_examples =
    "Examples:\n"
    "  leadscrew run part.ngc                     plan it for the built-in mill, show time and limits\n"
    "  leadscrew check part.ngc                   only read it\n"
    "  leadscrew drive part.ngc                   run it on time, with simulated drives\n"
    "  leadscrew pulse --line --end 11,7          a line in single steps, by every method\n"
    "  leadscrew design --help                    size digital integrators\n"
    "  leadscrew help run                         every option of run\n";

constexpr std::string_view check_examples =
    "Examples:\n"
    "  leadscrew check part.ngc\n"
    "  leadscrew check *.ngc --machine machines/mill6.toml --json\n";

constexpr std::string_view canon_examples =
    "Examples:\n"
    "  leadscrew canon part.ngc\n"
    "  leadscrew canon part.ngc --machine machines/mill6.toml | less\n"
    "\n"
    "The form is that of LinuxCNC's rs274 -g. Offsets, feeds and modes stand where the next call depends on them.\n"
    "With errors the calls are those before the first.\n";

constexpr std::string_view verify_examples =
    "Examples:\n"
    "  leadscrew verify part.csv part.ngc\n"
    "  leadscrew verify other-controller.csv part.ngc --machine machines/heavy3.toml --period 1ms --json\n"
    "  leadscrew verify other-controller.csv part.ngc --report judged.html\n"
    "\n"
    "TRACE is CSV with columns t and axis letters, or NPY. Without --period its rows must be evenly spaced in t.\n";

constexpr std::string_view measure_examples =
    "Examples:\n"
    "  leadscrew measure words.csv part.ngc --tools tools.tbl\n"
    "  leadscrew measure words.csv part.ngc --tools tools.tbl --allow 0.002 --picture left.svg --map left.csv\n"
    "\n"
    "TRACE is CSV with columns t, line and axis letters, or NPY; without line the program may have one tool only.\n";

/// Of commands that read programs.
Parsed<void> check_standard_input(const Arguments& arguments) {
  const auto from_programs = std::count(arguments.programs.begin(), arguments.programs.end(), "-");
  if (from_programs + (arguments.judged_trace == "-" ? 1 : 0) > 1)
    return wrong("standard input (-) can be read only once");
  return {};
}

Parsed<void> check_curves(const Arguments& arguments) {
  for (const std::string& program : arguments.programs) {
    if (!is_curve(program)) continue;
    const auto curve = curve_program(program);
    if (!curve) return tl::unexpected(curve.error());
    if (arguments.start.empty()) continue;
    return wrong("--start is of files; {} begins at X{} Y{}", program, curve->start[0], curve->start[1]);
  }
  return {};
}

/// What --out writes of one program must not have the name of another's.
Parsed<void> check_names(const Arguments& arguments) {
  if (!arguments.run.out || arguments.programs.size() < 2) return {};
  std::set<std::string> names;
  for (const std::string& program : arguments.programs) {
    const OutputPaths paths = output_paths(arguments, program);
    for (const auto& path : paths.all()) {
      if (path && !names.insert(*path).second) return wrong("--out: two programs would write {}", *path);
    }
  }
  return {};
}

void describe_check(Command& command, Arguments& arguments) {
  command.words("PROGRAM", programs_help, arguments.programs, program_values());
  add_common(command, arguments);
  add_threads(command, arguments);
  command.flag("--gouge", "See whether tools and their holders cut into surfaces that are machined (G6.5): exit 1",
               arguments.gouge);
  command.value("--gouge-tolerance", "MM", "Of --gouge: how deep they may be inside (default: the machine's tolerance)",
                arguments.gouge_tolerance, parse_tolerance);
  command.only_with("--gouge", {"--gouge-tolerance"});
  command.flag("--lint", "Warn of what runs but is surely not meant: rapids in the work, a spindle that is off",
               arguments.lint);
  command.value("--stock-top", "MM", "Of --lint: the top of the stock, Z of the program (default: 0)",
                arguments.stock_top, parse_number);
  command.only_with("--lint", {"--stock-top"});
  command.help(std::string(check_examples) + curves_text());
}

void describe_canon(Command& command, Arguments& arguments) {
  command.word("PROGRAM", "Part program; - is standard input, curve:NAME a curve of the studies", arguments.programs,
               program_values());
  add_setup(command, arguments);
  add_color(command, arguments);
  command.help(std::string(canon_examples) + curves_text());
}

void describe_verify(Command& command, Arguments& arguments) {
  command.word("TRACE", "Trace, " + trace::endings_text() + "; - is standard input", arguments.judged_trace,
               file(trace_endings()));
  command.word("PROGRAM", "Its part program; - is standard input, curve:NAME a curve of the studies",
               arguments.programs, program_values());
  add_common(command, arguments);
  command.value("--period", "TIME", "Time between rows, such as 1ms, in place of what t says", arguments.period,
                parse_period);
  add_motion(command, arguments);
  add_report(command, arguments);
  command.help(std::string(verify_examples) + curves_text());
}

Parsed<double> parse_reach(std::string_view text) {
  auto reach = parse_number(text);
  if (reach && *reach <= 0) return wrong("\"{}\": above 0", text);
  return reach;
}

Parsed<std::int64_t> parse_places(std::string_view text) {
  const auto places = parse_number(text);
  if (!places) return tl::unexpected(places.error());
  if (*places >= 4096 && *places <= 1 << 24 && *places == std::floor(*places))
    return static_cast<std::int64_t>(*places);
  return wrong("\"{}\": a whole number from 4096 to 16777216", text);
}

void describe_measure(Command& command, Arguments& arguments) {
  results::MeasureQuestion& question = arguments.measure;
  command.word("TRACE", "Trace, " + trace::endings_text() + "; - is standard input", arguments.judged_trace,
               file(trace_endings()));
  command.word("PROGRAM", "Its part program, which machines surfaces (G6.5); - is standard input", arguments.programs,
               program_values());
  add_common(command, arguments);
  command.value("--allow", "MM", "How deep a cut may be (default: the machine's tolerance)", question.allowed_cut,
                parse_tolerance);
  command.value("--ridge", "MM", "How tall a ridge may be (default: ridges are not judged)", question.allowed_ridge,
                parse_tolerance);
  command.value("--reach", "MM", "What is left above has not been reached (default: 1)", question.reach, parse_reach);
  command.value("--places", "COUNT", "Of the grid at most, 4096 to 16777216 (default: 1048576)", question.places,
                parse_places);
  command.output("--map", "FILE.csv", "Write what is left at each place of the grid", question.map, {".csv"});
  command.output("--picture", "FILE.svg", "Write what is left in colours, and a section across the passes",
                 question.picture, {".svg"});
  command.help(std::string(measure_examples));
}

void describe_sweep(Command& command, Arguments& arguments) {
  sweep::describe(command, arguments.sweep);
  add_output(command, arguments);
}

struct Described {
  const char* name;
  const char* what;
  void (*describe)(Command&, Arguments&);
};

/// Those of Arguments::Verb, in its order; then those that are answered at once.
constexpr std::array<Described, 17> verbs = {
    {{"run", "Plan and interpolate; summary, report, picture, traces, steps", describe_run},
     {"check", "Read only: diagnostics", describe_check},
     {"verify", "The referee: any trace against its program and machine", describe_verify},
     {"measure", "The surface that a tool leaves: ridges, cuts, what was not reached", describe_measure},
     {"canon", "The canonical machining calls of a program, as rs274 -g prints them", describe_canon},
     {"pulse", "One line or arc in reference pulses, clock by clock", describe_pulse},
     {"study", "Published tables and figures made again, ours beside them", describe_study},
     {"design", "Size digital integrators: bits, clock, feed word, rates", describe_design},
     {"simulate", "Words through simulated loops of all axes: errors of the slides", describe_simulate},
     {"drive", "Run on time: the real-time controller, with simulated drives or a file", describe_drive},
     {"explain", "What a block means, in words", describe_explain},
     {"format", "A program in one way of writing, its meaning kept", describe_format},
     {"surfaces", "Faces of a STEP or IGES file as surfaces of a program", describe_surfaces},
     {"serve", "The workbench in a browser of this machine", describe_serve},
     {"sweep", "Programs x machines x parameters, on all processors or under mpirun", describe_sweep},
     {"help", "What a command does, its options and examples; manual pages", describe_help},
     {"completion", "A script by which a shell completes this command's words", describe_completion}}};

}  // namespace

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const Described& verb : verbs) names.emplace_back(verb.name);
  return names;
}

void describe_program(options::Program& program, Arguments& arguments) {
  program.exit_statuses = exit_statuses;
  program.known_commands =
      "; there are run, check, verify, measure, canon and simulate for programs, drive to run them on time, pulse, "
      "study and "
      "design; "
      "sweep for many of them on many machines; explain and format for blocks in words and in order, surfaces for STEP "
      "and IGES, serve for the workbench; help "
      "says more";
  describe_itself(program.itself, arguments);
  program.itself.help(std::string(main_examples));
  for (const Described& verb : verbs) {
    Command& command = program.commands.emplace_back(verb.name, verb.what);
    verb.describe(command, arguments);
    command.check([&arguments] {
      return check_standard_input(arguments).and_then([&] { return check_curves(arguments); }).and_then([&] {
        return check_names(arguments);
      });
    });
  }
}

std::variant<Arguments, Answer> parse_arguments(int count, const char* const* values) {
  Arguments arguments;
  options::Program program("leadscrew", "CNC part programs into motion.", LEADSCREW_VERSION, LEADSCREW_RELEASED);
  describe_program(program, arguments);
  const auto parsed = options::parse_command_line(program, count, values);
  if (const auto* answer = std::get_if<Answer>(&parsed)) return *answer;
  const Command* const command = std::get<const Command*>(parsed);
  if (auto answer = answer_about(program, command, arguments)) return std::move(*answer);
  const auto verb = std::ranges::find(verbs, command->name(), &Described::name);
  arguments.verb = static_cast<Arguments::Verb>(verb - verbs.begin());
  arguments.command_line = options::command_line(program.name(), count, values);
  return arguments;
}

}  // namespace leadscrew::cli
