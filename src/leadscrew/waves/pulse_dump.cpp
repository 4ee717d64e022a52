// The registers of interpolators over time.

#include <algorithm>
#include <leadscrew/waves/pulses.hpp>
#include <leadscrew/waves/value_changes.hpp>

namespace leadscrew::waves {
namespace {

using nc::PulseRun;
using nc::RegisterRange;

constexpr std::int64_t units_per_clock = 10;  // of 100 ns
constexpr std::int64_t half_clock = units_per_clock / 2;

bool has_own_origin(const nc::PulseCurve& curve) {
  return curve.origin() != pulse::Point{};
}

std::string scope_name(nc::PulseMethod method) {
  std::string name(nc::name(method));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

/// Where the position goes, from where its register does.
int width_of_position(const RegisterRange& range, std::int64_t origin) {
  return RegisterRange{range.name, range.least + origin, range.greatest + origin}.width();
}

int width_of(std::int64_t value) {
  return RegisterRange{"", value, value}.width();
}

/// As loaded into coordinates.
struct Ends {
  pulse::Point start, end;
};

Ends ends_of(const nc::PulseCurve& curve) {
  if (!curve.is_arc()) return {{}, curve.delta()};
  return {curve.arc().start, curve.arc().end};
}

VcdScope common_scope(const nc::PulseCurve& curve) {
  const auto [start, end] = ends_of(curve);
  return {"common",
          {{"clk", 1},
           {"rst", 1, {"Syn"}},
           {"Start_X0", width_of(start.x)},
           {"Start_Y0", width_of(start.y), {"Start_Z0"}},
           {"End_X1", width_of(end.x)},
           {"End_Y1", width_of(end.y), {"End_Z1"}}}};
}

VcdScope scope_of(const MeasuredPulses& pulses, const nc::PulseCurve& curve) {
  const nc::PulseMethod method = pulses.run.method();
  const auto signal = [&](std::string_view name, int width) -> VcdSignal {
    const auto names = nc::names_in_paper(name, method, curve.shape);
    return {std::string(name), width, {names.begin(), names.end()}};
  };
  VcdScope scope{scope_name(method),
                 {{"Busy", 1}, {"X_Pwm_Out", 1}, {"Y_Pwm_Out", 1, {"Z_Pwm_Out"}}, signal("dx", 2), signal("dy", 2)}};
  const std::vector<RegisterRange>& registers = pulses.figures.registers;
  if (has_own_origin(curve)) {
    scope.signals.push_back({"X", width_of_position(registers[0], curve.origin().x)});
    scope.signals.push_back({"Y", width_of_position(registers[1], curve.origin().y)});
  }
  // Registers of n bits are shown with n bits and a sign, whether they were filled or not.
  const int least = pulses.run.conventions().bits.value_or(0) + 1;
  for (const RegisterRange& each : registers) scope.signals.push_back(signal(each.name, std::max(least, each.width())));
  return scope;
}

/// "dda: Sum_X is rx, Val_x is x"
std::string names_of(const VcdScope& scope) {
  std::string text;
  for (const VcdSignal& signal : scope.signals) {
    for (const std::string& name : signal.also) {
      text += (text.empty() ? scope.name + ": " : ", ") + name + " is " + signal.name;
    }
  }
  return text;
}

constexpr const char* what_signals_are =
    "clk rises at every clock; rst is high at the one that loads, as is Syn; Busy falls at the end; X_Pwm_Out and "
    "Y_Pwm_Out are high for half a clock at each step; the axis Z of \"FPGA-based implementation of circular "
    "interpolation\" is Y";

class PulseDump {
 public:
  PulseDump(const nc::PulseCurve& curve, const std::vector<MeasuredPulses>& pulses, const base::ByteSink& sink)
      : curve_(curve) {
    std::vector<VcdScope> scopes = {common_scope(curve)};
    for (const MeasuredPulses& each : pulses) {
      scopes.push_back(scope_of(each, curve));
      runs_.push_back({each.run, {}});
    }
    std::vector<std::string> comments = {title_of(curve) + "; one microsecond is one clock", what_signals_are};
    for (const VcdScope& scope : scopes) comments.push_back(names_of(scope));
    writer_.emplace(sink, "100 ns", comments, scopes);
  }

  /// To the clock behind the last pulse, where all rest.
  base::Result<void> write() {
    std::int64_t clock = 0;
    for (bool any_runs = true; any_runs; ++clock) {
      any_runs = clock == 0;
      for (Run& each : runs_) {
        const bool runs_on = clock > 0 && !each.state.done();
        any_runs = any_runs || runs_on;
        each.pulse = runs_on ? each.state.step() : pulse::Pulse<2>{};
      }
      for (const bool is_high : {true, false}) {
        const std::int64_t time = clock * units_per_clock + (is_high ? 0 : half_clock);
        if (auto written = writer_->write(time, values(clock == 0, is_high)); !written) return written;
      }
    }
    return writer_->finish(clock * units_per_clock);
  }

 private:
  struct Run {
    PulseRun state;
    pulse::Pulse<2> pulse;  ///< of this clock
  };

  /// Of all signals, while the clock is high or after.
  const std::vector<std::int64_t>& values(bool is_first, bool is_high) {
    const auto [start, end] = ends_of(curve_);
    values_ = {is_high, is_first, start.x, start.y, end.x, end.y};
    for (const Run& run : runs_) add_values(run, is_high);
    return values_;
  }

  void add_values(const Run& run, bool is_high) {
    const auto [dx, dy] = run.pulse.step;
    values_.insert(values_.end(), {!run.state.done(), is_high && dx != 0, is_high && dy != 0, dx, dy});
    if (has_own_origin(curve_)) values_.insert(values_.end(), {run.state.at().x, run.state.at().y});
    const nc::Registers signals = nc::signals_of(run.state, curve_);
    for (const nc::Register& each : signals.all()) values_.push_back(each.value);
  }

  nc::PulseCurve curve_;
  std::vector<Run> runs_;
  std::optional<VcdWriter> writer_;
  std::vector<std::int64_t> values_;
};

}  // namespace

base::Result<void> write_pulse_dump(const nc::PulseCurve& curve, const std::vector<MeasuredPulses>& pulses,
                                    const base::ByteSink& sink) {
  return PulseDump(curve, pulses, sink).write();
}

}  // namespace leadscrew::waves
