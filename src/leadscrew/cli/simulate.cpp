#include <fmt/format.h>

#include <algorithm>
#include <leadscrew/cli/adaptive_run.hpp>
#include <leadscrew/cli/outputs.hpp>
#include <leadscrew/cli/programs.hpp>
#include <leadscrew/cli/simulate.hpp>
#include <leadscrew/drive/slides.hpp>
#include <leadscrew/files/interrupt.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/pipeline/programmed_feed.hpp>
#include <leadscrew/results/simulation.hpp>

namespace leadscrew::cli {

namespace {

class Simulation {
 public:
  Simulation(const Job& job, Console& console, DiagnosticLog& log) : job_(job), console_(console), log_(log) {}

  /// Empty where the log says why.
  std::optional<results::SimulateFigures> execute(const std::string& program) {
    const auto file = open_program(program);
    if (!file) return failed(file.error());
    const OutputPaths paths = output_paths(job_.arguments, program);
    if (auto sound = check_paths(paths, *file, job_.arguments); !sound) return failed(sound.error());
    read_program(*file, job_, console_, log_);
    if (log_.errors() > 0) return std::nullopt;
    auto figures = move(*file, paths);
    console_.clear_progress();
    if (!figures) return failed(figures.error());
    return std::move(*figures);
  }

 private:
  std::nullopt_t failed(const base::Diagnostic& problem) {
    log_.add(problem);
    return std::nullopt;
  }

  base::Result<results::SimulateFigures> move(const files::InputFile& file, const OutputPaths& paths) {
    auto outputs = Outputs::open(paths, job_);
    if (!outputs) return base::failure(outputs.error());
    auto figures = follow_words(file, *outputs);
    if (!figures) return figures;
    if (outputs->shown().followed() != nullptr)
      results::observe_ideal_path(silent_reader(file, job_), job_.machine, job_.start, *outputs->shown().followed());
    if (auto done = outputs->conclude(file, log_, *figures); !done) return base::failure(done.error());
    return figures;
  }

  base::Result<results::SimulateFigures> follow_words(const files::InputFile& file, Outputs& outputs) {
    Progress progress{.work = "moving", .total = file.size()};
    pipeline::Program program(file.source(&progress.bytes), job_.machine, job_.tools, job_.reader_options(file),
                              nullptr);
    program.watch([&] { return file.unchanged(); });
    program.stop_when(files::interrupted);
    if (job_.machine.rotary_chain) program.tell_tool();
    if (outputs.shown().recording() != nullptr) program.tell_feed();
    gcode::Reader reader = silent_reader(file, job_);
    const drive::LoopKind kind = job_.arguments.simulate.pulses ? drive::LoopKind::pulses : drive::LoopKind::words;
    auto slides = drive::Slides::create(job_.machine, kind, [&](gcode::Move& move) { return reader.next(move); });
    if (!slides) return base::failure(slides.error());
    program.on_event([&](const base::PassedEvent& event) {
      outputs.write(event);
      slides->observe(event);
    });
    auto adaptive = AdaptiveRun::create(file, job_, program);
    if (!adaptive) return base::failure(adaptive.error());
    base::Word word;
    console_.begin_progress();
    while (program.prepare()) {
      word = program.cycle();
      const auto followed = follow(word, *slides, outputs);
      if (!followed) return base::failure(followed.error());
      if (*followed) (*adaptive)->follow(**followed, slides->measured_feed(), program);
      if (base::count(word.tick) % words_between_checks != 0) continue;
      if (files::interrupted()) return base::failure(files::interruption());
      progress.words = base::count(word.tick);
      progress.motion_seconds = base::seconds(word.tick, job_.machine.period);
      console_.progress(progress);
    }
    if (program.failure()) return base::failure(*program.failure());
    if (const auto warning = program.warning()) log_.add(*warning);
    if (auto done = come_to_rest(word, *slides, outputs); !done) return base::failure(done.error());
    record(slides->finish_contour(), *slides, outputs);
    results::SimulateFigures figures{slides->conclude()};
    if (reader.source_failure()) return base::failure(*reader.source_failure());
    figures.summary = program.summary();
    figures.tolerance = std::max(figures.summary.tolerance_mm, job_.machine.tolerance);
    auto of_cut = (*adaptive)->conclude();
    if (!of_cut) return base::failure(of_cut.error());
    figures.adaptive = *of_cut;
    if (figures.adaptive) {
      warn_of_sensor(*figures.adaptive);
      warn_of_force(*figures.adaptive);
    }
    return figures;
  }

