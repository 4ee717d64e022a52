#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/cli/curve_program.hpp>
#include <leadscrew/cli/drive_arguments.hpp>
#include <leadscrew/cli/shared_arguments.hpp>
#include <leadscrew/trace/word_writer.hpp>

namespace leadscrew::cli {

namespace {

constexpr std::string_view drive_examples =
    "Examples:\n"
    "  leadscrew drive part.ngc --state part.state\n"
    "  leadscrew drive part.ngc --resume part.state     from where it was stopped or killed\n"
    "  leadscrew drive part.ngc --trace words.csv --axes axes.csv --json\n"
    "  leadscrew drive part.ngc --sink words.csv        words on time to a file or a pipe, and no drives\n"
    "  make-program | leadscrew drive - --live          block by block, as they come\n"
    "  leadscrew drive part.ngc --serve --control       seen in a browser, and held or stopped from there\n"
    "\n"
    "Keys, on a terminal: space holds and resumes, + and - change the feed by 10 %, q stops. ^C brings motion to rest\n"
    "on the path; after a second one no more words are made. The drives are simulated by a process of their own: when\n"
    "words cease, they come to rest by themselves, on the path and within the limits of every axis. Without a "
    "terminal,\n"
    "and with --quiet, M0 and M1 pause only under --serve --control, for the page. What was in the file of --sink is\n"
    "gone. A pipe that is full holds motion back, word by word; behind it, whoever moves must come to rest by itself\n"
    "when words cease.\n";

/// 100ms, 0.3s or 0.3.
Parsed<double> parse_seconds(std::string_view text, double least, double greatest) {
  std::string_view number = text;
  double unit = 1;
  if (number.ends_with("ms")) {
    number.remove_suffix(2);
    unit = 1e-3;
  } else if (number.ends_with("s")) {
    number.remove_suffix(1);
  }
  const auto value = parse_number(number);
  if (value && *value * unit >= least && *value * unit <= greatest) return *value * unit;
  return wrong("is no time from {:g} s to {:g} s, such as 250ms", least, greatest);
}

/// What several options come to together.
Parsed<void> settle(const Command& command, drive::Options& drive) {
  if (drive.live && (drive.state || drive.resume))
    return wrong("{} is of a program that can be read again; --live reads it once",
                 command.first_given({"--state", "--resume"}));
  if (!drive.state) drive.state = drive.resume;
  const std::string_view of_drives = command.first_given({"--trace", "--axes"});
  if (!drive.sink || of_drives.empty()) return {};
  return wrong("{} is of simulated drives; with --sink the words are in its file", of_drives);
}

}  // namespace

void describe_drive(Command& command, Arguments& arguments) {
  drive::Options& drive = arguments.drive;
  command.word("PROGRAM", "Part program; - is standard input, curve:NAME a curve of the studies", arguments.programs,
               program_values());
  add_common(command, arguments);
  add_period(command, arguments);
  add_motion(command, arguments);
  command.output("--trace", "FILE", "Write the words that the drives took: " + trace::endings_text(), drive.trace,
                 trace_endings());
  command.output("--axes", "FILE", "Write where the axes went, period by period: " + trace::endings_text(), drive.axes,
                 trace_endings());
  command.output("--events", "FILE", "Write when and where spindle, coolant, tools and outputs were asked for, as CSV",
                 drive.events, {".csv"});
  command.output("--sink", "FILE", "Words go on time to this file or pipe, as CSV, and to no drives", drive.sink,
                 {".csv"});
  command.flag("--live", "Move while the program is being written, to a pipe: nothing of it is checked before it comes",
               drive.live);
  command.output("--state", "FILE", "Keep on disk how far it has come, for --resume", drive.state, {});
  command.output("--resume", "FILE", "Go on from where a drive was stopped or killed; FILE is kept up", drive.resume,
                 {});
  command.value("--look-ahead", "TIME", "Planned ahead of the words (default 300ms, less where that is enough)",
                drive.look_ahead, [](std::string_view text) { return parse_seconds(text, 0.01, 60); });
  command.value("--lead", "TIME", "Words made ahead of their time, so that late ones harm nothing (default 100ms)",
                drive.lead, [](std::string_view text) { return parse_seconds(text, 0, 2); });
  add_serve(command, arguments);
  command.check([&command, &drive] { return settle(command, drive); });
  command.help(std::string(drive_examples) + curves_text());
}

}  // namespace leadscrew::cli
