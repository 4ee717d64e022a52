#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/threading.hpp>
#include <leadscrew/numeric/functions.hpp>
#include <limits>
#include <utility>

namespace leadscrew::gcode {

namespace {

constexpr double most_passes = 10'000;

}  // namespace

bool Threading::can_turn(const Block& block) {
  if (modal_.spindle != Code::M3 && modal_.spindle != Code::M4) {
    return error("spindle-stands", motion_column(block), "the spindle stands in " + name(modal_.to_do),
                 "give M3 or M4 before");
  }
  if (modal_.spindle_speed > 0) return true;
  return error("spindle-stands", motion_column(block), "the spindle has no speed in " + name(modal_.to_do),
               "give S before");
}

bool Threading::moves_linear_axes_only(const Block& block) {
  for (const base::Axis axis : base::all_axes) {
    const bool linear = axis == base::Axis::X || axis == base::Axis::Y || axis == base::Axis::Z;
    if (linear || !block.has(base::letter(axis))) continue;
    return error("unused-word", block.column_of(base::letter(axis)),
                 name(modal_.to_do) + " does not move axis " + base::letter(axis), "move it in a block before");
  }
  return true;
}

// K, of G33 of Fanuc and Haas F; in the program's units.
std::optional<double> Threading::lead_of(const Block& block) {
  const bool by_feed = is_of_fanuc_family(options_.dialect);
  const char letter = by_feed && block.has('F') && !block.has('K') ? 'F' : 'K';
  // F of a lathe holds, as other feeds do.
  if (options_.dialect == Dialect::fanuc_lathe && !block.has('F') && modal_.feed_word > 0) return modal_.feed_word;
  if (!block.has(letter)) {
    const bool is_of_lathe = options_.dialect == Dialect::fanuc_lathe;
    const std::string called = name(modal_.to_do), wanted = is_of_lathe ? "F" : "K";
    error("missing-word", motion_column(block), called + " lacks " + wanted,
          "give the travel in a revolution: " + called + " Z-10 " + wanted + "1.25");
    return std::nullopt;
  }
  if (letter == 'K' && block.has('F')) {
    const bool is_lead = options_.dialect == Dialect::fanuc_lathe;
    error("unused-word", block.column_of(is_lead ? 'K' : 'F'),
          name(modal_.to_do) + (is_lead ? " takes no K" : " takes no F"),
          is_lead ? "F is the travel in a revolution" : "K and S are its feed");
    return std::nullopt;
  }
  if (block[letter] > 0) return block[letter];
  error("bad-value", block.column_of(letter), "the travel in a revolution is " + text(block[letter]),
        std::string(1, letter) + " must be above 0");
  return std::nullopt;
}

double Threading::feed_at(double lead, double factor) const {
  return lead * factor * modal_.spindle_speed / seconds_per_minute;
}

void Threading::go(const base::AxisVector& target, double feed) {
  Move& line = outbox_.emit(Move::Kind::line);
  line.end = target;
  line.feed = {Feed::Mode::units_per_second, feed};
  frame_.position = target;
}

// Fanuc: the lead is that along the axis that moves more.
double Threading::along_path(double lead, const base::AxisVector& target) const {
  if (options_.dialect != Dialect::fanuc_lathe) return lead;
  double most = 0;
  for (std::size_t i = 0; i < target.size(); ++i) most = std::max(most, std::fabs(target[i] - frame_.position[i]));
  return lead * feed_length_of_line(frame_.position, target) / most;
}

void Threading::thread(const Block& block) {
  cut_to(block, motion_.target_of(block));
}

void Threading::cut_to(const Block& block, const base::AxisVector& target) {
  const std::optional<double> lead = lead_of(block);
  if (can_turn(block) && lead && travel_.inside_travel(block, target) && target != frame_.position) {
    const double in_mm = along_path(*lead * (motion_.is_linear(target) ? frame_.length_unit : 1), target);
    if (pace_.is_reached(block, {frame_.position, target, in_mm, modal_.spindle_speed})) {
      outbox_.emit_event(base::Event::Kind::spindle_in_step, in_mm);
      go(target, feed_at(in_mm));
      outbox_.emit_event(base::Event::Kind::spindle_in_step, 0);
    }
  }
  frame_.position = target;
}

// The spindle turns back at the bottom, I times as fast, and again at the top.
void Threading::tap(const Block& block) {
  const base::AxisVector target = motion_.target_of(block), start = frame_.position;
  const std::optional<double> lead = lead_of(block);
  const bool sound = moves_linear_axes_only(block) && can_turn(block) && lead && travel_.inside_travel(block, target);
  if (!sound || target == start) return;
  const double in_mm = *lead * frame_.length_unit;
  const double factor = std::max(1.0, block.value_or('I', 1));
  const double speed = modal_.spindle_speed;
  if (!pace_.is_reached(block, {start, target, in_mm, speed * factor})) return;
  if (!pace_.can_brake(block, {start, target, in_mm, speed})) return;
  using Kind = base::Event::Kind;
  const bool clockwise = modal_.spindle == Code::M3;
  outbox_.emit_event(Kind::rigid_tap, in_mm);
  go(target, feed_at(in_mm));
  // Where the cycle follows the spindle it stands at both ends.
  const auto turn = [&](bool is_clockwise, double at) {
    Move& move = outbox_.emit(Move::Kind::event);
    outbox_.prepare_event(move, is_clockwise ? Kind::spindle_clockwise : Kind::spindle_counterclockwise, at);
    move.event.waits |= machine_.threads_follow();
  };
  turn(!clockwise, speed * factor);
  go(start, feed_at(in_mm, factor));
  turn(clockwise, speed);
  outbox_.emit_event(Kind::spindle_in_step, 0);
}

std::optional<int> Threading::count(const Block& block, char letter, int most) {
  const std::optional<int> value = as_integer(block.value_or(letter, 0));
  if (value && 0 <= *value && *value <= most) return value;
  error("bad-value", block.column_of(letter), "G76 has " + std::string(1, letter) + text(block[letter]),
        "an integer from 0 to " + std::to_string(most));
  return std::nullopt;
}

bool Threading::plan_depths(const Block& block, ThreadCycle::Plan& plan) {
  const double scale = modal_.diameters ? 0.5 : 1;
  plan.pitch = block['P'];
  plan.crest = block['I'] * scale;
  plan.first_depth = block['J'] * scale;
  plan.full_depth = block['K'] * scale;
  plan.degression = block.value_or('R', 1);
  plan.slide_angle = block.value_or('Q', 0);
  const auto refuse = [&](char letter, const char* hint) {
    return error("bad-value", block.column_of(letter), "G76 has " + std::string(1, letter) + text(block[letter]), hint);
  };
  constexpr double steepest = 80;  // degrees
  if (!(plan.pitch > 0)) return refuse('P', "the pitch must be above 0");
  if (plan.crest == 0) return refuse('I', "below 0 outside, above 0 inside");
  if (!(plan.first_depth > 0)) return refuse('J', "the first depth must be above 0");
  if (!(plan.full_depth > plan.first_depth)) return refuse('K', "the full depth must be above J");
  if (!(plan.degression >= 1)) return refuse('R', "1 or more");
  return std::fabs(plan.slide_angle) <= steepest || refuse('Q', "an angle from -80 to 80 degrees");
}

bool Threading::plan_tapers(const Block& block, ThreadCycle::Plan& plan) {
  constexpr int entry = 1, exit = 2, both = entry | exit;
  const std::optional<int> tapers = count(block, 'L', both), springs = count(block, 'H', static_cast<int>(most_passes));
  if (!tapers || !springs) return false;
  plan.spring_passes = *springs;
  plan.taper = block.value_or('E', 0);
  if (plan.taper < 0) {
    return error("bad-value", block.column_of('E'), "G76 has E" + text(plan.taper), "E must be 0 or more");
  }
  plan.tapers_entry = plan.taper > 0 && (*tapers & entry);
  plan.tapers_exit = plan.taper > 0 && (*tapers & exit);
  const double whole = std::fabs(plan.end_z - plan.start_z);
  if (plan.taper * (plan.tapers_entry + plan.tapers_exit) <= whole) return true;
  return error("bad-value", block.column_of('E'),
               "the tapers of " + text(plan.taper) + " are longer than the thread of " + text(whole),
               "at most half of the thread");
}

bool Threading::plan_cycle(const Block& block, ThreadCycle::Plan& plan) {
  const std::size_t x = base::index(base::Axis::X), z = base::index(base::Axis::Z);
  const base::AxisVector from = frame_.to_program(start_), to = frame_.to_program(end_);
  plan.drive_x = from[x] / frame_.length_unit;
  plan.start_z = from[z] / frame_.length_unit;
  plan.end_z = to[z] / frame_.length_unit;
  if (!plan_depths(block, plan) || !plan_tapers(block, plan)) return false;
  const double passes = ThreadCycle::passes(plan);
  if (passes <= most_passes) return true;
  return error("too-many-passes", motion_column(block), "the thread takes more than 10000 passes",
               "a greater J, or a smaller R");
}

// Where a step leads. Axes that the cycle does not move, and that go by themselves, stay exactly where they are.
base::AxisVector Threading::place(const ThreadCycle::Step& step) const {
  base::AxisVector program = frame_.to_program(start_);
  program[base::index(base::Axis::X)] = step.x * frame_.length_unit;
  program[base::index(base::Axis::Z)] = step.z * frame_.length_unit;
  base::AxisVector placed = frame_.to_machine(program);
  for (const base::Axis axis : base::all_axes) {
    const bool moved = axis == base::Axis::X || axis == base::Axis::Z;
    if (!moved && frame_.is_separate(axis)) placed[base::index(axis)] = start_[base::index(axis)];
  }
  return placed;
}

// The passes lie between the first and the last.
bool Threading::check_passes(const Block& block, const ThreadCycle::Plan& plan) {
  ThreadCycle::Plan last = plan;
  last.first_depth = std::nextafter(plan.full_depth, 0.0);
  last.spring_passes = 0;
  for (ThreadCycle cycle : {ThreadCycle(plan), ThreadCycle(last)}) {
    base::AxisVector from = start_;
    double lead = 0;
    for (bool ended = false; !ended;) {
      const ThreadCycle::Step step = cycle.next();
      ended = step.kind == ThreadCycle::Step::Kind::free;
      if (step.kind == ThreadCycle::Step::Kind::lead) lead = step.lead * frame_.length_unit;
      if (step.kind != ThreadCycle::Step::Kind::rapid && step.kind != ThreadCycle::Step::Kind::thread) continue;
      const base::AxisVector to = place(step);
      if (!travel_.inside_travel(block, to)) return false;
      if (step.kind == ThreadCycle::Step::Kind::thread &&
          !pace_.is_reached(block, {from, to, lead, modal_.spindle_speed}))
        return false;
      from = to;
    }
  }
  return travel_.inside_travel(block, end_);
}

void Threading::cycle(const Block& block) {
  start_ = frame_.position;
  end_ = motion_.target_of(block);
  ThreadCycle::Plan plan;
  const bool is_whole = !(row(Code::G76).needs.bits & ~block.words);
  if (is_whole && moves_linear_axes_only(block) && can_turn(block) && plan_cycle(block, plan) &&
      check_passes(block, plan)) {
    cycle_ = ThreadCycle(plan);
    in_cycle_ = true;
  } else {
    frame_.position = end_;
  }
}

// A change of the lead within a pass waits for nothing; but one line follows the spindle at a time, from rest to rest.
bool Threading::next_event(Move& move, double lead) {
  const bool waits = lead_ == 0 || lead == 0 || machine_.threads_follow();
  lead_ = lead;
  is_behind_line_ = false;
  outbox_.prepare_event(move, base::Event::Kind::spindle_in_step, lead);
  move.event.waits = waits;
  return true;
}

// The last step leads to the end of the block, but for rounding.
base::AxisVector Threading::target_of(const ThreadCycle::Step& step) const {
  const base::AxisVector target = place(step);
  constexpr double rounding = 1e-9;
  for (std::size_t i = 0; i < base::axis_count; ++i) {
    if (cycle_.active() || step_ < steps_.size() || std::fabs(target[i] - end_[i]) > rounding) return target;
  }
  return end_;
}

ThreadCycle::Step Threading::next_step() {
  if (waiting_) return *std::exchange(waiting_, std::nullopt);
  if (cycle_.active()) return cycle_.next();
  return in_cycle_ ? steps_[step_++] : ThreadCycle::Step{};
}

bool Threading::next_of_cycle(Move& move) {
  using Kind = ThreadCycle::Step::Kind;
  ThreadCycle::Step step;
  base::AxisVector target = frame_.position;
  while (in_cycle_ && target == frame_.position) {
    in_cycle_ = waiting_ || cycle_.active() || step_ < steps_.size();
    step = next_step();
    if (step.kind == Kind::lead || step.kind == Kind::free) return next_event(move, step.lead * frame_.length_unit);
    target = in_cycle_ ? target_of(step) : end_;
  }
  if (target == frame_.position) return false;
  const bool goes_on = is_behind_line_ && step.kind == Kind::thread;
  if (goes_on && machine_.threads_follow()) {
    waiting_ = step;
    return next_event(move, lead_);
  }
  is_behind_line_ = step.kind == Kind::thread;
  outbox_.prepare(move, Move::Kind::line, modal_.line);
  move.end = target;
  if (step.kind == Kind::thread) move.feed = {Feed::Mode::units_per_second, feed_at(lead_)};
  frame_.position = target;
  return true;
}

void Threading::abandon() {
  if (in_cycle_) frame_.position = end_;
  cycle_ = {};
  steps_.clear();
  step_ = 0;
  waiting_.reset();
  in_cycle_ = false;
}

}  // namespace leadscrew::gcode
