#include <algorithm>
#include <cmath>
#include <leadscrew/steps/axis_steps.hpp>

namespace leadscrew::steps {

namespace {

constexpr double hysteresis = 1.0 / (1 << 20);   // BLU
constexpr double evenly = 0.25;                  // greatest |α| + |β|
constexpr double upwards = 1 - 1.0 / (1 << 16);  // ticks: a crossing 2⁻¹⁶ behind a tick is rounding, and lies on it

std::int32_t tick_at(double ticks) {
  return static_cast<std::int32_t>(ticks + upwards);
}

}  // namespace

void AxisSteps::begin(const Span& span, const TickSpan& ticks) {
  span_ = span;
  ticks_ = ticks;
  final_tick_ = ticks.base + tick_at(ticks.offset + ticks.length);
  part_ = parts_ = 0;
  made_ = taken_ = 0;
  even_ = false;
  const bool behind = std::fabs(span.begin - static_cast<double>(count_)) > 0.5 + 2 * hysteresis;
  if (behind) add_part(0, 0, 0, 0);
  if (span.displacement == 0 && span.speed_begin == 0 && span.speed_end == 0) return begin_part();
  const double departure =
      std::fabs(span.speed_begin - span.displacement) + std::fabs(span.speed_end - span.displacement);
  if (!behind && departure <= evenly * std::fabs(span.displacement)) {
    even_ = true;
    add_part(0, 1, 0, span.displacement);
    return begin_part();
  }
  double turns[2];
  const int count = turning_points(span, turns);
  double x = 0;
  for (int k = 0; k <= count; ++k) {
    const double end = k < count ? turns[k] : 1;
    add_part(x, end, span.displacement_at(x), span.displacement_at(end));
    x = end;
  }
  begin_part();
}

void AxisSteps::add_part(double x_begin, double x_end, double displacement_begin, double displacement_end) {
  parts_of_span_[static_cast<std::size_t>(parts_++)] = {x_begin, x_end, displacement_begin, displacement_end};
}

/// Enters the first part from here on in which steps are due.
void AxisSteps::begin_part() {
  for (due_ = 0; part_ < parts_; ++part_) {
    const Part& part = parts_of_span_[static_cast<std::size_t>(part_)];
    const double from_count = span_.begin - static_cast<double>(count_);
    const bool stands = part.displacement_end == part.displacement_begin;
    part_direction_ =
        (stands ? from_count + part.displacement_end : part.displacement_end - part.displacement_begin) > 0 ? 1 : -1;
    const double beyond = part_direction_ * (from_count + part.displacement_end) - 0.5;  // the first step's half, BLU
    if (beyond < (part_direction_ == direction_ ? 0 : hysteresis)) continue;
    due_ = static_cast<std::int64_t>(beyond) + 1;
    x_ = part.x_begin;
    return;
  }
}

void AxisSteps::fill() {
  if (taken_ < made_ || !has_more()) return;
  const bool turns = part_direction_ != direction_;
  const std::size_t count = turns ? 1 : static_cast<std::size_t>(std::min<std::int64_t>(due_, capacity));
  const double first = part_direction_ * (static_cast<double>(count_) - span_.begin) + 0.5 + (turns ? hysteresis : 0);
  if (even_) {
    even_ticks(first, count);
  } else {
    bracketed_ticks(first, count);
  }
  taken_ = 0;
  made_ = place(count);
  due_ -= static_cast<std::int64_t>(made_);
  if (made_ < count) {
    part_ = parts_;  // what is left cannot be made in this period
  } else if (due_ == 0) {
    ++part_;
    begin_part();
  }
}

/// When the displacements first, first + 1, … in the direction of the part are reached, in a nearly even period.
void AxisSteps::even_ticks(double first, std::size_t count) {
  const double inverse = 1 / std::fabs(span_.displacement);
  const double alpha = span_.speed_begin / span_.displacement - 1;
  const double beta = span_.speed_end / span_.displacement - 1;
  const double linear = 1 + alpha, square = -2 * alpha - beta, cube = alpha + beta;
  const double offset = ticks_.offset + upwards, length = ticks_.length;
  std::int32_t* const ticks = due_ticks_.data();
  const auto steps = static_cast<std::int32_t>(count);
  for (std::int32_t k = 0; k < steps; ++k) {
    const double u = (first + k) * inverse, v = 1 - u;
    double x = u - u * v * (alpha * v - beta * u);
    x -= (x * (linear + x * (square + x * cube)) - u) / (linear + x * (2 * square + x * (3 * cube)));
    x -= (x * (linear + x * (square + x * cube)) - u) / (linear + x * (2 * square + x * (3 * cube)));
    ticks[k] = static_cast<std::int32_t>(offset + x * length);
  }
  // Rounding may have put a first step that is due at once before the period.
  ticks[0] = std::max(ticks[0], tick_at(ticks_.offset));
}

/// The same by Newton's method between brackets that close.
void AxisSteps::bracketed_ticks(double first, std::size_t count) {
  const Part& part = parts_of_span_[static_cast<std::size_t>(part_)];
  const double close = 1e-6 / ticks_.length;
  for (std::size_t k = 0; k < count; ++k) {
    const double target = first + static_cast<double>(k);
    double low = x_, high = part.x_end, x = (low + high) / 2;
    for (int tries = 0; tries < 64 && high - low > close; ++tries) {
      const double beyond = part_direction_ * span_.displacement_at(x) - target;
      (beyond < 0 ? low : high) = x;
      const double speed = part_direction_ * span_.speed_at(x);
      const double newton = x - beyond / speed;
      const double next = newton > low && newton < high ? newton : (low + high) / 2;
      if (std::fabs(next - x) < close / 2) high = low = next;
      x = next;
    }
    x_ = std::clamp(x, x_, part.x_end);
    due_ticks_[k] = tick_at(ticks_.offset + x_ * ticks_.length);
  }
}

/// Makes of ticks at which steps are due events that keep their distances; returns how many the period takes.
std::size_t AxisSteps::place(std::size_t count) {
  const std::int64_t first = earliest();
  const std::size_t placed = are_apart(count, first) ? place_as_due(count) : place_apart(count, first);
  if (placed == 0) return 0;
  last_ = events_[placed - 1].tick();
  direction_ = part_direction_;
  count_ += part_direction_ * static_cast<std::int64_t>(placed);
  steps_ += static_cast<std::int64_t>(placed);
  return placed;
}

/// Tick at which the next step may be made. The direction of the first one of all is set up from tick 0 on.
std::int64_t AxisSteps::earliest() const {
  if (steps_ == 0) return setup_;
  return last_ + (part_direction_ == direction_ ? pitch_ : turn_);
}

/// Do steps keep their distances, and the period, if they are made when they are due?
bool AxisSteps::are_apart(std::size_t count, std::int64_t earliest) const {
  const std::int32_t* const ticks = due_ticks_.data();
  const auto pitch = static_cast<std::int32_t>(pitch_);
  std::int32_t close = 0;
  for (std::size_t k = 1; k < count; ++k) close |= ticks[k] - ticks[k - 1] < pitch ? 1 : 0;
  return close == 0 && earliest <= ticks_.base + ticks[0] && ticks_.base + ticks[count - 1] <= final_tick_;
}

std::size_t AxisSteps::place_as_due(std::size_t count) {
  const std::int32_t* const ticks = due_ticks_.data();
  const StepEvent base(ticks_.base, axis_, part_direction_);
  for (std::size_t k = 0; k < count; ++k) events_[k] = base.later(ticks[k]);
  return count;
}

/// As far as the one before allows, and the period.
std::size_t AxisSteps::place_apart(std::size_t count, std::int64_t earliest) {
  std::size_t k = 0;
  for (; k < count; ++k) {
    const std::int64_t due = ticks_.base + due_ticks_[k];
    const std::int64_t tick = std::max(due, earliest);
    if (tick > final_tick_) break;
    postponed_ += tick != due;
    greatest_delay_ = std::max(greatest_delay_, tick - due);
    events_[k] = StepEvent(tick, axis_, part_direction_);
    earliest = tick + pitch_;
  }
  return k;
}

}  // namespace leadscrew::steps
