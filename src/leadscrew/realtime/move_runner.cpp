#include <leadscrew/realtime/move_runner.hpp>
#include <leadscrew/realtime/schedule.hpp>
#include <utility>

namespace leadscrew::realtime {

namespace {

constexpr double short_slice = 0.02;  // s, where the feeder asks for no other

RunnerOptions at_period(RunnerOptions options, base::Period period) {
  options.period = period;
  return options;
}

}  // namespace

MoveRunner::MoveRunner(machine::Machine machine, RunnerOptions options, WordSink sink)
    : machine_(std::move(machine)),
      moves_(machine_, options.position),
      source_([this](gcode::Move& move) { return give(move); }, machine_, options.position),
      runner_(at_period(options, machine_.period),
              {.next = [this] { return source_.next(); },
               .refuse = [this] { source_.planner().refuse(); },
               .override_feed = [this](double factor) { source_.planner().override_feed(factor); },
               .slice = [this](double seconds) { source_.planner().slice(seconds); },
               .drought = [this] { return drought(); },
               .end_for_now = [this] { end_for_now(); }},
              std::move(sink)) {
  source_.planner().slice(short_slice);
}

base::Result<void> MoveRunner::smooth(double tolerance) {
  const std::lock_guard lock(mutex_);
  return moves_.smooth(tolerance);
}

base::Result<void> MoveRunner::push(gcode::Move move) {
  const std::lock_guard lock(mutex_);
  auto pushed = moves_.push(std::move(move));
  if (pushed) {
    last_came_ = now();
    is_open_ = true;
  }
  return pushed;
}

void MoveRunner::finish() {
  const std::lock_guard lock(mutex_);
  moves_.finish();
}

pipeline::Supply MoveRunner::give(gcode::Move& move) {
  const std::lock_guard lock(mutex_);
  return moves_.give(move);
}

std::optional<Drought> MoveRunner::drought() {
  if (!source_.wants_moves()) return std::nullopt;
  const std::lock_guard lock(mutex_);
  return Drought{is_open_, 1e-9 * static_cast<double>(now() - last_came_)};
}

void MoveRunner::end_for_now() {
  const std::lock_guard lock(mutex_);
  moves_.end_for_now();
  is_open_ = false;
}

}  // namespace leadscrew::realtime
