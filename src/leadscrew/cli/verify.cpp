#include <fmt/format.h>

#include <leadscrew/cli/programs.hpp>
#include <leadscrew/cli/trace_period.hpp>
#include <leadscrew/cli/verify.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/referee/referee.hpp>
#include <leadscrew/results/program_json.hpp>
#include <leadscrew/results/program_text.hpp>
#include <leadscrew/trace/trace_reader.hpp>

namespace leadscrew::cli {

namespace {

constexpr std::int64_t rows_between_checks = 1024;

class Verification {
 public:
  Verification(const Job& job, Console& console, DiagnosticLog& log)
      : job_(job), machine_(job.machine), console_(console), log_(log) {}

  /// Empty where the log says why.
  std::optional<results::VerifyFigures> execute(const std::string& trace, const std::string& program) {
    const auto trace_file = files::InputFile::open(trace, "trace-changed");
    if (!trace_file) log_.add(trace_file.error());
    const auto program_file = open_program(program);
    if (!program_file) log_.add(program_file.error());
    if (log_.errors() > 0) return std::nullopt;
    if (is_trace(*program_file, machine_.axis_set()) && !is_trace(*trace_file, machine_.axis_set())) {
      log_.add(base::problem("usage", fmt::format("{} is the trace, {} is not: the two are swapped", program, trace),
                             fmt::format("leadscrew verify {} {}", program, trace)));
      return std::nullopt;
    }
    read_program(*program_file, job_, console_, log_);
    if (log_.errors() > 0) return std::nullopt;
    auto figures = judge(*trace_file, *program_file);
    console_.clear_progress();
    if (figures) return std::move(*figures);
    log_.add(figures.error());
    return std::nullopt;
  }

 private:
  base::Result<results::VerifyFigures> judge(const files::InputFile& trace, const files::InputFile& program) {
    const auto period = job_.arguments.period ? base::Result<base::Period>(*job_.arguments.period)
                                              : trace_period(trace, machine_.axis_set(), machine_.period);
    if (!period) return base::failure(period.error());
    machine_.period = *period;
    auto verdict = verdict_on(trace, program);
    if (!verdict) return base::failure(verdict.error());
    for (const files::InputFile* file : {&trace, &program}) {
      if (auto same = file->unchanged(); !same) return base::failure(same.error());
    }
    return results::VerifyFigures{trace.name(), *period, std::move(*verdict)};
  }

  base::Result<referee::Verdict> verdict_on(const files::InputFile& trace, const files::InputFile& program) {
    Progress progress{.work = "judging", .total = trace.size()};
    auto rows = trace::TraceReader::open(trace.source(&progress.bytes), trace.name(), machine_.axis_set());
    if (!rows) return base::failure(rows.error());
    note_absent_axes(rows->axes(), trace.name());
    gcode::Reader reader = silent_reader(program, job_);
    referee::Referee referee([&](gcode::Move& move) { return reader.next(move); }, machine_, machine_.period,
                             files::interrupted);
    console_.begin_progress();
    while (true) {
      const auto row = rows->next();
      if (!row) return base::failure(row.error());
      if (!*row) break;
      referee.observe(completed((*row)->position, rows->axes()));
      if (++progress.words % rows_between_checks != 0) continue;
      if (files::interrupted()) return base::failure(files::interruption());
      progress.motion_seconds = static_cast<double>(progress.words) * machine_.period.seconds();
      console_.progress(progress);
    }
    referee::Verdict verdict = referee.conclude();
    if (files::interrupted()) return base::failure(files::interruption());
    if (reader.source_failure()) return base::failure(*reader.source_failure());
    return verdict;
  }

  /// Axes without a column stand where the program begins.
  base::AxisVector completed(base::AxisVector position, base::AxisSet given) const {
    for (const base::Axis axis : base::all_axes) {
      if (!given.contains(axis)) position[base::index(axis)] = job_.start[base::index(axis)];
    }
    return position;
  }

  void note_absent_axes(base::AxisSet given, const std::string& trace) {
    for (const base::Axis axis : base::all_axes) {
      if (!machine_.has(axis) || given.contains(axis)) continue;
      log_.add({base::Severity::note,
                "trace-axis",
                fmt::format("no column {}", base::letter(axis)),
                "taken to stand still where the program begins, which --start says",
                {.file = trace},
                {}});
    }
  }

  const Job& job_;
  machine::Machine machine_;  ///< with the trace's period
  Console& console_;
  DiagnosticLog& log_;
};

/// Whoever brings another controller's trace may have meant other limits than those it was judged by.
void tell_measures(const results::VerifyFigures& figures, const Job& job, DiagnosticLog& log) {
  log.add({base::Severity::note,
           "judged-by",
           fmt::format("judged by machine {}, a period of {:g} ms and a tolerance of {:g} mm", job.machine.name,
                       figures.period.seconds() * 1e3, figures.verdict.tolerance_mm),
           "--machine FILE, --period TIME, --mode MODE and --tolerance MM judge by others",
           {.file = shown_name(job.arguments.judged_trace)},
           {}});
}

ProgramResult verify_program(const std::string& program, const Job& job, Console& console) {
  DiagnosticLog log(console);
  const std::string name = shown_name(program);
  const auto figures = Verification(job, console, log).execute(job.arguments.judged_trace, program);
  if (!figures) return rejected(results::verify_schema, name, job, log);
  if (figures->verdict.objects()) tell_measures(*figures, job, log);
  return {figures->verdict.objects() ? Status::not_kept : Status::done,
          results::json_of_verify(name, job.machine, *figures, log.all()),
          results::verify_summary(name, job.machine, *figures, console.output_style())};
}

}  // namespace

Status verify(const Job& job, Console& console) {
  return for_each_program(job, console, results::verify_schema, verify_program);
}

}  // namespace leadscrew::cli
