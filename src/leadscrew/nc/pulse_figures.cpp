#include <algorithm>
#include <bit>
#include <cmath>
#include <leadscrew/nc/pulse_figures.hpp>

namespace leadscrew::nc {

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
  return 1 + static_cast<int>(std::bit_width(std::max(magnitude(least), magnitude(greatest))));
}

PulseMeasurement::PulseMeasurement(const PulseRun& run, const PulseCurve& curve)
    : run_(run), curve_(curve), error_(curve) {
  figures_.worst = run_.at();
  figures_.registers = ranges_of(signals_of(run_, curve_));
}

void PulseMeasurement::step() {
  const pulse::Pulse<2> pulse = run_.step();
  widen(figures_.registers, signals_of(run_, curve_));
  if (pulse == pulse::Pulse<2>{}) return;
  ++figures_.pulses;
  const double distance = std::abs(error_(run_.at()));
  squares_ += distance * distance;
  if (distance <= figures_.max_error) return;
  figures_.max_error = distance;
  figures_.worst = run_.at();
  figures_.worst_clock = run_.clock();
}

PulseFigures PulseMeasurement::figures() const {
  PulseFigures figures = figures_;
  figures.clocks = run_.clock();
  figures.end = run_.at();
  figures.rms_error = figures.pulses > 0 ? std::sqrt(squares_ / static_cast<double>(figures.pulses)) : 0;
  return figures;
}

PulseFigures measure(const PulseRun& run, const PulseCurve& curve) {
  PulseMeasurement measurement(run, curve);
  while (!measurement.done()) measurement.step();
  return measurement.figures();
}

}  // namespace leadscrew::nc
