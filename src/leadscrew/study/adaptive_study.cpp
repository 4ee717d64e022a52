#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/servo/adaptive_cut.hpp>
#include <leadscrew/servo/machine_loops.hpp>
#include <leadscrew/servo/pulse_loop.hpp>
#include <leadscrew/servo/tracking.hpp>
#include <leadscrew/stepping/nc_program.hpp>
#include <leadscrew/study/studies.hpp>
#include <optional>
#include <string>

// A slot of 40 mm in steel, which is twice as deep over its middle part, milled with adaptive control: by the planner's
// feed override, and by the adaptive-control input of Koren's NC program, whose steps drive a pulse-driven axis. Feed
// is what the tachogenerator tells.

namespace leadscrew::study {

namespace {

constexpr double feed = 10, way = 40, period = 1e-3;  // mm/s, mm, s
constexpr double depth = 2, width = 4, safe = 0.5;    // mm, mm, override
constexpr double deep_from = 12, deep_to = 24;        // mm
constexpr double fails_at = 0.9;                      // s
constexpr std::int64_t most_periods = 60'000;

struct Moved {
  double feed = 0;  ///< mm/s
  double way = 0;   ///< mm
};

/// Words of the planner, and slides that follow them.
class PlannedCut {
 public:
  explicit PlannedCut(double factor)
      : program_(gcode::text_source(text_), machine_, tools_, {}, nullptr),
        servo_(servo::Servo::create(servo::loops_of(machine_), machine_.period)),
        tracking_(machine_.axis_set()) {
    program_.slice(0.02);
    program_.override_feed(factor);
  }
  PlannedCut(const PlannedCut&) = delete;
  PlannedCut& operator=(const PlannedCut&) = delete;

  /// A period on; nothing at the end.
  std::optional<Moved> next() {
    if (!servo_ || !program_.prepare()) return std::nullopt;
    const auto followed = servo_->follow(program_.cycle());
    if (!followed) return Moved{};
    tracking_.observe(*followed);
    return Moved{tracking_.measured_feed(), followed->position[0]};
  }
  void override_feed(double factor) { program_.override_feed(factor); }

 private:
  std::string text_ = "G21 G90 G94\nG1 X40 F600\nM2\n";
  machine::Machine machine_ = machine::mill3();
  machine::ToolTable tools_;
  pipeline::Program program_;
  base::Result<servo::Servo> servo_;
  servo::Tracking tracking_;
};

/// Pulses of the NC program, and an axis that they drive.
class PulsedCut {
 public:
  explicit PulsedCut(double factor)
      : program_({}, [this] { return std::exchange(block_, std::nullopt); }),
        loop_(servo::PulseLoop::create(
            {.converter = 10.0 / 256, .amplifier = 4, .motor = 0.96, .holes = 200, .time_constant = 0.01})) {
    override_feed(factor);
    if (loop_) loop_->load(pulses);
  }
  PulsedCut(const PulsedCut&) = delete;
  PulsedCut& operator=(const PulsedCut&) = delete;

  std::optional<Moved> next() {
    if (!loop_ || program_.done()) return std::nullopt;
    for (int k = 0; k < interrupts; ++k) {
      const int step = program_.interrupt().step[0];
      if (step != 0) loop_->pulse(step);
      loop_->run_through(period / interrupts);
    }
    return Moved{loop_->velocity() * blu, loop_->position() * blu};
  }
  void override_feed(double factor) {
    program_.override_feed(static_cast<int>(std::lround(factor * stepping::full_override)));
  }

 private:
  static constexpr double blu = 0.01;                       // mm
  static constexpr std::int64_t pulses = 4000, word = 600;  // f/q0 = 600/3000 of 5000 interrupts/s: 10 mm/s
  static constexpr int interrupts = 5;                      // a period

  static stepping::Block slot() {
    stepping::Block block;
    block.way[0] = block.commands = block.capacity = pulses;
    block.feed_word = word;
    block.greatest_word = 2 * word;
    return block;
  }

