#include <leadscrew/nc/pulse_run.hpp>

namespace leadscrew::nc {

PulseRun::PulseRun(PulseMethod method, const PulseCurve& curve, const MethodOptions& options)
    : method_(method),
      conventions_(conventions_of(method, curve, options)),
      state_(with_row(method, [&](auto row) { return row.template load<State>(curve, conventions_, options); })),
      origin_(curve.origin()),
      at_(curve.start) {}

bool PulseRun::done() const {
  return std::visit([](const auto& state) { return state.done(); }, state_);
}

pulse::Pulse<2> PulseRun::step() {
  last_ = std::visit([](auto& state) { return state.step(); }, state_);
  at_.x += last_.step[0];
  at_.y += last_.step[1];
  ++clock_;
  return last_;
}

Registers PulseRun::registers() const {
  Registers registers;
  registers.add("x", at_.x - origin_.x);
  registers.add("y", at_.y - origin_.y);
  std::visit([&](const auto& state) { add_registers(registers, state); }, state_);
  return registers;
}

}  // namespace leadscrew::nc
