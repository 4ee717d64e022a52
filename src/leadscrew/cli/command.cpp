#include <algorithm>
#include <array>
#include <cerrno>
#include <leadscrew/cli/arguments.hpp>
#include <leadscrew/cli/command.hpp>
#include <leadscrew/cli/design.hpp>
#include <leadscrew/cli/drive.hpp>
#include <leadscrew/cli/language.hpp>
#include <leadscrew/cli/program_verbs.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/cli/pulse.hpp>
#include <leadscrew/cli/run.hpp>
#include <leadscrew/cli/simulate.hpp>
#include <leadscrew/cli/study.hpp>
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

/// What a verb does: with programs on a machine, or alone.
struct Work {
  Arguments::Verb verb;
  Status (*alone)(const Arguments&, Console&);
  Status (*with_programs)(const Job&, Console&) = nullptr;
  std::string_view schema = results::run_schema;  ///< of a program's result
};

using Verb = Arguments::Verb;

Status sweep_tasks(const Arguments& arguments, Console& console) {
  return sweep::sweep(arguments.sweep, {arguments.json, arguments.quiet}, console);
}

constexpr std::array<Work, 15> works = {{{Verb::run, nullptr, run, results::run_schema},
                                         {Verb::check, nullptr, check, results::check_schema},
                                         {Verb::verify, nullptr, verify, results::verify_schema},
                                         {Verb::measure, nullptr, measure, results::measure_schema},
                                         {Verb::canon, nullptr, canon},
                                         {Verb::simulate, nullptr, simulate, results::simulate_schema},
                                         {Verb::drive, nullptr, drive, results::drive_schema},
                                         {Verb::pulse, pulse},
                                         {Verb::study, study},
                                         {Verb::design, design},
                                         {Verb::explain, explain},
                                         {Verb::format, format},
                                         {Verb::surfaces, surfaces},
                                         {Verb::serve, serve},
                                         {Verb::sweep, sweep_tasks}}};

/// No machine, no tools: nothing is known of any program. A usage error leaves standard output empty.
Status end_without_job(const Arguments& arguments, std::string_view schema, const DiagnosticLog& log,
                       Console& console) {
  if (!arguments.json || log.status() == Status::usage || log.status() == Status::interrupted) return log.status();
  std::vector<json::Json> objects;
  for (const std::string& program : arguments.programs) {
    objects.push_back(results::json_of_rejected(schema, program, {}, log.all()));
  }
  return worse(log.status(), write_output(console, results::json_text(results::runs_schema, std::move(objects))));
}

Status perform(const Arguments& arguments) {
  Console console(arguments.color, arguments.quiet);
  const Work& work = *std::ranges::find(works, arguments.verb, &Work::verb);
  if (work.alone != nullptr) return work.alone(arguments, console);
  DiagnosticLog log(console);
  const auto job = prepare_job(arguments, log);
  return job ? work.with_programs(*job, console) : end_without_job(arguments, work.schema, log, console);
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
