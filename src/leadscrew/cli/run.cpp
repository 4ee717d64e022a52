#include <algorithm>
#include <array>
#include <leadscrew/cli/outputs.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/cli/run.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/realtime/stop_watch.hpp>
#include <leadscrew/referee/referee.hpp>
#include <leadscrew/results/program_json.hpp>
#include <leadscrew/results/program_text.hpp>
#include <leadscrew/results/remark_output.hpp>
#include <span>

namespace leadscrew::cli {

namespace {

class ProgramRun {
 public:
  ProgramRun(const std::string& program, const Job& job, Console& console, DiagnosticLog& log)
      : program_(program), job_(job), console_(console), log_(log) {}

  /// Empty where the log says why.
  std::optional<results::RunFigures> execute() {
    const auto file = open_program(program_);
    if (!file) return failed(file.error());
    const OutputPaths paths = output_paths(job_.arguments, program_);
    if (auto sound = check_paths(paths, *file, job_.arguments); !sound) return failed(sound.error());
    const Reading reading = read_program(*file, job_, console_, log_);
    if (log_.status() <= Status::rejected) check_steps(*file, job_, log_);
    if (log_.errors() > 0) return std::nullopt;
    auto figures = move(*file, paths, reading);
    console_.clear_progress();
    if (!figures) return failed(figures.error());
    return std::move(*figures);
  }

 private:
  std::nullopt_t failed(const base::Diagnostic& problem) {
    log_.add(problem);
    return std::nullopt;
  }

  base::Result<results::RunFigures> move(const files::InputFile& file, const OutputPaths& paths,
                                         const Reading& reading) {
    auto outputs = Outputs::open(paths, job_);
    if (!outputs) return base::failure(outputs.error());
    results::RemarkOutput remarks(
        program_, [&](const std::string& path) { return is_in_use(path, program_, paths, job_.arguments); },
        [this](const std::string& text) { console_.error_text(text); });
    auto figures = make_words(file, *outputs, remarks, reading);
    if (!figures) return figures;
    if (auto written = outputs->finish_steps(file); !written) return base::failure(written.error());
    figures->steps = outputs->step_figures();
    if (job_.arguments.allow_gouge && outputs->shown().recording() != nullptr)
      figures->gouging = gouging_of(file, job_);
    if (auto done = outputs->conclude(file, log_, *figures); !done) return base::failure(done.error());
    auto logs = remarks.publish();
    if (!logs) return base::failure(logs.error());
    figures->files.insert(figures->files.end(), logs->begin(), logs->end());
    if (job_.arguments.parameters && parameters_) {
      const auto written = results::write_parameters(*job_.arguments.parameters, *parameters_);
      if (!written) return base::failure(written.error());
    }
    return figures;
  }

  base::Result<results::RunFigures> make_words(const files::InputFile& file, Outputs& outputs,
                                               results::RemarkOutput& remarks, const Reading& reading) {
    Progress progress{.work = "moving", .total = file.size()};
    gcode::ReaderOptions options = job_.reader_options(file);
    options.remarks = remarks.sink();
    options.parameters_at_end = [this](const auto& values) { parameters_ = values; };
    pipeline::Program program(file.source(&progress.bytes), job_.machine, job_.tools, options, nullptr);
    program.watch([&] { return file.unchanged(); });
    program.stop_when(files::interrupted);
    program.on_event([&](const base::PassedEvent& event) { outputs.write(event); });
    const bool is_shown = outputs.shown().recording() != nullptr;
    if (job_.machine.rotary_chain || is_shown) program.tell_tool();
    if (is_shown) program.tell_feed();
    if (auto opened = outputs.open_blocks(file); !opened) return base::failure(opened.error());
    pipeline::LostTime lost(job_.machine, outputs.blocks());
    program.on_move([&](const gcode::Move& move) {
      if (lost.observe(move)) outputs.shown().expect(program.machined());
    });
    program.step_by(job_.arguments.run.interpolator);
    gcode::Reader reader = silent_reader(file, job_);
    referee::Referee referee([&](gcode::Move& move) { return reader.next(move); }, job_.machine, job_.machine.period,
                             files::interrupted);
    realtime::StopWatch<> watch;
    console_.begin_progress();
    while (watch.prepare(program.will_plan(), [&] { return program.prepare(); })) {
      for (const base::Word& word : next_words(program, watch)) {
        referee.observe(word.position, word.feed);
        lost.observe(word);
        if (is_shown) outputs.shown().judge(referee.matched());
        if (auto written = outputs.write(word); !written) return base::failure(written.error());
        if (base::count(word.tick) % words_between_checks != 0) continue;
        if (files::interrupted()) return base::failure(files::interruption());
        progress.words = base::count(word.tick);
        progress.motion_seconds = base::seconds(word.tick, job_.machine.period);
        console_.progress(progress);
      }
    }
    if (program.failure()) return base::failure(*program.failure());
    if (const auto warning = program.warning()) log_.add(*warning);
    lost.finish();
    referee::Verdict verdict = referee.conclude();
    if (files::interrupted()) return base::failure(files::interruption());
    if (reader.source_failure()) return base::failure(*reader.source_failure());
    return results::RunFigures{program.summary(),
                               std::move(verdict),
                               {reading.seconds, watch.preparing(), watch.cycling(), watch.samples()},
                               lost.by_cause(),
                               results::extents_of(job_.machine, lost.least_position(), lost.greatest_position())};
  }

  /// Many together, but for those that are timed one by one.
  std::span<const base::Word> next_words(pipeline::Program& program, realtime::StopWatch<>& watch) {
    const std::size_t most = std::min(watch.words_until_sample(), words_.size());
    if (most > 0) return watch.many([&] { return program.cycle(std::span(words_).first(most)); });
    words_[0] = watch.cycle([&] { return program.cycle(); });
    return std::span(words_).first(1);
  }

  std::string program_;
  const Job& job_;
  Console& console_;
  DiagnosticLog& log_;
  std::optional<std::vector<gcode::NumberedValue>> parameters_;  // where the program ended
  std::array<base::Word, 64> words_;
};

ProgramResult run_program(const std::string& program, const Job& job, Console& console) {
  DiagnosticLog log(console);
  const std::string name = shown_name(program);
  const auto figures = ProgramRun(program, job, console, log).execute();
  if (!figures) return rejected(results::run_schema, name, job, log);
  return {figures->kept() ? Status::done : Status::not_kept,
          results::json_of_run(name, job.machine, *figures, log.all()),
          results::run_summary(name, job.machine, *figures, console.output_style())};
}

}  // namespace

Status run(const Job& job, Console& console) {
  return for_each_program(job, console, run_program);
}

}  // namespace leadscrew::cli
