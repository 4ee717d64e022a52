#include <leadscrew/realtime/move_runner.hpp>
#include <optional>
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
      source_([this](gcode::Move& move) { return moves_.give(move); }, machine_, options.position),
      runner_(at_period(options, machine_.period),
              {.next = [this] { return source_.next(); },
               .refuse = [this] { source_.planner().refuse(); },
               .override_feed = [this](double factor) { source_.planner().override_feed(factor); },
               .slice = [this](double seconds) { source_.planner().slice(seconds); },
               .drought = [this] { return source_.wants_moves() ? std::optional(moves_.drought()) : std::nullopt; },
               .end_for_now = [this] { moves_.end_for_now(); }},
              std::move(sink)) {
  source_.planner().slice(short_slice);
}

}  // namespace leadscrew::realtime