  base::Result<std::optional<servo::Followed>> follow(const base::Word& word, drive::Slides& slides, Outputs& outputs) {
    auto followed = slides.follow(word);
    if (!followed) return followed;
    if (!*followed) return followed;
    const auto written = outputs.write(**followed, slides.measured_feed());
    if (!written) return base::failure(written.error());
    record(slides.take_contour(), slides, outputs);
    return followed;
  }

  static void record(const std::vector<servo::Contour>& contours, const drive::Slides& slides, Outputs& outputs) {
    if (outputs.shown().followed() == nullptr) return;
    for (const servo::Contour& contour : contours) {
      outputs.shown().followed()->observe({contour.actual, contour.nearest, contour.distance}, slides.contour_stride());
    }
  }

  /// Of a sensor that is no longer believed.
  void warn_of_sensor(const results::AdaptiveFigures& adaptive) {
    if (!adaptive.cut.failed_at) return;
    log_.add(
        {base::Severity::warning,
         "force-sensor",
         fmt::format("the sensor of the force failed ({}): not believed from t = {:.3f} s on, the feed is {:g} times "
                     "the programmed one from there",
                     servo::name(adaptive.failure), *adaptive.cut.failed_at, adaptive.safe),
         "no limit of the force is held without it: choose a --safe-factor that the cut bears",
         {},
         {}});
  }

  /// Of a limit that no override there is keeps.
  void warn_of_force(const results::AdaptiveFigures& adaptive) {
    if (adaptive.cut.unreachable <= 2 * adaptive.turn) return;
    log_.add(
        {base::Severity::warning,
         "force-limit",
         fmt::format("not even the least feed override, {:.0f} %, keeps the force at {:.4g} N: for {:.3g} s in all",
                     servo::AdaptiveFeedOptions{}.least * 100, adaptive.limit, adaptive.cut.unreachable),
         "raise --force-limit, program a lower feed or take less --depth or --width",
         {},
         {}});
  }

  /// Repeats the last word until the slides stand.
  base::Result<void> come_to_rest(base::Word word, drive::Slides& slides, Outputs& outputs) {
    word.speed = word.feed = 0;
    word.state = base::MotionState::rest;
    slides.end_words();
    while (!slides.has_ended()) {
      word.tick = base::next(word.tick);
      if (auto done = follow(word, slides, outputs); !done) return base::failure(done.error());
      if (base::count(word.tick) % words_between_checks == 0 && files::interrupted())
        return base::failure(files::interruption());
    }
    return {};
  }

  const Job& job_;
  Console& console_;
  DiagnosticLog& log_;
};

ProgramResult simulate_program(const std::string& program, const Job& job, Console& console) {
  DiagnosticLog log(console);
  const std::string name = shown_name(program);
  const auto figures = Simulation(job, console, log).execute(program);
  if (!figures) return rejected(results::simulate_schema, name, job, log);
  return {figures->kept() ? Status::done : Status::not_kept,
          results::json_of_simulation(name, job.machine, *figures, log.all()),
          results::simulate_summary(name, job.machine, *figures, console.output_style())};
}

}  // namespace

Status simulate(const Job& given, Console& console) {
  Job job = given;
  job.arguments.simulate.put_into(job.machine);
  return for_each_program(job, console, simulate_program);
}

}  // namespace leadscrew::cli
