#include <algorithm>
#include <cmath>
#include <leadscrew/nc/nc_program.hpp>
#include <utility>

namespace leadscrew::nc {

namespace {

/// Digits of a root in base 4: each takes a comparison and, where it is 1, a subtraction.
constexpr std::int64_t digits_of_root = 31;

std::size_t moving_axes(const Block& block) {
  std::size_t count = block.kind == Block::Kind::arc ? 2 : 0;
  for (const std::int64_t delta : block.delta) count += delta != 0;
  return count;
}

}  // namespace

NcProgram::NcProgram(const NcOptions& options, BlockSource blocks)
    : options_(options), blocks_(std::move(blocks)), feed_(options.feed_capacity) {
  initiate();
}

std::int64_t NcProgram::feed_word(double inches_per_minute) {
  return std::llround(100 * inches_per_minute);
}

void NcProgram::override_feed(int thousandths) {
  override_ = std::clamp(thousandths, 0, greatest_override);
  load_feed();
}

void NcProgram::load_feed() {
  const std::int64_t greatest = std::min(block_.greatest_word, feed_.capacity());
  feed_.load(std::min(block_.feed_word * override_ / full_override, greatest));
}

AxisPulse NcProgram::interrupt() {
  AxisPulse pulse;
  if (ended_) return pulse;
  ++interrupts_;
  Operations count;
  ++count.tests;  // for a dwell
  if (dwell_left_ > 0) {
    ++count.additions;
    ++count.stores;
    if (--dwell_left_ == 0) initiate();
  } else if (feed_routine(count)) {
    pulse = interpolator_routine(count);
    output_routine(pulse, count);
    if (position_routine(pulse, count)) initiate();
  }
  operations_.add(count);
  return pulse;
}

/// Loads blocks until there is one with something to do.
void NcProgram::initiate() {
  do {
    std::optional<Block> next = blocks_();
    if (!next) {
      ended_ = true;
      return;
    }
    block_ = *next;
    interpolator_ = BlockInterpolator(block_, PulseMethod::koren, options_.interpolation);
    dwell_left_ = block_.kind == Block::Kind::dwell ? block_.dwell_clocks : 0;
    load_feed();

    Operations count;
    const auto axes = static_cast<std::int64_t>(moving_axes(block_));
    // Each axis has a displacement, a counter, a sign and a remainder; an arc two coordinates of its start besides.
    count.loads += 2 * axes + 2 + (block_.kind == Block::Kind::arc ? 2 : 0);
    count.tests += axes;
    count.stores += 4 * axes + 2 + (block_.kind == Block::Kind::arc ? 2 : 0);
    if (axes > 1) {  // q, the root of a sum of squares
      count.tests += digits_of_root;
      count.additions += digits_of_root + axes - 1;
      ++count.stores;
    }
    initiations_.add(count);
  } while (dwell_left_ == 0 && interpolator_.done());
}

bool NcProgram::feed_routine(Operations& count) {
  // r ← r + f; r ≥ q0?
  ++count.loads;
  ++count.additions;
  ++count.tests;
  const bool commands = feed_.step();
  if (commands) ++count.additions;  // r ← r − q0
  ++count.stores;
  return commands;
}

AxisPulse NcProgram::interpolator_routine(Operations& count) {
  ++count.tests;  // of the kind of block
  const bool is_arc = block_.kind == Block::Kind::arc;
  for (std::size_t axis = 0; axis < base::axis_count; ++axis) {
    const bool is_in_plane = is_arc && (axis == block_.first_axis || axis == block_.second_axis);
    if (!is_in_plane && block_.delta[axis] == 0) continue;
    if (is_in_plane) ++count.tests;  // for a counter whose integrand is 0
    ++count.tests;                   // of the counter
    if (interpolator_.left(axis) == 0) continue;
    // y + r ≥ q? Point to point has none of it.
    if (block_.kind == Block::Kind::point_to_point) continue;
    ++count.loads;
    ++count.additions;
    ++count.tests;
    ++count.stores;
  }
  const AxisPulse pulse = interpolator_.step();
  for (std::size_t axis = 0; axis < base::axis_count; ++axis) {
    if (pulse.step[axis] == 0) continue;
    if (block_.kind != Block::Kind::point_to_point) ++count.additions;  // r ← r − q
    if (!is_arc || (axis != block_.first_axis && axis != block_.second_axis)) continue;
    ++count.loads;  // the other axis' integrand ← itself ± 1
    ++count.additions;
    ++count.stores;
  }
  return pulse;
}

void NcProgram::output_routine(const AxisPulse& pulse, Operations& count) {
  for (const std::int8_t step : pulse.step) {
    if (step == 0) continue;
    ++count.loads;   // the sign
    ++count.stores;  // to the controller
  }
}

/// Have all counters come to zero?
bool NcProgram::position_routine(const AxisPulse& pulse, Operations& count) {
  for (std::size_t axis = 0; axis < base::axis_count; ++axis) {
    if (pulse.step[axis] == 0) continue;
    position_[axis] += pulse.step[axis];
    ++count.loads;
    ++count.additions;  // the counter, by one
    ++count.stores;
  }
  count.tests += static_cast<std::int64_t>(moving_axes(block_));
  return interpolator_.done();
}

}  // namespace leadscrew::nc
