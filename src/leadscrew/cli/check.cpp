#include <leadscrew/cli/check.hpp>
#include <leadscrew/cli/json_form.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/cli/summary_text.hpp>

namespace leadscrew::cli {

namespace {

ProgramResult check_program(const std::string& program, const Job& job, Console& console) {
  DiagnosticLog log(console);
  const auto file = open_program(program);
  if (!file) {
    log.add(file.error());
    return {log.status(), json_of_rejected(check_schema, program, job.machine.name, log), {}};
  }
  const Reading reading = read_program(*file, job, console, log);
  return {log.status(), json_of_check(file->name(), job, reading, log),
          check_summary(file->name(), reading, log, console.output_style())};
}

}  // namespace

Status check(const Job& job, Console& console) {
  return for_each_program(job, console, check_schema, check_program);
}

}  // namespace leadscrew::cli
