// G76 of Fanuc's lathes (Fanuc 0i operator's manual, "Multiple Thread Cutting Cycle"): one block says how threads are
// finished, another the thread. Pass n cuts Δd·√n deep, or Q of the first block more than the pass before, to R above the
// full depth; then come m passes at full depth. The tool goes in along the flank of its tip's angle.

#include <algorithm>
#include <cmath>
#include <leadscrew/gcode/threading.hpp>
#include <leadscrew/numeric/functions.hpp>

namespace leadscrew::gcode {

namespace {

constexpr double most_thread_passes = 10'000;

}  // namespace

// P is six digits: m, r and a of two each.
void Threading::keep_finish(const Block& block) {
  constexpr int most = 999'999;
  if (block.has('P')) {
    const std::optional<int> digits = as_integer(block['P']);
    const int passes = digits.value_or(0) / 10'000, chamfer = digits.value_or(0) / 100 % 100,
              angle = digits.value_or(0) % 100;
    constexpr int widest = 80;
    if (!digits || *digits < 0 || *digits > most || passes < 1 || angle > widest) {
      error(
          "bad-value", block.column_of('P'), "G76 has P" + text(block['P']),
          "six digits: passes at full depth from 01, tenths of the lead to leave the thread by, the tip's angle to 80");
      return;
    }
    finish_.passes = passes;
    finish_.chamfer = chamfer / 10.0;
    finish_.angle = angle;
  }
  for (const auto& [letter, value] : {std::pair{'Q', &finish_.least_cut}, {'R', &finish_.allowance}}) {
    if (!block.has(letter)) continue;
    if (block[letter] < 0) {
      error("bad-value", block.column_of(letter), "G76 has " + std::string(1, letter) + text(block[letter]),
            std::string(1, letter) + " must be 0 or more");
      return;
    }
    *value = block[letter];
  }
}

bool Threading::plan_thread(const Block& block, Thread& thread) {
  const std::size_t x = base::index(base::Axis::X), z = base::index(base::Axis::Z);
  const base::AxisVector from = frame_.to_program(start_), to = frame_.to_program(motion_.target_of(block));
  thread.start_x = from[x] / frame_.length_unit;
  thread.start_z = from[z] / frame_.length_unit;
  thread.end_x = to[x] / frame_.length_unit;
  thread.end_z = to[z] / frame_.length_unit;
  thread.taper = block.value_or('R', 0);
  thread.side = thread.start_x > thread.end_x ? 1 : -1;
  const std::uint32_t column = block.column_of(Group::nonmodal);
  for (const char letter : {'X', 'Z', 'P', 'Q'}) {
    if (!block.has(letter)) {
      return error("missing-word", column, "G76 lacks " + std::string(1, letter), "G76 X17.4 Z-14. P1300 Q300 F2.");
    }
  }
  const std::optional<double> lead = lead_of(block);
  if (!lead) return false;
  thread.lead = *lead;
  thread.height = block['P'];
  thread.first_depth = block['Q'];
  for (const char letter : {'P', 'Q'}) {
    if (block[letter] > 0) continue;
    return error("bad-value", block.column_of(letter), "G76 has " + std::string(1, letter) + text(block[letter]),
                 std::string(1, letter) + " must be above 0");
  }
  if (thread.start_z == thread.end_z) {
    return error("bad-value", block.column_of('Z'), "the thread has no length",
                 "Z must be another than where the tool stands");
  }
  if (finish_.chamfer * thread.lead > std::fabs(thread.end_z - thread.start_z)) {
    return error("bad-value", column, "the tool leaves the thread before it begins",
                 "less chamfer in P of the block before");
  }
  // Rapids stay off the crest at both ends.
  const double crest = thread.height + std::max(0.0, thread.side * thread.taper);
  return thread.side * (thread.start_x - thread.end_x) >= crest - 1e-9 ||
         error("bad-value", block.column_of('P'), "the tool stands below the crest of the thread",
               "begin farther off the work");
}

// In from the start, along the cone, off it at 45°, out and back.
void Threading::add_pass(const Thread& thread, double depth) {
  using Kind = ThreadCycle::Step::Kind;
  const double along = thread.end_z > thread.start_z ? 1 : -1, length = std::fabs(thread.end_z - thread.start_z);
  const double half = finish_.angle / 2;
  const double slide = std::min(depth * sine_of_degrees(half) / cosine_of_degrees(half), length);
  const double end_x = thread.end_x + thread.side * (thread.height - depth);
  const auto cone = [&](double z) { return end_x + thread.taper * std::fabs(thread.end_z - z) / length; };
  const double begin_z = thread.start_z + along * slide;
  const double off = std::min(finish_.chamfer * thread.lead, length - slide);
  const double off_z = thread.end_z - along * off;
  steps_.push_back({Kind::rapid, cone(begin_z), begin_z, 0});
  // The lead is that along Z.
  const double slope = std::fabs(thread.taper) / length;
  steps_.push_back(
      {Kind::lead, 0, 0, thread.lead * (slope <= 1 ? numeric::hypot(1, slope) : numeric::hypot(1, slope) / slope)});
  steps_.push_back({Kind::thread, cone(off_z), off_z, 0});
  if (off > 0) {
    steps_.push_back({Kind::lead, 0, 0, thread.lead * std::sqrt(2.0)});
    steps_.push_back({Kind::thread, cone(off_z) + thread.side * off, thread.end_z, 0});
  }
  steps_.push_back({Kind::free, 0, 0, 0});
  steps_.push_back({Kind::rapid, thread.start_x, thread.end_z, 0});
  steps_.push_back({Kind::rapid, thread.start_x, thread.start_z, 0});
}

bool Threading::plan_steps(const Block& block, const Thread& thread) {
  const double rough = std::max(thread.height - finish_.allowance, 0.0);
  if (std::pow(rough / thread.first_depth, 2) + finish_.passes > most_thread_passes) {
    return error("too-many-passes", motion_column(block), "the thread takes more than 10000 passes", "a greater Q");
  }
  double depth = 0;
  for (int pass = 1; depth < rough; ++pass) {
    const double by_area = thread.first_depth * std::sqrt(pass);
    depth = std::min(std::max(by_area, depth + finish_.least_cut), rough);
    add_pass(thread, depth);
  }
  for (int pass = 0; pass < finish_.passes; ++pass) add_pass(thread, thread.height);
  return check_steps(block);
}

bool Threading::check_steps(const Block& block) {
  base::AxisVector from = start_;
  double lead = 0;
  for (const ThreadCycle::Step& step : steps_) {
    if (step.kind == ThreadCycle::Step::Kind::lead) lead = step.lead * frame_.length_unit;
    if (step.kind != ThreadCycle::Step::Kind::rapid && step.kind != ThreadCycle::Step::Kind::thread) continue;
    const base::AxisVector to = place(step);
    if (!travel_.inside_travel(block, to)) return false;
    if (step.kind == ThreadCycle::Step::Kind::thread &&
        !pace_.is_reached(block, {from, to, lead, modal_.spindle_speed}))
      return false;
    from = to;
  }
  return true;
}

void Threading::cycle_of_two_blocks(const Block& block) {
  if (!(block.words & axis_letter_bits)) return keep_finish(block);
  start_ = end_ = frame_.position;
  steps_.clear();
  step_ = 0;
  Thread thread;
  if (modal_.plane != Plane::ZX) {
    error("bad-plane", block.column_of(Group::nonmodal), "G76 outside the plane of Z and X", "give G18 before");
    return;
  }
  modal_.to_do = Code::G76_profile;
  if (can_turn(block) && plan_thread(block, thread) && plan_steps(block, thread)) {
    in_cycle_ = true;
  } else {
    steps_.clear();
  }
  modal_.to_do = Code::none;  // it is no motion of the block
}

}  // namespace leadscrew::gcode
