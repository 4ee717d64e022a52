#include <leadscrew/cli/check.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/results/program_json.hpp>
#include <leadscrew/results/program_text.hpp>

namespace leadscrew::cli {

namespace {

ProgramResult check_program(const std::string& program, const Job& job, Console& console) {
  DiagnosticLog log(console);
  const auto file = open_program(program);
  if (!file) {
    log.add(file.error());
    return rejected(results::check_schema, program, job, log);
  }
  pipeline::PathSurvey survey(job.machine, job.start);
  const Reading reading = read_program(*file, job, console, log, &survey);
  results::CheckFigures figures{reading.blocks, reading.moves};
  if (log.errors() == 0) {
    survey.finish();
    figures.extents = results::extents_of(job.machine, survey.least(), survey.greatest());
    figures.bound_s = survey.bound_seconds();
  }
  return {log.status(), results::json_of_check(file->name(), job.machine, figures, log.all()),
          results::check_summary(file->name(), figures, log.all(), console.output_style())};
}

}  // namespace

Status check(const Job& job, Console& console) {
  return for_each_program(job, console, check_program);
}

}  // namespace leadscrew::cli
