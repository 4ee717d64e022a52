#include <cmath>
#include <leadscrew/sweep/model_table.hpp>
#include <leadscrew/sweep/options.hpp>

namespace leadscrew::sweep {

namespace {

using options::Command;
using options::Parsed;
using options::wrong;

constexpr const char* sweep_examples =
    "Examples:\n"
    "  leadscrew sweep --programs archive --machines machines/*.toml --tolerance 0.001,0.01,0.1 --out quoted\n"
    "  mpirun -n 64 leadscrew sweep --programs archive --out quoted     the same on many processors\n"
    "  leadscrew sweep --random 10000 --seed 7 --out campaign           random programs, every promise judged\n"
    "  leadscrew sweep --programs archive --optimise --out bought       which limit is worth buying\n"
    "  leadscrew sweep --merge --out quoted                             the table of what is done\n"
    "\n"
    "A task is a program on a machine with one of the values of each parameter: read, planned, made into words and "
    "judged.\n"
    "What is done stays in DIR/shards; the same command again does what is left. DIR/results.jsonl, .csv and .npy have "
    "a\n"
    "row a task, the same whoever did it; DIR/results.html is a page of them. A program with errors is a row, not a "
    "failure.\n";

/// Numbers from `least` to `most`, with commas between them.
auto numbers_between(double least, double most) {
  return [least, most](std::string_view text) -> Parsed<std::vector<double>> {
    auto numbers = options::parse_numbers(text);
    if (!numbers) return numbers;
    for (const double number : *numbers) {
      if (!(number >= least && number <= most)) return wrong("{:g} is not from {:g} to {:g}", number, least, most);
    }
    return numbers;
  };
}

Parsed<std::vector<base::Period>> parse_periods(std::string_view text) {
  std::vector<base::Period> periods;
  while (true) {
    const std::size_t end = std::min(text.find(','), text.size());
    const auto period = options::parse_period(text.substr(0, end));
    if (!period) return tl::unexpected(period.error());
    periods.push_back(*period);
    if (end == text.size()) return periods;
    text.remove_prefix(end + 1);
  }
}

auto whole_number(double least, double most) {
  return [least, most](std::string_view text) -> Parsed<std::int64_t> {
    const auto number = options::parse_number(text);
    if (!number || !(*number >= least) || *number > most || *number != std::floor(*number))
      return wrong("is no whole number from {} to {}", least, most);
    return static_cast<std::int64_t>(*number);
  };
}

Parsed<int> parse_processes(std::string_view text) {
  constexpr double most = 1024;
  const auto number = options::parse_number(text);
  if (!number || !(*number >= 1) || *number > most || *number != std::floor(*number))
    return wrong("is no number of processes from 1 to {}", most);
  return static_cast<int>(*number);
}

void add_grid(Command& command, Grid& grid) {
  constexpr double most_tolerance = 100, least_override = 0.01, most_override = 2, least = 0.01, most = 100;
  const auto factors = numbers_between(least, most);
  command.value("--tolerance", "MM,...", "In place of P of G64 and the machine's, mm", grid.tolerances,
                numbers_between(0, most_tolerance));
  command.value("--override", "FACTOR,...", "Of the programmed feed, 0.01 to 2", grid.overrides,
                numbers_between(least_override, most_override));
  command.value("--period", "TIME,...", "Servo periods, such as 1ms,250us, in place of the machine's", grid.periods,
                parse_periods);
  command.value("--velocity", "FACTOR,...", "Of every axis' limit of velocity, 0.01 to 100", grid.velocities, factors);
  command.value("--acceleration", "FACTOR,...", "Of every axis' limit of acceleration", grid.accelerations, factors);
  command.value("--jerk", "FACTOR,...", "Of every axis' limit of jerk", grid.jerks, factors);
}

Parsed<void> check(const Command& command, const Options& options) {
  if (!options.out) return wrong("--out DIR is missing: where results are kept");
  const int asked = (options.merges ? 1 : 0) + (options.model.empty() ? 0 : 1) + (command.given("--programs") ? 1 : 0) +
                    (options.random > 0 ? 1 : 0);
  if (asked == 0) return wrong("--programs is missing: folders and files of part programs");
  if (asked > 1) return wrong("--programs, --random, --merge and --model exclude each other: give one");
  return {};
}

}  // namespace

void describe(Command& command, Options& options) {
  command.values("--programs", "PATH...", "Part programs: files, and folders with all that are in them",
                 options.programs, {.files = true, .folders = true});
  command.values("--machines", "FILE...", "Machine files (TOML), or the built-in mill3 (default)", options.machines,
                 options::file({".toml"}, {"mill3"}));
  command.text("--tools", "FILE", "Tool table, in LinuxCNC's format", options.tools, options::file({".tbl"}));
  add_grid(command, options.grid);
  constexpr double most_cases = 1e12;
  command.value("--random", "N", "In place of programs: N random ones on random machines, each judged", options.random,
                whole_number(1, most_cases));
  command.value("--seed", "S", "Of --random (default: 1)", options.seed, whole_number(0, most_cases));
  command.value("--first", "K", "Of --random: the number of the first (default: 0)", options.first,
                whole_number(0, most_cases));
  command.only_with("--random", {"--seed", "--first"});
  command.folder("--out", "DIR", "Where results are kept, and taken up again", options.out);
  command.flag("--optimise", "Of --programs: what 5 % less and more of each limit makes of the time of all of them",
               options.optimises);
  command.only_with("--programs", {"--machines", "--optimise"});
  command.value("--model", "RANKS,...",
                "Simulate the sweep in DIR by its tasks' times: 1,2,4@2 (4 ranks on 2 processors)", options.model,
                parse_model_setups);
  command.value("--model-tasks", "N", "Of --model: repeat its tasks until there are N", options.model_tasks,
                whole_number(1, most_cases));
  command.only_with("--model", {"--model-tasks"});
  command.flag("--merge", "Only make the table of the results that are there", options.merges);
  command.value("--processes", "N", "Work on so many tasks at a time, 1 to 1024 (default: one a processor)",
                options.processes, parse_processes);
  command.check([&command, &options] { return check(command, options); });
  command.help(sweep_examples);
}

}  // namespace leadscrew::sweep
