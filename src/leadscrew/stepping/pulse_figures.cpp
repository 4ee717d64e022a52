#include <algorithm>
#include <bit>
#include <cmath>
#include <leadscrew/stepping/pulse_figures.hpp>

namespace leadscrew::stepping {

namespace {

void widen(std::vector<RegisterRange>& ranges, const Registers& registers) {
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    const std::int64_t value = registers.all()[i].value;
    ranges[i].least = std::min(ranges[i].least, value);
    ranges[i].greatest = std::max(ranges[i].greatest, value);
  }
}

std::vector<RegisterRange> ranges_of(const Registers& loaded) {
  std::vector<RegisterRange> ranges;
  for (const Register& each : loaded.all()) ranges.push_back({each.name, each.value, each.value});
  return ranges;
}

}  // namespace

int RegisterRange::width() const {
  const auto magnitude = [](std::int64_t value) { return static_cast<std::uint64_t>(value < 0 ? ~value : value); };
  return 1 + std::bit_width(std::max(magnitude(least), magnitude(greatest)));
}

PulseFigures measure(PulseRun run, const PulseCurve& curve) {
  const PulseError error(curve);
  PulseFigures figures;
  figures.worst = run.at();
  figures.registers = ranges_of(run.registers());
  double squares = 0;
  while (!run.done()) {
    const pulse::Pulse<2> pulse = run.step();
    widen(figures.registers, run.registers());
    if (pulse == pulse::Pulse<2>{}) continue;
    ++figures.pulses;
    const double distance = std::abs(error(run.at()));
    squares += distance * distance;
    if (distance <= figures.max_error) continue;
    figures.max_error = distance;
    figures.worst = run.at();
    figures.worst_clock = run.clock();
  }
  figures.clocks = run.clock();
  figures.end = run.at();
  figures.rms_error = figures.pulses > 0 ? std::sqrt(squares / static_cast<double>(figures.pulses)) : 0;
  return figures;
}

}  // namespace leadscrew::stepping
