#include <fmt/format.h>

#include <cmath>
#include <leadscrew/cli/outputs.hpp>
#include <leadscrew/cli/program_verbs.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/referee/referee.hpp>
#include <leadscrew/report/traced_words.hpp>
#include <leadscrew/results/program_json.hpp>
#include <leadscrew/results/program_text.hpp>
#include <leadscrew/results/trace_period.hpp>
#include <leadscrew/trace/trace_reader.hpp>

namespace leadscrew::cli {

namespace {

constexpr std::int64_t rows_between_checks = 1024;

class Verification {
 public:
  Verification(const Job& job, Console& console, DiagnosticLog& log) : job_(job), console_(console), log_(log) {}

  /// Empty where the log says why.
  std::optional<results::VerifyFigures> execute(const std::string& trace, const std::string& program) {
    const auto trace_file = files::InputFile::open(trace, "trace-changed");
    if (!trace_file) log_.add(trace_file.error());
    const auto program_file = open_program(program);
    if (!program_file) log_.add(program_file.error());
    if (log_.errors() > 0) return std::nullopt;
    if (results::is_trace(*program_file, job_.machine.axis_set()) &&
        !results::is_trace(*trace_file, job_.machine.axis_set())) {
      log_.add(base::problem("usage", fmt::format("{} is the trace, {} is not: the two are swapped", program, trace),
                             fmt::format("leadscrew verify {} {}", program, trace)));
      return std::nullopt;
    }
    read_program(*program_file, job_, console_, log_);
    if (log_.errors() > 0) return std::nullopt;
    const OutputPaths paths = output_paths(job_.arguments, program);
    if (auto sound = check_paths(paths, *program_file, job_.arguments); !sound) {
      log_.add(sound.error());
      return std::nullopt;
    }
    auto figures = judge(*trace_file, *program_file, paths);
    console_.clear_progress();
    if (figures) return std::move(*figures);
    log_.add(figures.error());
    return std::nullopt;
  }

 private:
  base::Result<results::VerifyFigures> judge(const files::InputFile& trace, const files::InputFile& program,
                                             const OutputPaths& paths) {
    const auto period = job_.arguments.period
                            ? base::Result<base::Period>(*job_.arguments.period)
                            : results::trace_period(trace, job_.machine.axis_set(), job_.machine.period);
    if (!period) return base::failure(period.error());
    job_.machine.period = *period;
    auto outputs = Outputs::open(paths, job_);
    if (!outputs) return base::failure(outputs.error());
    results::VerifyFigures figures{trace.name(), *period, {}};
    if (auto judged = judge_rows(trace, program, figures, *outputs); !judged) return base::failure(judged.error());
    if (auto same = trace.unchanged(); !same) return base::failure(same.error());
    if (auto done = outputs->conclude(program, log_, figures); !done) return base::failure(done.error());
    return figures;
  }

  /// Verdict and length.
  base::Result<void> judge_rows(const files::InputFile& trace, const files::InputFile& program,
                                results::VerifyFigures& figures, Outputs& outputs) {
    Progress progress{.work = "judging", .total = trace.size()};
    auto rows = trace::TraceReader::open(trace.source(&progress.bytes), trace.name(), job_.machine.axis_set());
    if (!rows) return base::failure(rows.error());
    note_absent_axes(rows->axes(), trace.name());
    gcode::Reader reader = silent_reader(program, job_);
    referee::Referee referee([&](gcode::Move& move) { return reader.next(move); }, job_.machine, job_.machine.period,
                             files::interrupted);
    words_.emplace(job_.machine.period);
    console_.begin_progress();
    while (true) {
      const auto row = rows->next();
      if (!row) return base::failure(row.error());
      if (!*row) break;
      const base::AxisVector position = completed((*row)->position, rows->axes());
      referee.observe(position, (*row)->feed);
      if (auto shown = show(position, (*row)->line, referee.matched(), outputs); !shown) return shown;
      if (++progress.words % rows_between_checks != 0) continue;
      if (files::interrupted()) return base::failure(files::interruption());
      progress.motion_seconds = static_cast<double>(progress.words) * job_.machine.period.seconds();
      console_.progress(progress);
    }
    figures.verdict = referee.conclude();
    figures.length_mm = words_->length();
    if (files::interrupted()) return base::failure(files::interruption());
    if (reader.source_failure()) return base::failure(*reader.source_failure());
    return {};
  }

  /// Where a page or a picture was asked for. A block is the trace's own, or the one that the row was matched to.
  base::Result<void> show(const base::AxisVector& position, std::optional<std::int64_t> line,
                          const referee::MatchedBlock& block, Outputs& outputs) {
    outputs.hold(block.tool);
    const base::Word word = words_->next(position, line ? base::Line{*line} : block.line);
    if (feed_ != block.feed) {
      const double told = std::isinf(block.feed) ? 0 : block.feed;
      outputs.write({{base::Event::Kind::programmed_feed, told, word.line, 0, false}, word.tick, word.path_length});
      feed_ = block.feed;
    }
    return outputs.write(word);
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
      if (!job_.machine.has(axis) || given.contains(axis)) continue;
      log_.add({base::Severity::note,
                "trace-axis",
                fmt::format("no column {}", base::letter(axis)),
                "taken to stand still where the program begins, which --start says",
                {.file = trace},
                {}});
    }
  }

  Job job_;  ///< with the trace's period
  Console& console_;
  DiagnosticLog& log_;
  std::optional<report::TracedWords> words_;
  double feed_ = -1;  ///< of the last row's block
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
  return for_each_program(job, console, verify_program);
}

}  // namespace leadscrew::cli
