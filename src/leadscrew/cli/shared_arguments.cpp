#include <algorithm>
#include <cmath>
#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/cli/curve_program.hpp>
#include <leadscrew/cli/shared_arguments.hpp>
#include <leadscrew/study/named_curves.hpp>
#include <leadscrew/trace/word_writer.hpp>

namespace leadscrew::cli {

Values program_values() {
  Values values = file({".ngc", ".nc", ".tap", ".gcode", ".cnc"});
  for (const study::NamedCurve& curve : study::named_curves())
    values.words.push_back(std::string(curve_prefix) + std::string(curve.name));
  return values;
}

std::vector<std::string> trace_endings() {
  const auto endings = trace::endings();
  return {endings.begin(), endings.end()};
}

void add_color(Command& command, Arguments& arguments) {
  command.choice<ColorChoice>(
      "--color", "WHEN", "auto, always or never; NO_COLOR is heeded", arguments.color,
      {{"auto", ColorChoice::automatic}, {"always", ColorChoice::always}, {"never", ColorChoice::never}});
}

void add_output(Command& command, Arguments& arguments) {
  command.flag("--json", "One JSON object on standard output, nothing else there", arguments.json);
  command.flag("--quiet", "No summary and no progress bar", arguments.quiet);
  add_color(command, arguments);
}

void add_dialect(Command& command, Arguments& arguments) {
  std::vector<std::pair<std::string_view, machine::Dialect>> dialects;
  for (std::size_t i = 0; i < machine::dialect_names.size(); ++i) {
    dialects.emplace_back(machine::dialect_names[i], static_cast<machine::Dialect>(i));
  }
  command.choice<machine::Dialect>("--dialect", "NAME",
                                   "What codes mean, in place of the machine's: leadscrew, linuxcnc, fanuc, haas, "
                                   "grbl, mach3, marlin or fanuc-lathe",
                                   arguments.dialect, std::move(dialects));
}

void add_flow(Command& command, Arguments& arguments) {
  command.value("--subprograms", "DIR:...", "Folders of subprograms, behind that of the program", arguments.subprograms,
                [](std::string_view text) -> Parsed<std::vector<std::string>> {
                  std::vector<std::string> folders;
                  while (!text.empty()) {
                    const std::size_t end = std::min(text.find(':'), text.size());
                    if (end > 0) folders.emplace_back(text.substr(0, end));
                    text.remove_prefix(std::min(end + 1, text.size()));
                  }
                  return folders;
                });
  command.flag("--allow-gouge", "Go on though the tool gouges: surfaces (G6.5), compensated contours",
               arguments.allow_gouge);
  command.value("--fuel", "BLOCKS", "Read so many blocks in loops and subprograms at most (default: 100000000)",
                arguments.fuel, [](std::string_view text) -> Parsed<std::int64_t> {
                  constexpr double most = 1e15;
                  const auto number = parse_number(text);
                  if (!number || !(*number >= 1) || *number > most || *number != std::floor(*number))
                    return wrong("is no number of blocks from 1 to {}", most);
                  return static_cast<std::int64_t>(*number);
                });
}

void add_setup(Command& command, Arguments& arguments) {
  command.text("--machine", "FILE", "Machine file (TOML), or the built-in mill3 (default)", arguments.machine,
               file({".toml"}, {"mill3"}));
  command.text("--tools", "FILE", "Tool table, in LinuxCNC's format", arguments.tools, file({".tbl"}));
  add_dialect(command, arguments);
  command.text(
      "--parameters", "FILE",
      "Parameters where a program begins, in LinuxCNC's format; run and drive write there what holds at its end",
      arguments.parameters, file({".var"}));
  command.value("--start", "X0,Y0,...",
                "Where a program of a file begins, machine coordinates: X10,Y5 or 10,5,0 (default: 0)", arguments.start,
                parse_axis_values);
  add_flow(command, arguments);
}

void add_common(Command& command, Arguments& arguments) {
  add_setup(command, arguments);
  add_output(command, arguments);
}

void add_one_set_of_parameters(Command& command, Arguments& arguments) {
  command.check([&arguments]() -> Parsed<void> {
    if (arguments.programs.size() < 2 || !arguments.parameters) return {};
    return wrong("--parameters is written by one program; run several one by one");
  });
}

void add_threads(Command& command, Arguments& arguments) {
  command.value("--threads", "N", "Work on so many programs at a time, 1 to 1024 (default: one a processor)",
                arguments.threads, [](std::string_view text) -> Parsed<int> {
                  constexpr double most_threads = 1024;
                  const auto number = parse_number(text);
                  const bool is_count =
                      number && *number >= 1 && *number <= most_threads && *number == std::floor(*number);
                  if (!is_count) return wrong("is no number of threads from 1 to {}", most_threads);
                  return static_cast<int>(*number);
                });
}

void add_period(Command& command, Arguments& arguments) {
  command.value("--period", "TIME", "Servo period, such as 1ms or 250us, in place of the machine's", arguments.period,
                parse_period);
}

void add_motion(Command& command, Arguments& arguments) {
  command.choice<gcode::PathMode>("--mode", "MODE", "exact-stop or blend, in place of G61, G61.1 and G64",
                                  arguments.mode,
                                  {{"exact-stop", gcode::PathMode::exact_stop}, {"blend", gcode::PathMode::blend}});
  command.choice<machine::Smoothing>(
      "--smoothing", "WAY", "splines or least-time, in place of the machine's: corners and short lines within G64's P",
      arguments.smoothing, {{"splines", machine::Smoothing::splines}, {"least-time", machine::Smoothing::least_time}});
  command.value("--tolerance", "MM", "In place of P of G64 and the machine's, mm", arguments.tolerance,
                parse_tolerance);
}

void add_report(Command& command, Arguments& arguments) {
  command.output("--report", "FILE.html", "Write one self-contained page", arguments.run.report, {".html", ".htm"});
  command.output("--picture", "FILE.svg", "Write the path alone, coloured by speed, rapids dashed",
                 arguments.run.picture, {".svg"});
  command.output("--charts", "FILE.svg", "Write the axes over time alone, to jerk, against their limits",
                 arguments.run.charts, {".svg"});
}

void add_pages(Command& command, Arguments& arguments) {
  RunArguments& run = arguments.run;
  add_report(command, arguments);
  command.output("--events", "FILE.csv", "Write when and where spindle, coolant, tools and outputs were asked for",
                 run.events, {".csv"});
  command.folder("--out", "DIR", "Write DIR/NAME.csv, .html and .svg of each program", run.out);
  command.check([&command, &arguments]() -> Parsed<void> {
    const std::string_view option = command.first_given({"--trace", "--report", "--picture", "--charts", "--events"});
    if (arguments.programs.size() < 2 || option.empty()) return {};
    return wrong("{} is for one program; with several, --out DIR writes the files of each", option);
  });
}

}  // namespace leadscrew::cli
