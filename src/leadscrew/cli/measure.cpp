#include <leadscrew/cli/outputs.hpp>
#include <leadscrew/cli/program_verbs.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/results/measured.hpp>
#include <leadscrew/results/measured_trace.hpp>

namespace leadscrew::cli {

namespace {

/// Empty where the log says why.
std::optional<ProgramResult> measured_program(const std::string& program, const Job& job, Console& console,
                                              DiagnosticLog& log) {
  const auto refuse = [&](const base::Diagnostic& problem) {
    log.add(problem);
    return std::nullopt;
  };
  const auto trace_file = files::InputFile::open(job.arguments.judged_trace, "trace-changed");
  if (!trace_file) return refuse(trace_file.error());
  const auto program_file = open_program(program);
  if (!program_file) return refuse(program_file.error());
  read_program(*program_file, job, console, log);
  if (log.errors() > 0) return std::nullopt;
  const results::MeasureQuestion& question = job.arguments.measure;
  std::vector<std::string> written;
  for (const auto& path : {question.map, question.picture}) {
    if (path) written.push_back(*path);
  }
  if (auto sound = check_written(written, *program_file, job.arguments); !sound) return refuse(sound.error());
  auto tools = results::surfaces_of(silent_reader(*program_file, job), job.tools, program_file->name());
  if (!tools) return refuse(tools.error());
  if (const auto warning = results::warning_of(*tools, program_file->name())) log.add(*warning);
  measuring::TraceMeasurement measured(std::move(*tools), job.machine, job.start, results::options_of(question));
  Progress progress{.work = "measuring", .total = trace_file->size()};
  console.begin_progress();
  const auto read = results::read_trace(*trace_file, measured, [&](std::int64_t rows, std::int64_t bytes) {
    progress.words = rows, progress.bytes = bytes;
    console.progress(progress);
  });
  console.clear_progress();
  if (!read) return refuse(read.error());
  results::MeasureFigures figures{trace_file->name(), &measured, question.allowed_cut.value_or(job.machine.tolerance),
                                  question.allowed_ridge};
  auto files = results::write_measured(question, figures, shown_name(program));
  if (!files) return refuse(files.error());
  figures.files = std::move(*files);
  return ProgramResult{figures.kept() ? Status::done : Status::not_kept,
                       results::json_of_measure(shown_name(program), job.machine, figures, log.all()),
                       results::measure_summary(shown_name(program), job.machine, figures, console.output_style())};
}

ProgramResult measure_program(const std::string& program, const Job& job, Console& console) {
  DiagnosticLog log(console);
  auto result = measured_program(program, job, console, log);
  return result ? std::move(*result) : rejected(results::measure_schema, shown_name(program), job, log);
}

}  // namespace

Status measure(const Job& job, Console& console) {
  return for_each_program(job, console, measure_program);
}

}  // namespace leadscrew::cli
