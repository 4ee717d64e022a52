#include <fmt/format.h>

#include <atomic>
#include <filesystem>
#include <leadscrew/cli/curve_program.hpp>
#include <leadscrew/cli/job.hpp>
#include <leadscrew/config/machine_file.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/gcode/frame.hpp>
#include <leadscrew/gcode/parameter_file.hpp>
#include <leadscrew/gcode/tool_table.hpp>
#include <leadscrew/language/lint.hpp>
#include <leadscrew/realtime/passes_ahead.hpp>
#include <leadscrew/realtime/stop_watch.hpp>
#include <leadscrew/results/figures.hpp>
#include <leadscrew/results/trace_period.hpp>

namespace leadscrew::cli {

namespace {

constexpr std::string_view built_in = "mill3";
constexpr std::int64_t largest_tool_table = 16 << 20;
constexpr std::int64_t largest_parameter_file = 1 << 20;

/// Adds its text to what was read. Empty where the log says why.
std::optional<std::string> read_text(const std::string& path, std::int64_t largest, std::string_view hint,
                                     std::string& read, DiagnosticLog& log) {
  auto text = files::read_whole(path, largest);
  if (text) {
    read += *text;
    return std::move(*text);
  }
  if (text.error().code == "io-open" && text.error().hint.empty()) text.error().hint = hint;
  log.add(text.error());
  return std::nullopt;
}

machine::Machine read_machine_file(const std::string& path, std::string& read, DiagnosticLog& log) {
  const auto text = read_text(path, config::largest_machine_file, "give a machine file; built in is mill3", read, log);
  if (!text) return {};
  auto machine = config::read_machine(*text, path);
  if (machine) return std::move(*machine);
  for (const base::Diagnostic& problem : machine.error()) log.add(problem);
  return {};
}

machine::ToolTable read_tools(const std::string& path, std::string& read, DiagnosticLog& log) {
  const auto text = read_text(path, largest_tool_table, {}, read, log);
  if (!text) return {};
  const gcode::ToolTableText tools = gcode::read_tool_table(*text, path);
  for (const base::Diagnostic& problem : tools.diagnostics) log.add(problem);
  return tools.table;
}

/// None where there is no such file yet.
std::vector<gcode::NumberedValue> read_parameters(const std::string& path, std::string& read, DiagnosticLog& log) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    log.add({base::Severity::note,
             "new-parameters",
             "there is no parameter file yet: all begin at 0",
             "run and drive make it",
             {.file = path},
             {}});
    return {};
  }
  const auto text = read_text(path, largest_parameter_file, {}, read, log);
  if (!text) return {};
  gcode::ParameterFileText parameters = gcode::read_parameter_file(*text, path);
  for (const base::Diagnostic& problem : parameters.diagnostics) log.add(problem);
  return std::move(parameters.values);
}

void log_usage(DiagnosticLog& log, std::string message, std::string hint) {
  log.add({base::Severity::error, "usage", std::move(message), std::move(hint), {}, {}});
}

std::string axis_letters(const machine::Machine& machine) {
  std::string letters;
  for (const base::Axis axis : base::all_axes) {
    if (machine.has(axis)) letters += fmt::format("{}{}", letters.empty() ? "" : " ", base::letter(axis));
  }
  return letters;
}

void take_start(const AxisValue& given, Job& job, DiagnosticLog& log) {
  const auto [axis, value] = given;
  const char letter = base::letter(axis);
  if (!job.machine.has(axis)) {
    return log_usage(log,
                     fmt::format("--start {}{}: machine {} has no axis {}", letter, value, job.machine.name, letter),
                     fmt::format("it has {}", axis_letters(job.machine)));
  }
  const machine::AxisLimits& limits = job.machine.limits(axis);
  if (value < limits.travel_min || value > limits.travel_max) {
    return log_usage(log, fmt::format("--start {}{}: outside the travel of axis {}", letter, value, letter),
                     fmt::format("from {} to {}", limits.travel_min, limits.travel_max));
  }
  job.start[base::index(axis)] = value;
}

void take_step_times(const RunArguments& run, machine::Machine& machine) {
  for (std::size_t k = 0; k < run.step_times.size(); ++k) {
    if (!run.step_times[k]) continue;
    for (auto& axis : machine.axes) {
      if (axis) axis->step_times.*machine::all_step_times[k].value = *run.step_times[k];
    }
  }
}

}  // namespace

gcode::ReaderOptions Job::reader_options() const {
  gcode::ReaderOptions options;
  options.start = start;
  options.dialect = machine.dialect;
  options.path_mode = arguments.mode;
  options.tolerance = arguments.tolerance;
  options.fuel = arguments.fuel.value_or(options.fuel);
  options.parameters = parameters;
  options.warns_of_unset = arguments.lint;
  options.surface_drafts = surface_drafts;
  options.allows_gouging = arguments.gouge || arguments.allow_gouge;
  return options;
}

