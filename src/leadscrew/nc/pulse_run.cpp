#include <leadscrew/nc/pulse_run.hpp>

namespace leadscrew::nc {

namespace {

template <pulse::Search method, pulse::OnCircle tie>
void add_registers(Registers& registers, const pulse::CircularSearch<method, tie>& state) {
  registers.add("F", state.deviation());
}

void add_registers(Registers& registers, const pulse::CircularDda& state) {
  registers.add("rx", state.x().remainder());
  registers.add("ry", state.y().remainder());
  registers.add("nx", state.left_x());
  registers.add("ny", state.left_y());
  registers.add("q", state.x().capacity());
}

void add_registers(Registers& registers, const pulse::LinearDda<2>& state) {
  registers.add("Jx", state.integrand(0));
  registers.add("Jy", state.integrand(1));
  registers.add("rx", state.integrator(0).remainder());
  registers.add("ry", state.integrator(1).remainder());
  registers.add("nx", state.left(0));
  registers.add("ny", state.left(1));
  registers.add("q", state.integrator(0).capacity());
}

void add_registers(Registers& registers, const pulse::LinearPointComparison<2>& state) {
  registers.add("F", state.deviation());
  registers.add("nx", state.left(0));
  registers.add("ny", state.left(1));
}

void add_registers(Registers& registers, const pulse::LinearBresenham& state) {
  registers.add("F", state.deviation());
  registers.add("n", state.left());
}

}  // namespace

PulseRun::State PulseRun::load(PulseMethod method, const PulseCurve& curve, const PulseConventions& conventions,
                               const MethodOptions& options) {
  const bool integrates = conventions.capacity.has_value();
  const pulse::Preload preload = conventions.preload.value_or(pulse::Preload::none);
  if (!curve.is_arc()) {
    const pulse::Point way = curve.way();
    if (integrates) return pulse::LinearDda<2>({way.x, way.y}, *conventions.capacity, preload);
    if (method == PulseMethod::point_comparison) return pulse::LinearPointComparison<2>({way.x, way.y});
    return pulse::LinearBresenham(way);
  }
  const pulse::Arc arc = curve.arc();
  if (integrates) {
    const int bits = method == PulseMethod::dda ? conventions.bits.value_or(0) : 0;
    return pulse::CircularDda(arc, {conventions.order.value_or(pulse::Order::parallel), preload, 0, bits});
  }
  if (method == PulseMethod::improved_min_error) return Search<pulse::Search::improved_least_error>(arc);
  if (method != PulseMethod::point_comparison) return Search<pulse::Search::least_error>(arc);
  if (options.tie == pulse::OnCircle::inward)
    return Search<pulse::Search::point_comparison, pulse::OnCircle::inward>(arc);
  return Search<pulse::Search::point_comparison>(arc);
}

PulseRun::PulseRun(PulseMethod method, const PulseCurve& curve, const MethodOptions& options)
    : method_(method),
      conventions_(conventions_of(method, curve, options)),
      state_(load(method, curve, conventions_, options)),
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
