#include <algorithm>
#include <leadscrew/base/number_text.hpp>
#include <leadscrew/steps/step_generator.hpp>
#include <string>

namespace leadscrew::steps {

namespace {

constexpr std::int64_t nano = 1'000'000'000;

}  // namespace

base::Result<StepGenerator> StepGenerator::create(const machine::Machine& machine, std::int64_t clock_hz) {
  auto problems = validate(clock_hz, machine);
  if (!problems.empty()) return base::failure(std::move(problems.front()));
  return StepGenerator(machine, clock_hz);
}

StepGenerator::StepGenerator(const machine::Machine& machine, std::int64_t clock_hz) {
  const double period = machine.period.seconds();
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    const std::size_t index = base::index(axis);
    const machine::AxisLimits& limits = machine.limits(axis);
    order_[axes_++] = index;
    steps_[index] = AxisSteps(axis, in_ticks(limits.step_times, clock_hz));
    tracks_[index].blu = limits.blu;
    tracks_[index].sharpest = 2 * limits.acceleration * period * period / limits.blu;
  }
  const std::int64_t scaled = machine.period.nanoseconds * clock_hz;
  ticks_whole_ = scaled / nano;
  ticks_rest_ = scaled % nano;
  ticks_.length = static_cast<double>(scaled) / nano;
}

void StepGenerator::accept(const base::Word& word) {
  const bool first = !last_;
  for (std::size_t k = 0; k < axes_; ++k) {
    Track& track = tracks_[order_[k]];
    track.before = track.now;
    track.now = track.next;
    track.next = word.position[order_[k]] / track.blu;
    if (!first) continue;
    track.before = track.now = track.next;
    steps_[order_[k]].stand(track.next);
  }
  if (first) {
    const std::int64_t tick = base::count(word.tick);
    offset_ = (tick % nano) * ticks_rest_;
    ticks_.base = tick * ticks_whole_ + tick / nano * ticks_rest_ + offset_ / nano;
    offset_ %= nano;
  }
  words_ = std::min<std::int64_t>(words_ + 1, 3);
  last_ = word;
}

/// The period from `before` to `now` of each axis.
void StepGenerator::begin_period() {
  ticks_.offset = static_cast<double>(offset_) / nano;
  for (std::size_t k = 0; k < axes_; ++k) {
    Track& track = tracks_[order_[k]];
    const double displacement = track.now - track.before;
    const double speed = speed_between(displacement, track.next - track.now, track.sharpest);
    steps_[order_[k]].begin({track.before, displacement, track.speed, speed}, ticks_);
    track.speed = speed;
  }
}

void StepGenerator::end_period() {
  for (std::size_t k = 0; k < axes_; ++k) {
    const std::size_t index = order_[k];
    const double error = std::fabs(tracks_[index].now - static_cast<double>(steps_[index].count()));
    if (error <= greatest_error_) continue;
    greatest_error_ = error;
    worst_ = static_cast<base::Axis>(index);
  }
  offset_ += ticks_rest_;
  ticks_.base += ticks_whole_ + offset_ / nano;
  offset_ %= nano;
}

/// Do all steps lead to the last word?
bool StepGenerator::settled() const {
  return std::ranges::all_of(std::span(order_).first(axes_), [&](std::size_t index) {
    return !(std::fabs(tracks_[index].next - static_cast<double>(steps_[index].count())) > 0.5 + 1e-5);
  });
}

/// The known events of all axes until this tick, in order.
std::span<const StepEvent> StepGenerator::merged_until(std::int64_t tick) {
  std::span<const StepEvent> all;
  std::size_t into = 0;
  for (std::size_t k = 0; k < axes_; ++k) {
    AxisSteps& axis = steps_[order_[k]];
    std::span<const StepEvent> run = axis.known();
    if (run.empty()) continue;
    if (run.back().tick() > tick) {
      const auto end = std::ranges::upper_bound(run, tick, {}, &StepEvent::tick);
      run = run.first(static_cast<std::size_t>(end - run.begin()));
    }
    axis.take(run.size());
    if (all.empty()) {
      all = run;
      continue;
    }
    StepEvent* const out = merged_[into].data();
    all = {out, merge(all, run, out)};
    into = 1 - into;
  }
  return all;
}

StepReport StepGenerator::report() const {
  StepReport report;
  for (const AxisSteps& axis : steps_) {
    report.steps += axis.steps();
    report.postponed += axis.postponed();
    report.greatest_delay = std::max(report.greatest_delay, axis.greatest_delay());
  }
  report.greatest_error = greatest_error_;
  report.worst = worst_;
  return report;
}

std::optional<base::Diagnostic> StepGenerator::complaint() const {
  const StepReport made = report();
  if (made.greatest_error < 1) return std::nullopt;
  return base::Diagnostic{base::Severity::error,
                          "step-late",
                          std::string("axis ") + base::letter(made.worst) + " was " +
                              base::rounded_text(made.greatest_error) + " BLU from its words; " +
                              std::to_string(made.postponed) + " steps came later than they were due",
                          "words that keep the machine's greatest velocities",
                          {},
                          {},
                          {.axis = made.worst}};
}

}  // namespace leadscrew::steps