gcode::ReaderOptions Job::reader_options(const files::InputFile& file) const {
  gcode::ReaderOptions options = reader_options();
  options.file = file.name();
  options.opener = file.opener(arguments.subprograms);
  return options;
}

std::optional<Job> prepare_job(const Arguments& arguments, DiagnosticLog& log) {
  Job job{arguments, machine::mill3(), {}, {}, {}, 0, 0};
  if (arguments.machine && *arguments.machine != built_in) {
    job.machine = read_machine_file(*arguments.machine, job.text, log);
  }
  job.machine_end = job.text.size();
  if (arguments.tools) job.tools = read_tools(*arguments.tools, job.text, log);
  job.tools_end = job.text.size();
  if (arguments.parameters) job.parameters = read_parameters(*arguments.parameters, job.text, log);
  if (log.errors() > 0) return std::nullopt;
  if (arguments.period) job.machine.period = *arguments.period;
  if (arguments.smoothing) job.machine.smoothing = *arguments.smoothing;
  if (arguments.dialect) job.machine.dialect = *arguments.dialect;
  take_step_times(arguments.run, job.machine);
  for (const AxisValue& value : arguments.start) take_start(value, job, log);
  if (log.errors() > 0) return std::nullopt;
  return job;
}

Job job_of(const Job& job, const std::string& program) {
  Job of_program = job;
  of_program.surface_drafts = gcode::new_surface_drafts();
  if (!is_curve(program)) return of_program;
  if (const auto curve = curve_program(program)) of_program.start = curve->start;
  return of_program;
}

base::Result<files::InputFile> open_program(const std::string& program) {
  if (!is_curve(program)) return files::InputFile::open(program);
  const auto curve = curve_program(program);
  if (!curve) return base::failure({base::Severity::error, "usage", curve.error(), {}, {}, {}});
  return files::InputFile::of_text(curve->text, program);
}

Reading read_program(const files::InputFile& file, const Job& job, Console& console, DiagnosticLog& log,
                     pipeline::Survey* survey, gcode::RemarkSink remarks) {
  if (results::is_trace(file, job.machine.axis_set())) {
    log.add({base::Severity::error,
             "not-a-program",
             "is a trace, not a part program",
             "leadscrew verify TRACE PROGRAM judges one",
             {.file = file.name()},
             {}});
    return {};
  }
  const double begin = realtime::SystemClocks::processor_seconds();
  Progress progress{.work = "reading", .total = file.size()};
  console.begin_progress();
  gcode::ReaderOptions options = job.reader_options(file);
  options.remarks = std::move(remarks);
  std::atomic<double> makers = 0;  // s of the processor
  options.pass_source = [&](surfaces::Passes& passes) { return realtime::passes_ahead(passes, makers); };
  gcode::Reader reader(file.source(&progress.bytes), job.machine, job.tools, std::move(options),
                       [&](const base::Diagnostic& problem) { log.add(problem); });
  std::optional<language::Lint> lint;
  if (job.arguments.lint) lint.emplace(job.machine, job.arguments.stock_top);
  const auto check = [&](const gcode::Move& move) {
    for (base::Diagnostic& found : lint->see(move, reader.frame(), reader.modal())) reader.warn(move, std::move(found));
  };
  const auto goes_on = [&] {
    if (!files::interrupted()) console.progress(progress);
    return !files::interrupted();  // a block may repeat itself for ever
  };
  Reading reading{pipeline::read_whole(reader, {.survey = survey,
                                                .is_sound = [&] { return log.errors() == 0; },
                                                .see = lint ? decltype(pipeline::ReadingWatch::see)(check) : nullptr,
                                                // a survey may make the tool path as well
                                                .moves_between_questions = survey != nullptr ? 64 : 4096,
                                                .goes_on = goes_on})};
  console.clear_progress();
  if (reader.source_failure()) log.add(*reader.source_failure());
  if (files::interrupted() && !reader.source_failure()) log.add(files::interruption());
  reading.seconds = realtime::SystemClocks::processor_seconds() - begin + makers;
  return reading;
}

gouging::GougeVerdict gouging_of(const files::InputFile& file, const Job& job) {
  const double tolerance = job.arguments.gouge_tolerance.value_or(job.machine.tolerance);
  return gouging::check_gouging([&] { return silent_reader(file, job); }, job.machine, job.tools,
                                {tolerance, files::interrupted});
}

gcode::Reader silent_reader(const files::InputFile& file, const Job& job) {
  return gcode::Reader(file.source(), job.machine, job.tools, job.reader_options(file), nullptr);
}

}  // namespace leadscrew::cli
