#include <fmt/format.h>

#include <leadscrew/cli/measure.hpp>
#include <leadscrew/cli/outputs.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/results/measured.hpp>

namespace leadscrew::cli {

namespace {

base::Diagnostic of_file(base::Diagnostic problem, const std::string& file) {
  if (problem.place.file.empty()) problem.place.file = file;
  return problem;
}

base::Result<measuring::ProgramTools> surfaces_of(const files::InputFile& program, const Job& job) {
  measuring::ProgramTools tools(job.tools);
  gcode::Reader reader = silent_reader(program, job);
  gcode::Move move;
  for (std::int64_t count = 0; reader.next(move); ++count) {
    tools.see(move, reader);
    if (count % words_between_checks == 0 && files::interrupted()) return base::failure(files::interruption());
  }
  if (!tools.surfaces().empty()) return tools;
  return base::failure(
      of_file(base::problem("measure-nothing", "machines no surface", "G6.4 defines a surface, G6.5 machines it"),
              program.name()));
}

base::Result<void> read_trace(const files::InputFile& trace, const Job& job, measuring::TraceMeasurement& measured,
                              Console& console) {
  Progress progress{.work = "measuring", .total = trace.size()};
  console.begin_progress();
  const auto open = [&] {
    return trace::TraceReader::open(trace.source(&progress.bytes), trace.name(), job.machine.axis_set());
  };
  auto read = measured.measure(open, [&](std::int64_t rows) -> base::Result<void> {
    if (files::interrupted()) return base::failure(files::interruption());
    progress.words = rows;
    console.progress(progress);
    return {};
  });
  console.clear_progress();
  if (read) return trace.unchanged();
  return base::failure(of_file(read.error(), trace.name()));
}

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
  auto tools = surfaces_of(*program_file, job);
  if (!tools) return refuse(tools.error());
  if (tools->left_out() > 0) {
    log.add(of_file({base::Severity::warning,
                     "measure-surfaces",
                     fmt::format("machines {} surfaces more than are measured", tools->left_out()),
                     fmt::format("the first {} are", measuring::ProgramTools::most_surfaces),
                     {},
                     {}},
                    program_file->name()));
  }
  measuring::MeasureOptions options{.reach = question.reach};
  if (question.places) options.most_places = static_cast<std::size_t>(*question.places);
  measuring::TraceMeasurement measured(std::move(*tools), job.machine, job.start, options);
  if (auto read = read_trace(*trace_file, job, measured, console); !read) return refuse(read.error());
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
