#include <cmath>
#include <functional>
#include <leadscrew/gcode/reader.hpp>
#include <leadscrew/machine/machine.hpp>
#include <leadscrew/nc/nc_program.hpp>
#include <leadscrew/pipeline/program.hpp>
#include <leadscrew/servo/machine_loops.hpp>
#include <leadscrew/servo/pulse_loop.hpp>
#include <leadscrew/servo/tracking.hpp>
#include <leadscrew/study/adaptive_slot.hpp>
#include <optional>
#include <string>
#include <utility>

namespace leadscrew::study {

namespace {

constexpr std::int64_t most_periods = 60'000;

struct Moved {
  double feed = 0;      ///< mm/s
  double position = 0;  ///< mm
};

/// Words of the planner, and slides that follow them.
class PlannedSlot {
 public:
  explicit PlannedSlot(double length)
      : text_("G21 G90 G94\nG1 X" + std::to_string(length) + " F600\nM2\n"),
        program_(gcode::text_source(text_), machine_, tools_, {}, nullptr),
        servo_(servo::Servo::create(servo::loops_of(machine_), machine_.period)),
        tracking_(machine_.axis_set(), machine_.period) {
    program_.slice(0.02);
  }
  PlannedSlot(const PlannedSlot&) = delete;
  PlannedSlot& operator=(const PlannedSlot&) = delete;

  bool can_move() const { return servo_.has_value() && machine_.period.seconds() == slot_period; }
  /// A period on; nothing at the end.
  std::optional<Moved> next() {
    if (!program_.prepare()) return std::nullopt;
    const auto followed = servo_->follow(program_.cycle());
    if (!followed) return Moved{};
    tracking_.observe(*followed);
    return Moved{tracking_.measured_feed(), followed->position[0]};
  }
  void override_feed(double factor) { program_.override_feed(factor); }

 private:
  std::string text_;
  machine::Machine machine_ = machine::mill3();
  machine::ToolTable tools_;
  pipeline::Program program_;
  base::Result<servo::Servo> servo_;
  servo::Tracking tracking_;
};

/// Steps of the NC program, and an axis that they drive.
class SteppedSlot {
 public:
  explicit SteppedSlot(double length)
      : block_(slot(steps_of(length))),
        program_({}, [this] { return std::exchange(block_, std::nullopt); }),
        loop_(servo::PulseLoop::create(
            {.converter = 10.0 / 256, .amplifier = 4, .motor = 0.96, .holes = 200, .time_constant = 0.01})) {
    if (loop_) loop_->load(steps_of(length));
  }
  SteppedSlot(const SteppedSlot&) = delete;
  SteppedSlot& operator=(const SteppedSlot&) = delete;

  bool can_move() const { return loop_.has_value(); }
  std::optional<Moved> next() {
    if (program_.done()) return std::nullopt;
    for (int k = 0; k < interrupts; ++k) {
      const int step = program_.interrupt().step[0];
      if (step != 0) loop_->pulse(step);
      loop_->run_through(slot_period / interrupts);
    }
    return Moved{loop_->velocity() * blu, loop_->position() * blu};
  }
  void override_feed(double factor) {
    program_.override_feed(static_cast<int>(std::lround(factor * nc::full_override)));
  }

 private:
  static constexpr double blu = 0.01;        // mm
  static constexpr std::int64_t word = 600;  // f/q0 = 600/3000 of 5000 interrupts/s: 10 mm/s
  static constexpr int interrupts = 5;       // a period

  static std::int64_t steps_of(double length) { return std::lround(length / blu); }
  static nc::Block slot(std::int64_t steps) {
    nc::Block block;
    block.delta[0] = block.commands = block.capacity = steps;
    block.feed_word = word;
    block.greatest_word = 2 * word;
    return block;
  }

  std::optional<nc::Block> block_;
  nc::NcProgram program_;
  base::Result<servo::PulseLoop> loop_;
};

tl::unexpected<base::Diagnostic> refused(std::string message) {
  return base::failure({base::Severity::error, "study-slot", std::move(message), "", {}, {}});
}

/// The periods that it takes. control: what is told of each gives the override from then on.
template <class Slot>
base::Result<std::int64_t> travel(double length, double first, const std::function<double(const Moved&)>& control) {
  Slot slot(length);
  if (!slot.can_move()) return refused("the slot's loops cannot be made");
  slot.override_feed(first);
  std::int64_t periods = 0;
  for (auto moved = slot.next(); moved; moved = slot.next()) {
    if (++periods > most_periods) return refused("the slot does not end");
    slot.override_feed(control(*moved));
  }
  return periods;
}

base::Result<std::int64_t> travel(Overridden overridden, double length, double first,
                                  const std::function<double(const Moved&)>& control) {
  return overridden == Overridden::planner ? travel<PlannedSlot>(length, first, control)
                                           : travel<SteppedSlot>(length, first, control);
}

}  // namespace

base::Result<MilledSlot> mill_slot(Overridden overridden, double length, const servo::AdaptiveCutOptions& options) {
  auto cut = servo::AdaptiveCut::create(options, slot_period);
  if (!cut) return base::failure(cut.error());
  MilledSlot milled;
  const auto travelled = travel(overridden, length, 1, [&](const Moved& moved) {
    const double factor = cut->follow(moved.feed, slot_feed, moved.position);
    milled.periods.push_back({moved.position, moved.feed, cut->mean_force(), factor});
    return factor;
  });
  if (!travelled) return base::failure(travelled.error());
  milled.cut = cut->figures();
  milled.failure = cut->control().failure();
  return milled;
}

base::Result<double> slot_time(Overridden overridden, double length, double factor) {
  const auto travelled = travel(overridden, length, factor, [=](const Moved&) { return factor; });
  if (!travelled) return base::failure(travelled.error());
  return static_cast<double>(*travelled) * slot_period;
}

}  // namespace leadscrew::study
