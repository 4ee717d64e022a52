#include <cerrno>
#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/cli/canon.hpp>
#include <leadscrew/cli/check.hpp>
#include <leadscrew/cli/command.hpp>
#include <leadscrew/cli/design.hpp>
#include <leadscrew/cli/drive.hpp>
#include <leadscrew/cli/language.hpp>
#include <leadscrew/cli/measure.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/cli/pulse.hpp>
#include <leadscrew/cli/run.hpp>
#include <leadscrew/cli/simulate.hpp>
#include <leadscrew/cli/study.hpp>
#include <leadscrew/cli/verify.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/results/program_json.hpp>
#include <leadscrew/results/simulation.hpp>

namespace leadscrew::cli {

namespace {

/// A file that is opened must not become standard output because that was closed: reading from and writing to what
/// stands in its place fail.
void occupy_standard_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) != -1 || errno != EBADF) continue;
    // open() takes the lowest free number, which is this one.
    static_cast<void>(::open("/dev/null", descriptor == STDOUT_FILENO ? O_RDONLY : O_WRONLY));
  }
}

Status answer(const Answer& answer) {
  Console console(ColorChoice::automatic, true);
  if (answer.status == Status::done) return write_output(console, answer.text);
  console.error_text(answer.text);
  return answer.status;
}

std::string_view schema_of(Arguments::Verb command) {
  switch (command) {
    case Arguments::Verb::run:
      return results::run_schema;
    case Arguments::Verb::check:
      return results::check_schema;
    case Arguments::Verb::verify:
      return results::verify_schema;
    case Arguments::Verb::measure:
      return results::measure_schema;
    case Arguments::Verb::simulate:
      return results::simulate_schema;
    case Arguments::Verb::drive:
      return results::drive_schema;
    case Arguments::Verb::pulse:
    case Arguments::Verb::study:
    case Arguments::Verb::design:
    case Arguments::Verb::explain:
    case Arguments::Verb::format:
    case Arguments::Verb::surfaces:
    case Arguments::Verb::canon:
      break;  // no result of a program in JSON
  }
  return results::run_schema;
}

/// No machine, no tools: nothing is known of any program. A usage error leaves standard output empty.
Status end_without_job(const Arguments& arguments, const DiagnosticLog& log, Console& console) {
  if (!arguments.json || log.status() == Status::usage || log.status() == Status::interrupted) return log.status();
  std::vector<json::Json> objects;
  for (const std::string& program : arguments.programs) {
    objects.push_back(results::json_of_rejected(schema_of(arguments.verb), program, {}, log.all()));
  }
  return worse(log.status(), write_output(console, results::json_text(results::runs_schema, std::move(objects))));
}

Status perform(const Arguments& arguments) {
  Console console(arguments.color, arguments.quiet);
  if (arguments.verb == Arguments::Verb::pulse) return pulse(arguments, console);
  if (arguments.verb == Arguments::Verb::study) return study(arguments, console);
  if (arguments.verb == Arguments::Verb::design) return design(arguments, console);
  if (arguments.verb == Arguments::Verb::explain) return explain(arguments, console);
  if (arguments.verb == Arguments::Verb::format) return format(arguments, console);
  if (arguments.verb == Arguments::Verb::surfaces) return surfaces(arguments, console);
  DiagnosticLog log(console);
  const auto job = prepare_job(arguments, log);
  if (!job) return end_without_job(arguments, log, console);
  switch (arguments.verb) {
    case Arguments::Verb::run:
      return run(*job, console);
    case Arguments::Verb::check:
      return check(*job, console);
    case Arguments::Verb::canon:
      return canon(*job, console);
    case Arguments::Verb::verify:
      return verify(*job, console);
    case Arguments::Verb::measure:
      return measure(*job, console);
    case Arguments::Verb::simulate:
      return simulate(*job, console);
    case Arguments::Verb::drive:
      return drive(job_of(*job, arguments.programs.front()), console);
    case Arguments::Verb::pulse:
    case Arguments::Verb::study:
    case Arguments::Verb::design:
    case Arguments::Verb::explain:
    case Arguments::Verb::format:
    case Arguments::Verb::surfaces:
      break;
  }
  return Status::usage;
}

}  // namespace

int command(int count, const char* const* values) {
  occupy_standard_descriptors();
  files::watch_signals();
  const auto parsed = parse_arguments(count, values);
  const auto* arguments = std::get_if<Arguments>(&parsed);
  return static_cast<int>(arguments != nullptr ? perform(*arguments) : answer(std::get<Answer>(parsed)));
}

}  // namespace leadscrew::cli
