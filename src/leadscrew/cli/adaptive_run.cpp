#include <algorithm>
#include <cmath>
#include <leadscrew/cli/adaptive_run.hpp>
#include <leadscrew/files/interrupt.hpp>

namespace leadscrew::cli {

namespace {

constexpr double least_change = 0.005;   // of the override's mean: less is not worth planning anew
constexpr double greatest_change = 0.1;  // of the override itself, that waits for its mean
constexpr double mean_over = 0.1;        // s
constexpr double slice = 0.02;           // s, until which a change takes effect

/// Of a program, mm/s; 0 where all is rapid.
double greatest_feed(const files::InputFile& file, const Job& job) {
  gcode::Reader reader = silent_reader(file, job);
  gcode::Move move;
  double greatest = 0;
  while (reader.next(move)) greatest = std::max(greatest, pipeline::programmed_feed(move));
  return greatest;
}

}  // namespace

AdaptiveRun::AdaptiveRun(const files::InputFile& file, const Job& job)
    : file_(file),
      job_(job),
      reader_(silent_reader(file, job)),
      programmed_([this](gcode::Move& move) { return reader_.next(move); }) {}

base::Result<std::unique_ptr<AdaptiveRun>> AdaptiveRun::create(const files::InputFile& file, const Job& job,
                                                               pipeline::Program& program) {
  std::unique_ptr<AdaptiveRun> run(new AdaptiveRun(file, job));
  const auto& asked = job.arguments.simulate.adaptive;
  if (!asked) return run;
  servo::AdaptiveCutOptions options = asked->cut;
  options.milling.noise = 0;
  const auto mill = servo::MillingForce::create(options.milling);
  if (!mill) return base::failure(mill.error());
  const servo::Engagement first{options.depths.front().depth, options.width};
  options.limit = run->limit_ = asked->limit ? *asked->limit : mill->mean(greatest_feed(file, job), first);
  if (!(options.limit > 0)) {
    return base::failure({base::Severity::error,
                          "usage",
                          "nothing cuts where the program begins",
                          "tell the limit by --force-limit",
                          {},
                          {}});
  }
  options.milling.noise = asked->noise * options.limit;
  run->noise_ = asked->noise;
  auto cut = servo::AdaptiveCut::create(options, job.machine.period.seconds());
  if (!cut) return base::failure(cut.error());
  run->cut_ = std::move(*cut);
  program.slice(slice);
  return run;
}

void AdaptiveRun::follow(const servo::Followed& followed, double measured_feed, pipeline::Program& program) {
  if (!cut_) return;
  const double programmed = programmed_.at(followed.word.line);
  const double wanted = cut_->follow(measured_feed, programmed, followed.word.path_length);
  mean_ += (wanted - mean_) * std::min(1.0, job_.machine.period.seconds() / mean_over);
  const bool has_failed = cut_->control().failure() != servo::SensorFailure::none;
  const double at_once = std::clamp(noise_, least_change, greatest_change);
  if (has_failed || std::fabs(wanted - told_) >= at_once * told_) mean_ = wanted;
  if (has_failed ? mean_ == told_ : std::fabs(mean_ - told_) < least_change * told_) return;
  told_ = mean_;
  program.override_feed(told_);
}

base::Result<std::optional<results::AdaptiveFigures>> AdaptiveRun::conclude() const {
  if (!cut_) return std::optional<results::AdaptiveFigures>();
  const double safe = job_.arguments.simulate.adaptive->cut.safe;
  const auto time = time_at(safe);
  if (!time) return base::failure(time.error());
  return std::optional(
      results::AdaptiveFigures{cut_->figures(), limit_, cut_->turn(), safe, cut_->control().failure(), *time});
}

base::Result<double> AdaptiveRun::time_at(double factor) const {
  pipeline::Program program(file_.source(), job_.machine, job_.tools, job_.reader_options(file_), nullptr);
  program.watch([this] { return file_.unchanged(); });
  program.stop_when(files::interrupted);
  program.override_feed(factor);
  while (program.prepare()) {
    const base::Word word = program.cycle();
    if (base::count(word.tick) % words_between_checks == 0 && files::interrupted())
      return base::failure(files::interruption());
  }
  if (program.failure()) return base::failure(*program.failure());
  return program.summary().time_s;
}

}  // namespace leadscrew::cli
