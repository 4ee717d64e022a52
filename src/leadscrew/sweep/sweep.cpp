#include <fmt/format.h>
#include <sys/file.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <leadscrew/config/machine_file.hpp>
#include <leadscrew/files/descriptor.hpp>
#include <leadscrew/files/input_file.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/files/output_file.hpp>
#include <leadscrew/gcode/tool_table.hpp>
#include <leadscrew/sweep/archive.hpp>
#include <leadscrew/sweep/campaign.hpp>
#include <leadscrew/sweep/merge.hpp>
#include <leadscrew/sweep/model_table.hpp>
#include <leadscrew/sweep/options.hpp>
#include <leadscrew/sweep/results_page.hpp>
#include <leadscrew/sweep/runner.hpp>
#include <leadscrew/sweep/summary.hpp>
#include <leadscrew/sweep/world_load.hpp>
#include <optional>
#include <thread>

namespace leadscrew::sweep {

namespace {

using options::Status;

constexpr std::int64_t largest_tool_table = 16 << 20;
constexpr double seconds_for_others = 10;  // to end, of a sweep that was killed

std::size_t processes_of(const Options& options) {
  return static_cast<std::size_t>(
      options.processes.value_or(static_cast<int>(std::max(1U, std::thread::hardware_concurrency()))));
}

base::Result<NamedMachine> machine_at(const std::string& path, console::Console& console) {
  if (path == "mill3") return NamedMachine{path, machine::mill3(), path};
  auto text = files::read_whole(path, config::largest_machine_file);
  if (!text) return base::failure(text.error());
  auto machine = config::read_machine(*text, path);
  if (machine) return NamedMachine{path, std::move(*machine), std::move(*text)};
  for (std::size_t k = 0; k + 1 < machine.error().size(); ++k) console.diagnostic(machine.error()[k]);
  return base::failure(machine.error().back());
}

base::Result<ArchiveSetup> archive_of(const Options& options, console::Console& console) {
  ArchiveSetup setup;
  auto programs = programs_in(options.programs);
  if (!programs) return base::failure(programs.error());
  setup.programs = std::move(*programs);
  for (const std::string& path : options.machines.empty() ? std::vector<std::string>{"mill3"} : options.machines) {
    auto machine = machine_at(path, console);
    if (!machine) return base::failure(machine.error());
    setup.machines.push_back(std::move(*machine));
  }
  if (options.tools) {
    auto text = files::read_whole(*options.tools, largest_tool_table);
    if (!text) return base::failure(text.error());
    gcode::ToolTableText tools = gcode::read_tool_table(*text, *options.tools);
    for (const base::Diagnostic& problem : tools.diagnostics) {
      if (problem.severity == base::Severity::error) return base::failure(problem);
    }
    setup.tools = std::move(tools.table);
    setup.tools_text = std::move(*text);
  }
  setup.parameters = options.grid.combinations();
  if (options.optimises) setup.parameters = with_changes(setup.parameters, setup.machines);
  return setup;
}

/// Those of number first, first + step, …: one a line.
base::Result<std::string> survey_share(const ArchiveSetup& setup, std::size_t first, std::size_t step) {
  std::string lines;
  for (std::size_t k = first; k < setup.programs.size(); k += step) {
    const auto found = survey(setup, k);
    if (!found) return base::failure(found.error());
    lines += fmt::format("{} {} {} {} {}\n", k, text_of(found->content), found->bound_s, found->moves,
                         found->is_readable ? 1 : 0);
  }
  return lines;
}

void take_surveyed(const std::string& lines, std::vector<SurveyedProgram>& programs) {
  for (std::size_t begin = 0; begin < lines.size(); begin = lines.find('\n', begin) + 1) {
    unsigned long long number = 0;
    std::array<char, 40> content{};
    double bound = 0;
    long long moves = 0;
    int readable = 0;
    if (std::sscanf(lines.c_str() + begin, "%llu %32s %lf %lld %d", &number, content.data(), &bound, &moves,
                    &readable) != 5)
      return;
    SurveyedProgram& program = programs.at(number);
    program.content = key_of_text(content.data()).value_or(Key{});
    program.bound_s = bound;
    program.moves = moves;
    program.is_readable = readable == 1;
  }
}

base::Result<std::vector<SurveyedProgram>> survey_all(const ArchiveSetup& setup, std::size_t processes, World* world) {
  std::vector<base::Result<std::string>> parts;
  if (world != nullptr) {
    const auto own =
        survey_share(setup, static_cast<std::size_t>(world->rank()), static_cast<std::size_t>(world->size()));
    if (!own) return base::failure(own.error());
    std::string all;
    for (const std::string& part : world->gather(*own)) all += part;
    parts.emplace_back(world->broadcast(all));
  } else {
    parts.resize(std::min(processes, setup.programs.size()));
    std::vector<std::jthread> threads;
    for (std::size_t k = 0; k < parts.size(); ++k)
      threads.emplace_back([&, k] { parts[k] = survey_share(setup, k, parts.size()); });
  }
  std::vector<SurveyedProgram> programs(setup.programs.size());
  for (std::size_t k = 0; k < programs.size(); ++k) programs[k].path = setup.programs[k];
  for (const auto& part : parts) {
    if (!part) return base::failure(part.error());
    take_surveyed(*part, programs);
  }
  return programs;
}

/// Held as long as the sweep runs, by its processes too.
base::Result<files::Descriptor> lock(const std::string& folder) {
  const std::string path = folder + "/lock";
  if (auto made = files::make_folder_of(path); !made) return base::failure(made.error());
  auto file = files::open_descriptor(path, O_RDWR | O_CREAT | O_CLOEXEC, "cannot open");
  if (!file) return file;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds_for_others);
  while (::flock(file->number(), LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK) break;  // a file system without locks
    if (files::interrupted()) return base::failure(files::interruption());
    if (std::chrono::steady_clock::now() > deadline)
      return base::failure({base::Severity::error,
                            "sweep-in-use",
                            "another sweep writes its results here",
                            "wait for its end, or choose another --out",
                            {.file = folder},
                            {}});
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  const std::string shards = shards_of_sweep(folder);
  if (auto free = await_writers(shards, seconds_for_others); !free) return base::failure(free.error());
  return file;
}

std::string bytes_of(const Plan& plan) {
  std::string bytes(plan.order.size() * sizeof(std::int64_t), '\0');
  std::memcpy(bytes.data(), plan.order.data(), bytes.size());
  return bytes;
}

Plan plan_of_bytes(const std::string& bytes) {
  Plan plan;
  plan.order.resize(bytes.size() / sizeof(std::int64_t));
  std::memcpy(plan.order.data(), bytes.data(), bytes.size());
  return plan;
}

Status told(const base::Diagnostic& problem, console::Console& console) {
  if (problem.code != "interrupted") console.diagnostic(problem);
  return options::status_of(problem);
}

/// What stands in DIR before tasks are begun.
base::Result<Plan> begin(const Work& work, const std::string& folder) {
  if (auto written = write_tasks(work, folder); !written) return base::failure(written.error());
  return plan_of(work, shards_of_sweep(folder));
}

struct Asked {
  const Options& options;
  const Output& output;
};

/// The table, and what is printed.
Status conclude(const Asked& asked, const Plan& plan, const Ended& ended, double wall_s, console::Console& console) {
  const auto& [options, output] = asked;
  Summary summary;
  Sensitivities sensitivities;
  ResultsPage page;
  const auto merged = merge(*options.out, [&](const json::Json& row) {
    observe(row, summary);
    page.observe(row);
    if (row.find("changed") != nullptr || options.optimises) sensitivities.observe(row);
  });
  if (!merged) return told(merged.error(), console);
  summary.tasks = merged->tasks;
  summary.tasks_processor_s = merged->processor_s;
  summary.files = merged->files;
  summary.rows_of_others = merged->rows_of_others;
  summary.sensitivities = sensitivities.found();
  if (!summary.sensitivities.empty()) {
    const std::string path = *options.out + "/sensitivities.svg";
    if (auto drawn = write_text(path, sensitivity_picture(summary.sensitivities)); !drawn)
      return told(drawn.error(), console);
    summary.files.push_back(path);
  }
  const std::string page_path = *options.out + "/results.html";
  if (auto written = write_text(page_path, page.written(summary, *options.out)); !written)
    return told(written.error(), console);
  summary.files.push_back(page_path);
  summary.done_before = plan.done_before;
  summary.done = ended.done;
  summary.failed = ended.failed;
  summary.processor_s = ended.processor_s;
  summary.wall_s = wall_s;
  const Status status = worse(ended.status, summary.not_kept > 0 ? Status::not_kept : Status::done);
  if (output.quiet && !output.json) return status;
  const std::string text = output.json ? json_of(summary).written() + "\n" : text_of(summary, console.output_style());
  return worse(status, write_output(console, text));
}

/// How a start ends: all ranks together, or this one early, for which the others would wait.
struct Ending {
  Status status = Status::done;
  bool is_common = false;
};

Ending perform(Work& work, const Asked& asked, World* world, console::Console& console) {
  const auto begun = std::chrono::steady_clock::now();
  const Options& options = asked.options;
  const bool leads = world == nullptr || world->rank() == 0;
  std::optional<files::Descriptor> held;
  Plan plan;
  if (leads) {
    auto locked = lock(*options.out);
    if (!locked) return {told(locked.error(), console)};
    held = std::move(*locked);
    auto planned = begin(work, *options.out);
    if (!planned) return {told(planned.error(), console)};
    plan = std::move(*planned);
  }
  const std::string shards = shards_of_sweep(*options.out);
  Ended ended;
  if (world == nullptr) {
    ended = run_alone(work, plan, shards, static_cast<int>(processes_of(options)), console);
  } else {
    const std::int64_t done_before = plan.done_before;
    plan = plan_of_bytes(world->broadcast(bytes_of(plan)));
    plan.done_before = done_before;
    ended = run_ranked(work, plan, shards, *world, console);
  }
  // The first tells for all.
  Status status = Status::done;
  if (leads) {
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begun;
    status = conclude(asked, plan, ended, wall.count(), console);
  }
  if (world != nullptr) world->broadcast({});
  return {status, true};
}

Ending sweep_archive(const Asked& asked, World* world, console::Console& console) {
  const Options& options = asked.options;
  const auto setup = archive_of(options, console);
  if (!setup) return {told(setup.error(), console)};
  auto programs = survey_all(*setup, processes_of(options), world);
  if (!programs) return {told(programs.error(), console)};
  Archive work(*setup, std::move(*programs));
  return perform(work, asked, world, console);
}

Status print_model(const Options& options, console::Console& console) {
  const auto table = model_table(*options.out, options.model, options.model_tasks);
  return table ? write_output(console, *table) : told(table.error(), console);
}

Ending sweep_cases(const Asked& asked, World* world, console::Console& console) {
  const Options& options = asked.options;
  Campaign work({options.seed, options.first, options.random, *options.out + "/counterexamples"});
  return perform(work, asked, world, console);
}

}  // namespace

Status sweep(const Options& options, const Output& output, console::Console& console) {
  const Asked asked{options, output};
  if (!options.model.empty()) return print_model(options, console);
  if (options.merges) return conclude(asked, {}, {}, 0, console);
  const auto world = load_world();
  if (!world) return told(world.error(), console);
  const Ending ending =
      options.random > 0 ? sweep_cases(asked, *world, console) : sweep_archive(asked, *world, console);
  if (*world != nullptr && !ending.is_common) (*world)->abort(static_cast<int>(ending.status));
  return ending.status;
}

}  // namespace leadscrew::sweep
