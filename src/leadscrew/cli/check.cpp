#include <leadscrew/cli/program_verbs.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/results/gouging.hpp>
#include <leadscrew/results/messages.hpp>
#include <leadscrew/results/program_json.hpp>
#include <leadscrew/results/program_text.hpp>
#include <memory>

namespace leadscrew::cli {

namespace {

ProgramResult check_program(const std::string& program, const Job& job, Console& console) {
  DiagnosticLog log(console);
  const auto file = open_program(program);
  if (!file) {
    log.add(file.error());
    return rejected(results::check_schema, program, job, log);
  }
  // For JSON as in a run; for a glance, at the pace of reading.
  std::unique_ptr<pipeline::Survey> survey;
  if (job.arguments.json) {
    survey = std::make_unique<pipeline::PathSurvey>(job.machine, job.start);
  } else {
    survey = std::make_unique<pipeline::QuickSurvey>(job.machine, job.start);
  }
  results::Messages messages([&](const std::string& text) {
    if (!job.arguments.quiet) console.error_text(text);
  });
  const Reading reading = read_program(*file, job, console, log, survey.get(), messages.sink());
  results::CheckFigures figures{
      .blocks = reading.blocks, .moves = reading.moves, .messages = messages.kept(), .message_count = messages.count()};
  if (log.errors() == 0) {
    survey->finish();
    figures.extents = results::extents_of(job.machine, survey->least(), survey->greatest());
    figures.bound_s = survey->bound_seconds();
  }
  if (job.arguments.gouge && log.errors() == 0) {
    figures.gouging = gouging_of(*file, job);
    for (const auto& problem : results::gouging_diagnostics(*figures.gouging, file->name())) log.add(problem);
    if (files::interrupted()) log.add(files::interruption());
  }
  return {log.status(), results::json_of_check(file->name(), job.machine, figures, log.all()),
          results::check_summary(file->name(), figures, log.all(), console.output_style())};
}

}  // namespace

Status check(const Job& job, Console& console) {
  return for_each_program(job, console, check_program);
}

}  // namespace leadscrew::cli
