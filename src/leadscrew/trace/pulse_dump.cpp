// The registers of interpolators over time.

#include <algorithm>
#include <leadscrew/trace/pulses.hpp>
#include <leadscrew/trace/value_changes.hpp>

namespace leadscrew::trace {
namespace {

using stepping::PulseRun;
using stepping::RegisterRange;

bool has_own_origin(const stepping::PulseCurve& curve) {
  return curve.origin() != pulse::Point{};
}

std::string scope_name(stepping::PulseMethod method) {
  std::string name(stepping::name(method));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// Where the position goes, from where its register does.
int width_of_position(const RegisterRange& range, std::int64_t origin) {
  return RegisterRange{range.name, range.least + origin, range.greatest + origin}.width();
}

VcdScope scope_of(const MeasuredPulses& pulses, const stepping::PulseCurve& curve) {
  VcdScope scope{scope_name(pulses.run.method()), {{"dx", 2}, {"dy", 2}}};
  const std::vector<RegisterRange>& registers = pulses.figures.registers;
  if (has_own_origin(curve)) {
    scope.signals.push_back({"X", width_of_position(registers[0], curve.origin().x)});
    scope.signals.push_back({"Y", width_of_position(registers[1], curve.origin().y)});
  }
  // Registers of n bits are shown with n bits and a sign, whether they were filled or not.
  const int least = pulses.run.conventions().bits.value_or(0) + 1;
  for (const RegisterRange& each : registers)
    scope.signals.push_back({std::string(each.name), std::max(least, each.width())});
  return scope;
}

void add_values(std::vector<std::int64_t>& values, const PulseRun& run, pulse::Pulse<2> pulse, bool with_position) {
  values.push_back(pulse.step[0]);
  values.push_back(pulse.step[1]);
  if (with_position) {
    values.push_back(run.at().x);
    values.push_back(run.at().y);
  }
  const stepping::Registers registers = run.registers();
  for (const stepping::Register& each : registers.all()) values.push_back(each.value);
}

}  // namespace

base::Result<void> write_pulse_dump(const stepping::PulseCurve& curve, const std::vector<MeasuredPulses>& pulses,
                                    const ByteSink& sink) {
  std::vector<VcdScope> scopes;
  std::vector<PulseRun> runs;
  for (const MeasuredPulses& each : pulses) {
    scopes.push_back(scope_of(each, curve));
    runs.push_back(each.run);
  }
  VcdWriter writer(sink, "1 us", title_of(curve) + "; one microsecond is one clock", scopes);
  std::vector<std::int64_t> values;
  std::int64_t clock = 0;
  // To the clock behind the last pulse, where all rest.
  for (bool any_runs = true; any_runs; ++clock) {
    values.clear();
    any_runs = clock == 0;
    for (PulseRun& run : runs) {
      const bool runs_on = clock > 0 && !run.done();
      any_runs = any_runs || runs_on;
      add_values(values, run, runs_on ? run.step() : pulse::Pulse<2>{}, has_own_origin(curve));
    }
    if (auto written = writer.write(clock, values); !written) return written;
  }
  return writer.finish(clock);
}

}  // namespace leadscrew::trace
