#include <algorithm>
#include <cmath>
#include <leadscrew/study/motion.hpp>
#include <utility>

namespace leadscrew::study {

namespace {

gcode::ReaderOptions options_of(const PartProgram& program) {
  gcode::ReaderOptions options;
  options.file = "study";
  options.start = program.start;
  return options;
}

/// Reads the program whole, as whoever moves a machine must before moving it.
base::Result<void> check(const PartProgram& program, const machine::Machine& machine) {
  std::optional<base::Diagnostic> first;
  gcode::Reader reader(gcode::text_source(program.text), machine, program.tools, options_of(program),
                       [&](const base::Diagnostic& diagnostic) {
                         if (!first && diagnostic.severity == base::Severity::error) first = diagnostic;
                       });
  gcode::Move move;
  while (reader.next(move)) {
  }
  if (first) return base::failure(*first);
  return {};
}

/// Runs the work; adds what it took to `total` and returns that too.
template <class Work>
double timed(const std::function<double()>& clock, double& total, Work&& work) {
  const double begin = clock ? clock() : 0;
  work();
  const double taken = clock ? clock() - begin : 0;
  total += taken;
  return taken;
}

/// The rooms from text to motion, each call of the path's and the planner's room timed.
class TimedPlanning {
 public:
  TimedPlanning(const PartProgram& program, const machine::Machine& machine, const Host& host)
      : host_(host),
        reader_(gcode::text_source(program.text), machine, program.tools, options_of(program), nullptr),
        builder_(machine),
        planner_(machine, program.start) {}

  std::vector<planner::Chunk> chunks() {
    gcode::Move move;
    while (reader_.next(move)) {
      timed(host_.thread_cpu_seconds, cpu_.path, [&] { builder_.push(move); });
      take_path();
    }
    timed(host_.thread_cpu_seconds, cpu_.path, [&] { builder_.finish(); });
    take_path();
    planning([&] { planner_.finish(); });
    take_motion();
    return std::move(chunks_);
  }

  const PlanningTime& cpu() const { return cpu_; }

 private:
  template <class Work>
  void planning(Work&& work) {
    cpu_.longest_plan = std::max(cpu_.longest_plan, timed(host_.thread_cpu_seconds, cpu_.plan, work));
  }

  void take_path() {
    std::optional<toolpath::Element> element;
    const auto pop = [&] { element = builder_.pop(); };
    for (timed(host_.thread_cpu_seconds, cpu_.path, pop); element; timed(host_.thread_cpu_seconds, cpu_.path, pop)) {
      planning([&] { planner_.push(*element); });
      take_motion();
    }
  }

  void take_motion() {
    std::optional<planner::Chunk> chunk;
    const auto pop = [&] { chunk = planner_.pop(); };
    for (planning(pop); chunk; planning(pop)) chunks_.push_back(std::move(*chunk));
  }

  const Host& host_;
  gcode::Reader reader_;
  toolpath::Builder builder_;
  planner::Planner planner_;
  std::vector<planner::Chunk> chunks_;
  PlanningTime cpu_;
};

/// The value that `part` (0 … 1) of the values do not exceed.
double percentile(std::vector<double>& values, double part) {
  if (values.empty()) return 0;
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(part * static_cast<double>(values.size()))) - 1;
  const auto at = values.begin() + std::max<std::ptrdiff_t>(rank, 0);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

CycleTime cycle_time(const std::vector<planner::Chunk>& chunks, base::Period period, const base::AxisVector& start,
                     const Host& host) {
  interpolator::Interpolator interpolator(period, start);
  std::vector<double> nanoseconds;
  double total = 0;
  for (const planner::Chunk& chunk : chunks) {
    // A chunk shorter than what is left of the period has no word of its own.
    interpolator.load(chunk);
    while (!interpolator.wants_chunk())
      nanoseconds.push_back(1e9 * timed(host.wall_seconds, total, [&] { interpolator.next(); }));
  }
  return {percentile(nanoseconds, 0.5), percentile(nanoseconds, 0.999), percentile(nanoseconds, 1)};
}

}  // namespace

machine::Machine machine_with(const LimitSet& limits, base::Period period) {
  machine::Machine machine = machine::mill3();
  machine.period = period;
  for (std::optional<machine::AxisLimits>& axis : machine.axes) {
    if (!axis) continue;
    axis->velocity = limits.velocity;
    axis->acceleration = limits.acceleration;
    axis->jerk = limits.jerk;
  }
  return machine;
}

base::Result<Planned> plan(const PartProgram& program, const machine::Machine& machine, const Host& host) {
  if (auto sound = check(program, machine); !sound) return base::failure(sound.error());
  TimedPlanning planning(program, machine, host);
  const std::vector<planner::Chunk> chunks = planning.chunks();
  Planned planned;
  for (const planner::Chunk& chunk : chunks) planned.seconds += chunk.duration.value();
  planned.cpu = planning.cpu();
  planned.cycle = cycle_time(chunks, machine.period, program.start, host);
  return planned;
}

base::Result<Judged> judge(const PartProgram& program, const machine::Machine& machine) {
  if (auto sound = check(program, machine); !sound) return base::failure(sound.error());
  gcode::Reader reader(gcode::text_source(program.text), machine, program.tools, options_of(program), nullptr);
  referee::Referee referee([&](gcode::Move& move) { return reader.next(move); }, machine, machine.period);
  pipeline::Program motion(gcode::text_source(program.text), machine, program.tools, options_of(program), nullptr);
  while (motion.prepare()) referee.observe(motion.cycle().position);
  return Judged{motion.summary(), referee.conclude()};
}

machine::Derivatives largest(const constraints::LimitRatios& ratios) {
  return ratios.by_derivative();
}

machine::Derivatives largest(const std::vector<referee::AxisVerdict>& axes) {
  machine::Derivatives most;
  for (const referee::AxisVerdict& axis : axes)
    most = greater(most, {axis.velocity_ratio, axis.acceleration_ratio, axis.jerk_ratio});
  return most;
}

}  // namespace leadscrew::study
