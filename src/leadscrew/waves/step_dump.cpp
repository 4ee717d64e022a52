#include <algorithm>
#include <leadscrew/base/digits.hpp>
#include <leadscrew/waves/step_dump.hpp>
#include <limits>
#include <utility>

namespace leadscrew::waves {
namespace {

constexpr std::size_t longest_row = 2 * base::digits_room + 8;

char identifier(std::uint8_t signal) {
  return static_cast<char>('!' + signal);
}

std::uint8_t step_signal(base::Axis axis) {
  return static_cast<std::uint8_t>(2 * base::index(axis));
}
std::uint8_t direction_signal(base::Axis axis) {
  return static_cast<std::uint8_t>(2 * base::index(axis) + 1);
}

}  // namespace

StepCsvWriter::StepCsvWriter(base::ByteSink sink, std::int64_t clock_hz)
    : rows_(std::move(sink), longest_row), clock_hz_(static_cast<double>(clock_hz)) {
  rows_.text() = "tick,t,axis,direction\n";
}

base::Result<void> StepCsvWriter::write(std::span<const steps::StepEvent> events) {
  for (const steps::StepEvent event : events) {
    char row[longest_row];
    char* at = base::write_integer(row, event.tick());
    *at++ = ',';
    at = base::write_digits(at, static_cast<double>(event.tick()) / clock_hz_);
    *at++ = ',';
    *at++ = base::letter(event.axis());
    *at++ = ',';
    at = base::write_integer(at, event.direction());
    *at++ = '\n';
    rows_.text().append(row, static_cast<std::size_t>(at - row));
    if (auto written = rows_.flush_if_full(); !written) return written;
  }
  return rows_.state();
}

StepVcdWriter::StepVcdWriter(base::ByteSink sink, const machine::Machine& machine, std::int64_t clock_hz)
    : text_(std::move(sink)), clock_hz_(clock_hz) {
  std::string& header = text_.text();
  header = "$comment step and direction, a clock of " + std::to_string(clock_hz_) +
           " Hz $end\n$version leadscrew $end\n$timescale 1 ns $end\n$scope module steps $end\n";
  std::string values;
  for (const base::Axis axis : base::all_axes) {
    if (!machine.has(axis)) continue;
    steps::StepTicks& ticks = ticks_[base::index(axis)];
    ticks = steps::in_ticks(machine.limits(axis).step_times, clock_hz);
    longest_setup_ = std::max(longest_setup_, ticks.setup);
    const std::string name(1, base::letter(axis));
    const std::string step(1, identifier(step_signal(axis))), direction(1, identifier(direction_signal(axis)));
    header += "$var wire 1 " + step + " " + name + "_step $end\n$var wire 1 " + direction + " " + name + "_dir $end\n";
    values += "0" + step + "\nx" + direction + "\n";
  }
  header += "$upscope $end\n$enddefinitions $end\n#0\n$dumpvars\n" + values + "$end\n";
}

base::Result<void> StepVcdWriter::write(std::span<const steps::StepEvent> events) {
  for (const steps::StepEvent event : events) {
    const steps::StepTicks& ticks = ticks_[base::index(event.axis())];
    int& direction = directions_[base::index(event.axis())];
    if (direction != event.direction()) {
      direction = event.direction();
      const std::int64_t tick = std::max<std::int64_t>(0, event.tick() - ticks.setup);
      add(tick, direction_signal(event.axis()), direction > 0 ? '1' : '0');
    }
    add(event.tick(), step_signal(event.axis()), '1');
    add(event.tick() + ticks.length, step_signal(event.axis()), '0');
    put_before(event.tick() - longest_setup_);  // no event to come changes anything earlier
    if (auto written = text_.flush_if_full(); !written) return written;
  }
  return text_.state();
}

base::Result<void> StepVcdWriter::finish() {
  put_before(std::numeric_limits<std::int64_t>::max());
  return text_.flush();
}

void StepVcdWriter::add(std::int64_t tick, std::uint8_t signal, char value) {
  to_come_.push_back({tick, signal, value});
  std::ranges::push_heap(to_come_, is_later);
}

void StepVcdWriter::put_before(std::int64_t tick) {
  while (!to_come_.empty() && to_come_.front().tick < tick) {
    const Change change = to_come_.front();
    std::ranges::pop_heap(to_come_, is_later);
    to_come_.pop_back();
    if (change.tick != now_) put_time(change.tick);
    text_.text() += change.value;
    text_.text() += identifier(change.signal);
    text_.text() += '\n';
  }
}

/// In nanoseconds, the nearest to the tick.
void StepVcdWriter::put_time(std::int64_t tick) {
  constexpr std::int64_t nano = 1'000'000'000;
  const std::int64_t rest = tick % clock_hz_;
  char digits[base::digits_room];
  char* const end = base::write_integer(digits, tick / clock_hz_ * nano + (rest * nano + clock_hz_ / 2) / clock_hz_);
  text_.text() += '#';
  text_.text().append(digits, static_cast<std::size_t>(end - digits));
  text_.text() += '\n';
  now_ = tick;
}

}  // namespace leadscrew::waves
