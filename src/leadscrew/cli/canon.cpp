#include <leadscrew/cli/program_verbs.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/gcode/canon.hpp>

namespace leadscrew::cli {

namespace {

constexpr std::size_t bytes_at_a_time = std::size_t{64} * 1024;
constexpr std::int64_t moves_between_looks = 4096;

/// Prints as it reads, up to the first error; reads on, to find the others.
Status print_calls(const files::InputFile& file, const Job& job, Console& console, DiagnosticLog& log) {
  gcode::ReaderOptions options = job.reader_options(file);
  options.probing = gcode::ProbingMoves::programmed;
  gcode::Reader reader(file.source(), job.machine, job.tools, options,
                       [&](const base::Diagnostic& problem) { log.add(problem); });
  gcode::CanonWriter writer(job.machine.axis_set());
  std::string text;
  writer.begin(text);
  Status written = Status::done;
  gcode::Move move;
  for (std::int64_t count = 1; reader.next(move) && written == Status::done; ++count) {
    if (count % moves_between_looks == 0 && files::interrupted()) break;
    if (log.errors() > 0) continue;
    writer.write(move, reader.frame(), reader.system(), reader.modal(), text);
    if (text.size() < bytes_at_a_time) continue;
    written = write_output(console, text);
    text.clear();
  }
  if (written == Status::done) written = write_output(console, text);
  if (reader.source_failure()) log.add(*reader.source_failure());
  if (files::interrupted() && !reader.source_failure()) log.add(files::interruption());
  return written;
}

ProgramResult canon_of_program(const std::string& program, const Job& job, Console& console) {
  DiagnosticLog log(console);
  const auto file = open_program(program);
  if (!file) {
    log.add(file.error());
    return {log.status(), {}, {}};
  }
  const Status written = print_calls(*file, job, console, log);
  return {worse(log.status(), written), {}, {}};
}

}  // namespace

Status canon(const Job& job, Console& console) {
  return for_each_program(job, console, canon_of_program);
}

}  // namespace leadscrew::cli