  std::optional<stepping::Block> block_ = slot();
  stepping::NcProgram program_;
  base::Result<servo::PulseLoop> loop_;
};

servo::AdaptiveCutOptions options_with(double noise, std::optional<servo::SensorFault> fault) {
  servo::AdaptiveCutOptions options;
  options.milling.cutting_coefficient = 2000;
  options.width = width;
  options.depths = {{0, depth}, {deep_from, 2 * depth}, {deep_to, depth}};
  const auto mill = servo::MillingForce::create(options.milling);
  options.limit = mill ? mill->mean(feed, {depth, width}) : 1;
  options.milling.noise = noise * options.limit;
  options.safe = safe;
  options.fault = fault;
  return options;
}

struct Milled {
  double time = 0;   ///< s
  double limit = 0;  ///< N
  servo::CutFigures cut;
  servo::SensorFailure failure = servo::SensorFailure::none;
  double swing = 0;       ///< of the override, last third of every depth, share of its greatest
  double feed_after = 0;  ///< mm/s, mean over the deep part's last third
  double override_after = 0;
};

/// The last third of a part of the slot.
bool is_settled(double at) {
  const auto within = [&](double from, double to) { return at > to - (to - from) / 3 && at < to - 0.2; };
  return within(0, deep_from) || within(deep_from, deep_to) || within(deep_to, way - 1);
}

template <class Cut>
base::Result<Milled> milled(const servo::AdaptiveCutOptions& options) {
  auto control = servo::AdaptiveCut::create(options, period);
  if (!control) return base::failure(control.error());
  Cut cut(1);
  Milled milled;
  milled.limit = options.limit;
  double least = 2, most = 0, feed_sum = 0;
  std::int64_t periods = 0, settled = 0;
  for (auto moved = cut.next(); moved && periods < most_periods; moved = cut.next(), ++periods) {
    const double factor = control->follow(moved->feed, feed, moved->way);
    cut.override_feed(factor);
    if (!is_settled(moved->way)) {
      least = 2;
      most = 0;
      continue;
    }
    least = std::min(least, factor);
    most = std::max(most, factor);
    milled.swing = std::max(milled.swing, (most - least) / most);
    if (moved->way < deep_from || moved->way > deep_to) continue;
    feed_sum += moved->feed;
    ++settled;
    milled.override_after = factor;
  }
  milled.time = static_cast<double>(periods) * period;
  milled.feed_after = feed_sum / static_cast<double>(std::max<std::int64_t>(1, settled));
  milled.cut = control->figures();
  milled.failure = control->control().failure();
  return milled;
}

template <class Cut>
double time_at(double factor) {
  Cut cut(factor);
  std::int64_t periods = 0;
  while (cut.next() && periods < most_periods) ++periods;
  return static_cast<double>(periods) * period;
}

template <class Cut>
Rows failing_rows() {
  Rows rows;
  for (const servo::SensorFailure kind :
       {servo::SensorFailure::not_a_number, servo::SensorFailure::stuck, servo::SensorFailure::silent}) {
    const std::string name = "sensor " + std::string(servo::name(kind)) + ": ";
    const auto outcome = milled<Cut>(options_with(0.05, servo::SensorFault{kind, fails_at}));
    if (!outcome || outcome->failure != kind) {
      rows.push_back(not_run_row(name + "feed", outcome ? "the failure was not seen" : outcome.error().message));
      continue;
    }
    const double taken = outcome->cut.failed_at.value_or(1e9) - fails_at;
    rows.push_back(limit_row(name + "not believed after", {"ms", 0}, 20, taken * 1000, 1));
    rows.push_back(exact_row(name + "override from there", {"", 2}, safe, outcome->override_after));
    rows.push_back(reproduced_row(name + "feed from there", {"mm/s", 2}, safe * feed, outcome->feed_after, 0.02));
  }
  return rows;
}

template <class Cut>
Rows rows_of(const std::string& group) {
  const auto noisy = milled<Cut>(options_with(0.05, {})), quiet = milled<Cut>(options_with(1e-7, {}));
  if (!noisy || !quiet) return under(group, {not_run_row("force", (noisy ? quiet : noisy).error().message)});
  const double safe_time = time_at<Cut>(safe);
  Rows rows = {
      because(limit_row("force beyond 1.25 limits at a stretch", {"ms", 0}, 150, noisy->cut.longest_excess * 1000),
              "mean over a turn; 150 ms or two turns of 20 ms, whichever is longer"),
      measured_row("greatest mean force over a turn", {"% of the limit", 0},
                   noisy->cut.greatest_mean / noisy->limit * 100),
      because(limit_row("swing of the override once it is settled", {"%", 2}, 2, quiet->swing * 100),
              "without noise: no limit cycle"),
      because(limit_row("time", {"s", 2}, safe_time, noisy->time), "beside the constant safe feed"),
      measured_row("time saved", {"%", 1}, (1 - noisy->time / safe_time) * 100)};
  append(rows, failing_rows<Cut>());
  return under(group, std::move(rows));
}

}  // namespace

Rows adaptive_rows(const Host&) {
  Rows rows = rows_of<PlannedCut>("override of the planner, 10 mm/s, depths 2, 4 and 2 mm");
  append(rows, rows_of<PulsedCut>("override of the NC program, 10 mm/s, depths 2, 4 and 2 mm"));
  return rows;
}

}  // namespace leadscrew::study
